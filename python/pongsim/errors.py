"""What goes wrong, as exceptions. All derive from `Error`."""

from __future__ import annotations

import os
import traceback
from typing import TYPE_CHECKING, Sequence

if TYPE_CHECKING:
    from ._core import Diagnostic


class Error(Exception):
    """What all exceptions of pongsim are."""


class LoadError(Error):
    """A world or a model can't be loaded. Its text names each fault with file, line and column."""

    def __init__(self, diagnostics: Sequence[Diagnostic]) -> None:
        #: All that was found, warnings too, in the order of the file.
        self.diagnostics: list[Diagnostic] = list(diagnostics)
        errors = [each for each in self.diagnostics if each.is_error] or self.diagnostics
        super().__init__("\n".join(str(each) for each in errors) or "it can't be loaded")
        #: Of the first error; None and 0 where it has no place in a file.
        self.file: str | None = errors[0].file if errors else None
        self.line: int = errors[0].line if errors else 0
        self.column: int = errors[0].column if errors else 0

    def __reduce__(self) -> tuple[object, ...]:
        return (Error, (str(self),))


class Gone(Error):
    """What is asked is not there any more: its model was removed, or the simulation is closed."""


class Refused(Error):
    """A change was refused, and nothing was changed. The text says why."""


class Busy(Error):
    """Another thread steps the simulation, or a change is asked for from within a step."""


class SystemFailed(Error):
    """A system has failed: its name and why. Of a system in Python `__cause__` is what it has raised."""


class ServiceError(Error):
    """A service is not there, did not answer, or has refused. The text says which."""


class NoReading(Error):
    """A sensor has no reading yet: it takes one when a step comes at which one is due."""


class WorldWarning(UserWarning):
    """Something in a file is left out or doubtful, and the rest of it runs."""


def describe(exception: BaseException) -> str:
    """What was raised and where: "ValueError: too far (judge.py:12)"."""
    text = "".join(traceback.format_exception_only(type(exception), exception)).strip()
    frames = traceback.extract_tb(exception.__traceback__)
    if not frames:
        return text
    return f"{text} ({os.path.basename(frames[-1].filename)}:{frames[-1].lineno})"
