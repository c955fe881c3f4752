#!/usr/bin/env python3
"""How far explicit runs are from fracture without waves: the peak of a quasi-static run, and of explicit runs of the same
specimen and strength field at falling rates, without damping and with local damping 0.2.
    tests/bench/rate_free.py build/release/bin/mesopix [SEEDS [PIXEL_MM [CELL [DIRECTION]]]]
Prints a line a field, and the means [%] that docs/accuracy.md quotes."""
import json
import statistics
import subprocess
import sys
import tempfile

SCENE = """
[generate]
width = "75 mm"
height = "75 mm"
fraction = "45 %"
d_min = "5 mm"
d_max = "20 mm"
[loading]
direction = "{direction}"
stop_drop = 0.5
stop_strain = {stop}
"""


def main():
    mesopix = sys.argv[1]
    seeds = int(sys.argv[2]) if len(sys.argv) > 2 else 10
    pixel = sys.argv[3] if len(sys.argv) > 3 else "0.5"
    cell = sys.argv[4] if len(sys.argv) > 4 else "pixel"
    direction = sys.argv[5] if len(sys.argv) > 5 else "tension"
    rates = ["0.05", "0.02", "0.01", "0.005"] if direction == "tension" else ["0.2", "0.1", "0.05", "0.02"]
    with tempfile.TemporaryDirectory() as folder:
        scene = folder + "/scene.toml"
        with open(scene, "w", encoding="utf-8") as file:
            file.write(SCENE.format(direction=direction, stop="5e-4" if direction == "tension" else "3e-3"))

        def run(seed, *options):
            done = subprocess.run([mesopix, "simulate", scene, f"--generate.pixel-size={pixel} mm", "--cell", cell,
                                   f"--damage.seed={seed}", *options, "-o", folder + "/run", "--overwrite", "--json", "-q"],
                                  capture_output=True, text=True, check=True)
            return json.loads(done.stdout)

        print("seed   MPa  microstrain  s   " + "".join(f"{rate:>8}" for rate in rates + rates))
        columns = []
        for seed in range(1, seeds + 1):
            still = run(seed, "--method", "quasi_static")
            row = []
            for damping in ("0", "0.2"):
                for rate in rates:
                    slow = run(seed, "--velocity", f"{rate} m/s", "--local-damping", damping)
                    row.append(100 * (slow["peak_stress_Pa"] / still["peak_stress_Pa"] - 1))
            columns.append(row)
            print(f"{seed:4} {1e-6 * still['peak_stress_Pa']:6.3f} {1e6 * still['peak_strain']:8.1f} {still['wall_s']:6.2f}"
                  + "".join(f"{value:8.2f}" for value in row), flush=True)
        print("mean                        " + "".join(f"{statistics.mean(c):8.2f}" for c in zip(*columns)))
        print("deviation                   " + "".join(f"{statistics.pstdev(c):8.2f}" for c in zip(*columns)))


if __name__ == "__main__":
    main()
