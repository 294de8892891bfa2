"""Exceptions. All derive from `Error`."""

from __future__ import annotations

import os
import traceback
from typing import TYPE_CHECKING, Sequence

if TYPE_CHECKING:
    from ._core import Diagnostic


class Error(Exception):
    """Base class of all exceptions of pongsim."""


class LoadError(Error):
    """A world or model can't be loaded. The text lists all errors with file, line and column."""

    def __init__(self, diagnostics: Sequence[Diagnostic]) -> None:
        #: All errors and warnings, in the order of the file.
        self.diagnostics: list[Diagnostic] = list(diagnostics)
        errors = [each for each in self.diagnostics if each.is_error] or self.diagnostics
        super().__init__("\n".join(str(each) for each in errors) or "it can't be loaded")
        #: Position of the first error; None and 0 if it has none.
        self.file: str | None = errors[0].file if errors else None
        self.line: int = errors[0].line if errors else 0
        self.column: int = errors[0].column if errors else 0

    def __reduce__(self) -> tuple[object, ...]:
        return (Error, (str(self),))


class Gone(Error):
    """The object no longer exists: its model was removed, or the simulation was closed."""


class Refused(Error):
    """A change was refused and has no effect. The text has the reason."""


class Busy(Error):
    """Another thread is stepping the simulation, or a change was requested within a step."""


class SystemFailed(Error):
    """A system has failed: its name and the reason. For a system in Python, `__cause__` is its exception."""


class ServiceError(Error):
    """A service does not exist, did not respond, or has refused. The text says which."""


class NoReading(Error):
    """A sensor has no reading yet: it takes one in the next step in which one is due."""


class WorldWarning(UserWarning):
    """Something in a file is left out or doubtful; the rest runs."""


def describe(exception: BaseException) -> str:
    """An exception and its position: "ValueError: too far (judge.py:12)"."""
    text = "".join(traceback.format_exception_only(type(exception), exception)).strip()
    frames = traceback.extract_tb(exception.__traceback__)
    if not frames:
        return text
    return f"{text} ({os.path.basename(frames[-1].filename)}:{frames[-1].lineno})"
