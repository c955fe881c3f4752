#!/usr/bin/env python3
"""Does the estimate of the error hold the error? Runs the paper's tension test with --estimate-error at several rates
and seeds, and compares with equilibrium, failure by failure:
    tests/bench/estimate.py build/release/bin/mesopix [PIXEL_MM [SEEDS]]
Prints error and estimate of the peak stress [%] without the part of the pixels, which the other run has too, and exits
non-zero when fewer than nine in ten estimates hold the error."""
import json
import subprocess
import sys
import tempfile


def summary(mesopix, *options):
    with tempfile.TemporaryDirectory() as folder:
        command = [mesopix, "simulate", "data/paper/tension.toml", "--set", "loading.stop_strain=2.5e-4", *options,
                   "-o", folder + "/run", "--json"]
        done = subprocess.run(command, capture_output=True, text=True, check=True)
        return json.loads(done.stdout)


def main():
    mesopix = sys.argv[1]
    pixel = sys.argv[2] if len(sys.argv) > 2 else "1.5"
    seeds = int(sys.argv[3]) if len(sys.argv) > 3 else 3
    held = total = 0
    print("seed   m/s   CFL    error  estimate  times")
    for seed in range(1, seeds + 1):
        fixed = ["--set", f"generate.pixel_size={pixel} mm", "--set", f"damage.seed={seed}"]
        still = summary(mesopix, *fixed, "--set", "solver.method=quasi_static", "--set", "solver.event_tolerance=0",
                        "--set", "loading.stop_drop=0.8", "--set", "loading.stop_strain=1e-3")
        for cfl in (0.5, 0.8):
            for velocity in (0.2, 0.1, 0.05):
                run = summary(mesopix, *fixed, "--set", f"loading.velocity={velocity} m/s", "--set",
                              f"solver.cfl={cfl}", "--estimate-error")
                error = abs(still["peak_stress_Pa"] / run["peak_stress_Pa"] - 1)
                sources = [s for s in run["error_estimate"]["sources"] if s["name"] != "pixel size"]
                estimate = sum(s["peak_stress_error"] for s in sources)
                extra = sum(s["wall_s"] for s in run["error_estimate"]["sources"]) / run["wall_s"]
                total += 1
                held += estimate >= error
                print(f"{seed:4} {velocity:5} {cfl:5} {100 * error:7.2f}  {100 * estimate:8.2f} {extra:6.1f}"
                      + ("" if estimate >= error else "   too small"), flush=True)
    print(f"{held} of {total} estimates hold the error")
    return 0 if held >= 0.9 * total else 1


if __name__ == "__main__":
    sys.exit(main())
