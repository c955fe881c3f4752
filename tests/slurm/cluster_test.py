#!/usr/bin/env python3
"""A study of many members on a Slurm of its own, one node of which fails in the middle: nothing is lost, and the table
has the same bits as that of a run without Slurm.

  cluster_test.py MESOPIX [--members N] [--chunk N] [--patience SECONDS]

Skipped (exit code 77) where Slurm is not installed.
"""
import argparse, hashlib, json, subprocess, sys, tempfile, time
from pathlib import Path

sys.dont_write_bytecode = True
from private_cluster import PrivateCluster, missing

SCENE = """[generate]
width = "30 mm"
height = "30 mm"
pixel_size = "0.5 mm"
fraction = 0.4
d_min = "4 mm"
d_max = "8 mm"
[loading]
velocity = "{velocity}"
stop_strain = 3e-4
stop_drop = 0.2
[solver]
cfl = 0.8
"""


def study(folder, name, members, velocity="0.002 m/s"):
    """A study of so many seeds in a folder."""
    (folder / f"{name}_scene.toml").write_text(SCENE.format(velocity=velocity))
    (folder / f"{name}.toml").write_text(f'title = "{name}"\nscene = "{name}_scene.toml"\nseeds = {members}\n')
    return f"{name}.toml"


class Studies:
    """The program in one folder, with the environment of a cluster."""

    def __init__(self, mesopix, cluster, folder, patience):
        self.mesopix, self.cluster, self.folder, self.patience = mesopix, cluster, folder, patience

    def run(self, *arguments, codes=(0,)):
        done = self.cluster.run(self.mesopix, "study", *arguments, check=False, cwd=self.folder)
        assert done.returncode in codes, f"{arguments}: exit code {done.returncode}: {done.stderr}"
        return done

    def submit(self, file, *options):
        said = self.run("submit", file, "--slurm", *options).stderr
        return said.split("submitted job ")[1].split(":")[0]

    def status(self, file):
        return json.loads(self.run("status", file, "--json").stdout)

    def wait(self, file, reached):
        end = time.monotonic() + self.patience
        while not reached(status := self.status(file)):
            assert time.monotonic() < end, f"after {self.patience} s: {status}\n{self.logs(file)}"
            time.sleep(0.2)
        return status

    def logs(self, file):
        return "\n".join(path.read_text() for path in sorted((self.folder / "runs").glob(f"{Path(file).stem}/slurm/*/*.log")))

    def tables(self, file):
        return {name: hashlib.sha256((self.folder / "runs" / Path(file).stem / name).read_bytes()).hexdigest()
                for name in ("table.csv", "table.h5")}


def queued(status):
    return sum(sum(job["tasks"].values()) for job in status["jobs"])


def check_failing_node(studies, cluster, given):
    """@return the members that were done when the node failed, and the time that all took."""
    file = study(studies.folder, "strength", given.members)
    begin = time.monotonic()
    job = studies.submit(file, "--chunk", given.chunk)
    studies.run("collect", file, codes=(65, 75))  # none or some of them are done
    before = studies.wait(file, lambda status: status["done"] >= given.members // 4)
    assert queued(before) > 0, "the study was over before a node could fail"
    cluster.kill_node("n2")
    status = studies.wait(file, lambda status: queued(status) == 0)
    assert (status["done"], status["failed"], status["begun"]) == (given.members, 0, 0), f"{status}\n{studies.logs(file)}"
    assert [entry["id"] for entry in status["jobs"]] == [job]
    studies.run("collect", file)
    on_cluster = studies.tables(file)
    assert "nothing to do" in studies.run("submit", file, "--slurm").stderr
    studies.run(file, "-o", "runs/local")
    assert studies.tables("local.toml") == on_cluster, "the table is another one than without Slurm"
    return before["done"], time.monotonic() - begin


def check_time_that_runs_out(studies, cluster):
    """A task that is told that its time is nearly up keeps what it has, and goes on when it is queued again."""
    file = study(studies.folder, "slow", 2, velocity="0.00005 m/s")
    job = studies.submit(file, "--chunk", 1)
    studies.wait(file, lambda status: status["jobs"][0]["tasks"].get("RUNNING", 0) > 0)
    time.sleep(1)
    cluster.run("scancel", "--signal=USR1", "--batch", job)
    studies.wait(file, lambda status: status["begun"] > 0 or status["done"] == 2)
    status = studies.wait(file, lambda status: status["done"] == 2)
    assert "interrupted" in studies.logs(file), studies.logs(file)
    studies.run("collect", file)
    on_cluster = studies.tables(file)
    studies.run(file, "-o", "runs/slow_local")
    assert studies.tables("slow_local.toml") == on_cluster, "the table is another one than that of runs in one go"


def check_refusals(studies):
    file = study(studies.folder, "refused", 2)
    said = studies.run("submit", file, "--slurm", "--sbatch=--partition=nowhere", codes=(74,)).stderr
    assert "sbatch" in said and "nowhere" in said or "partition" in said, said
    assert "must be told where to" in studies.run("submit", file, codes=(64,)).stderr
    assert "goes with --slurm" in studies.run("submit", file, "--commands", "--dry-run", codes=(64,)).stderr
    assert studies.status(file)["open"] == 2


def check_commands(studies):
    """The list of commands, run by a shell."""
    file = study(studies.folder, "listed", 5)
    commands = studies.run("submit", file, "--commands", "--chunk", 2).stdout
    assert len(commands.splitlines()) == 3, commands
    subprocess.run(["sh", "-e"], input=commands, text=True, check=True, capture_output=True)
    assert studies.status(file)["done"] == 5


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("mesopix", type=lambda path: Path(path).resolve())
    parser.add_argument("--members", type=int, default=100)
    parser.add_argument("--chunk", type=int, default=5)
    parser.add_argument("--patience", type=float, default=240, help="seconds that a part may take")
    given = parser.parse_args()
    if missing():
        print("skipped: there is no", ", ".join(missing()))
        sys.exit(77)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name).resolve()
        with PrivateCluster(folder / "cluster", nodes=2, cpus=1) as cluster:
            studies = Studies(given.mesopix, cluster, folder, given.patience)
            check_refusals(studies)
            check_commands(studies)
            check_time_that_runs_out(studies, cluster)
            done, took = check_failing_node(studies, cluster, given)
    print(f"In all: {given.members} members on two nodes, of which one failed after {done}: all done, the same table, "
          f"{took:.0f} s")


if __name__ == "__main__":
    main()
