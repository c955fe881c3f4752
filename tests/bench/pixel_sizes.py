#!/usr/bin/env python3
"""Whether the peak and the energy of a specimen settle when its picture is refined: the same ellipses and the same strength
field with pixels of four sizes.
    tests/bench/pixel_sizes.py build/release/bin/mesopix [--cells "pixel,2 x 2"] [--law brittle|band] [--direction tension]
                               [--method explicit|quasi_static] [--seeds 10] [--pixels 1,0.5,0.25,0.125] [--width 32]
Prints peak [MPa] and released energy [J/m2 of the cross-section] of every run, and mean changes from each size to the next."""
import argparse
import csv
import json
import statistics
import subprocess
import sys
import tempfile

SCENE = """
[generate]
width = "{width} mm"
height = "{width} mm"
fraction = "40 %"
d_min = "{d_min} mm"
d_max = "{d_max} mm"
[itz]
thickness = "1 mm"
[loading]
direction = "{direction}"
stop_drop = {drop}
stop_strain = {stop}
[damage]
crack_closure = "{closure}"
correlation_length = "{length}"
"""
BANDS = """
[phases.mortar]
tensile_scale = "4 MPa"
weibull_modulus = 12
fracture_energy = "60 J/m2"{mortar}
[phases.itz]
tensile_scale = "2.4 MPa"
weibull_modulus = 12
fracture_energy = "25 J/m2"{itz}
"""
# In compression cracks close, and what ends the test is shear, which takes ten times the energy of a crack.
SHEAR = """
cohesion = "{cohesion} MPa"
friction_angle = "35 deg"
shear_fracture_energy = "{energy} J/m2\""""


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--cells", default="pixel,2 x 2")
    parser.add_argument("--law", default="band")
    parser.add_argument("--direction", default="tension")
    parser.add_argument("--method", default="explicit")
    parser.add_argument("--seeds", type=int, default=10)
    parser.add_argument("--pixels", default="1,0.5,0.25,0.125")
    parser.add_argument("--length", default="2 mm")
    parser.add_argument("--drop", default="0.2")
    parser.add_argument("--width", type=float, default=32, help="of the specimen in mm; the aggregates have 3/16 to 3/8 of it")
    parser.add_argument("--more", default="", help="options for mesopix simulate")
    args = parser.parse_args()
    pixels = args.pixels.split(",")
    with tempfile.TemporaryDirectory() as folder:
        scene = folder + "/scene.toml"
        pressed = args.direction == "compression" and args.law == "band"
        mortar, itz = (SHEAR.format(cohesion=c, energy=g) if pressed else "" for c, g in ((8, 600), (5, 250)))
        with open(scene, "w", encoding="utf-8") as file:
            file.write(SCENE.format(width=args.width, d_min=args.width * 3 / 16, d_max=args.width * 3 / 8, direction=args.direction, length=args.length, closure="unilateral" if pressed else "off",
                                    drop=args.drop, stop="2e-3" if args.direction == "tension" else "2e-2")
                       + (BANDS.format(mortar=mortar, itz=itz) if args.law == "band" else ""))

        def run(cell, pixel, seed):
            done = subprocess.run([args.program, "simulate", scene, f"--generate.pixel-size={pixel} mm", "--cell", cell,
                                   f"--damage.seed={seed}", f"--generate.seed={seed}", "--method", args.method, *args.more.split(), "-o", folder + "/run",
                                   "--overwrite", "--json", "-q"], capture_output=True, text=True)
            if done.returncode: sys.exit(done.stderr)
            with open(folder + "/run/curve.csv", encoding="utf-8") as curve:
                last = list(csv.DictReader(curve))[-1]
            return json.loads(done.stdout) | {"released_J_per_m": float(last["released_J_per_m"])}

        for cell in args.cells.split(","):
            peaks, energies = [], []
            for seed in range(1, args.seeds + 1):
                rows = [run(cell, pixel, seed) for pixel in pixels]
                peaks.append([1e-6 * row["peak_stress_Pa"] for row in rows])
                energies.append([row["released_J_per_m"] / (1e-3 * args.width) for row in rows])
                print(f"{cell:6} {seed:4}  " + "".join(f"{v:8.3f}" for v in peaks[-1]) + "  |" + "".join(f"{v:9.3f}" for v in energies[-1])
                      + "  |" + "".join(f"{row['wall_s']:8.2f}" for row in rows), flush=True)
            for name, table in (("peak", peaks), ("energy", energies)):
                means = [statistics.mean(column) for column in zip(*table)]
                print(f"{cell:6} {name:7}" + "".join(f"{value:9.3f}" for value in means) + "   change "
                      + "".join(f"{100 * (b / a - 1):8.2f} %" for a, b in zip(means, means[1:])), flush=True)


if __name__ == "__main__":
    main()
