"""Makes runs one after another, in this process."""

from __future__ import annotations

import contextlib
import signal
import threading
import time
import warnings
from typing import Any, Iterator

from ..errors import LoadError, SystemFailed, WorldWarning, describe
from ..simulation import Simulation
from . import template, world
from .errors import SweepError
from .measures import Functions, MeasureError, Reached, TopicMeasure, watch
from .plan import Function, Plan, Row, Run


class WallLimit(BaseException):
    """The run has exceeded its wall time. Not an Exception, so that functions that catch those do not continue."""


@contextlib.contextmanager
def wall_limit(seconds: float) -> Iterator[None]:
    """Interrupts code that takes longer by raising WallLimit, in steps and in Python. Only a main thread can be
    interrupted."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return

    def end(signum: int, frame: Any) -> None:
        raise WallLimit

    before = signal.signal(signal.SIGALRM, end)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


class Executor:
    """Makes the runs of a plan. If the world does not change, it is loaded once, and reset before each further run."""

    def __init__(self, plan: Plan) -> None:
        self.plan = plan
        self._functions = Functions(plan)
        functions = any(isinstance(each, Function) for each in plan.measures)
        #: A function may change its simulation in any way.
        self._keeps = not (plan.fresh or plan.setup is not None or functions)
        self._sim: Simulation | None = None
        self._text: str | None = None

    def execute(self, run: Run) -> Row:
        """Makes one run. Any error is reported in the row."""
        row = Row(run.number, run.parameters, run.seed)
        begin = time.perf_counter()
        try:
            with wall_limit(self.plan.wall_limit):
                self._attempt(run, row)
            row.status = "done"
        except WallLimit:
            row.reason = f"it took longer than {self.plan.wall_limit:g} s of wall time"
        except (SweepError, MeasureError) as error:
            row.reason = str(error)
        except LoadError as error:
            row.reason = "; ".join(str(each).splitlines()[0] for each in error.diagnostics if each.is_error) or str(error)
        except (Exception, SystemExit) as error:
            row.reason = describe(error)
        finally:
            row.wall_time = time.perf_counter() - begin
        if self._sim is not None:
            row.sim_time = self._sim.time
            if not row.is_done or not self._keeps:
                incomplete = self._drop()
                if row.is_done and incomplete is not None:
                    row.status, row.reason = "failed", incomplete
        if not row.is_done:
            row.measures, row.state_hash = {}, ""
        return row

    def close(self) -> None:
        """Closes the world."""
        self._drop_kept()

    def _attempt(self, run: Run, row: Row) -> None:
        plan = self.plan
        sim = self._ready(run, row)
        if plan.setup is not None:
            self._functions.find(plan.setup)(sim, dict(run.parameters))
        topics: list[TopicMeasure] = []
        watched = None
        try:
            for measure in plan.measures:
                if not isinstance(measure, Function):
                    topics.append(TopicMeasure(measure, sim))
            watched = watch(plan.until, sim) if plan.until is not None else None
            self._run(sim, run)
            for measure in plan.measures:
                if isinstance(measure, Function):
                    row.measures[measure.name] = self._functions.measure(measure, sim, run.parameters)
            row.state_hash = f"{sim.state_hash():016x}"
            if watched is not None:
                watched.close()
            # deliver what was published in the last step
            sim.dispatch()
            values = {each.name: each.value() for each in topics}
            row.measures = {name: values[name] if name in values else row.measures[name] for name in plan.measure_names}
        finally:
            for topic in topics:
                topic.close()
            if watched is not None:
                watched.close()

    def _run(self, sim: Simulation, run: Run) -> None:
        plan = self.plan
        try:
            for command in plan.commands:
                if command.time <= plan.duration:
                    sim.run_until(command.time)
                    sim.publish(command.topic, template.fill(command.message, run.parameters), type=command.type)
            sim.run_until(plan.duration)
        except Reached:
            return
        if plan.until is not None:
            raise MeasureError(f"it did not end within {plan.duration:g} simulated seconds")

    def _ready(self, run: Run, row: Row) -> Simulation:
        """Returns the world at its start, with the run's parameters and seed."""
        text = world_of(self.plan, run) if self.plan.text is not None else None
        if self._sim is not None and text == self._text:
            self._sim.reset(run.seed)
            return self._sim
        self._drop_kept()
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always", WorldWarning)
            self._sim = Simulation(text if text is not None else self.plan.world, file=self.plan.world, seed=run.seed, strict=True)
        row.warnings = [str(each.message) for each in caught if issubclass(each.category, WorldWarning)]
        self._text = text
        return self._sim

    def _drop(self) -> str | None:
        """Closes the world. Returns which of its files is not complete."""
        sim, self._sim = self._sim, None
        if sim is not None:
            try:
                sim.close()
            except SystemFailed as error:
                return str(error)
        return None

    def _drop_kept(self) -> None:
        """Closes the world of runs that have been reported."""
        incomplete = self._drop()
        if incomplete is not None:
            warnings.warn(incomplete, WorldWarning)


def world_of(plan: Plan, run: Run) -> str:
    """Returns the text of a run's world, for a plan that changes it."""
    assert plan.text is not None
    return world.put(plan.text, plan.targets, run.parameters)


_executor: Executor | None = None


def execute(plan: Plan, run: Run) -> Row:
    """Makes a run, and keeps the world for the next one of the same plan."""
    global _executor
    if _executor is None or _executor.plan.key != plan.key:
        if _executor is not None:
            _executor.close()
        _executor = Executor(plan)
    return _executor.execute(run)
