#!/usr/bin/env python3
"""Lays files that nobody ever wrote before every reader, as long as asked; finds what crashes or hangs one.

  fuzz.py BUILD [--seconds N | --hours N | --runs N] [--jobs N] [TARGET...]

BUILD is a folder of the preset `fuzz`, with the targets fuzz_targets and write_fuzz_seeds built. Each target (all of
them, if none is named) runs for a minute, or as long as asked. What reached new code is kept in BUILD/fuzz, so that the
next run goes on from there; with --runs nothing is kept, and every run does the same. A file that a reader does not
survive is named, and stays in BUILD/fuzz/found.
"""
import argparse, concurrent.futures, os, re, subprocess, sys, tempfile
from pathlib import Path

# HDF5 takes it as damage when it gets none of the memory that a file asks for; so does the program, whose limit is the
# memory of the machine.
hdf5 = {"specimen_file", "result_file", "frame_file"}
kind_of_seeds = {"conversion": "picture"}
limits = ["-timeout=20", "-rss_limit_mb=2000"]


def arguments(given, name, seeds):
    kept, found = given.build / "fuzz" / name, given.build / "fuzz/found"
    found.mkdir(parents=True, exist_ok=True)
    corpus = [seeds / kind_of_seeds.get(name, name)]
    if given.runs:
        much = [f"-runs={given.runs}", "-seed=1"]
    else:
        kept.mkdir(exist_ok=True)
        corpus.insert(0, kept)
        much = [f"-max_total_time={round(given.hours * 3600) if given.hours else given.seconds}"]
    memory = "-malloc_limit_mb=2000000" if name in hdf5 else "-malloc_limit_mb=512"
    return [*much, *limits, memory, "-print_final_stats=1", f"-artifact_prefix={found}/{name}-", *corpus]


def run(given, name, seeds):
    """Whether all was well, how many files were tried, what to tell of it, and the whole of what the target said."""
    environment = dict(os.environ, ASAN_OPTIONS="allocator_may_return_null=1") if name in hdf5 else os.environ
    target = subprocess.run([given.build / "bin" / f"fuzz_{name}", *arguments(given, name, seeds)], env=environment,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
    numbers = re.findall(r"^stat::number_of_executed_units:\s*(\d+)", target.stdout, re.M)
    edges = re.findall(r"\bcov: (\d+)", target.stdout)
    unit = re.findall(r"Test unit written to (.*)", target.stdout)
    result = "ok" if target.returncode == 0 else "FOUND " + (unit[-1] if unit else f"exit code {target.returncode}")
    line = f"{name:<14} {numbers[-1] if numbers else '?':>10} files {edges[-1] if edges else '?':>6} edges   {result}"
    return target.returncode == 0, int(numbers[-1]) if numbers else 0, line, target.stdout


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=lambda text: Path(text).resolve())
    parser.add_argument("targets", nargs="*")
    amount = parser.add_mutually_exclusive_group()
    amount.add_argument("--seconds", type=int, default=60)
    amount.add_argument("--hours", type=float)
    amount.add_argument("--runs", type=int)
    parser.add_argument("--jobs", type=int, default=2)
    given = parser.parse_intermixed_args()  # targets may stand behind options
    known = sorted(path.name.removeprefix("fuzz_") for path in given.build.glob("bin/fuzz_*"))
    unknown = set(given.targets) - set(known)
    if not known or unknown:
        parser.error(f"{given.build}/bin has no fuzz_{min(unknown, default='*')}; there are: {' '.join(known) or 'none'}")
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        seeds = Path(folder)
        subprocess.run([given.build / "bin/write_fuzz_seeds", seeds], check=True)
        well, files = True, 0
        for good, number, line, said in pool.map(lambda name: run(given, name, seeds), given.targets or known):
            print(line, flush=True)
            well, files = well and good, files + number
            if not good:
                print(said[-6000:], flush=True)
    print(f"In all: {files} files before {len(given.targets or known)} readers{'' if well else ', of which one did not survive'}")
    return 0 if well else 1


if __name__ == "__main__":
    sys.exit(main())
