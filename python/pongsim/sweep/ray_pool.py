"""Runs on a Ray cluster that is there."""

from __future__ import annotations

import socket
from typing import Any, Iterable, Iterator

from .. import _core
from .errors import SweepError, need
from .execute import execute
from .plan import Plan, Row, Run

#: How often Ray starts a run again whose process or node is lost.
_RETRIES = 5
#: Runs that are handed to Ray and have not ended; it spreads them over its nodes.
_OPEN = 1000
#: How long a cluster may take to answer [s].
_PATIENCE = 5.0


def _make(plan: Plan, run: Run) -> Row:
    if _core.version != plan.version:
        return Row(run.number, run.parameters, run.seed,
                   reason=f"the node has pongsim {_core.version}, the sweep was begun with {plan.version}")
    return execute(plan, run)


class RayPool:
    """The runs of a plan as tasks of Ray, which decides where and when."""

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
                                 hint="begin one with: ray start --head") from None

    def __enter__(self) -> RayPool:
        return self

    def __exit__(self, *raised: object) -> None:
        if self._is_ours:
            self._ray.shutdown()

    def rows(self, runs: Iterable[Run]) -> Iterator[Row]:
        """Makes the runs, and gives the row of each as it comes."""
        ray = self._ray
        plan = ray.put(self._plan)
        make = ray.remote(num_cpus=1, max_retries=_RETRIES)(_make)
        left = iter(runs)
        opened: dict[Any, Run] = {}
        while True:
            for run in left:
                opened[make.remote(plan, run)] = run
                if len(opened) >= _OPEN:
                    break
            if not opened:
                return
            ended, _ = ray.wait(list(opened), num_returns=1)
            for reference in ended:
                run = opened.pop(reference)
                try:
                    row: Row = ray.get(reference)
                except Exception as error:
                    row = Row(run.number, run.parameters, run.seed,
                              reason=f"Ray has lost it {_RETRIES + 1} times: {_first_line(error)}")
                yield row


def _reach(address: str) -> None:
    """Raises SweepError where nobody listens, which Ray itself takes minutes to find."""
    host, colon, port = address.removeprefix("ray://").rpartition(":")
    if address in ("auto", "local") or not colon:
        if address != "auto":
            raise SweepError(f"'{address}' is no address of a Ray cluster", hint="HOST:PORT, ray://HOST:PORT or auto")
        return
    try:
        socket.create_connection((host, int(port)), _PATIENCE).close()
    except (OSError, ValueError, OverflowError) as error:
        raise SweepError(f"there is no Ray cluster at '{address}': {error}", hint="begin one with: ray start --head") from None


def _first_line(error: BaseException) -> str:
    return (str(error).strip() or type(error).__name__).splitlines()[0]
