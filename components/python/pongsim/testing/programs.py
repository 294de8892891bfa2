"""Programs that run beside a world."""

from __future__ import annotations

import contextlib
import ctypes
import os
import re
import signal
import subprocess
import tempfile
import time
from typing import IO, Callable

from .scenario import Program

#: How long a program may take to end after each signal [s].
_PATIENCE = ((signal.SIGINT, 2.0), (signal.SIGTERM, 1.0), (signal.SIGKILL, 5.0))
#: Of what it printed: as many lines are shown.
_LAST_LINES = 12
_LOOK = 0.01
_PR_SET_PDEATHSIG = 1
_LIBC = ctypes.CDLL(None)

#: Told the number of a group of processes that has begun (True) or ended.
Noted = Callable[[int, bool], None]


class ProgramError(Exception):
    """A program did not start, died or did not get ready. The text has its last words."""


def _begin() -> None:
    """Called in the new process: it ends with its parent, however that ends, and can be interrupted, which its parent
    can't."""
    _LIBC.prctl(_PR_SET_PDEATHSIG, signal.SIGKILL)
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGTERM})


class Beside:
    """A program with all that it starts: a group of processes of its own."""

    def __init__(self, program: Program, noted: Noted) -> None:
        self.program = program
        self._noted = noted
        self._output: IO[bytes] = tempfile.TemporaryFile()
        self._process: subprocess.Popen[bytes] | None = None

    def start(self) -> None:
        """Starts it. Raises ProgramError. Whatever it raises, `end` ends what has started."""
        program = self.program
        environment = {**os.environ, **program.environment}
        # a signal that ends this process waits until the new one is known here
        before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGTERM})
        try:
            self._process = subprocess.Popen(
                program.command, cwd=program.folder, env=environment, stdin=subprocess.DEVNULL, stdout=self._output,
                stderr=subprocess.STDOUT, start_new_session=True,
                preexec_fn=_begin)
        except OSError as error:
            where = f"{error.filename}: {error.strerror}" if error.filename else str(error)
            raise ProgramError(f"program '{program.name}' does not start: {where}") from None
        except subprocess.SubprocessError as error:
            raise ProgramError(f"program '{program.name}' does not start: {error}") from None
        finally:
            signal.pthread_sigmask(signal.SIG_SETMASK, before)
        self._noted(self._process.pid, True)

    def output(self) -> str:
        """Returns all that it has printed so far."""
        size = os.fstat(self._output.fileno()).st_size
        return os.pread(self._output.fileno(), size, 0).decode(errors="replace")

    def last_words(self) -> str:
        """Returns its last lines, indented."""
        lines = self.output().rstrip().splitlines()
        return "".join(f"\n  | {line}" for line in lines[-_LAST_LINES:]) or "\n  it printed nothing"

    def check(self) -> None:
        """Raises ProgramError if it has ended and must not have."""
        assert self._process is not None
        code = self._process.poll()
        if code is None or (code == 0 and self.program.ends):
            return
        raise ProgramError(f"program '{self.program.name}' {_how(code)} before the run was over{self.last_words()}")

    def wait_until_ready(self, is_known: Callable[[str, bool], bool], go_on: Callable[[], object]) -> None:
        """Waits until it is ready. Raises ProgramError.

        is_known: whether a topic has a publisher (True) or a subscriber in another process.
        go_on: called meanwhile.
        """
        assert self._process is not None
        ready = self.program.ready
        if ready is None:
            return
        end = time.monotonic() + self.program.wait
        while not self._is_ready(ready.kind, ready.value, is_known):
            if self._process.poll() is not None and not (self.program.ends and self._process.returncode == 0):
                raise ProgramError(f"program '{self.program.name}' {_how(self._process.returncode)} before it was "
                                   f"ready{self.last_words()}")
            if time.monotonic() > end:
                raise ProgramError(f"program '{self.program.name}' was not ready within {self.program.wait:g} s: it "
                                   f"{_WAITED[ready.kind]} {ready.value}{self.last_words()}")
            go_on()
            time.sleep(_LOOK)

    def _is_ready(self, kind: str, value: str, is_known: Callable[[str, bool], bool]) -> bool:
        if kind == "prints":
            return re.search(value, self.output(), re.MULTILINE) is not None
        return is_known(value, kind == "publishes")

    def end(self) -> str:
        """Ends it and all that it has started, and returns what it printed."""
        if self._process is None:
            self._output.close()
            return ""
        group = self._process.pid
        for number, patience in _PATIENCE:
            with contextlib.suppress(ProcessLookupError, PermissionError):
                os.killpg(group, number)
            with contextlib.suppress(subprocess.TimeoutExpired):
                self._process.wait(patience)
                break
        # what it has started and left behind
        with contextlib.suppress(ProcessLookupError, PermissionError):
            os.killpg(group, signal.SIGKILL)
        # who is to be told may be gone
        with contextlib.suppress(OSError):
            self._noted(group, False)
        text = self.output()
        self._output.close()
        return text


_WAITED = {"prints": "did not print", "publishes": "did not publish", "subscribes": "did not subscribe to"}


def _how(code: int) -> str:
    if code >= 0:
        return f"ended with code {code}"
    with contextlib.suppress(ValueError):
        return f"was killed by {signal.Signals(-code).name}"
    return f"was killed by signal {-code}"
