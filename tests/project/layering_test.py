#!/usr/bin/env python3
"""The house rules that a compiler does not check: which file may know what. Usage: layering_test.py SOURCE_DIR"""
import re, subprocess, sys
from pathlib import Path

root = Path(sys.argv[1])
files = subprocess.run(["git", "-C", root, "ls-files"], capture_output=True, text=True).stdout.split() or [
    str(p.relative_to(root)) for p in root.rglob("*") if p.is_file() and p.relative_to(root).parts[0] not in ("build", "runs")]
top_level = {"CMakeLists.txt", "CMakePresets.json", "README.md", "CHANGELOG.md", "CITATION.cff", "LICENSE", "quickstart",
             "check", "pyproject.toml", "specimen", "libmpm", "apps", "data", "docs", "tests"}
libraries = ("specimen/", "libmpm/")
# An include that matches the first may stand only in a file that matches the second.
may_include = [
    (r"apps/", r"(apps|tests)/"),
    (r"tests/", r"tests/"),
    (r"specimen/", r"(specimen|apps|tests)/"),
    (r"libmpm/", r"(libmpm|apps|tests)/"),
    (r"opencv", r"specimen/image_\w+\.[ch]pp$|tests/"),
    (r"hdf5|H5", r"specimen/specimen_file\w*\.[ch]pp$|libmpm/(hdf5|result_file|frame_file|table_file)\w*\.[ch]pp$|tests/"),
    (r"toml|CLI/|cairo|nlohmann", r"(apps|tests)/"),
    (r"iostream", r"(apps|tests)/"),
    (r"pybind11|Python\.h|apps/python/", r"apps/python/"),
]
never_in_libraries = re.compile(r"\b(std::c(out|err|log)|f?printf|puts|perror|(std::)?_?exit|abort|terminate)\s*(\(|<<)")
may_read_environment = {
    "apps/system/other_program.cpp",  # hands it on to the programs that it runs
    "apps/system/terminal.cpp",       # TERM and NO_COLOR: what a terminal can show, and who sits before it wants to see
}
reads_environment = re.compile(r"\b(?:secure_)?getenv\b|\benviron\b")

faults = []
includes = {}
for name in files:
    if name.split("/")[0] not in top_level and not name.startswith("."):
        faults.append(f"{name}: has no place at the top level; allowed: {' '.join(sorted(top_level))}")
    if not name.endswith((".cpp", ".hpp")):
        continue
    text = (root / name).read_text()
    includes[name] = re.findall(r'^\s*#\s*include\s*[<"]([^">]+)', text, re.M)
    for include in includes[name]:
        faults += [f"{name}: includes {include}, which only {where} may do" for what, where in may_include
                   if re.match(what, include) and not re.match(where, name)]
    code = re.sub(r'//.*|"(\\.|[^"\\])*"', "", text)
    if not name.startswith("tests/") and name not in may_read_environment:
        faults += [f"{name}: {word}: settings come from options and scenes, which a run writes down, never from the environment"
                   for word in reads_environment.findall(code)]
    if name.startswith(libraries):
        faults += [f"{name}: {m.group(0)}: a library never prints and never exits"
                   for m in never_in_libraries.finditer(code)]


def look_for_cycle(name, path):
    if name in path:
        faults.append("a circle of includes: " + " -> ".join(path[path.index(name):] + [name]))
        return
    if name not in seen:
        for include in includes.get(name, []):
            look_for_cycle(include, path + [name])
        seen.add(name)


seen = set()
for name in includes:
    if name.endswith(".hpp"):
        look_for_cycle(name, [])

print("\n".join(faults) or f"{len(includes)} files keep the rules")
sys.exit(bool(faults) or len(includes) < 10)
