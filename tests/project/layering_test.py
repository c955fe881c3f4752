#!/usr/bin/env python3
"""The house rules that a compiler does not check: which file may know what. Usage: layering_test.py SOURCE_DIR"""
import re, subprocess, sys
from pathlib import Path

root = Path(sys.argv[1])
files = subprocess.run(["git", "-C", root, "ls-files"], capture_output=True, text=True).stdout.split() or [
    str(p.relative_to(root)) for p in root.rglob("*") if p.is_file() and p.relative_to(root).parts[0] not in ("build", "runs")]
top_level = {"CMakeLists.txt", "CMakePresets.json", "README.md", "CHANGELOG.md", "CITATION.cff", "LICENSE", "quickstart",
             "check", "pyproject.toml", "specimen", "libmpm", "apps", "data", "docs", "tests", "findings"}
libraries = ("specimen/", "libmpm/")

# Who may include whom. A room may include its own headers, those of the rooms behind it, and whatever these may include;
# of the two libraries the program may include what is installed. "apps" is main() and what it is linked with.
rooms = {
    "specimen/body": "",
    "specimen/picture": "specimen/body",
    "specimen/teach": "specimen/picture",
    "specimen/convert": "specimen/teach",
    "specimen/pack": "specimen/body",
    "specimen/describe": "specimen/pack specimen/picture",
    "specimen/file": "specimen/body",
    "libmpm/scene": "",
    "libmpm/material": "libmpm/scene",
    "libmpm/kernels": "libmpm/material",
    "libmpm/solver": "libmpm/kernels",
    "libmpm/solver/lattice": "libmpm/solver",
    "libmpm/solver/moving": "libmpm/solver",
    "libmpm/solver/quasi_static": "libmpm/solver/lattice",
    "libmpm/run": "libmpm/solver/lattice libmpm/solver/moving libmpm/solver/quasi_static",
    "libmpm/files": "libmpm/solver",
    "libmpm/problems": "libmpm/run",
    "apps/text": "",
    "apps/system": "apps/text",
    "apps/statistics": "",
    "apps/export": "",
    "apps/drawing": "apps/text",
    "apps/report": "apps/drawing",
    "apps/settings": "apps/system",
    "apps/scene": "apps/settings",
    "apps/live": "apps/report apps/system",
    "apps/job": "apps/scene",
    "apps/edit": "apps/job apps/live",
    "apps/run": "apps/job apps/live apps/statistics",
    "apps/twin": "apps/job apps/report",
    "apps/calibrate": "apps/run",
    "apps/study": "apps/run",
    "apps/command": "apps/study apps/calibrate apps/twin apps/edit apps/export",
    "apps/reproduce": "apps/command",
    "apps/bench": "apps/reproduce libmpm/problems",
    "apps": "apps/bench",
    "apps/manual": "apps",
    "apps/python": "apps/study apps/calibrate apps/twin",
}
# Rooms of the program that look behind what the libraries install, and where.
sees_inside = {
    "apps/system": "libmpm/kernels libmpm/solver",                   # doctor: instruction sets, idle cores
    "apps/run": "libmpm/solver specimen/convert",                    # the time step; pixels twice as large
    "apps/edit": "specimen/convert",                                 # sketches, and strokes as they are read
    "apps/command": "libmpm/kernels libmpm/solver libmpm/files specimen/picture",  # scene check and doctor
    "apps/bench": "libmpm/kernels libmpm/material libmpm/solver libmpm/solver/lattice libmpm/solver/moving libmpm/problems",
    "apps/python": "specimen/picture",                               # pictures that come as arrays
}
# An include that matches the first may stand only in a file that matches the second.
may_include = [
    (r"tests/", r"tests/"),
    (r"opencv", r"specimen/(picture|teach|convert)/|tests/"),
    (r"hdf5|H5", r"specimen/file/|libmpm/files/|tests/"),
    (r"toml|CLI/|cairo|nlohmann", r"(apps|tests)/"),
    (r"iostream", r"(apps|tests)/"),
    (r"pybind11|Python\.h", r"apps/python/"),
]
never_in_libraries = re.compile(r"\b(std::c(out|err|log)|f?printf|puts|perror|(std::)?_?exit|abort|terminate)\s*(\(|<<)")
may_read_environment = {
    "apps/system/browser.cpp",    # DISPLAY: whether there is a screen
    "apps/system/processes.cpp",  # hands it on to the programs that it runs
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


def room_of(name):
    return name.rpartition("/")[0]


def closure(room):
    """The rooms that one may include. A circle in the table ends in a fault."""
    found, todo = {room}, rooms[room].split()
    while todo:
        one = todo.pop()
        if one == room:
            faults.append(f"the table of rooms has a circle through {room}")
        elif one not in found:
            found.add(one)
            todo += rooms[one].split()
    return found


def installed_headers():
    headers = set()
    for library in ("specimen", "libmpm"):
        text = (root / library / "CMakeLists.txt").read_text()
        listed = re.search(r"FILE_SET HEADERS BASE_DIRS \S+ FILES([^)]*)\)", text).group(1)
        headers |= {f"{library}/{name}" for name in listed.split()}
    return headers


def check_rooms():
    installed = installed_headers()
    allowed = {room: closure(room) for room in rooms}
    for name, found in includes.items():
        room = room_of(name)
        if name.startswith("tests/"):
            continue
        if room not in rooms:
            faults.append(f"{name}: {room} is no room; the rooms are in tests/project/layering_test.py")
            continue
        for include in found:
            other = room_of(include)
            if other not in rooms or other in allowed[room]:
                continue
            if room.startswith("apps") and other.startswith(libraries):
                if include in installed or other in sees_inside.get(room, "").split():
                    continue
            faults.append(f"{name}: includes {include}, but {room} may not include {other}")


def check_links():
    """A room of the program links just the rooms that its row names, so that table and build tell the same."""
    text = (root / "apps/CMakeLists.txt").read_text()
    linked = {f"apps/{name}": set(re.findall(r"mesopix_(\w+)", links)) for name, links in re.findall(
        r"add_room\((\w+)(?: LINK ([^\n]*))?\n", text)}
    for room, found in linked.items():
        wanted = {other[len("apps/"):] for other in rooms[room].split() if other.startswith("apps/")}
        if room != "apps/manual" and found != wanted:
            faults.append(f"apps/CMakeLists.txt: {room} links {sorted(found)}, the table says {sorted(wanted)}")


def check_mirror():
    """tests/ROOM/x_test.cpp tests ROOM/x.cpp or ROOM/x.hpp, and so does tests/ROOM/x_of_something_test.cpp."""
    units = {room: {name.rpartition("/")[2].split(".")[0] for name in files
                    if room_of(name) == room and name.endswith((".cpp", ".hpp", ".cpp.in"))} for room in rooms}
    for name in files:
        if not re.match(r"tests/.*_test\.cpp$", name) or name.startswith("tests/libmpm/verification/"):
            continue
        room = room_of(name)[len("tests/"):]
        stem = name.rpartition("/")[2][:-len("_test.cpp")]
        if room not in rooms:
            faults.append(f"{name}: {room} is no room; the rooms are in tests/project/layering_test.py")
        elif not any(stem == unit or stem.startswith(unit + "_") for unit in units[room]):
            faults.append(f"{name}: mirrors no source: {room}/{stem}.cpp is not there, nor one whose name begins it")


check_rooms()
check_links()
check_mirror()


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
