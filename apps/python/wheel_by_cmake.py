"""The build backend of the Python package (PEP 517): CMake compiles, setuptools packs."""
from __future__ import annotations

import re
import subprocess
import sys
import tempfile
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parents[2]


def version() -> str:
    """That of the project, as CMake knows it."""
    found = re.search(r"project\(mesopix VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())
    assert found, "CMakeLists.txt names no version"
    return found[1]


def cmake(*words: object) -> None:
    subprocess.run(["cmake", *map(str, words)], check=True)


class BuildByCMake(build_ext):
    """Puts what CMake installs as the component wheel where setuptools expects it."""

    there: str | None = None  #: a build folder that is configured already

    def run(self) -> None:
        build = self.there or ROOT / "build" / "wheel"
        if not self.there:
            cmake("-S", ROOT, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DMESOPIX_PYTHON=ON",
                  "-DMESOPIX_TESTS=OFF", "-DMESOPIX_EVIDENCE=OFF", f"-DPython_EXECUTABLE={sys.executable}")
        cmake("--build", build, "--target", "mesopix_python")
        cmake("--install", build, "--component", "wheel", "--prefix", Path(self.build_lib).resolve(), "--strip")
        if not Path(self.build_lib, self.get_ext_filename("mesopix._core")).exists():
            raise RuntimeError(f"{build} was configured for another Python than {sys.executable}; remove it")


def build_wheel(
    wheel_directory: str, config_settings: dict[str, str] | None = None, metadata_directory: str | None = None
) -> str:
    """Make the wheel in a folder; --config-settings build=DIR takes a build folder that is there.

    Returns its file name.
    """
    with tempfile.TemporaryDirectory() as scratch:
        made = setup(
            version=version(),
            ext_modules=[Extension("mesopix._core", [])],
            cmdclass={"build_ext": type("Build", (BuildByCMake,), {"there": (config_settings or {}).get("build")})},
            script_args=["egg_info", "--egg-base", scratch, "build", "--build-base", scratch, "bdist_wheel", "--bdist-dir",
                         f"{scratch}/wheel", "--dist-dir", wheel_directory])
    return Path(made.dist_files[-1][2]).name


def build_sdist(sdist_directory: str, config_settings: object = None) -> str:
    """There is none: the package is made from a checkout."""
    raise RuntimeError("mesopix has no source distribution; make the wheel from a checkout: pip wheel .")
