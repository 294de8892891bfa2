"""Runs in processes of this machine."""

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

#: Where a process finds this package: not in the folder that it is started in.
_START = "import sys; sys.path[0] = sys.argv.pop(1); from pongsim.sweep.worker import main; main()"
_PACKAGES = str(pathlib.Path(__file__).resolve().parents[2])
#: Runs that a worker has: the one it makes, and the next, so that it waits for nobody.
_AHEAD = 2
#: How much longer than its limit a run may take before its process is killed [s].
_GRACE = 5.0
#: So many workers that end before they have begun are enough.
_FALSE_STARTS = 3
#: How often the wall times are looked at [s].
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
        #: Since when it makes the first of its runs.
        self.since = 0.0
        with contextlib.suppress(OSError):
            self.connection.send(plan)

    def give(self, run: Run) -> None:
        if not self.runs:
            self.since = time.monotonic()
        self.runs.append(run)
        with contextlib.suppress(OSError):
            # of one that has gone, its end of the connection tells
            self.connection.send(run)

    def end(self) -> str:
        """Kills it. Returns how it has ended before that, or by this."""
        if self.process.poll() is None:
            with contextlib.suppress(subprocess.TimeoutExpired):
                # one whose connection is closed is about to end
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
    """Processes that make the runs of a plan. One that is killed takes its run with it, and no other."""

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
        """Makes the runs, and gives the row of each as it comes."""
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
        """A run for each that has too few, the busiest last."""
        for worker in sorted(self._workers, key=lambda each: len(each.runs)):
            # towards the end nobody has one waiting that another could make
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
