# A recipe for Spack, for the program and both libraries. After each dependency is what .ci/install-packages calls it on
# Debian; tests/project/recipe_test.py compares the two lists. The recipe is read and compared by that test, but nobody has
# built it yet. In a repository of yours, as packages/mesopix/package.py, and from a checkout of mesopix:
#   spack dev-build mesopix@0.1.0
# Nothing stands for: git, ca-certificates (they fetch the sources), fonts-dejavu-core (Spack has no such package: any
# font that fontconfig finds will do)
from spack.package import *


class Mesopix(CMakePackage):
    """From a picture of concrete to a broken specimen."""

    license("MIT")

    version("0.1.0")

    variant("shared", default=False, description="Build shared libraries")

    depends_on("cxx", type="build")  # g++
    depends_on("cmake@3.25:", type="build")  # cmake
    depends_on("ninja", type="build")  # ninja-build
    depends_on("pkgconfig", type="build")  # pkg-config
    depends_on("opencv@4: +imgproc")  # libopencv-core-dev libopencv-imgproc-dev
    depends_on("eigen@3.4")  # libeigen3-dev
    depends_on("hdf5")  # libhdf5-dev
    depends_on("cli11")  # libcli11-dev
    depends_on("tomlplusplus")  # libtomlplusplus-dev
    depends_on("nlohmann-json@3.10:")  # nlohmann-json3-dev
    depends_on("fmt")  # libfmt-dev
    depends_on("nlopt")  # libnlopt-dev
    depends_on("cairo +png")  # libcairo2-dev
    depends_on("libpng")  # libpng-dev
    depends_on("jpeg")  # libjpeg-dev
    depends_on("libtiff")  # libtiff-dev
    depends_on("zlib-api")  # zlib1g-dev
    depends_on("openssl")  # libssl-dev
    depends_on("libzip")  # libzip-dev
    depends_on("cpp-httplib")  # libcpp-httplib-dev
    depends_on("boost")  # libboost-dev

    generator("ninja")

    def cmake_args(self):
        return [self.define("MESOPIX_TESTS", False), self.define_from_variant("BUILD_SHARED_LIBS", "shared")]
