"""Whether a file is whole, by its kind; for the tests of disks that fail."""
import csv, json, tomllib, xml.dom.minidom, zipfile

import h5py
from PIL import Image


def _picture(path):
    with Image.open(path) as picture:
        picture.load()


def _hdf5(path):
    with h5py.File(path) as file:
        file.visititems(lambda name, entry: entry[()] if isinstance(entry, h5py.Dataset) else None)


def _table(path):
    text = path.read_text()
    assert text.endswith("\n") and len({len(row) for row in csv.reader(text.splitlines())}) == 1


def _ends_with(end):
    def check(path):
        assert path.read_bytes().rstrip().endswith(end)

    return check


def _zip(path):
    assert zipfile.ZipFile(path).testzip() is None


_checks = {
    ".png": _picture, ".tif": _picture, ".pgm": _picture,
    ".h5": _hdf5, ".hdf": _hdf5,
    ".json": lambda path: json.loads(path.read_text()), ".series": lambda path: json.loads(path.read_text()),
    ".toml": lambda path: tomllib.loads(path.read_text()),
    ".csv": _table,
    ".xdmf": lambda path: xml.dom.minidom.parse(str(path)), ".svg": lambda path: xml.dom.minidom.parse(str(path)),
    ".vti": _ends_with(b"</VTKFile>"), ".html": _ends_with(b"</html>"), ".pdf": _ends_with(b"%%EOF"),
    ".msh": _ends_with(b"$EndElements"), ".zip": _zip,
}


def check_whole(path):
    """@raises what its reader raises; a file of a kind without a reader must at least hold something."""
    assert path.stat().st_size > 0, f"{path} is empty"
    if path.suffix in _checks:
        _checks[path.suffix](path)
