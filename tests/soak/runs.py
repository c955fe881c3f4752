"""What the tests of stopped runs share: how a run is started, stopped, gone on with, and compared with another."""
import hashlib, signal, subprocess, time
from pathlib import Path

import h5py


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
