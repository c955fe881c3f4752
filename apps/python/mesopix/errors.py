"""What goes wrong, and what to do about it."""
from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from . import Calibration, Result, Study, Twins

__all__ = ["Complaint", "Diverged", "Doubt", "Error", "FileError", "Interrupted", "LongRun"]


class Doubt(UserWarning):
    """What speaks against a specimen of a picture: much of it void, no aggregate, a width of micrometres ...

    warnings.simplefilter("ignore", mesopix.Doubt) silences it.
    """


class LongRun(UserWarning):
    """Said before a call that takes a minute or more here: what is computed, and how long that takes.

    warnings.simplefilter("ignore", mesopix.LongRun) silences it.
    """


class Complaint(NamedTuple):
    """One mistake; parts that say nothing are empty."""

    text: str  #: all of it on one line: "PLACE: FIELD: VALUE; ALLOWED; CURE"
    place: str  #: "scene.toml:3:8", of settings in a scene
    field: str  #: the setting, the argument or the file that is at fault
    value: str  #: the value met
    allowed: str  #: what would have been accepted
    cure: str  #: what to try


class _Complaints:
    """What errors share that name what is at fault."""

    complaints: tuple[Complaint, ...]  #: every mistake that was found, one at least

    def __str__(self) -> str:
        return "\n".join(complaint.text for complaint in self.complaints)

    @property
    def place(self) -> str:
        """Of the first mistake, as are the following."""
        return self.complaints[0].place

    @property
    def field(self) -> str:
        return self.complaints[0].field

    @property
    def value(self) -> str:
        return self.complaints[0].value

    @property
    def allowed(self) -> str:
        return self.complaints[0].allowed

    @property
    def cure(self) -> str:
        return self.complaints[0].cure


class Error(_Complaints, ValueError):
    """A value, a scene, a picture or a specimen that cannot be used."""

    def __init__(self, *complaints: Complaint) -> None:
        super().__init__(*complaints)
        self.complaints = complaints
        self.result: Study | None = None  #: of a study that did not come to what was asked for


class FileError(_Complaints, OSError):
    """A file that cannot be read or written: a complaint each, `field` the file or the argument that names it."""

    def __init__(self, *complaints: Complaint) -> None:
        super().__init__()
        self.args = complaints
        self.complaints = complaints
        self.result: Result | None = None  #: of a run whose folder the disk did not take whole


class Diverged(RuntimeError):
    """Physics gone wrong: the text names the step, the time, the place, and what to try."""

    def __init__(self, text: str, result: Result) -> None:
        super().__init__(text, result)
        self.result: Result = result  #: what was computed before

    def __str__(self) -> str:
        return str(self.args[0])


class Interrupted(KeyboardInterrupt):
    """Ctrl-C during a run, a calibration, a study or the drawing of twins."""

    def __init__(self, text: str, result: Result | Calibration | Study | Twins | None) -> None:
        super().__init__(text, result)
        self.result: Result | Calibration | Study | Twins | None = result  #: what was computed until then; None = nothing

    def __str__(self) -> str:
        return str(self.args[0])
