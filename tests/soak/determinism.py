#!/usr/bin/env python3
"""Runs scenes of data/ with each instruction set that this processor has, on 1, 2 and 4 threads, and wants the same bits
for every number of threads. Instruction sets round differently, and so do compilers: by how much the peak stress and
the work of the loads differ between them is printed, and must stay within a limit.

  determinism.py MESOPIX DATA [--full] [--only NAME]... [--other MESOPIX]

Without --full the scenes are loaded so fast that each takes a second or so. --other is a second build of the program.
"""
import argparse, re, sys, tempfile
from pathlib import Path

import h5py

sys.dont_write_bytecode = True
from runs import digest, finished, scenes_of, simulate

# What two runs may differ by that round differently, as a share of the value: the order in which points break is
# chaotic, the strength of the specimen is not.
MOST = {"peak stress": 0.05, "work": 0.05}


def run(mesopix, scene, options, instructions, threads, folder):
    process = simulate(mesopix, scene, *options, "--instruction-set", instructions, "--threads", threads, "-o", folder)
    finished(process)
    return folder


def instruction_sets(mesopix):
    """The program names them when it is asked for one that the processor has not; the fastest comes first."""
    small = "width = '20 mm'\nheight = '20 mm'\npixel_size = '1 mm'\nfraction = 0.2\nd_min = '4 mm'\nd_max = '6 mm'\n"
    every = ["avx512", "avx2", "baseline"]
    with tempfile.TemporaryDirectory() as made:
        scene = Path(made, "small.toml")
        scene.write_text("[generate]\n" + small)
        for name in every:
            process = simulate(mesopix, scene, "--instruction-set", name, "-o", Path(made, name))
            said = process.communicate()[1]
            if process.returncode == 0:
                continue
            assert process.returncode == 65 and "this processor supports" in said, said
            return re.findall(r"\w+", said.split("this processor supports")[1].split("\n")[0])
    return every


def figures(folder):
    with h5py.File(folder / "result.h5") as file:
        return {"peak stress": float(file.attrs["peak_stress_Pa"]), "work": float(file["history/platen_work"][-1])}


def check(builds, name, scene, options, folder):
    """@return by how much each figure differs between instruction sets and builds, as a share of its largest value."""
    seen = []
    for number, (mesopix, sets) in enumerate(builds.items()):
        for instructions in sets:
            sums = {}
            for threads in (1, 2, 4):
                made = run(mesopix, scene, options, instructions, threads, folder / f"{number}_{instructions}_{threads}")
                sums[threads] = digest(made)
            for threads in sums:
                different = [key for key in sums[1] if sums[threads].get(key) != sums[1][key]]
                assert not different, f"{name}, {instructions}: {threads} threads differ from one in {', '.join(different)}"
            seen.append(figures(made))
    values = {key: [figure[key] for figure in seen] for key in MOST}
    return {key: (max(all) - min(all)) / (max(map(abs, all)) or 1) for key, all in values.items()}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("mesopix", type=lambda path: Path(path).resolve())
    parser.add_argument("data", type=Path)
    parser.add_argument("--full", action="store_true")
    parser.add_argument("--only", action="append", help="names of scenes; all of them without it")
    parser.add_argument("--other", action="append", default=[], type=lambda path: Path(path).resolve())
    given = parser.parse_args()
    far, count = [], 0
    builds = {mesopix: instruction_sets(mesopix) for mesopix in [given.mesopix, *given.other]}
    print("this processor supports", ", ".join(builds[given.mesopix]), flush=True)
    for name, (scene, options) in scenes_of(given.data, given.full).items():
        if given.only and name not in given.only:
            continue
        with tempfile.TemporaryDirectory() as folder:
            difference = check(builds, name, scene, options, Path(folder))
        print(f"{name}: the same bits on 1, 2 and 4 threads; between instruction sets"
              f"{' and builds' if given.other else ''}", ", ".join(f"{key} {share:.2g}" for key, share in difference.items()),
              flush=True)
        count += 1
        far += [f"{name}: {key} differs by {share:.3f}" for key, share in difference.items() if share > MOST[key]]
    if far:
        sys.exit("\n".join(far))
    print(f"In all: {count} scenes, each with the same bits on 1, 2 and 4 threads")


if __name__ == "__main__":
    main()
