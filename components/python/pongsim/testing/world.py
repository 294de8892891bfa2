"""Expectations in Python, for pytest and other tests."""

from __future__ import annotations

import os
import pathlib
import traceback
from types import TracebackType
from typing import Any, Mapping, Union

from .. import _core
from ..simulation import Message, Simulation
from ..sweep import document
from ..sweep.errors import SweepError
from .conditions import read_fields
from .scenario import Spec
from .text_plot import text_plot

#: A value, or a comparison: `above(1)`.
Condition = Union[bool, int, float, str, "dict[str, Any]"]

#: Where the files of recordings are.
_HERE = pathlib.Path(".")


class Signal:
    """Something in a world that has fields: `topic("/scan")`, `pose("robot")`."""

    def __init__(self, kind: str, name: str, other: str = "") -> None:
        self.kind = kind
        self.name = name
        self.other = other

    def event(self, conditions: Mapping[str, Condition]) -> Spec:
        """Returns the event that the signal meets the conditions. Raises ValueError for a wrong one."""
        made: Spec = {"kind": self.kind, "name": self.name, "other": self.other, "criteria": []}
        if conditions:
            plain = {key.replace("__", "."): value for key, value in conditions.items()}
            try:
                made["criteria"] = read_fields(document.from_plain(plain, self.name), "an expectation", (self.kind, self.name), _HERE)
            except SweepError as error:
                raise ValueError(str(error)) from None
        elif self.kind in ("pose", "velocity", "joint"):
            raise ValueError(f"an expectation of a {self.kind} needs a condition, such as x=above(1)")
        return made


def topic(name: str) -> Signal:
    """The messages of a topic. Fields: `data=True`, `pose__position__x=above(1)`, or `{"pose.position.x": above(1)}`."""
    return Signal("topic", name)


def pose(name: str) -> Signal:
    """The pose of a model, link ("model::link") or actor in the world: x, y, z [m], roll, pitch, yaw [rad]."""
    return Signal("pose", name)


def velocity(name: str) -> Signal:
    """The velocity of a model or link in the world: x, y, z, speed [m/s], roll, pitch, yaw [rad/s]."""
    return Signal("velocity", name)


def joint(name: str) -> Signal:
    """A joint, "model::joint": position [rad or m], velocity [rad/s or m/s]."""
    return Signal("joint", name)


def contact(one: str, other: str = "") -> Signal:
    """The contact of two models, links or collisions; of one with anything: touching, points, depth [m], force [N]."""
    return Signal("contact", one, other)


def above(value: float) -> dict[str, Any]:
    """More than the value."""
    return {"above": value}


def at_least(value: float) -> dict[str, Any]:
    """The value or more."""
    return {"at_least": value}


def below(value: float) -> dict[str, Any]:
    """Less than the value."""
    return {"below": value}


def at_most(value: float) -> dict[str, Any]:
    """The value or less."""
    return {"at_most": value}


def near(value: float, tolerance: float) -> dict[str, Any]:
    """Within a tolerance of the value."""
    return {"near": value, "tolerance": tolerance}


def between(low: float, high: float) -> dict[str, Any]:
    """From one value to the other."""
    return {"between": [low, high]}


def differs(value: bool | float | str) -> dict[str, Any]:
    """Anything but the value."""
    return {"not": value}


def contains(text: str) -> dict[str, Any]:
    """A text with that in it."""
    return {"contains": text}


def recorded(file: str | os.PathLike[str], tolerance: float) -> dict[str, Any]:
    """Within a tolerance of the value of a recorded run at the same time."""
    return {"recorded": os.fspath(file), "tolerance": tolerance}


class Expectation:
    """What is expected of a signal. The last call of eventually, always, never or in_order says what."""

    def __init__(self, signal: Signal) -> None:
        self._signal = signal
        self._spec: Spec = {}
        #: Where it was written, for messages.
        self.at = ""
        for frame in reversed(traceback.extract_stack()):
            if os.path.dirname(frame.filename) != os.path.dirname(__file__):
                self.at = f"{frame.filename}:{frame.lineno}"
                break

    @property
    def spec(self) -> Spec:
        """What the monitor judges."""
        if not self._spec:
            raise ValueError(f"{self.at}: nothing is expected: call eventually, always, never or in_order")
        return self._spec

    def eventually(self, conditions: Mapping[str, Condition] | None = None, *, within: float | None = None,
                   lasting: float = 0.0, after: tuple[Signal, Mapping[str, Condition]] | Signal | None = None,
                   **fields: Condition) -> Expectation:
        """It comes: within so many simulated seconds of the run, or of `after`; and stays for `lasting` seconds."""
        return self._is("eventually", {**(conditions or {}), **fields}, after, None, to=within, hold=lasting or None)

    def always(self, conditions: Mapping[str, Condition] | None = None, *, during: tuple[float, float] | None = None,
               at: float | None = None, within: float | None = None,
               after: tuple[Signal, Mapping[str, Condition]] | Signal | None = None,
               until: tuple[Signal, Mapping[str, Condition]] | Signal | None = None, **fields: Condition) -> Expectation:
        """Each value is so: during the run, some seconds, or until something comes, which it must, `within` seconds."""
        begin, end = during if during is not None else (at or 0.0, at)
        return self._is("always", {**(conditions or {}), **fields}, after, until, to=within if within is not None else end,
                        **{"from": begin})

    def never(self, conditions: Mapping[str, Condition] | None = None, *, during: tuple[float, float] | None = None,
              within: float | None = None, after: tuple[Signal, Mapping[str, Condition]] | Signal | None = None,
              until: tuple[Signal, Mapping[str, Condition]] | Signal | None = None, **fields: Condition) -> Expectation:
        """No value is so, in the same time."""
        begin, end = during if during is not None else (0.0, None)
        return self._is("never", {**(conditions or {}), **fields}, after, until, to=within if within is not None else end,
                        **{"from": begin})

    def in_order(self, conditions: Mapping[str, Condition] | None = None, *then: tuple[Signal, Mapping[str, Condition]] | Signal,
                 within: float | None = None, after: tuple[Signal, Mapping[str, Condition]] | Signal | None = None) -> Expectation:
        """It comes, then the others, one after another."""
        self._is("in_order", conditions or {}, after, None, to=within)
        self._spec["events"] += [_event(each) for each in then]
        return self

    def _is(self, mode: str, conditions: Mapping[str, Condition], after: Any, until: Any, **window: float | None) -> Expectation:
        self._spec = {"mode": mode, "events": [self._signal.event(conditions)],
                      **{key: value for key, value in window.items() if value is not None}}
        if after is not None:
            self._spec["after"] = _event(after)
        if until is not None:
            self._spec["until"] = _event(until)
        return self


def _event(given: tuple[Signal, Mapping[str, Condition]] | Signal) -> Spec:
    return given.event({}) if isinstance(given, Signal) else given[0].event(given[1])


class World:
    """A world under test.

        with World("sensor_tutorial.sdf") as world:
            world.publish("/cmd_vel", {"linear": {"x": 2}})
            world.expect(topic("/wall/touched")).eventually(data=True, within=20)
            world.run(30)
    """

    _current: World | None = None

    def __init__(self, world: str | os.PathLike[str], **options: Any) -> None:
        """Loads a world, with the options of `pongsim.Simulation`; `strict` is True unless given."""
        self.sim = Simulation(world, **{"strict": True, **options})
        self._monitor = _core.Monitor(self.sim)
        self._expected: list[Expectation] = []
        self._messages: list[tuple[str, Message, str]] = []
        World._current = self

    def __enter__(self) -> World:
        return self

    def __exit__(self, kind: type[BaseException] | None, raised: BaseException | None, trace: TracebackType | None) -> None:
        self.close()
        if kind is None:
            self.check_done()

    def close(self) -> None:
        """Ends the world."""
        if World._current is self:
            World._current = None
        self.sim.close()

    def check_done(self) -> None:
        """Raises AssertionError if something expected was not judged."""
        if self._expected:
            raise AssertionError(f"{self._expected[0].at}: it is expected, but the world was not run: call run")

    def publish(self, topic: str, message: Message, *, type: str = "") -> None:
        """Publishes a message, which arrives at the start of the next step of `run`. Raises like `Simulation.publish`."""
        _core.check_message(self.sim, topic, message, type)
        self._messages.append((topic, message, type))

    def expect(self, signal: Signal) -> Expectation:
        """Begins an expectation; `run` judges it."""
        made = Expectation(signal)
        self._expected.append(made)
        return made

    def run(self, seconds: float) -> None:
        """Runs the world until all that is expected is decided, or for so many simulated seconds; for all of them if nothing
        is expected. Raises AssertionError with all that was not met, and ValueError for what the world does not have."""
        expected, self._expected = self._expected, []
        numbers = []
        for each in expected:
            try:
                numbers.append(self._monitor.add(each.spec))
            except ValueError as error:
                raise ValueError(f"{each.at}: {error}") from None
        # now, so that what is expected sees them
        for message in self._messages:
            self.sim.publish(*message[:2], type=message[2])
        self._messages.clear()
        end = self.sim.time + seconds
        while self.sim.time < end and (not numbers or any(self._monitor.verdict(number)[0] == "pending" for number in numbers)):
            self._monitor.run_until(end)
        self._monitor.finish()
        lines: list[str] = []
        for each, number in zip(expected, numbers):
            state, when, words, seen, field, times, values = self._monitor.verdict(number)
            if state != "met":
                lines += [f"{each.at}: not met", f"  expected  {words}", f"  seen      {seen}"]
                lines += [f"    {line}".rstrip() for line in text_plot(times, values, field, when)]
        if lines:
            raise AssertionError("\n" + "\n".join(lines))


def expect(signal: Signal) -> Expectation:
    """Begins an expectation of the world that was opened last."""
    if World._current is None:
        raise RuntimeError("there is no world: open one with World(...), or the fixture pongsim_world of pytest")
    return World._current.expect(signal)
