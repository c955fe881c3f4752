#!/usr/bin/env python3
"""Holds scenes against their JSON Schema with a validator of others. Usage: scene_schema_test.py MESOPIX DATA_DIR"""
import json, subprocess, sys, tempfile, tomllib
from pathlib import Path

import jsonschema

mesopix, data = Path(sys.argv[1]).resolve(), Path(sys.argv[2])


def said(*words):
    return subprocess.run([mesopix, *words], capture_output=True, text=True, check=True).stdout


schema = json.loads(said("scene", "schema"))
jsonschema.Draft7Validator.check_schema(schema)
validator = jsonschema.Draft7Validator(schema)


def faults(text):
    return [f"{'.'.join(map(str, error.absolute_path))}: {error.message}" for error in validator.iter_errors(tomllib.loads(text))]


scenes = [path for path in sorted(data.rglob("*.toml")) if "scene" not in tomllib.loads(path.read_text())]
assert len(scenes) >= 6, scenes
for path in scenes:
    assert not faults(path.read_text()), f"{path}: {faults(path.read_text())}"
    resolved = said("simulate", path, "--print-scene")
    assert not faults(resolved), f"{path}, resolved: {faults(resolved)}"
with tempfile.TemporaryDirectory() as folder:
    for loading in ("tension", "compression", "none"):
        begun = Path(folder) / f"{loading}.toml"
        said("scene", "init", "-q", begun, "--loading", loading)
        whole = "\n".join(line[1:] if line[:1] == "#" and line[1:2] not in (" ", "") else line for line in begun.read_text().splitlines())
        assert whole != begun.read_text() and not faults(whole), f"{loading}: {faults(whole)}"

allowed = [
    "[loading]\nvelocity = '+1.5e-1m/s'",
    "[generate]\nfraction = '40 %'",
    "[generate]\nclasses = ['5 mm .. 10 mm: 40 %', '10 mm .. 20 mm: 60 %']",
    "[generate]\ngap = '0 mm'",
    "[loading]\nstop_drop = 'none'",
    "[loading]\ninitial_velocity_y = '-3 m/s'",
    "[solver]\nthreads = 'auto'",
    "[convert]\ncrop = [1, 2, 3, 4]",
    "[convert]\ncrop = []",
    "[convert]\nthresholds = [80, 160.5]",
    "[convert]\nlabel_phases = ['0: void']",
    "[phases.steel-fibre]\nyoung = '200 GPa'\ntensile_scale = 'unbreakable'",
]
refused = [
    "velocity = '1 m/s'",  # in no table
    "[loading]\nvelocty = '1 m/s'",
    "[loadng]\nvelocity = '1 m/s'",
    "[loading]\nvelocity = 1",
    "[loading]\nvelocity = '1 mm'",
    "[loading]\nvelocity = '-1 m/s'",
    "[loading]\nvelocity = '0.0 m/s'",
    "[loading]\nvelocity = 'fast'",
    "[loading]\ndirection = 'tensile'",
    "[loading]\nstop_drop = 1",
    "[loading]\nstop_drop = 0.0",
    "[loading]\nseparation = 1",
    "[generate]\ngap = '-1 mm'",
    "[generate]\nseed = 1.5",
    "[generate]\nfraction = 1.5",
    "[solver]\nthreads = 0",
    "[solver]\nthreads = 'many'",
    "[convert]\ncrop = [1, 2, 3]",
    "[convert]\nlabel_phases = ['void']",
    "[convert]\nclass_phases = ['']",
    "[output]\ntitle = 3",
    "[phases.mortar]\ncolour = 'grey'",
    "[phases.mortar]\npoisson = 0.6",
    "[phases.'a b']\nyoung = '1 GPa'",
    "[phases.fibre]\nyoung = '1 m'",
    "ellipses = [{x = '1 mm', y = '1 mm', a = '1 mm'}]",
    "ellipses = [{x = '1 mm', y = '1 mm', a = '1 mm', b = '1 mm', c = '1 mm'}]",
    "loading = 3",
]
for text in allowed:
    assert not faults(text), f"{text!r}: {faults(text)}"
for text in refused:
    assert faults(text), f"{text!r} is let through"
print(f"{len(scenes)} scenes hold, {len(refused)} wrong ones do not")
