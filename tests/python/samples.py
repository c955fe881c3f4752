"""Small specimens that the tests break."""
import contextlib, os, tempfile
import mesopix


def specimen(seed: int = 3) -> mesopix.Specimen:
    """60 x 60 pixels with a dozen of aggregates."""
    return mesopix.generate(width="30 mm", height="30 mm", d_min="4 mm", d_max="8 mm", fraction=0.3, seed=seed)


def run(**options) -> mesopix.Result:
    """In tension beyond its peak, in a fraction of a second."""
    wanted = dict(velocity="0.2 m/s", stop_strain=3e-4, history_rows=100, threads=1)
    return mesopix.simulate(specimen(), **{**wanted, **options})


#: Settings of a run that takes tens of seconds unless it is stopped.
ENDLESS = dict(velocity=1e-4, stop_strain=1e-3, history_rows=1_000_000, threads=1)


@contextlib.contextmanager
def empty_folder():
    """The working directory while it lasts."""
    before = os.getcwd()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        try:
            yield folder
        finally:
            os.chdir(before)
