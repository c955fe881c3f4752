"""What callbacks are told."""
from __future__ import annotations

from typing import NamedTuple

__all__ = ["Progress", "StudyProgress", "Trial", "TwinProgress"]


class Progress(NamedTuple):
    """A run on its way, at a row of its history."""

    fraction: float  #: of the strain at which the run ends that is done [-]
    time: float  #: [s]
    strain: float  #: platen displacement over height [-]
    stress: float  #: mean of the reactions of both platens over the width [Pa]
    tension_failures: int  #: points that have failed in tension so far
    shear_failures: int  #: points that have failed in shear so far
    wall_time: float  #: since the run began [s]

    @property
    def failures(self) -> int:
        """Points that have failed so far."""
        return self.tension_failures + self.shear_failures


class Trial(NamedTuple):
    """A calibration on its way, after one more set of parameters."""

    number: int  #: 1, 2, ...
    misfit: float  #: of this one [-]
    best_misfit: float  #: of all so far [-]
    factors: list[float]  #: on the values in the scene, one a free parameter [-]
    peak_stress: float  #: mean of the seeds that reached a peak [Pa]; NaN where none did
    peak_strain: float  #: mean of these seeds [-]


class StudyProgress(NamedTuple):
    """A study on its way, after one more member."""

    done: int  #: members that have a result now
    failed: int  #: members that have failed now
    before: int  #: members that were done, or had failed, before the call
    all: int  #: members of the study


class TwinProgress(NamedTuple):
    """Twins on their way, after one more."""

    done: int
    all: int
