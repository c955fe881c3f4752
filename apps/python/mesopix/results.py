"""What results give beside their arrays."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from . import Result

__all__ = ["Curve", "damage", "plot"]


class Curve(NamedTuple):
    """A stress-strain curve, positive in the direction of the loading."""

    strain: NDArray[np.float64]  #: platen displacement over height [-]
    stress: NDArray[np.float64]  #: mean of the reactions of both platens over the width [Pa]


def damage(result: Result, strain: float | None = None) -> NDArray[np.uint8]:
    """How the point of each pixel has failed at a platen strain.

    strain: [-]; None = at the end.
    Returns a new uint8 array of shape (rows, columns), row 0 on top: 0 = it has not, 1 = in tension, 2 = in shear.
    """
    if strain is None:
        return result.failure_mode.copy()
    if np.isnan(strain):
        raise ValueError("strain: nan; must be a number; a run without a peak has no peak_strain, see peak_reached")
    return np.where(result.failure_strain <= strain, result.failure_mode, 0).astype(np.uint8)


def plot(result: Result, ax: Any = None, **line: Any) -> Any:
    """Draw the curve in MPa over microstrain with matplotlib, which must be there.

    ax: where to; None = a new figure.   line: passed to Axes.plot.
    Returns the axes.
    """
    if ax is None:
        from matplotlib import pyplot  # type: ignore[import]

        ax = pyplot.figure().add_subplot()
    strain, stress = result.curve
    ax.plot(1e6 * strain, 1e-6 * stress, **line)
    ax.set_xlabel("strain [microstrain]")
    ax.set_ylabel("stress [MPa]")
    return ax
