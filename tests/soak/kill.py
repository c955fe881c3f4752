#!/usr/bin/env python3
"""Kills a run that writes checkpoints, again and again, and goes on with it each time.

  kill.py MESOPIX [--kills N] [--seed S] [--every SECONDS] [--disk LIBRARY]

Every second kill waits for a file on its way to the disk. After each, no file may be unreadable and no more than an
interval be lost, by the clock on the wall; a run that comes to its end must have the bits of one that was never killed.
With libfailing_disk.so there are also runs whose disk stalls for several intervals: while it does, no more may be lost
than an interval beside what it holds back, and from then on no more than an interval.
"""
import argparse, os, random, sys, tempfile, time
from pathlib import Path

import h5py

sys.dont_write_bytecode = True
from runs import checkpoints, digest, finished, is_whole, simulate

scenes = {
    "lattice": "",
    "moving": '[solver]\nkinematics = "auto"\n[handover]\nstrain = 2e-4\n',
}
common = """[generate]
width = "40 mm"
height = "40 mm"
pixel_size = "0.5 mm"
fraction = 0.4
d_min = "4 mm"
d_max = "10 mm"
[output]
frames = 6
[loading]
velocity = "{velocity} m/s"
stop_strain = 4e-4
"""


def slack():
    """To start, and to wait for a core of a machine that others use too [s]."""
    return 0.5 * max(1, os.getloadavg()[0] / os.cpu_count())


stall = 1.5  # of the disk [s]


def being_written(run):
    try:
        return any(run.glob("*.tmp")) or any(run.glob("*/*.tmp"))
    except FileNotFoundError:  # a folder that was removed meanwhile
        return False


class Victim:
    """A run that is killed until it comes to its end."""

    def __init__(self, given, name, folder, chance):
        self.given, self.chance, self.folder = given, chance, folder
        self.scene = folder / f"{name}.toml"
        self.scene.write_text(common.format(velocity=given.velocity[name]) + scenes[name])
        self.every = ["--checkpoint-every", f"{given.every} s"]
        self.kills = self.ends = self.without = 0
        self.worst = 0.0

    def start(self):
        self.run = self.folder / f"run_{self.ends}"
        return simulate(self.given.mesopix, self.scene, *self.every, "--threads", 1, "-o", self.run)

    def go_on(self):
        if not checkpoints(self.run):  # it was killed before there was any: the run begins anew
            self.without += 1
            return simulate(self.given.mesopix, self.scene, *self.every, "--overwrite", "-o", self.run)
        return simulate(self.given.mesopix, "--resume", self.run, "--threads", self.chance.choice((1, 2, 3)))

    def kill(self, process):
        """@return whether the run was over before."""
        begin = time.time()
        until = begin + self.chance.uniform(0, 2 * self.given.every + 1)
        if self.kills % 2 == 0:
            while process.poll() is None and time.time() < until + 1 and not being_written(self.run):
                pass
            until = time.time() + self.chance.choice((0, 0, 1e-3, 5e-3))
        while process.poll() is None and time.time() < until:
            time.sleep(1e-4)
        process.kill()
        end = time.time()
        said = process.communicate()[1]
        if process.returncode == 0:
            return True
        assert process.returncode == -9, f"exit code {process.returncode}: {said}"
        assert all("checkpoints come late" in line for line in said.splitlines() if "warning" in line), said
        self.kills += 1
        self.look(begin, end)
        return False

    def look(self, begin, end):
        """At what a kill has left."""
        kept = checkpoints(self.run)
        assert len(kept) <= 3, "the third is written before the first goes"
        for checkpoint in kept:
            assert is_whole(checkpoint), f"{checkpoint} is damaged"
        for path in [*self.run.glob("*.h5"), *self.run.glob("frames/*.hdf")]:
            h5py.File(path).close()
        if (self.run / "result.h5").exists():  # it was over, and wrote what came of it
            return
        last = max([begin, *(path.stat().st_mtime for path in kept)])
        self.worst = max(self.worst, end - last)
        assert end - last < self.given.every + slack(), f"more than an interval is lost: {end - last:.2f} s"

    def check_end(self):
        different = [key for key, value in self.whole.items() if digest(self.run).get(key) != value]
        assert not different, f"{', '.join(different)} differ"
        left = [str(path) for path in (*self.run.glob("checkpoints"), *self.run.glob("checkpoints/*"))]
        assert not left, left
        self.ends += 1

    def start_with_a_stall(self):
        self.run = self.folder / "stalled"
        log = self.folder / "stall.log"
        log.write_text("")
        os.environ.update(LD_PRELOAD=str(self.given.disk), FAULT_FOLDER=str(self.run / "checkpoints"),
                          FAULT_LOG=str(log), FAULT_MODE="stall", FAULT_AT="2", FAULT_SECONDS=str(stall))
        process = simulate(self.given.mesopix, self.scene, *self.every, "--threads", 1, "--overwrite", "-o", self.run)
        del os.environ["LD_PRELOAD"]
        while "FAULT" not in log.read_text():
            assert process.poll() is None, "ended before the disk stalled: " + process.communicate()[1]
            time.sleep(1e-3)
        return process, time.time()

    def endure_a_stall(self):
        """Kills while the disk stalls, and later, when the run has to have warned of it."""
        for after in (0.6 * stall, stall + 4 * self.given.every):
            process, begin = self.start_with_a_stall()
            time.sleep(after)
            process.kill()
            end = time.time()
            said = process.communicate()[1]
            assert process.returncode == -9, f"exit code {process.returncode}, too soon for a kill: {said}"
            lost = end - max(path.stat().st_mtime for path in checkpoints(self.run))
            held_back = end - begin if after < stall else 0
            print(f"killed {after:.1f} s after the disk began to stall for {stall} s: {lost:.2f} s lost at an interval "
                  f"of {self.given.every} s", flush=True)
            assert lost < self.given.every + held_back + slack(), "more than an interval is lost"
            assert "warning: checkpoints come late" in said, said

    def endure(self, kills):
        finished(simulate(self.given.mesopix, self.scene, *self.every, "-o", self.folder / "whole"))
        self.whole = digest(self.folder / "whole")
        process = self.start()
        while self.kills < kills:
            if self.kill(process):
                self.check_end()
                process = self.start()
            else:
                process = self.go_on()
        finished(process)
        self.check_end()


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("mesopix", type=Path)
    parser.add_argument("--kills", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--every", type=float, default=0.2)
    parser.add_argument("--disk", type=Path, help="libfailing_disk.so, which lets the disk stall")
    parser.add_argument("--velocity", type=float, nargs=2, default=[0.002, 0.016],
                        help="of the platen, of the lattice and of moving points; slower runs take longer")
    given = parser.parse_args()
    given.mesopix = given.mesopix.resolve()
    given.disk = given.disk and given.disk.resolve()
    given.velocity = dict(zip(scenes, given.velocity))
    begin, kills, ends = time.time(), 0, 0
    for number, name in enumerate(scenes):
        with tempfile.TemporaryDirectory() as folder:
            victim = Victim(given, name, Path(folder), random.Random(given.seed + number))
            if given.disk:
                victim.endure_a_stall()
            if not given.kills:
                continue
            victim.endure((given.kills + 1 - number) // 2)
            print(f"{name}: {victim.kills} kills, {victim.without} before the first checkpoint, {victim.ends} runs to "
                  f"their end with the same bits; at most {victim.worst:.2f} s lost at an interval of {given.every} s",
                  flush=True)
            kills, ends = kills + victim.kills, ends + victim.ends
    print(f"In all: {kills} kills, {ends} runs to their end with the same bits, {time.time() - begin:.0f} s")
