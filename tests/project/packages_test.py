#!/usr/bin/env python3
"""Packs what is built, looks at what is in the Debian packages and what they say of themselves, and runs what comes out of
them. That they install on a Debian that has nothing else is for clean_debian_test.sh.
Usage: packages_test.py SOURCE_DIR BUILD_DIR WORK_DIR"""
import os, re, shutil, subprocess, sys
from pathlib import Path

if not shutil.which("dpkg-shlibdeps"):
    print("this is no Debian system, or dpkg-dev is missing")
    sys.exit(77)

source, build, work = (Path(argument).resolve() for argument in sys.argv[1:])
version = re.search(r"project\(mesopix VERSION (\S+)", (source / "CMakeLists.txt").read_text())[1]
tracked = set(subprocess.run(["git", "-C", source, "ls-files", "data"], capture_output=True, text=True).stdout.split()) or {
    str(path.relative_to(source)) for path in (source / "data").rglob("*") if path.is_file()}
shared = any(build.glob("specimen/*.so"))
runtimes = {f"libmesopix-{library}{version.rpartition('.')[0]}" for library in ("specimen", "mpm") if shared}
headers = {}
for folder in ("specimen", "libmpm"):
    listed = re.search(r"FILE_SET HEADERS BASE_DIRS \S+ FILES([^)]*)\)", (source / folder / "CMakeLists.txt").read_text())[1]
    headers[folder] = set(listed.split())


def run(*words, **more):
    return subprocess.run(words, check=True, capture_output=True, text=True, **more).stdout


def pack():
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    made = subprocess.run(["cpack", "-G", "DEB", "--config", build / "CPackConfig.cmake", "-B", work,
                           "-D", "CPACK_DEBIAN_COMPRESSION_TYPE=gzip"], capture_output=True, text=True)
    assert made.returncode == 0, made.stdout + made.stderr
    packages = {path.name.split("_")[0]: path for path in work.glob("*.deb")}
    python = {"python3-mesopix"} if (build / "python/mesopix").exists() else set()
    wanted = {"mesopix", "libmesopix-specimen-dev", "libmesopix-mpm-dev", "libmesopix-common-dev"} | python | runtimes
    assert set(packages) == wanted, packages
    return packages


def fields(path):
    """What a package says of itself, a text a field."""
    return dict(re.findall(r"^([\w-]+): (.*(?:\n .*)*)", run("dpkg-deb", "--field", path), re.M))


def files(path):
    """Its files, and the rights and owners that they have."""
    lines = [line.split(" -> ")[0].split(None, 5) for line in run("dpkg-deb", "--contents", path).splitlines()]
    for rights, owner, *_, name in lines:
        assert owner == "root/root", f"{path.name}: {name} is owned by {owner}"
        wanted = {"d": "drwxr-xr-x", "l": "lrwxrwxrwx"}.get(rights[0], "-rwxr-xr-x" if "/bin/" in name else "-rw-r--r--")
        assert rights == wanted, f"{path.name}: {name} has the rights {rights}"
    return {name.removeprefix("./usr/") for rights, *_, name in lines if rights[0] != "d"}


def expect_files(name, met, *patterns, wanted=()):
    """Those that are wanted, those of every package, and others that match a pattern, and no others."""
    papers = {f"share/doc/{name}/{file}" for file in ("copyright", "changelog.gz", "changelog.Debian.gz")}
    papers.add(f"share/lintian/overrides/{name}")
    missing = (papers | set(wanted)) - met
    others = [file for file in met - papers - set(wanted) if not any(re.fullmatch(p, file) for p in patterns)]
    assert not missing and not others, f"{name}: lacks {sorted(missing)}, and should not have {sorted(others)}"


def texts():
    """Completions, and manual pages of a build that has them."""
    return {f"share/man/man{page.suffix[1]}/{page.name}.gz" for page in (build / "manual/man").glob("*.[1-9]")} | {
        "share/bash-completion/completions/mesopix", "share/zsh/vendor-completions/_mesopix",
        "share/fish/vendor_completions.d/mesopix.fish"}


def expect_contents(packages):
    met = {name: files(path) for name, path in packages.items()}
    for name, others in met.items():
        for other, held in met.items():
            assert name == other or not held & others, f"{name} and {other} both have {held & others}"
    examples = {"share/doc/mesopix/examples" + path.removeprefix("data") for path in tracked}
    expect_files("mesopix", met["mesopix"], wanted=examples | texts() | {"bin/mesopix", "share/doc/mesopix/CITATION.cff"})
    cmake = r"lib/(?:[\w-]+/)?cmake/mesopix/"
    for library, folder in {"specimen": "specimen", "mpm": "libmpm"}.items():
        name, binary = f"libmesopix-{library}-dev", rf"lib/(?:[\w-]+/)?libmesopix_{library}\.{'so' if shared else 'a'}"
        expect_files(name, met[name], binary, cmake + rf"mesopix-{library}-targets(-\w+)?\.cmake",
                     cmake + "FindOpenCVParts.cmake" if library == "specimen" else "",
                     wanted={f"include/mesopix/{folder}/{header}" for header in headers[folder]})
        assert len(headers[folder]) > 10 and len(met[name]) > len(headers[folder]) + 5
    for name in runtimes:
        expect_files(name, met[name], r"lib/(?:[\w-]+/)?libmesopix_\w+\.so\.[\d.]+")
    expect_files("libmesopix-common-dev", met["libmesopix-common-dev"], cmake + r"(mesopixConfig(Version)?|FindHDF5C)\.cmake")
    if "python3-mesopix" in met:
        modules = {path.name for path in (source / "apps/python/mesopix").iterdir() if path.is_file()}
        place = "lib/python3/dist-packages/mesopix/"
        expect_files("python3-mesopix", met["python3-mesopix"], place + r"_core\.cpython-\w+-[\w-]+\.so",
                     wanted={place + module for module in modules})


def needs():
    """What must be among the dependencies of each package, by their beginnings, and what must not."""
    compiled = ["libc6 (", "libstdc++6 ("]
    specimen = ["libopencv-core", "libopencv-imgproc", "libhdf5-", "libpng", "libjpeg", "libtiff", "libssl"]
    mpm = ["libhdf5-", "libssl"]
    known = {
        "mesopix": ([*compiled, "libcairo2 (", "fonts-dejavu-core", *(runtimes or specimen)], "-dev|python"),
        "python3-mesopix": ([*compiled, "python3 (>= 3", "python3 (<< 3", "python3-numpy", "fonts-dejavu-core",
                             *(runtimes or specimen)], "-dev"),
        "libmesopix-common-dev": ([], "."),
        "libmesopix-specimen-dev": (["libmesopix-common-dev (= ", *([] if shared else specimen)],
                                    r"eigen|-mpm|libstdc|libopencv-\w+\d"),
        "libmesopix-mpm-dev": (["libmesopix-common-dev (= ", "libeigen3-dev", *([] if shared else mpm)],
                               "opencv|png|jpeg|tiff|-specimen|libstdc"),
    }
    for name in runtimes:
        known[name] = ([*compiled, *(specimen if "specimen" in name else mpm)], "-dev")
        known[re.sub(r"[\d.]+$", "-dev", name)][0].append(f"{name} (= ")
    return known


def expect_fields(packages):
    wanted = needs()
    for name, path in packages.items():
        says, (must, must_not) = fields(path), wanted[name]
        depends = says.get("Depends", "").split(", ")
        for need in must:
            assert any(met.startswith(need) for met in depends), f"{name} does not depend on {need}, but on {depends}"
        assert not re.search(must_not, says.get("Depends", "")), f"{name} depends on {depends}"
        assert (says["Version"], says["Source"], says["Priority"]) == (f"{version}-1", "mesopix", "optional"), says
        assert says["Maintainer"].startswith("The mesopix authors"), says["Maintainer"]
        assert says["Architecture"] == run("dpkg", "--print-architecture").strip(), says
        assert says["Section"] in ("science", "python", "libdevel", "libs"), says["Section"]
        summary, *text = says["Description"].splitlines()
        assert summary[0].islower() and len(summary) < 80 and text, says["Description"]
        assert all(4 < len(line) <= 80 for line in text), says["Description"]
        print(f"{name} {says['Version']}: {len(depends)} dependencies, {path.stat().st_size >> 10} KiB")


def expect_use(packages):
    """The program and the Python package, from the folder that they were unpacked to."""
    root = work / "unpacked"
    for path in packages.values():
        run("dpkg-deb", "--extract", path, root)
    mesopix, examples = root / "usr/bin/mesopix", root / "usr/share/doc/mesopix/examples"
    here = dict(os.environ, LD_LIBRARY_PATH=str(next(iter(root.rglob("libmesopix_*.so.*")), root).parent))
    assert run(mesopix, "--version", env=here).split() == ["mesopix", version]
    run(mesopix, "simulate", examples / "two_aggregates.toml", "--stop-strain", "1e-6", "-o", work / "run", env=here)
    assert (work / "run/report.html").exists()
    if "python3-mesopix" in packages:
        packed = dict(here, PYTHONPATH=f"{root}/usr/lib/python3/dist-packages", PYTHONDONTWRITEBYTECODE="1")
        code = "import mesopix; print(mesopix.__file__, mesopix.__version__)"
        said = run("/usr/bin/python3", "-c", code, env=packed, cwd=work).split()
        assert said == [f"{root}/usr/lib/python3/dist-packages/mesopix/__init__.py", version], said
    licence = (root / "usr/share/doc/mesopix/copyright").read_text()
    for line in filter(None, (source / "LICENSE").read_text().splitlines()[3:]):
        assert f"\n {line}\n" in licence, f"copyright lacks: {line}"


packages = pack()
expect_contents(packages)
expect_fields(packages)
expect_use(packages)
