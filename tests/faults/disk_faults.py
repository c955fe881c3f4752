#!/usr/bin/env python3
"""Lets the disk fail at each call in turn, in a small run of every command that writes.

  disk_faults.py MESOPIX FAILING_DISK [--most N] [--command NAME]

After each fault: exit code 74 and the path; no file that cannot be read, and none left over; the files that were there
are as they were, or replaced by whole ones; where each file is tried, only the one that failed is missing."""
import argparse, errno, os, re, shutil, subprocess, sys, tempfile
from collections import Counter
from pathlib import Path

sys.dont_write_bytecode = True
from commands import COMMANDS, arguments_of, prepare
from readable import check_whole

FAULTS = [("once", errno.EIO), ("once", errno.ENOSPC), ("onward", errno.ENOSPC), ("short", 0)]


def snapshot(folder):
    return {path.relative_to(folder): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


class Walk:
    """A command, over and over from the same files."""

    def __init__(self, mesopix, disk, folder, inputs, command):
        self.mesopix, self.disk, self.inputs, self.command = mesopix, disk, inputs, command
        self.work, self.log = folder / "work", folder / "log"
        self.before = snapshot(inputs)
        done, self.calls = self.run(0, "once", 0)
        assert done.returncode == 0, f"fails without a fault: {done.stderr}"
        assert self.calls, "writes nothing that is counted"
        self.complete = snapshot(self.work)
        for path in self.complete:
            check_whole(self.work / path)

    def run(self, at, mode, error):
        shutil.rmtree(self.work, ignore_errors=True)
        shutil.copytree(self.inputs, self.work)
        self.log.unlink(missing_ok=True)
        environment = os.environ | {"LD_PRELOAD": str(self.disk), "FAULT_FOLDER": str(self.work),
                                    "FAULT_LOG": str(self.log), "FAULT_AT": str(at), "FAULT_MODE": mode,
                                    "FAULT_ERROR": str(error)}
        done = subprocess.run([self.mesopix, *arguments_of(self.command)], cwd=self.work, env=environment,
                              capture_output=True, text=True, timeout=120)
        return done, self.log.read_text().splitlines() if self.log.exists() else []

    def name_of(self, call):
        """What the user knows the file by: without the ending of a temporary name."""
        path = re.sub(r"(\.\d+-\d+\.tmp|\.tmp-\d+-\d+)$", "", call.split(" ", 1)[1])
        return Path(path).relative_to(self.work)

    def check(self, at, mode, error):
        done, calls = self.run(at, mode, error)
        faults = [call.removeprefix("FAULT ") for call in calls if call.startswith("FAULT ")]
        after = snapshot(self.work)
        for path in after:
            assert ".tmp" not in path.name, f"{path} is left over"
            if after[path] != self.before.get(path):
                assert path.parts[0] in self.command.writes, f"{path} was touched"
                if after[path] != self.complete.get(path):  # those were looked at
                    check_whole(self.work / path)
        missing_before = set(self.before) - set(after)
        doomed = set(self.before) - set(self.complete)
        if self.command.anew:
            doomed |= {path for path in self.before if path.parts[0] in self.command.writes}
        assert missing_before <= doomed, f"{missing_before - doomed} is gone"
        failed = [self.name_of(fault) for fault in faults]
        removed = all(fault.endswith(" (deleted)") for fault in faults)  # a lock that is let go: nothing to lose
        spared = removed or self.command.spare and all(path.is_relative_to(self.command.spare) for path in failed)
        if mode == "short" or not faults or (spared and done.returncode == 0):
            assert done.returncode == 0, f"exit code {done.returncode}: {done.stderr}"
            assert set(after) == set(self.complete), "a file is missing"
            return len(faults)
        assert done.returncode == 74, f"exit code {done.returncode}, not 74: {done.stderr}"
        assert any(str(path) in done.stderr for path in failed), f"no word of {failed}: {done.stderr}"
        call = faults[0].split()[0]
        begun = str(failed[0]) not in self.command.first or "steps in" in done.stderr
        if mode == "once" and self.command.each_alone and begun and call != "mkdir":
            missing = set(self.complete) - set(after) - set(failed)
            assert not missing, f"missing: {missing}"
        return len(faults)


def walk(arguments, name, folder, inputs, number):
    """@return how many calls there are, the faults that were injected by kind, and what went wrong."""
    one = Walk(arguments.mesopix, arguments.disk, folder, inputs, COMMANDS[name])
    count, wrong = Counter(), []
    cases = [(mode, error, at) for mode, error in FAULTS for at in range(1, len(one.calls) + 1)]
    if arguments.most < len(cases):  # evenly spread, and each command begins elsewhere: all kinds of call are met
        cases = [cases[(int(i * len(cases) / arguments.most) + 7 * number) % len(cases)] for i in range(arguments.most)]
    for mode, error, at in cases:
        try:
            if one.check(at, mode, error) > 0:
                count[mode, one.calls[at - 1].split()[0]] += 1
        except Exception as problem:  # of a reader too
            wrong.append(f"{name}, {mode} {errno.errorcode.get(error, '')} at call {at}, "
                         f"{one.calls[at - 1]}: {type(problem).__name__} {problem}")
    return len(one.calls), count, wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("mesopix", type=lambda path: Path(path).resolve())
    parser.add_argument("disk", type=lambda path: Path(path).resolve())
    parser.add_argument("--most", type=int, default=10**6, help="faults a command; all of them without it")
    parser.add_argument("--command", action="append", choices=COMMANDS)
    arguments = parser.parse_args()
    total, wrong = Counter(), []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name).resolve()
        inputs = folder / "inputs"
        inputs.mkdir()
        prepare(arguments.mesopix, inputs)
        for number, command in enumerate(arguments.command or COMMANDS):
            calls, count, bad = walk(arguments, command, folder, inputs, number)
            print(f"{command:16} {calls:4} calls {count.total():5} faults {len(bad):4} wrong", flush=True)
            total += count
            wrong += bad
    for line in wrong[:20]:
        print("FAILED:", line)
    print(f"In all: {total.total()} faults of the disk injected:", ", ".join(f"{mode} {call} {n}" for (mode, call), n in sorted(total.items())))
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
