"""What the tests of whole runs share: the scenes, and how a run is started, stopped, gone on with, and compared with another."""
import hashlib, signal, subprocess, time
from pathlib import Path

import h5py

small = ["--generate.width", "60 mm", "--generate.height", "60 mm"]
# What makes a scene of data/ last a second or so, by its name.
short = {
    "brazilian": ["--velocity", "20 m/s"],
    "compression_fragments": [*small, "--velocity", "50 m/s"],
    "concrete_compression": [*small, "--velocity", "1 m/s"],
    "concrete_tension": [*small, "--velocity", "0.2 m/s"],
    "disc_impact": ["--duration", "0.05 ms"],
    "two_aggregates": ["--velocity", "0.2 m/s"],
    "paper/compression": [*small, "--velocity", "2 m/s", "--set", "damage.crack_closure=clipped"],
    "paper/compression_closure": [*small, "--velocity", "8 m/s"],
    "paper/generation": [*small, "--velocity", "0.2 m/s"],
    "paper/objectivity": ["--velocity", "1 m/s"],
    "paper/tension": [*small, "--velocity", "0.2 m/s", "--precision", "single"],
    "paper/two_aggregates": ["--velocity", "0.2 m/s"],
}


def scenes_of(data, full=False):
    """Every scene of data/ by its name, and the options that make it short; none for a full one."""
    scenes = {str(path.relative_to(data).with_suffix("")): path.resolve() for path in sorted(data.rglob("*.toml"))
              if not path.stem.endswith("_study") and path.stem != "small_tension"}  # which is over at once
    assert scenes.keys() == short.keys(), "a scene of data/ has no short form here, or the other way round"
    return {name: (path, [] if full else short[name]) for name, path in scenes.items()}


def simulate(mesopix, *arguments):
    """A process of the program; its streams come with communicate()."""
    return subprocess.Popen([str(mesopix), "simulate", *map(str, arguments)], stdout=subprocess.DEVNULL,
                            stderr=subprocess.PIPE, text=True)


def finished(process, code=0):
    """What the program said; it ends with that code."""
    said = process.communicate()[1]
    assert process.returncode == code, f"{' '.join(process.args)}: exit code {process.returncode}, not {code}: {said}"
    return said


def wait_for(path, process):
    """Until the program has made a file."""
    while not path.exists():
        assert process.poll() is None, f"ended before there was {path}: {process.communicate()[1]}"
        time.sleep(0.001)


def stop(process):
    process.send_signal(signal.SIGTERM)


def digest(run):
    """SHA-256 of the curve, and of every array of the result."""
    sums = {"curve.csv": hashlib.sha256((run / "curve.csv").read_bytes()).hexdigest()}

    def add(name, entry):
        if isinstance(entry, h5py.Dataset):
            sums[name] = hashlib.sha256(f"{entry.dtype} {entry.shape}".encode() + entry[()].tobytes()).hexdigest()

    with h5py.File(run / "result.h5") as file:
        file.visititems(add)
        for name in ("peak_stress_Pa", "peak_strain", "tension_failures", "shear_failures", "steps", "energy_error",
                     "stop_reason"):
            sums[name] = str(file.attrs[name])
    assert len(sums) > 20
    return sums


def frames(run):
    """Names of the frames, and what the lists say of them."""
    files = sorted(path.name for path in (run / "frames").glob("*"))
    return files, (run / "frames.hdf.series").read_text(), (run / "frames.xdmf").read_text()


def checkpoints(run):
    return sorted((run / "checkpoints").glob("*.checkpoint"))


def is_whole(checkpoint):
    """By the digest at its end."""
    data = Path(checkpoint).read_bytes()
    return hashlib.sha256(data[:-32]).digest() == data[-32:]
