"""Makes runs side by side, in processes that are copies of this one."""

from __future__ import annotations

import contextlib
import ctypes
import os
import pathlib
import signal
import sys
import time
from multiprocessing.connection import Connection, Pipe, wait
from typing import Iterator, NoReturn, Sequence

from .. import set_log_level
from .artefacts import execute_and_keep
from .result import Result, Status
from .scenario import Case

#: Beyond its limit of wall time, after which a run's process is killed [s].
_GRACE = 5.0
#: How often the wall times are looked at [s].
_LOOK = 0.2
#: How long a process may take to end its programs [s].
_PATIENCE = 10.0
_PR_SET_PDEATHSIG = 1


class _Stopped(BaseException):
    """The process is to end."""


class _Worker:
    """A forked process: it has the cases already, and starts in a millisecond."""

    def __init__(self, cases: Sequence[Case], place: pathlib.Path, others: list[Connection]) -> None:
        ours, theirs = Pipe()
        parent = os.getpid()
        sys.stdout.flush()
        sys.stderr.flush()
        self.pid = os.fork()
        if self.pid == 0:
            for each in (ours, *others):
                each.close()
            _work(cases, place, theirs, parent)
        theirs.close()
        self.connection = ours
        #: What it does now, and since when.
        self.case: int | None = None
        self.since = 0.0
        #: Groups of processes of programs that it has started.
        self.groups: set[int] = set()

    def give(self, case: int) -> None:
        self.case = case
        self.since = time.monotonic()
        with contextlib.suppress(OSError):
            self.connection.send(case)

    def end(self, number: int) -> str:
        """Ends it with a signal, and the programs that it has started. Returns how it ended."""
        with contextlib.suppress(ProcessLookupError):
            os.kill(self.pid, number)
        status = self._wait()
        for group in self.groups:
            with contextlib.suppress(ProcessLookupError, PermissionError):
                os.killpg(group, signal.SIGKILL)
        self.connection.close()
        if os.WIFSIGNALED(status):
            return f"was killed by {signal.Signals(os.WTERMSIG(status)).name}"
        return f"ended with code {os.WEXITSTATUS(status)}"

    def _wait(self) -> int:
        end = time.monotonic() + _PATIENCE
        while time.monotonic() < end:
            pid, status = os.waitpid(self.pid, os.WNOHANG)
            if pid:
                return status
            time.sleep(0.005)
        with contextlib.suppress(ProcessLookupError):
            os.kill(self.pid, signal.SIGKILL)
        return os.waitpid(self.pid, 0)[1]


def _work(cases: Sequence[Case], place: pathlib.Path, connection: Connection, parent: int) -> NoReturn:
    """What a forked process does until its parent ends."""
    def stop(signum: int, frame: object) -> None:
        # a second one would go past what catches the first
        signal.signal(signal.SIGTERM, signal.SIG_IGN)
        raise _Stopped

    code = 0
    try:
        # Ctrl-C is for the parent, which then ends this
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        signal.signal(signal.SIGTERM, stop)
        ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGTERM)
        if os.getppid() == parent:
            # what goes wrong is in the result
            set_log_level(0)
            while True:
                number = connection.recv()
                connection.send(execute_and_keep(
                    cases[number], place, noted=lambda group, begins: connection.send((group, begins)),
                    again=lambda: connection.send(None)))
    except (_Stopped, EOFError, OSError):
        pass
    except BaseException:
        import traceback

        traceback.print_exc()
        code = 1
    # nothing of the parent's is to be done twice
    sys.stderr.flush()
    os._exit(code)


class Pool:
    """Processes that make the runs. If one is killed, its run has failed."""

    def __init__(self, cases: Sequence[Case], place: pathlib.Path, jobs: int) -> None:
        self._cases = cases
        self._place = place
        self._jobs = min(jobs, len(cases))
        self._workers: list[_Worker] = []
        self._next = 0

    def __enter__(self) -> Pool:
        return self

    def __exit__(self, *raised: object) -> None:
        # all at once, then each
        for worker in self._workers:
            with contextlib.suppress(ProcessLookupError):
                os.kill(worker.pid, signal.SIGTERM)
        for worker in self._workers:
            worker.end(signal.SIGTERM)
        self._workers.clear()

    def results(self) -> Iterator[tuple[int, Result]]:
        """Makes all runs, and yields the number and result of each as it ends."""
        while True:
            self._hand_out()
            if not any(worker.case is not None for worker in self._workers):
                return
            for each in wait([worker.connection for worker in self._workers], _LOOK):
                yield from self._hear(next(worker for worker in self._workers if worker.connection is each))
            yield from self._overdue()

    def _hand_out(self) -> None:
        while self._next < len(self._cases):
            worker = next((each for each in self._workers if each.case is None), None)
            if worker is None:
                if len(self._workers) == self._jobs:
                    return
                worker = _Worker(self._cases, self._place, [each.connection for each in self._workers])
                self._workers.append(worker)
            worker.give(self._next)
            self._next += 1

    def _hear(self, worker: _Worker) -> Iterator[tuple[int, Result]]:
        try:
            message = worker.connection.recv()
        except (EOFError, OSError):
            yield self._bury(worker, "")
            return
        if message is None:
            # it makes the run again, to keep something of it
            worker.since = time.monotonic()
            return
        if isinstance(message, tuple):
            group, begins = message
            (worker.groups.add if begins else worker.groups.discard)(group)
            return
        number, worker.case = worker.case, None
        assert number is not None
        yield number, message

    def _overdue(self) -> Iterator[tuple[int, Result]]:
        now = time.monotonic()
        for worker in list(self._workers):
            if worker.case is None:
                continue
            limit = self._cases[worker.case].wall
            if now - worker.since > limit + _GRACE:
                yield self._bury(worker, f"the world hangs: it took longer than {limit:g} s of wall time, and was killed")

    def _bury(self, worker: _Worker, reason: str) -> tuple[int, Result]:
        self._workers.remove(worker)
        number = worker.case
        how = worker.end(signal.SIGKILL)
        assert number is not None
        return number, Result(Status.FAILED, reason or f"its process {how}", wall_time=time.monotonic() - worker.since)
