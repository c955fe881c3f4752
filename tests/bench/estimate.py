#!/usr/bin/env python3
"""Whether the estimated error of a peak covers its true one, and whether a tolerance is kept. The truth is the peak of the
same specimen, strength field and pixels without waves, failures within 0.2 % of strain at once; so the part of the estimate
that belongs to the pixel size is left out.
    tests/bench/estimate.py build/release/bin/mesopix [SEEDS]
Two specimens, two pixel sizes, tension and compression; prints a line a run, and the share of estimates that cover the error,
the median of estimate over error, and the share of tolerances of 2 % that were kept."""
import json
import statistics
import subprocess
import sys
import tempfile

SPECIMENS = {"two": """
ellipses = [
  {{x = "13 mm", y = "25 mm", a = "10 mm", b = "8 mm", angle = "70 deg"}},
  {{x = "37 mm", y = "25.5 mm", a = "9.5 mm", b = "8.5 mm", angle = "110 deg"}},
]
[generate]
width = "50 mm"
height = "50 mm"
""", "many": """
[generate]
width = "50 mm"
height = "50 mm"
fraction = "40 %"
d_min = "5 mm"
d_max = "14 mm"
"""}
LOADING = """
pixel_size = "{pixel} mm"
[loading]
direction = "{direction}"
velocity = "{velocity} m/s"
stop_drop = 0.5
stop_strain = {stop}
[damage]
seed = {seed}
"""


def main():
    program = sys.argv[1]
    seeds = int(sys.argv[2]) if len(sys.argv) > 2 else 10
    covered, ratios, kept = [], [], []
    with tempfile.TemporaryDirectory() as folder:
        def run(scene, *options):
            with open(folder + "/scene.toml", "w", encoding="utf-8") as file:
                file.write(scene)
            done = subprocess.run([program, "simulate", folder + "/scene.toml", *options, "-o", folder + "/run", "--overwrite", "--json", "-q"],
                                  capture_output=True, text=True)
            return json.loads(done.stdout) if done.returncode == 0 else None

        print("specimen pixel load         seed    truth      run  error %  estimate %   ratio   tolerance 2 %: peak, error %")
        for name, specimen in SPECIMENS.items():
            for pixel in ("1", "0.5"):
                for direction, velocity, stop in (("tension", 0.1, "1e-3"), ("compression", 0.4, "6e-3")):
                    for seed in range(1, seeds + 1):
                        scene = (specimen + LOADING).format(pixel=pixel, direction=direction, velocity=velocity, stop=stop, seed=seed)
                        truth = run(scene, "--method", "quasi_static", "--event-tolerance", "0.002")["peak_stress_Pa"]
                        rough = run(scene, "--estimate-error")
                        sources = rough["error_estimate"]["sources"]
                        estimate = sum(s["peak_stress_error"] for s in sources if s["name"] != "pixel size")
                        error = abs(truth / rough["peak_stress_Pa"] - 1)
                        covered.append(estimate >= error)
                        ratios.append(estimate / max(error, 1e-4))
                        close = run(scene, "--tolerance", "2 %")
                        off = abs(close["peak_stress_Pa"] / truth - 1) if close else None
                        kept.append(off is not None and off <= 0.02)
                        print(f"{name:8} {pixel:5} {direction:12} {seed:4} {1e-6 * truth:8.3f} {1e-6 * rough['peak_stress_Pa']:8.3f} {100 * error:8.2f}"
                              f" {100 * estimate:11.2f} {ratios[-1]:7.2f}   "
                              + (f"{1e-6 * close['peak_stress_Pa']:.3f}, {100 * off:.2f}" if close else "refused"), flush=True)
    print(f"covered {100 * statistics.mean(covered):.1f} %, median of estimate over error {statistics.median(ratios):.2f}, "
          f"tolerance kept {100 * statistics.mean(kept):.1f} % of {len(kept)}")


if __name__ == "__main__":
    main()
