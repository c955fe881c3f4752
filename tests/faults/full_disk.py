#!/usr/bin/env python3
"""Runs the program on small disks of its own, and where nobody reads what it says.   full_disk.py MESOPIX

Mounting a disk takes root; where that is not allowed the test says so and is skipped."""
import json, os, shutil, signal, subprocess, sys, tempfile
from contextlib import contextmanager
from pathlib import Path

sys.dont_write_bytecode = True
from commands import COMMANDS, arguments_of, prepare
from readable import check_whole

mesopix = Path(sys.argv[1]).resolve()


@contextmanager
def disk(folder, size):
    """A disk of `size` bytes."""
    folder.mkdir()
    subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", folder], check=True, capture_output=True)
    try:
        yield folder
    finally:
        subprocess.run(["umount", folder], check=True)
        folder.rmdir()


def can_mount(folder):
    try:
        with disk(folder / "probe", 65536):
            return True
    except (subprocess.CalledProcessError, OSError):
        (folder / "probe").rmdir()
        return False


def run(arguments, cwd, **options):
    return subprocess.run([mesopix, *arguments], cwd=cwd, text=True, timeout=120,
                          **({"capture_output": True} | options))


def space_of(folder):
    return sum((path.stat().st_size + 4095) // 4096 * 4096 + 4096 for path in folder.rglob("*"))


def fill(folder, left):
    """Leaves so much space on a disk, in bytes."""
    state = os.statvfs(folder)
    with open(folder / "filler", "wb") as file:
        file.write(b"x" * (state.f_bavail * state.f_frsize - left))


def files_in(folder):
    return {path.relative_to(folder): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def check_files(folder, before, may_go=()):
    for path in folder.rglob("*"):
        assert ".tmp" not in path.name, f"{path} is left over"
        if path.is_file() and path.name != "filler" and path.read_bytes() != before.get(path.relative_to(folder)):
            check_whole(path)
    gone = [path for path in before if path not in may_go and not (folder / path).exists()]
    assert not gone, f"{gone} is gone"


def check_command(name, folder, inputs):
    """With no space at all, and with a part of what is needed."""
    command = COMMANDS[name]
    before = files_in(inputs)
    shutil.copytree(inputs, folder / "free")
    assert run(arguments_of(command), folder / "free").returncode == 0
    replaced = set(before) - set(files_in(folder / "free"))  # what a run removes of an earlier one
    shutil.rmtree(folder / "free")
    for left in (0, 8192, 40960):
        with disk(folder / "disk", space_of(inputs) + (1 << 20)) as small:
            shutil.copytree(inputs, small, dirs_exist_ok=True)
            fill(small, left)
            done = run(arguments_of(command), small)
            assert done.returncode in ((74,) if left == 0 else (0, 74)), f"exit code {done.returncode}: {done.stderr}"
            if done.returncode == 74:
                assert "No space left on device" in done.stderr, done.stderr
                assert any(path in done.stderr for path in command.writes), f"no path: {done.stderr}"
            check_files(small, before, replaced)


def check_frames(folder):
    """The disk is full amidst the frames: what was computed is kept, and the frames that fit."""
    scene = (folder / "inputs" / "scene.toml").read_text()
    with disk(folder / "disk", 512 << 10) as small:
        (small / "scene.toml").write_text(scene)
        done = run("simulate scene.toml -o run --frames 60 --json".split(), small)
        assert done.returncode == 74, f"exit code {done.returncode}: {done.stderr}"
        assert "frames are missing" in done.stderr and "the run goes on" in done.stderr, done.stderr
        assert json.loads(done.stdout)["peak_stress_Pa"] > 0, "no summary on standard output"
        check_files(small, {})
        listed = [file["name"] for file in json.loads((small / "run" / "frames.hdf.series").read_text())["files"]]
        there = sorted(str(path.relative_to(small / "run")) for path in (small / "run" / "frames").iterdir())
        assert 3 < len(there) < 61, f"{len(there)} frames"
        assert set(listed) <= set(there) and len(listed) >= len(there) - 1, "the list is not that of the frames"
        os.remove(small / "run" / there[-1])
        done = run("simulate scene.toml -o run --overwrite --frames 2".split(), small)
        assert done.returncode in (0, 74), f"exit code {done.returncode}: {done.stderr}"


def check_space_again(folder):
    """Results fit where no frame did: every file of the run is there, and the exit code tells of the frames."""
    scene = (folder / "inputs" / "scene.toml").read_text()
    work = folder / "no_frames"
    (work / "run").mkdir(parents=True)
    (work / "scene.toml").write_text(scene)
    with disk(work / "run" / "frames", 4096):
        done = run("simulate scene.toml -o run --overwrite --frames 2".split(), work)
    assert done.returncode == 74 and "3 of 3 frames are missing" in done.stderr, f"{done.returncode}: {done.stderr}"
    for name in ("result.h5", "curve.csv", "summary.json", "scene.toml", "report.html", "specimen.h5", "curve.png"):
        check_whole(work / "run" / name)


def check_limit(folder, inputs):
    """A file beyond the limit of its size ends no program."""
    import resource
    for name in ("simulate", "generate", "export inp"):
        work = folder / "limited"
        shutil.copytree(inputs, work)
        done = run(arguments_of(COMMANDS[name]), work,
                   preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096)))
        assert done.returncode == 74 and "File too large" in done.stderr, f"{name}: {done.returncode}: {done.stderr}"
        check_files(work, {})
        shutil.rmtree(work)


def check_streams(folder, inputs):
    """What cannot be printed is told; what cannot be told ends nothing."""
    work = folder / "streams"
    shutil.copytree(inputs, work)
    with open("/dev/full", "w") as full:
        for line in ("inspect first", "inspect specimen.h5 --json", "--help", "simulate scene.toml --print-scene",
                     "simulate scene.toml --explain", "simulate scene.toml -o a --json", "generate scene.toml --json"):
            done = run(line.split(), work, capture_output=False, stdout=full, stderr=subprocess.PIPE)
            assert done.returncode == 74 and "standard output" in done.stderr, f"{line}: {done.returncode} {done.stderr}"
        check_whole(work / "a" / "result.h5")
        done = run("simulate scene.toml -o b".split(), work, capture_output=False, stderr=full)
        assert done.returncode == 0, f"exit code {done.returncode} where nothing can be said"
        done = run("simulate no.toml".split(), work, capture_output=False, stderr=full)
        assert done.returncode == 74, f"exit code {done.returncode} where nothing can be said"
    for closed in ("<&- >&- 2>&-", ">&-", "2>&-"):
        line = f'exec "$0" generate scene.toml --json -o c.h5 {closed}'
        done = subprocess.run(["bash", "-c", line, mesopix], cwd=work, capture_output=True, text=True)
        assert done.returncode == (0 if closed == "2>&-" else 74), f"{closed}: {done.returncode} {done.stderr}"
        check_whole(work / "c.h5")
        os.remove(work / "c.h5")
    reader, writer = os.pipe()
    os.close(reader)
    done = run("simulate scene.toml -o d".split(), work, capture_output=False, stderr=writer,
               preexec_fn=lambda: signal.signal(signal.SIGPIPE, signal.SIG_DFL))
    assert done.returncode == 0, f"exit code {done.returncode} where nobody listens"
    check_whole(work / "d" / "result.h5")


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name).resolve()
        inputs = folder / "inputs"
        inputs.mkdir()
        prepare(mesopix, inputs)
        check_limit(folder, inputs)
        check_streams(folder, inputs)
        if not can_mount(folder):
            print("skipped: no disk can be mounted here, which takes root; limits and streams are well")
            sys.exit(77)
        for command in COMMANDS:
            check_command(command, folder, inputs)
        check_frames(folder)
        check_space_again(folder)
    print(f"In all: {len(COMMANDS)} commands on full disks")


if __name__ == "__main__":
    main()
