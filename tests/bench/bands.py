#!/usr/bin/env python3
"""Peaks of the paper's tests on generated specimens, beside the bands of an independent implementation.

    python3 tests/bench/bands.py build/release/bin/mesopix [--seeds 3] [--only tension]

Each case is the mean of as many specimens (packing and strengths of seed 1, 2, ...). The bands are those of one other
mask, so a few per cent of difference are expected; more than 10 % is marked, and the exit code is then 1.
"""
import argparse
import concurrent.futures
import json
import pathlib
import subprocess
import sys
import tempfile

TENSION = ["--velocity", "0.05 m/s", "--stop-strain", "4e-4"]
COMPRESSION = ["--direction", "compression", "--velocity", "0.2 m/s", "--stop-strain", "3e-3"]
CLOSURE = ["--direction", "compression", "--velocity", "0.4 m/s", "--stop-strain", "5e-3",
           "--crack-closure", "clipped"]


def modulus(m):
    return ["--mortar.weibull-modulus", str(m), "--itz.weibull-modulus", str(m)]


def strength(mortar):
    """The ITZ keeps its share of 0.6 of the mortar, as in Table 1."""
    return ["--mortar.tensile-scale", f"{mortar} MPa", "--itz.tensile-scale", f"{0.6 * mortar} MPa"]


def cohesion(mortar):
    return ["--mortar.cohesion", f"{mortar} MPa", "--itz.cohesion", f"{0.6 * mortar} MPa"]


def pixel(mm):
    return ["--pixel-size", f"{mm} mm"]


# name, options of generate, options of simulate, band of the peak stress [MPa], band of the peak strain [1e-6]
CASES = [
    ("tension, 0.05 m/s", [], TENSION, 3.50, 149),
    ("tension, 0.02 m/s", [], TENSION + ["--velocity", "0.02 m/s"], 3.43, 144),
    ("compression, smooth", [], COMPRESSION, 24.1, 940),
    ("compression, rough", [], COMPRESSION + ["--platen", "rough"], 26.8, 980),
    *[(f"tension, m = {m}", [], TENSION + modulus(m), s, e)
      for m, s, e in [(1, 2.99, 146), (2, 3.76, 149), (3, 4.46, 167), (6, 5.41, 200)]],
    *[(f"compression, m = {m}", [], COMPRESSION + modulus(m), s, e)
      for m, s, e in [(1, 17.8, 756), (2, 31.3, 1181), (3, 36.2, 1338), (6, 46.1, 1708)]],
    *[(f"tension, f_t = {f} MPa", [], TENSION + strength(f), s, e)
      for f, s, e in [(5, 1.19, 49), (10, 2.35, 97), (20, 4.58, 192), (25, 5.76, 239)]],
    *[(f"compression, f_t = {f} MPa", [], COMPRESSION + strength(f), s, None)
      for f, s in [(5, 8.6), (10, 16.9), (20, 31.7), (25, 39.3)]],
    *[(f"compression, c = {c} MPa", [], COMPRESSION + cohesion(c), s, None) for c, s in [(110, 24.2), (190, 24.4)]],
    *[(f"compression, cracks close, c = {c} MPa", [], CLOSURE + cohesion(c), s, None)
      for c, s in [(110, 71), (150, 75), (190, 76)]],
    ("tension, pixel 1 mm", pixel(1), TENSION, 3.68, None),
    ("tension, pixel 0.25 mm", pixel(0.25), TENSION, 2.99, None),
    ("two aggregates, f_t = 15 MPa", None, TENSION + ["--velocity", "0.02 m/s"], 3.2, 162),
    ("two aggregates, f_t = 8 MPa", None, TENSION + ["--velocity", "0.02 m/s"] + strength(8), 1.73, 88),
]


def without_repeats(options):
    """Of an option given twice the last one holds."""
    chosen = dict(zip(options[::2], options[1::2]))
    return [word for pair in chosen.items() for word in pair]


def run(program, folder, case, seed):
    name, generate, simulate, _, _ = case
    where = pathlib.Path(folder) / f"{abs(hash((name, seed)))}"
    where.mkdir()
    if generate is None:
        specimen = str(pathlib.Path(__file__).parents[2] / "data" / "two_aggregates.toml")
    else:
        specimen = str(where / "specimen.h5")
        subprocess.run([program, "generate", "-o", specimen, "--quiet", "--set", f"generate.seed={seed}", *generate],
                       check=True)
    done = subprocess.run([program, "simulate", specimen, "-o", str(where / "run"), "--quiet", "--json",
                           "--set", f"damage.seed={seed}", *without_repeats(simulate)],
                          check=True, capture_output=True, text=True)
    return json.loads(done.stdout)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--seeds", type=int, default=3)
    parser.add_argument("--only", default="", help="cases whose name holds this")
    parser.add_argument("--jobs", type=int, default=2)
    arguments = parser.parse_args()
    cases = [case for case in CASES if arguments.only in case[0]]
    outside = 0
    print(f"{'case':40} {'peak MPa':>9} {'band':>6} {'off %':>6}   {'at 1e-6':>8} {'band':>5} {'off %':>6}   shear %")
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        jobs = [[pool.submit(run, arguments.program, folder, case, seed + 1) for seed in range(arguments.seeds)]
                for case in cases]
        for (name, _, _, stress_band, strain_band), futures in zip(cases, jobs):
            results = [future.result() for future in futures]
            count = len(results)
            stress = sum(r["peak_stress_Pa"] for r in results) / count / 1e6
            strain = sum(r["peak_strain"] for r in results) / count * 1e6
            shear = sum(r["shear_failures"] for r in results)
            failures = max(1, shear + sum(r["tension_failures"] for r in results))
            off = 100 * (stress / stress_band - 1)
            line = f"{name:40} {stress:9.3f} {stress_band:6.2f} {off:+6.1f}   {strain:8.0f}"
            bad = abs(off) > 10
            if strain_band:
                strain_off = 100 * (strain / strain_band - 1)
                bad = bad or abs(strain_off) > 10
                line += f" {strain_band:5.0f} {strain_off:+6.1f}"
            else:
                line += " " * 13
            print(line + f"   {100 * shear / failures:7.1f}" + ("   <-- more than 10 %" if bad else ""), flush=True)
            outside += bad
    print(f"{len(cases) - outside} of {len(cases)} cases within 10 %")
    return 1 if outside else 0


if __name__ == "__main__":
    sys.exit(main())
