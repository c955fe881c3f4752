#!/usr/bin/env python3
"""One version, that of CMakeLists.txt, wherever one is written down. Usage: version_test.py SOURCE_DIR MESOPIX"""
import re, subprocess, sys, tomllib
from pathlib import Path

import yaml

root, mesopix = Path(sys.argv[1]), sys.argv[2]
sys.path.insert(0, str(root / "apps/python"))
sys.dont_write_bytecode = True
import wheel_by_cmake


def found(pattern, name):
    match = re.search(pattern, (root / name).read_text(), re.M)
    assert match, f"{name}: names no version"
    return match[1]


project = found(r"^project\(mesopix VERSION (\S+)", "CMakeLists.txt")
versions = {
    "CITATION.cff": yaml.safe_load((root / "CITATION.cff").read_text())["version"],
    ".packaging/conda/meta.yaml": found(r'{% set version = "(.*?)" %}', ".packaging/conda/meta.yaml"),
    ".packaging/spack/package.py": found(r'^    version\("(.*?)"', ".packaging/spack/package.py"),
    "apps/python/wheel_by_cmake.py": wheel_by_cmake.version(),
    "mesopix --version": subprocess.run([mesopix, "--version"], capture_output=True, text=True, check=True).stdout.split()[-1],
}
python = tomllib.loads((root / "pyproject.toml").read_text())["project"]
assert "version" in python["dynamic"] and "version" not in python, "pyproject.toml: the version comes from CMakeLists.txt alone"

# What is not released yet has no number; of the releases, none may be newer than the project.
sections = re.findall(r"^## \[(.*?)\](?: - (\d{4}-\d\d-\d\d))?$", (root / "CHANGELOG.md").read_text(), re.M)
assert sections and sections[0][0] == "Unreleased", "CHANGELOG.md: the first section is not [Unreleased]"
numbers = [tuple(map(int, name.split("."))) for name, _ in sections[1:]]
assert all(date for _, date in sections[1:]), "CHANGELOG.md: a release has no date"
assert numbers == sorted(numbers, reverse=True), "CHANGELOG.md: the releases are not in their order, the newest first"
if numbers and numbers[0] > tuple(map(int, project.split("."))):
    versions["CHANGELOG.md"] = sections[1][0]

wrong = {name: version for name, version in versions.items() if str(version) != project}
print(f"CMakeLists.txt: {project}; elsewhere: {versions}")
sys.exit(f"not {project}: {wrong}" if wrong else 0)
