"""From a picture of concrete to a broken specimen.

    import mesopix
    specimen = mesopix.convert("cut.png", width="150 mm", pixels=300)
    result = mesopix.simulate(specimen, velocity="0.1 m/s", seed=3)
    result.plot()

Settings are those of the program and of its scenes. They are given by their keys in a dictionary, or by their short
names as keyword arguments; help(mesopix.simulate) lists them. Numbers are in SI units, angles in rad; texts have
units: pixel_size=0.0005 and pixel_size="0.5 mm" are the same. Properties of a phase are in the dictionary:
{"mortar.tensile_scale": "12 MPa"}. Arrays have row 0 on top, as the picture has, and y points up.

Runs leave the interpreter free for other threads, so that many go side by side; see docs/python.md.
"""
from __future__ import annotations

import os
from typing import Any, Callable, Mapping, Optional, Sequence, Union

from numpy.typing import ArrayLike

from . import _core, results
from ._core import Calibration, Result, Specimen, Study, Twins
from .errors import Complaint, Diverged, Doubt, Error, FileError, Interrupted, LongRun
from .progress import Progress, StudyProgress, Trial, TwinProgress
from .results import Curve

__all__ = [
    "Calibration", "Complaint", "Curve", "Diverged", "Doubt", "Error", "FileError", "Interrupted", "LongRun", "Progress",
    "Result", "Specimen", "Study", "StudyProgress", "Trial", "TwinProgress", "Twins", "calibrate", "convert", "generate",
    "read_result", "read_specimen", "simulate", "stiffness", "study", "twin",
]
__version__: str = _core.version

Path = Union[str, "os.PathLike[str]"]
#: Of a setting: a number in SI units, a text with its unit, True or False, or a sequence of these.
Value = Union[bool, float, str, "os.PathLike[str]", Sequence[Any], Mapping[int, str]]
Settings = Mapping[str, Value]

setattr(Result, "damage", results.damage)
setattr(Result, "plot", results.plot)


def generate(settings: Optional[Settings] = None, /, *, scene: Optional[Path] = None, **options: Value) -> Specimen:
    """Draw random or listed ellipses as a specimen.

    settings: by their keys, {"generate.fraction": 0.4}.
    scene: path of a scene.toml whose specimen to draw, which settings and options change.
    options: settings by their short names, see below.

    Raises Error for what cannot be drawn, FileError for a file that cannot be read.

        specimen = mesopix.generate(width="100 mm", height="100 mm", fraction=0.4, seed=2)
    """
    return _core.generate(scene, dict(settings or {}), options)


def convert(image: Union[Path, ArrayLike], settings: Optional[Settings] = None, /, **options: Value) -> Specimen:
    """Turn a picture into a specimen.

    image: path of a picture (PNG, TIFF, BMP, JPEG, PGM, PPM) or of a scene.toml that names one; or an array, labels or
        grey of shape (rows, columns), or RGB, uint8 of shape (rows, columns, 3), row 0 on top.
    settings: by their keys, {"convert.width": "150 mm"}.
    options: settings by their short names, see below. An array has no scale of its own: give width or pixel_size.

    What was guessed is in the notes of the specimen. Raises Error for what is no picture or has no scale, FileError for
    a file that cannot be read.

        specimen = mesopix.convert("photo.jpg", width="150 mm", pixels=300)
        specimen = mesopix.convert(labels, pixel_size="0.5 mm", label_phases={0: "void", 1: "aggregate", 2: "mortar"})
    """
    return _core.convert(image, dict(settings or {}), options)


def simulate(
    specimen: Union[Specimen, Path],
    settings: Optional[Settings] = None,
    /,
    *,
    output: Optional[Path] = None,
    overwrite: bool = False,
    estimate_error: bool = False,
    tolerance: Union[float, str, None] = None,
    progress: Optional[Callable[[Progress], Any]] = None,
    **options: Value,
) -> Result:
    """Break a specimen.

    specimen: a Specimen, or the path of a specimen.h5, a scene.toml or a picture.
    settings: by their keys, {"loading.stop_strain": 2e-4, "mortar.tensile_scale": "12 MPa"}.
    output: run folder to write, as the program does; with frames it must be given. Else see Result.save.
    overwrite: write into a folder that is not empty.
    estimate_error: add to the summary how wrong the peak may be, from runs without inertia and with another step,
        precision and pixel size.
    tolerance: choose the rate, the step and the precision, or the method without inertia, that keep the error of the peak
        stress below this [-]. Raises Error where no choice does.
    progress: is given a Progress at each row of the history; where it raises StopIteration the run ends, and what was
        computed is returned, as SciPy does.
    options: settings by their short names, see below.

    Ctrl-C raises Interrupted, a KeyboardInterrupt that has what was computed as .result; it comes to the main thread
    alone, and to no run in another one. What else progress raises ends the run and is raised again. Other threads go
    on meanwhile. Runs side by side want threads=1, each; the result does not depend on it.

    Raises Error for what cannot be solved, Diverged with what was computed as .result where the physics goes wrong, and
    FileError, with the result too where it was computed, when the disk fails.

        result = mesopix.simulate(specimen, {"mortar.tensile_scale": "12 MPa"}, velocity="0.1 m/s", seed=3)
    """
    return _core.simulate(
        specimen, dict(settings or {}), options, output, overwrite, estimate_error, tolerance, progress
    )


def calibrate(
    specimen: Union[Specimen, Path],
    settings: Optional[Settings] = None,
    /,
    *,
    peak_stress: Union[float, str, None] = None,
    peak_strain: Union[float, str, None] = None,
    target: Union[Path, "tuple[ArrayLike, ArrayLike]", None] = None,
    free: Union[str, Sequence[str], None] = None,
    seeds: Optional[int] = None,
    tolerance: Union[float, str, None] = None,
    max_evaluations: Optional[int] = None,
    progress: Optional[Callable[[Trial], Any]] = None,
    **options: Value,
) -> Calibration:
    """Fit parameters to a measured peak or curve, in the mean over several random strength fields.

    specimen: a Specimen, or the path of a scene.toml.
    settings: by their keys, where the search begins.
    peak_stress: to be met [Pa].
    peak_strain: strain of the platens at that stress [-].
    target: a whole curve in place of a peak: path of a CSV file with the columns strain and stress_MPa, or (strains [-],
        stresses [Pa]).
    free: what may change, as "tensile_scale" or ["mortar.young=10 GPa..30 GPa", "tensile_scale"]; None = tensile_scale
        for a peak stress, young for a peak strain, weibull_modulus with them for a curve.
    seeds: runs of each set of parameters; None = 4.
    tolerance: misfit at which the search ends [-]; None = 0.5 %.
    max_evaluations: sets of parameters to try at most; None = 100.
    progress: is given a Trial after each; where it raises StopIteration the search ends with the best so far.
    options: settings by their keys, or properties of phases.

    Whether the target was met is in Calibration.met. Ctrl-C raises Interrupted with the best so far as .result; what
    else progress raises is raised again. Raises Error for what cannot be fitted, FileError for a file that cannot be read.

        calibration = mesopix.calibrate(specimen, peak_stress="2.8 MPa")
        result = mesopix.simulate(specimen, calibration.settings)
    """
    wanted = {
        "peak_stress": peak_stress, "peak_strain": peak_strain, "target": target, "free": free, "seeds": seeds,
        "tolerance": tolerance, "max_evaluations": max_evaluations,
    }
    return _core.calibrate(specimen, dict(settings or {}), options, wanted, progress)


def study(
    specimen: Union[Specimen, Path],
    settings: Optional[Settings] = None,
    /,
    *,
    output: Path,
    vary: Optional[Mapping[str, Union[Sequence[Value], Mapping[str, Value]]]] = None,
    seeds: Union[int, Sequence[int], None] = None,
    seed_of: Optional[Sequence[str]] = None,
    sampling: Optional[str] = None,
    samples: Optional[int] = None,
    sampling_seed: Optional[int] = None,
    title: Optional[str] = None,
    jobs: Optional[int] = None,
    until_ci: Union[float, str, None] = None,
    retry: bool = False,
    progress: Optional[Callable[[StudyProgress], Any]] = None,
    **options: Value,
) -> Study:
    """Run a scene many times, with other seeds and values, one run on each core.

    specimen: a Specimen, or the path of a specimen.h5, a picture or a scene.toml; or that of a study.toml, which says
        itself what varies, so that only output, jobs, until_ci, retry and progress go with it.
    settings: by their keys, of all members.
    output: folder that keeps each member by what it depends on, with table.csv, table.h5 and report.html. The same call
        goes on with a study that was interrupted, and a study may grow by seeds, levels and samples.
    vary: {setting: values}; several settings with + between take one value. Values are a sequence, equal steps {"from":
        1, "to": 3, "steps": 5}, or a range {"low": 1, "high": 3} to sample. Numbers are in SI units.
    seeds: how many random fields each point is run with, or which.
    seed_of: tables whose seed varies, of ["damage", "generate"]; None = those that the scene has.
    sampling: how points fill the space of vary: "grid", "latin_hypercube" or "sobol"; None = grid.
    samples: points, of all but a grid.
    sampling_seed: of a Latin hypercube.
    title: of the report.
    jobs: members at a time; None = one a core. The results do not depend on it.
    until_ci: more seeds until the 95 % confidence interval of the mean peak stress is within this share of it [-].
    retry: run members again that have failed before.
    progress: is given a StudyProgress after each member; where it raises StopIteration no more members are begun, and
        what there is is returned.
    options: settings by their short names, of all members, see below.

    Members that have failed are in Study.failures. Ctrl-C raises Interrupted, what there is as .result; what else
    progress raises is raised again. Raises Error for what cannot be run, and with what there is as .result where
    until_ci was not met; FileError when the disk fails.

        study = mesopix.study("scene.toml", output="runs/rates", vary={"velocity": [0.02, 0.05, 0.1]}, seeds=10)
        study.table["peak_stress"]
    """
    what = {
        "title": title, "seeds": seeds, "seed_of": seed_of, "sampling": sampling, "samples": samples,
        "sampling_seed": sampling_seed, "vary": vary,
    }
    return _core.study(specimen, dict(settings or {}), options, what, output, jobs, until_ci, retry, progress)


def twin(
    original: Union[Specimen, Path],
    settings: Optional[Settings] = None,
    /,
    *,
    output: Path,
    count: Optional[int] = None,
    seed: Optional[int] = None,
    twin_width: Union[float, str, None] = None,
    twin_height: Union[float, str, None] = None,
    twin_pixel_size: Union[float, str, None] = None,
    gap: Union[float, str, None] = None,
    border: Optional[str] = None,
    overwrite: bool = False,
    progress: Optional[Callable[[TwinProgress], Any]] = None,
    **options: Value,
) -> Twins:
    """Draw random specimens that are like a picture: with its fraction, sizes, aspect ratios and directions.

    original: a Specimen, or the path of a picture, a specimen.h5 or a scene.toml.
    settings: by their keys, {"convert.width": "150 mm"}.
    output: folder for the twins, their statistics and report.html, and study.toml, which breaks them all.
    count: number of twins; None = 10.
    seed: of the first twin, the others have those after it; None = 1.
    twin_width, twin_height, twin_pixel_size: of the twins [m]; None = as the original.
    gap: least distance of aggregates [m]; None = as those of the original keep.
    border: "cut" = that of a saw cut, which cuts aggregates; "whole" = a wall, which keeps them inside; None = as that
        of the original.
    overwrite: write into a folder that is not empty.
    progress: is given a TwinProgress after each twin; where it raises StopIteration no more are drawn, and those that
        there are are returned.
    options: settings by their short names, see below.

    Ctrl-C raises Interrupted with the twins that were made as .result. Raises Error for what cannot be twinned,
    FileError when a file cannot be read or written.

        twins = mesopix.twin("photo.jpg", width="150 mm", pixels=300, count=50, output="runs/twins")
        mesopix.study(twins.folder + "/study.toml", output="runs/broken")
    """
    wanted = {
        "count": count, "seed": seed, "twin_width": twin_width, "twin_height": twin_height,
        "twin_pixel_size": twin_pixel_size, "gap": gap, "border": border,
    }
    return _core.twin(original, dict(settings or {}), options, wanted, output, overwrite, progress)


def stiffness(
    specimen: Union[Specimen, Path], settings: Optional[Settings] = None, /, **options: Value
) -> "dict[str, Any]":
    """Effective elastic moduli of a specimen: nothing moves, nothing breaks.

    specimen: a Specimen, or the path of a specimen.h5, a picture or a scene.toml.
    settings: by their keys, {"mortar.young": "25 GPa"}.
    options: settings by their short names, see below.

    The figures are those of mesopix stiffness --json: "uniform_stress", "periodic" and "uniform_strain" each have the tensor
    "stiffness_Pa" (xx, yy, xy) and its nearest isotropic "young_Pa" and "poisson"; "bounds" has those of the mixture.
    Raises Error for what has no stiffness, FileError for a file that cannot be read.

        young = mesopix.stiffness(specimen, plane="stress")["periodic"]["young_Pa"]
    """
    return _core.stiffness(specimen, dict(settings or {}), options)


def read_specimen(path: Path, /) -> Specimen:
    """Read a specimen.h5. Raises Error for what is none, FileError when it cannot be read."""
    return _core.read_specimen(path)


def read_result(folder: Path, /) -> Result:
    """Read the folder of a run, but for its notes and the estimate of its error, which are in its summary.json.

    Raises Error for what is no run folder, FileError when a file cannot be read.
    """
    return _core.read_result(folder)


def _append_settings(function: Callable[..., Any]) -> None:
    lines, group = ["", "Settings, by short name, with type and default:"], ""
    for name, key, kind, default, text in _core.described(function.__name__):
        if key.split(".")[0] != group:
            group = key.split(".")[0]
            lines += ["", f"{group}, each {{\"PHASE.young\": ...}}:" if group == "phases" else f"{group}:"]
        value = default.capitalize() if kind == "BOOLEAN" else default
        lines += [f"    {name}: {kind}" + (f" = {value}" if value else ""), f"        {text}"]
    indented = "\n".join(("    " + line).rstrip() for line in lines)
    function.__doc__ = str(function.__doc__).rstrip() + "\n" + indented


_functions: Sequence[Callable[..., Any]] = (generate, convert, twin, simulate, study, calibrate, stiffness)
for _function in _functions:
    _append_settings(_function)
