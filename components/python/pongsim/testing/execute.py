"""Makes one run of a scenario in this process."""

from __future__ import annotations

import contextlib
import dataclasses
import heapq
import itertools
import os
import time
import warnings
from typing import Iterator

from .. import _core
from ..errors import LoadError, ServiceError, SystemFailed, WorldWarning, describe
from ..simulation import Simulation
from ..sweep.errors import SweepError, nearest
from ..sweep.execute import WallLimit, wall_limit
from .domains import domain
from .programs import Beside, Noted, ProgramError
from .result import Judged, Result, Status
from .scenario import Case, Expected, Publication

#: With programs beside it, a run goes on in parts of this simulated time [s]: between them it looks at the programs and
#: at the wall clock.
_PART = 0.005


class Mistake(Exception):
    """The scenario asks for what the world does not have. The text has its position."""


def execute(case: Case, noted: Noted = lambda group, begins: None, recorder: str = "", pictures: str = "",
            until: float | None = None) -> Result:
    """Makes the run. Whatever goes wrong is in the result.

    noted: told of the processes that programs are.
    recorder: the element of a system that records the run.
    pictures: a folder for what the cameras see at the end.
    until: end it after this simulated time [s].
    """
    result = Result()
    begin = time.perf_counter()
    try:
        with wall_limit(case.wall):
            _Attempt(case, result, recorder, pictures, until).make(noted)
        result.status = Status.PASSED if not result.failures else Status.FAILED
    except WallLimit:
        result.reason = f"it took longer than {case.wall:g} s of wall time, at {result.sim_time:g} s of simulated time"
    except Mistake as mistake:
        result.status, result.reason = Status.MISTAKE, str(mistake)
    except (ProgramError, SweepError) as error:
        result.reason = str(error)
    except LoadError as error:
        errors = [each for each in error.diagnostics if each.is_error]
        if all(each.file == case.file for each in errors):
            result.status, result.reason = Status.MISTAKE, "; ".join(map(str, errors))
        else:
            result.reason = "the world can't be loaded: " + "; ".join(map(str, errors))
    except SystemFailed as error:
        result.reason = str(error)
    except (OSError, ValueError, RuntimeError) as error:
        result.reason = describe(error)
    result.wall_time = time.perf_counter() - begin
    return result


class _Attempt:
    def __init__(self, case: Case, result: Result, recorder: str, pictures: str, until: float | None) -> None:
        self.case = case
        self.result = result
        self.recorder = recorder
        self.pictures = pictures
        self.end = case.duration if until is None else min(until, case.duration)
        #: What is to be published, by time.
        self.due: list[tuple[float, int, Publication]] = []
        self.count = itertools.count()
        #: Publications that wait for an event, by the event's number.
        self.waiting: dict[int, Publication] = {}
        self.beside: list[Beside] = []

    def make(self, noted: Noted) -> None:
        """Makes the run. Raises what keeps it from its end."""
        with contextlib.ExitStack() as stack:
            number = self._apart(stack)
            stack.callback(self._end_programs)
            for program in self.case.programs:
                self.beside.append(Beside(program, noted))
                self.beside[-1].start()
            with self._world(number) as sim:
                try:
                    self._run(sim)
                finally:
                    self.result.sim_time = sim.time

    def _apart(self, stack: contextlib.ExitStack) -> int:
        """Keeps the run apart from others until the end of the stack. Returns its domain; 0: none is left, and it needs
        none."""
        try:
            number = stack.enter_context(domain())
        except OSError:
            if self.case.programs:
                raise
            return 0
        stack.enter_context(_environment(number))
        return number

    def _end_programs(self) -> None:
        for each in self.beside:
            self.result.printed[each.program.name] = each.end()

    @contextlib.contextmanager
    def _world(self, number: int) -> Iterator[Simulation]:
        case = self.case
        world = case.text if case.text is not None else case.world
        added = "".join((*case.systems, self.recorder))
        if added:
            world = with_system(text_of(case), added)
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always", WorldWarning)
            network = bool(case.programs)
            sim = Simulation(world, file=case.world, seed=case.run.seed, strict=True, network=network,
                             domain=number if network else None, _plugins=case.faults.plugins)
        self.result.warnings = [str(each.message) for each in caught if issubclass(each.category, WorldWarning)]
        with sim:
            yield sim

    def _run(self, sim: Simulation) -> None:
        # first, since it holds what comes from programs
        monitor = _core.Monitor(sim, self.case.lockstep)
        numbers = self._add(sim, monitor)
        for each in self.beside:
            each.wait_until_ready(lambda topic, publisher: _core.wait_for_other(sim, topic, publisher, 0.0), sim.dispatch)
        self._steps(sim, monitor, numbers)
        if unused := self.case.faults.unused(name for name, type_ in sim.topics.items() if type_ != "*"):
            raise Mistake(unused)
        # before the messages of the last step are delivered, whose receivers may change something
        self.result.state_hash = f"{sim.state_hash():016x}"
        monitor.finish()
        step = sim.step_size
        for _, group in itertools.groupby(zip(self.case.expected, numbers), lambda each: each[0].at):
            judged = [(expected, _judged(monitor, expected, number)) for expected, number in group]
            self.result.judged.append(judged[0][1] if not judged[0][0].part else _first_difference(judged, step))
        if self.pictures:
            from .artefacts import draw

            self.result.kept += draw(sim, self.pictures)

    def _add(self, sim: Simulation, monitor: _core.Monitor) -> list[int]:
        """Gives the monitor what is to be judged. Raises Mistake, with all of them."""
        numbers: list[int] = []
        # the first at each place
        mistakes: dict[str, str] = {}
        for expected in self.case.expected:
            try:
                numbers.append(monitor.add(expected.spec))
            except (ValueError, TypeError) as error:
                mistakes.setdefault(expected.at, f"{expected.at}: error: {error}")
        for publication in self.case.publications:
            try:
                self._add_publication(sim, monitor, publication)
            except (ValueError, TypeError) as error:
                mistakes.setdefault(publication.at, f"{publication.at}: error: {error}")
        if mistakes:
            raise Mistake("\n".join(mistakes.values()))
        return numbers

    def _add_publication(self, sim: Simulation, monitor: _core.Monitor, publication: Publication) -> None:
        self._check(sim, publication)
        if publication.after is None:
            self._put(publication, publication.time)
        else:
            self.waiting[monitor.add({"mode": "eventually", "events": [publication.after]})] = publication

    def _check(self, sim: Simulation, publication: Publication) -> None:
        """Raises ValueError and TypeError if the message can't be published."""
        if publication.reply:
            _core.message_type(publication.type)
            _core.message_type(publication.reply)
            return
        topic = publication.topic if publication.topic.startswith("/") else "/" + publication.topic
        if not publication.type and topic not in sim.topics:
            raise ValueError(f"the world has no topic {topic} ({nearest(topic, sim.topics)}; or give its 'type')")
        _core.check_message(sim, topic, publication.message, publication.type)

    def _put(self, publication: Publication, when: float) -> None:
        heapq.heappush(self.due, (when, next(self.count), publication))

    def _steps(self, sim: Simulation, monitor: _core.Monitor, numbers: list[int]) -> None:
        begin = time.monotonic()
        while sim.time < self.end:
            self._publish(sim)
            next_time = min(self.end, self.due[0][0] if self.due else self.end)
            if self.case.programs or self.case.speed > 0:
                next_time = min(next_time, sim.time + _PART)
            if self._run_until(sim, monitor, next_time):
                self._note_events(sim, monitor)
                if all(monitor.verdict(number)[0] != "pending" for number in numbers):
                    break
            self._check_programs()
            if self.case.speed > 0:
                time.sleep(max(0.0, begin + sim.time / self.case.speed - time.monotonic()))

    def _run_until(self, sim: Simulation, monitor: _core.Monitor, next_time: float) -> bool:
        lockstep = self.case.lockstep
        if lockstep is None:
            return monitor.run_until(next_time)
        try:
            return monitor.run_until(next_time, self._check_programs)
        except RuntimeError as error:
            # somebody is late; a topic that the world does not have may be why
            raise ProgramError("; ".join([str(error), *_core.unknown_lockstep_topics(sim, lockstep)])) from None

    def _check_programs(self) -> None:
        for each in self.beside:
            each.check()

    def _publish(self, sim: Simulation) -> None:
        # half a nanosecond: times are whole nanoseconds
        while self.due and self.due[0][0] <= sim.time + 5e-10:
            when, _, publication = heapq.heappop(self.due)
            try:
                if publication.reply:
                    self._request(sim, publication)
                else:
                    sim.publish(publication.topic, publication.message, type=publication.type)
            except (ValueError, TypeError) as error:
                raise Mistake(f"{publication.at}: error: {error}") from None
            if publication.every:
                self._put(publication, when + publication.every)

    def _request(self, sim: Simulation, request: Publication) -> None:
        try:
            answer = sim.request(request.topic, request.message, type=request.type, reply=request.reply)
        except ServiceError as error:
            raise ProgramError(f"{request.at}: {error}") from None
        if isinstance(answer, dict) and answer.get("data") is False:
            raise ProgramError(f"{request.at}: the service {request.topic} answered false at {sim.time:g} s")

    def _note_events(self, sim: Simulation, monitor: _core.Monitor) -> None:
        for number in [each for each in self.waiting if monitor.verdict(each)[0] == "met"]:
            publication = self.waiting.pop(number)
            self._put(publication, sim.time + publication.time)


def _judged(monitor: _core.Monitor, expected: Expected, number: int) -> Judged:
    state, when, words, seen, field, times, values = monitor.verdict(number)
    return Judged(expected.at, expected.name, state == "met", when, words, seen, field, times, values)


def _first_difference(parts: list[tuple[Expected, Judged]], step: float) -> Judged:
    """Returns the first of the parts that is not met, with its step and how many others there are; one of them if all are."""
    failed = sorted((each for each in parts if not each[1].met), key=lambda each: each[1].time)
    if not failed:
        return parts[0][1]
    expected, first = failed[0]
    others = f"; {len(failed)} of {len(parts)} numbers differ" if len(failed) > 1 else ""
    seen = f"{expected.part}: {first.seen}, step {round(first.time / step)}{others}"
    return dataclasses.replace(first, seen=seen)


@contextlib.contextmanager
def _environment(number: int) -> Iterator[None]:
    """Sets the variables that keep a run and its programs apart from others: of pongsim's topics, ROS 2 and Gazebo."""
    own = f"pongsim-test-{os.getpid()}"
    variables = {"PONGSIM_DOMAIN": str(number), "ROS_DOMAIN_ID": str(number), "IGN_PARTITION": own, "GZ_PARTITION": own}
    before = {name: os.environ.get(name) for name in variables}
    os.environ.update(variables)
    try:
        yield
    finally:
        for name, value in before.items():
            if value is None:
                del os.environ[name]
            else:
                os.environ[name] = value


def text_of(case: Case) -> str:
    """Returns the text of the case's world. Raises OSError and ValueError."""
    if case.text is not None:
        return case.text
    with open(case.world, encoding="utf-8") as file:
        return file.read()


def with_system(text: str, element: str) -> str:
    """Returns the world with a system more, without another line. Raises ValueError for a file without a world."""
    place = text.find("</world>")
    if place < 0:
        raise ValueError("the file has no <world> to add a system to")
    return text[:place] + element + text[place:]
