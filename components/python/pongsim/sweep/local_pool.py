"""Makes runs in processes on this machine."""

from __future__ import annotations

import collections
import contextlib
import os
import pathlib
import signal
import socket
import subprocess
import sys
import time
from multiprocessing.connection import Connection, wait
from typing import Iterable, Iterator

from .errors import SweepError
from .plan import Plan, Row, Run

#: Where a process finds this package: not in its current folder.
_START = "import sys; sys.path[0] = sys.argv.pop(1); from pongsim.sweep.worker import main; main()"
_PACKAGES = str(pathlib.Path(__file__).resolve().parents[2])
#: Number of runs assigned to a worker: the current one and the next, so that it never waits.
_AHEAD = 2
#: Time beyond its limit after which a run's process is killed [s].
_GRACE = 5.0
#: Give up after this many workers that ended before they started.
_FALSE_STARTS = 3
#: How often the wall times are checked [s].
_LOOK = 0.5


class _Worker:
    def __init__(self, plan: Plan) -> None:
        ours, theirs = socket.socketpair()
        with theirs:
            self.process = subprocess.Popen(
                [sys.executable, "-c", _START, _PACKAGES, str(os.getpid()), str(theirs.fileno())],
                pass_fds=[theirs.fileno()], stdin=subprocess.DEVNULL, stdout=2, start_new_session=True)
        self.connection = Connection(ours.detach())
        self.runs: collections.deque[Run] = collections.deque()
        self.is_ready = False
        #: When its current run started.
        self.since = 0.0
        with contextlib.suppress(OSError):
            self.connection.send(plan)

    def give(self, run: Run) -> None:
        if not self.runs:
            self.since = time.monotonic()
        self.runs.append(run)
        with contextlib.suppress(OSError):
            # if it has exited, its end of the connection shows that
            self.connection.send(run)

    def end(self) -> str:
        """Kills it. Returns how it ended, before that or because of it."""
        if self.process.poll() is None:
            with contextlib.suppress(subprocess.TimeoutExpired):
                # one whose connection is closed is about to exit
                self.process.wait(0.2)
        self.process.kill()
        code = self.process.wait()
        self.connection.close()
        if code < 0:
            with contextlib.suppress(ValueError):
                return f"was killed by {signal.Signals(-code).name}"
            return f"was killed by signal {-code}"
        return f"ended with code {code}"


class LocalPool:
    """Processes that make the runs of a plan. If one is killed, only its current run is lost."""

    def __init__(self, plan: Plan, jobs: int) -> None:
        self._plan = plan
        self._jobs = jobs
        self._workers: list[_Worker] = []
        self._left: collections.deque[Run] = collections.deque()
        self._false_starts = 0

    def __enter__(self) -> LocalPool:
        return self

    def __exit__(self, *raised: object) -> None:
        for worker in self._workers:
            worker.process.kill()
        for worker in self._workers:
            worker.end()
        self._workers.clear()

    def rows(self, runs: Iterable[Run]) -> Iterator[Row]:
        """Makes the runs, and yields the row of each as it arrives."""
        self._left.extend(runs)
        while self._left or any(worker.runs for worker in self._workers):
            busy = sum(1 for worker in self._workers if worker.runs)
            while len(self._workers) < min(self._jobs, len(self._left) + busy):
                self._workers.append(_Worker(self._plan))
            for _ in range(_AHEAD):
                self._hand_out()
            ready = wait([worker.connection for worker in self._workers], _LOOK)
            for worker in list(self._workers):
                if worker.connection in ready:
                    yield from self._hear(worker)
            yield from self._overdue()

    def _hand_out(self) -> None:
        """Assigns runs to workers that have too few, the busiest last."""
        for worker in sorted(self._workers, key=lambda each: len(each.runs)):
            # near the end, no worker keeps one waiting that another could make
            ahead = _AHEAD if len(self._left) > self._jobs else 1
            if worker.is_ready and len(worker.runs) < ahead and self._left:
                worker.give(self._left.popleft())

    def _hear(self, worker: _Worker) -> Iterator[Row]:
        try:
            row: Row | None = worker.connection.recv()
        except (EOFError, OSError):
            yield from self._bury(worker, "")
            return
        if row is None:
            worker.is_ready = True
            self._false_starts = 0
            return
        worker.runs.popleft()
        worker.since = time.monotonic()
        yield row

    def _overdue(self) -> Iterator[Row]:
        now = time.monotonic()
        for worker in list(self._workers):
            if worker.runs and now - worker.since > self._plan.wall_limit + _GRACE:
                worker.process.kill()
                yield from self._bury(worker, f"it took longer than {self._plan.wall_limit:g} s of wall time, and was killed")

    def _bury(self, worker: _Worker, reason: str) -> Iterator[Row]:
        how = worker.end()
        self._workers.remove(worker)
        if not worker.is_ready:
            self._false_starts += 1
            if self._false_starts >= _FALSE_STARTS:
                raise SweepError(f"the processes for the runs can't be started: the last one {how}")
        if worker.runs:
            run = worker.runs.popleft()
            self._left.extendleft(reversed(worker.runs))
            yield Row(run.number, run.parameters, run.seed, reason=reason or f"its process {how}",
                      wall_time=time.monotonic() - worker.since)
