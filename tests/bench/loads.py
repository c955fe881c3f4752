#!/usr/bin/env python3
"""Counts what the sweeps load, a point and step, with and without each feature that a scene can leave out, and what
`mesopix simulate --explain` says that the feature takes in memory. Needs valgrind. Usage: loads.py FEATURE_STEPS"""
import re, subprocess, sys

program = sys.argv[1]
width = {"I32": 4, "F32": 4, "I64": 8, "F64": 8, "I128": 16, "V128": 16, "V256": 32}


def bytes_loaded(case, variant, steps):
    run = subprocess.run(["valgrind", "--tool=lackey", "--detailed-counts=yes", program, str(case), variant, str(steps)],
                         capture_output=True, text=True, check=True)
    loads = {m[1]: int(m[2].replace(",", "")) for m in re.finditer(r"(\w+)\s+([\d,]+)\s+[\d,]+\s+[\d,]+\s*$", run.stderr, re.M)}
    points, done, failures = map(int, run.stdout.split())
    assert failures == 0, "points fail: what that loads is no part of the sweep"
    return sum(width.get(kind, 0) * count for kind, count in loads.items()), points, done


print(f"{'bytes loaded a point and step':44} {'without':>8} {'with':>8} {'more':>8}")
for case, name in enumerate(subprocess.run([program], capture_output=True, text=True).stdout.splitlines()):
    found = []
    for variant in ("without", "with"):
        first, points, few = bytes_loaded(case, variant, 10)
        second, _, many = bytes_loaded(case, variant, 20)
        found.append((second - first) / points / (many - few))
    print(f"{name:44} {found[0]:8.1f} {found[1]:8.1f} {found[1] - found[0]:+8.1f}", flush=True)
