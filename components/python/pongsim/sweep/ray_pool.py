"""Makes runs on an existing Ray cluster."""

from __future__ import annotations

import collections
import socket
from typing import Any, Iterable, Iterator

from .. import _core
from .errors import SweepError, need
from .execute import execute
from .plan import Plan, Row, Run

#: How often Ray restarts a run whose process or node is lost.
_RETRIES = 5
#: Number of tasks submitted for each processor of the cluster: one that is running, and those that wait.
_OPEN = 3
#: Duration of a task [s]; it makes as many runs as fit, because each task costs some milliseconds.
_TASK = 0.5
#: Maximum number of runs in a task, because they are repeated together.
_MOST_RUNS = 32
#: Timeout for a cluster's answer [s].
_PATIENCE = 5.0


def _make(plan: Plan, runs: list[Run]) -> list[Row]:
    if _core.version != plan.version:
        reason = f"the node has pongsim {_core.version}, but the sweep was started with {plan.version}"
        return [Row(run.number, run.parameters, run.seed, reason=reason) for run in runs]
    return [execute(plan, run) for run in runs]


class RayPool:
    """Makes the runs of a plan as Ray tasks; Ray decides where and when."""

    def __init__(self, plan: Plan, address: str) -> None:
        self._ray: Any = need("ray", "--ray")
        self._plan = plan
        self._is_ours = not self._ray.is_initialized()
        if self._is_ours:
            _reach(address)
            try:
                self._ray.init(address=address, log_to_driver=False, configure_logging=False)
            except Exception as error:
                raise SweepError(f"there is no Ray cluster at '{address}': {_first_line(error)}",
                                 hint="start one with: ray start --head") from None

    def __enter__(self) -> RayPool:
        return self

    def __exit__(self, *raised: object) -> None:
        if self._is_ours:
            self._ray.shutdown()

    def rows(self, runs: Iterable[Run]) -> Iterator[Row]:
        """Makes the runs, and yields the row of each as it arrives."""
        ray = self._ray
        plan = ray.put(self._plan)
        make = ray.remote(num_cpus=1, max_retries=_RETRIES)(_make)
        left = collections.deque(runs)
        opened: dict[Any, list[Run]] = {}
        #: Runs that get a task each, because one of them has ended its process.
        doubtful: set[int] = set()
        together = 1
        while left or opened:
            while left and len(opened) < self._room():
                batch = [left.popleft()]
                while left and len(batch) < together and not {batch[0].number, left[0].number} & doubtful:
                    batch.append(left.popleft())
                opened[make.remote(plan, batch)] = batch
            [ended], _ = ray.wait(list(opened), num_returns=1)
            batch = opened.pop(ended)
            try:
                rows: list[Row] = ray.get(ended)
            except Exception as error:
                if len(batch) > 1:
                    doubtful.update(run.number for run in batch)
                    left.extendleft(reversed(batch))
                    continue
                rows = [Row(run.number, run.parameters, run.seed,
                            reason=f"Ray lost it {_RETRIES + 1} times: {_first_line(error)}") for run in batch]
            together = min(_MOST_RUNS, max(1, int(_TASK * len(rows) / (sum(row.wall_time for row in rows) or _TASK))))
            yield from rows

    def _room(self) -> int:
        """Returns how many tasks may be open with the current nodes."""
        return _OPEN * max(1, int(self._ray.cluster_resources().get("CPU", 1)))


def _reach(address: str) -> None:
    """Raises SweepError if nobody listens, which Ray itself takes minutes to notice."""
    host, colon, port = address.removeprefix("ray://").rpartition(":")
    if address in ("auto", "local") or not colon:
        if address != "auto":
            raise SweepError(f"'{address}' is not the address of a Ray cluster", hint="HOST:PORT, ray://HOST:PORT or auto")
        return
    try:
        socket.create_connection((host, int(port)), _PATIENCE).close()
    except (OSError, ValueError, OverflowError) as error:
        raise SweepError(f"there is no Ray cluster at '{address}': {error}", hint="start one with: ray start --head") from None


def _first_line(error: BaseException) -> str:
    return (str(error).strip() or type(error).__name__).splitlines()[0]
