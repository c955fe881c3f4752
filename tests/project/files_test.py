#!/usr/bin/env python3
"""Runs scenes, and compares what they leave with what docs/files.md says: every file, dataset, attribute, column and key that
is there must stand on the page, and the other way round. Usage: files_test.py SOURCE_DIR MESOPIX"""
import csv, json, os, re, signal, subprocess, sys, tempfile, time
from pathlib import Path

import h5py
import numpy as np

source, mesopix = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
page = (source / "docs/files.md").read_text()


def tables(heading):
    """Tables of a section: lists of rows, each a dictionary by the names of the columns."""
    section = re.search(rf"^## {re.escape(heading)}\n(.*?)(?=^## |\Z)", page, re.S | re.M)[1]
    for block in re.findall(r"(?:^\|.*\n)+", section, re.M):
        names, _, *rows = [[cell.strip() for cell in line.strip("|\n").split("|")] for line in block.splitlines()]
        yield [dict(zip(names, row, strict=True)) for row in rows]


def quoted(text):
    return re.findall(r"`([^`]+)`", text)


def names_of(table, column):
    return [name for row in table for name in quoted(row[column])]


def pattern_of(name):
    return re.compile(re.escape(name).replace("NNN", r"\d+").replace("ID", "[0-9a-f]{16}"))


def run(*words, code=0):
    met = subprocess.run([mesopix, *words, "-q"], capture_output=True, text=True)
    assert met.returncode == code, f"{words}: exit code {met.returncode}, not {code}: {met.stderr}"


def compare(what, there, told):
    assert there == told, f"{what}: on the page alone: {sorted(told - there)}; not on the page: {sorted(there - told)}"


def check_folders(heading, folders):
    """Every file matches a name of the page, and every name has a file in some folder."""
    patterns = {name: pattern_of(name) for name in names_of(next(tables(heading)), "file")}
    seen = set()
    for folder in folders:
        for path in (p for p in folder.rglob("*") if p.is_file()):
            name = str(path.relative_to(folder))
            matching = [told for told, pattern in patterns.items() if pattern.fullmatch(name)]
            assert matching, f"{heading}: {name} is not on the page"
            seen.update(matching)
    compare(heading, seen, set(patterns))


def value_of(text, known):
    """Extent that the page gives, "N + 1"; a letter means whatever stands in the file first."""
    name, *more = text.split(" + ")
    if name.isdigit():
        return int(name)
    return None if name not in known else known[name] + sum(map(int, more))


def check_dataset(where, dataset, row, known):
    kinds = row["type"].split(" or ")
    kind = "text" if dataset.dtype.kind == "S" else "record" if dataset.dtype.names else str(dataset.dtype)
    assert kind in kinds, f"{where}: type {kind}, not {row['type']}"
    extents = row["shape"].strip("()").split(", ")
    assert len(extents) == len(dataset.shape), f"{where}: shape {dataset.shape}, not {row['shape']}"
    for extent, met in zip(extents, dataset.shape):
        told = value_of(extent, known)
        if told is None:
            known[extent] = met
        else:
            assert told == met, f"{where}: {extent} is {met}, and was {told} before"
    unit = dataset.attrs.get("unit", "")
    unit = unit.decode() if isinstance(unit, bytes) else unit
    if row["unit"] != "as above":
        assert unit == row["unit"], f"{where}: unit {unit!r}, not {row['unit']!r}"


def datasets_of(path):
    found = {}
    with h5py.File(path) as file:
        file.visititems(lambda name, item: found.update({name: item.shape}) if isinstance(item, h5py.Dataset) else None)
    return set(found)


def check_datasets(heading, paths, entries=lambda name: [name]):
    """@param entries  datasets that a name of the page stands for."""
    rows = {name: row for row in next(tables(heading)) for told in quoted(row["dataset"]) for name in entries(told)}
    seen = set()
    for path in paths:
        there = datasets_of(path)
        compare(path, there - set(rows), set())
        seen |= there
        known = {}
        with h5py.File(path) as file:
            for name in sorted(there, key=list(rows).index):
                check_dataset(f"{path}: {name}", file[name], rows[name], known)
    compare(heading, seen, set(rows))


def history():
    """Columns of curve.csv, and their names and units in result.h5."""
    rows = next(tables("History"))
    names = names_of(rows, "column")
    bare = [re.sub("(_s|_Pa|_J_per_m)$", "", name) for name in names]
    return names, bare, rows


def check_history(folder):
    names, bare, rows = history()
    with open(folder / "curve.csv") as file:
        compare("curve.csv", set(next(csv.reader(file))), set(names))
    with h5py.File(folder / "result.h5") as file:
        for name, row in zip(bare, rows, strict=True):
            check_dataset(name, file["history"][name], {**row, "shape": "(T)"}, {})


def check_attributes(path, told):
    with h5py.File(path) as file:
        compare(path, set(file.attrs), set(told))


def check_specimen_words(path):
    """What the text says of attributes and of fields."""
    section = re.search(r"^## specimen.h5\n(.*?)(?=^## )", page, re.S | re.M)[1].split("Fields of", 1)[1]
    told = set(quoted(section))
    with h5py.File(path) as file:
        there = set(file.attrs) | set(file["rings"].attrs) | set(file["provenance"].attrs) | set(file["inclusions"].dtype.names)
        there |= set(file["inclusions"].attrs) | {"inclusions", "rings", "provenance"}
    compare("specimen.h5", there, told)


def check_summary(folders):
    told = set(names_of(next(tables("summary.json")), "key"))
    there = set().union(*(json.loads((folder / "summary.json").read_text()) for folder in folders))
    compare("summary.json", there, told)


def check_study_table(folder, keys):
    _, columns = tables("Folder of a study")
    told = set(names_of(columns, "column"))
    with open(folder / "table.csv") as file:
        there = set(next(csv.reader(file)))
    compare("table.csv", {name for name in there if not name.startswith(keys)}, told)
    bare = {re.sub("(_s|_Pa|_J_per_m)$", "", name) for name in told}
    compare("table.h5", {name for name in datasets_of(folder / "table.h5") if not name.startswith(keys)}, bare)
    with open(folder / "timing.csv") as file:
        first = next(tables("Folder of a study"))
        timing = next(row["what it holds"] for row in first if "`timing.csv`" in row["file"])
        assert next(csv.reader(file)) == quoted(timing), timing


moving_disc = f"""
[specimen]
picture = "{source}/data/disc.png"
[convert]
label_phases = ["0: void", "112: aggregate", "226: mortar"]
pixel_size = "0.5 mm"
pixels = 60
[itz]
mode = "points"
[damage]
crack_closure = "unilateral"
[loading]
direction = "compression"
velocity = "1 m/s"
separation = true
stop_strain = 4e-3
[solver]
kinematics = "moving"
[motion]
deformation_gradient = true
"""
small = str(source / "data/small_tension.toml")


def run_that_is_stopped(folder):
    """Ctrl-C once there is something to go on from."""
    words = ["simulate", small, "--velocity", "1e-4 m/s", "--checkpoint-every", "0.2 s", "-q", "-o", str(folder)]
    program = subprocess.Popen([mesopix, *words], stderr=subprocess.DEVNULL)
    until = time.monotonic() + 60
    while not list(folder.glob("checkpoints/*.checkpoint")) and time.monotonic() < until:
        time.sleep(0.05)
    program.send_signal(signal.SIGINT)
    assert program.wait(60) == 75, program.returncode


def study(folder):
    """Of a member that is refused, and of one that is done."""
    Path("study.toml").write_text(f'title = "Some"\nscene = "{small}"\nseeds = 1\n[vary]\n'
                                  '"phases.mortar.fracture_energy" = ["brittle", "0.01 J/m2"]\n')
    run("study", "study.toml", "-o", str(folder), code=65)


def study_that_is_stopped(folder):
    """Ctrl-C while its members run, which leave what they can go on from; sooner or later, for a machine that others use too."""
    Path("slow.toml").write_text(f'title = "Slow"\nscene = "{small}"\nseeds = 1\n[vary]\n"loading.velocity" = ["1e-4 m/s"]\n')
    for patience in (1, 4, 16):
        program = subprocess.Popen([mesopix, "study", "slow.toml", "-q", "-o", folder], stderr=subprocess.DEVNULL)
        time.sleep(patience)
        program.send_signal(signal.SIGINT)
        assert program.wait(60) in (75, -signal.SIGINT), program.returncode
        if list(folder.glob("members/*/checkpoints/*")):
            return
    assert False, "a study that was stopped kept nothing"


with tempfile.TemporaryDirectory() as scratch:
    os.chdir(scratch)
    here = Path(scratch)
    Path("disc.toml").write_text(moving_disc)
    run("simulate", small, "--frames", "2", "--estimate-error", "-o", "tension")
    run("simulate", "disc.toml", "-o", "disc")
    run("simulate", small, "--method", "quasi_static", "--generate.pixel-size", "1 mm", "-o", "still")
    run_that_is_stopped(here / "stopped")
    check_folders("Folder of a run", [here / "tension", here / "disc", here / "stopped"])
    check_history(here / "tension")
    results = [here / "tension/result.h5", here / "disc/result.h5"]
    check_datasets("result.h5", results, lambda name: [f"history/{one}" for one in history()[1]] if "NAME" in name else [name])
    check_attributes(results[0], names_of(list(tables("result.h5"))[1], "attribute"))
    halves = b"".join(bytes((200, 180, 140) * 60 + (110, 120, 150) * 60) for _ in range(120))
    Path("halves.ppm").write_bytes(b"P6 120 120 255\n" + halves)  # either may be the mortar
    run("convert", "halves.ppm", "--width", "60 mm", "--method", "kmeans", "-o", "doubtful.h5")
    check_datasets("specimen.h5", [here / "tension/specimen.h5", here / "disc/specimen.h5", here / "doubtful.h5"])
    check_specimen_words(here / "tension/specimen.h5")
    check_datasets("Frames", sorted(here.glob("tension/frames/*.hdf")))
    check_summary([here / "tension", here / "disc", here / "still"])

    study(here / "study")
    check_study_table(here / "study", "phases.")
    run("twin", str(source / "data/concrete.png"), "--width", "150 mm", "--pixels", "100", "-n", "1", "-o", "twins")
    check_folders("Folder of twins", [here / "twins"])
    run("calibrate", small, "--peak-stress", "4 MPa", "--seeds", "1", "--tolerance", "20 %", "-o", "fit")
    check_folders("Folder of a calibration", [here / "fit"])
    study_that_is_stopped(here / "stopped_study")
    check_folders("Folder of a study", [here / "study", here / "stopped_study"])
print("what runs leave is what docs/files.md says")
