"""Measures of a run: from topics, and from Python functions."""

from __future__ import annotations

import os
import re
import sys
import types
from typing import Any, Callable

from ..simulation import Simulation
from .errors import nearest
from .plan import Function, Measure, Plan, Until, Value


class MeasureError(Exception):
    """A measure has no value. The text has the reason."""


class Reached(BaseException):
    """The condition that ends a run is fulfilled. Raised out of a step."""


_STEP = re.compile(r"([^.\[\]]+)|\[(\d+)\]")


def parse_field(path: str) -> list[str | int]:
    """Parses "pose[0].position.x" into names and indices. Raises MeasureError."""
    steps: list[str | int] = []
    end = 0
    for match in _STEP.finditer(path):
        if path[end:match.start()] not in (("",) if match.start() == 0 or match.group(2) else (".",)):
            break
        steps.append(match.group(1) if match.group(1) else int(match.group(2)))
        end = match.end()
    if end != len(path) or not steps:
        raise MeasureError(f"'{path}' is not a field; write pose.position.x or pose[0].name")
    return steps


def field_of(message: Any, path: list[str | int]) -> Value:
    """Returns a field of a message. Raises LookupError that names the available fields."""
    for step in path:
        if isinstance(step, int):
            if not isinstance(message, list) or step >= len(message):
                raise LookupError(f"has no [{step}]: " + (f"{len(message)} are there" if isinstance(message, list) else "it is not a list"))
            message = message[step]
        elif isinstance(message, dict) and step in message:
            message = message[step]
        else:
            raise LookupError(f"has no '{step}' ({nearest(step, message if isinstance(message, dict) else ())})")
    if isinstance(message, dict) and set(message) == {"sec", "nsec"}:
        return message["sec"] + message["nsec"] / 1e9
    return message


class TopicMeasure:
    """Evaluates the messages of a topic during a simulation."""

    def __init__(self, measure: Measure, sim: Simulation) -> None:
        self.name = measure.name
        self._measure = measure
        self._sim = sim
        self._path = parse_field(measure.field) if measure.field else []
        self._is_known = measure.topic in sim.topics
        self._missing = ""
        #: Number of messages that had the field, number of those that count, and the result so far.
        self._heard = 0
        self._count = 0
        self._sum = 0.0
        self._value: Value = None
        self._subscription = sim.subscribe(measure.topic, self._hear, length=100_000)

    def _hear(self, message: dict[str, Any]) -> None:
        try:
            value = field_of(message, self._path) if self._path else None
        except LookupError as missing:
            self._missing = str(missing)
            return
        self._heard += 1
        try:
            self._take(value)
        except TypeError:
            raise MeasureError(f"measure '{self._measure.name}': '{self._measure.field}' is {value!r}, not a number") from None

    def _take(self, value: Value) -> None:
        take, condition = self._measure.take, self._measure.condition
        if condition is not None and not condition.holds(value):
            return
        self._count += 1
        if take == "last" or (take == "first" and self._count == 1):
            self._value = value
        elif take == "time" and self._count == 1:
            # messages arrive at the start of the step after the one that published them: time has not advanced yet
            self._value = self._sim.time
        elif take == "mean":
            self._sum += value
        elif take in ("min", "max"):
            better = max if take == "max" else min
            self._value = value + 0 if self._count == 1 else better(self._value, value)

    def value(self) -> Value:
        """Returns the result; None for a time that was not reached. Raises MeasureError if no message had the field."""
        measure = self._measure
        if self._heard == 0 and self._missing:
            raise MeasureError(f"measure '{measure.name}': a message of {measure.topic} {self._missing}")
        if self._heard == 0 and not (measure.take == "count" and self._is_known):
            hint = "" if self._is_known else nearest(measure.topic, (each for each in self._sim.topics if each != measure.topic))
            raise MeasureError(f"measure '{measure.name}': no messages on {measure.topic}" + (f" ({hint})" if hint else ""))
        if measure.take == "count":
            return self._count
        result = self._sum / self._count if measure.take == "mean" else self._value
        if isinstance(result, (dict, list, bytes)):
            raise MeasureError(f"measure '{measure.name}': '{measure.field}' is not a single value")
        return result

    def close(self) -> None:
        """Ends the subscription."""
        self._subscription.close()


def watch(until: Until, sim: Simulation) -> Any:
    """Returns a subscription that raises Reached out of the step in which the condition is fulfilled."""
    path = parse_field(until.field)

    def receive(message: dict[str, Any]) -> None:
        try:
            value = field_of(message, path)
        except LookupError as missing:
            raise MeasureError(f"until: a message of {until.topic} {missing}") from None
        if until.condition.holds(value):
            raise Reached

    return sim.subscribe(until.topic, receive)


class Functions:
    """The functions in a plan's Python files; each file is executed once per process."""

    def __init__(self, plan: Plan) -> None:
        self._plan = plan
        self._modules: dict[str, types.ModuleType] = {}

    def find(self, function: Function) -> Callable[[Simulation, dict[str, Value]], Any]:
        """Returns the function. Raises the exceptions of its file, and AttributeError."""
        module = self._modules.get(function.file)
        if module is None:
            module = types.ModuleType(os.path.splitext(os.path.basename(function.file))[0])
            module.__file__ = function.file
            folder = os.path.abspath(os.path.dirname(function.file))
            if folder not in sys.path:
                sys.path.append(folder)
            exec(compile(self._plan.sources[function.file], function.file, "exec"), module.__dict__)
            self._modules[function.file] = module
        found: Callable[[Simulation, dict[str, Value]], Any] = getattr(module, function.function)
        return found

    def measure(self, function: Function, sim: Simulation, parameters: dict[str, Value]) -> Value:
        """Returns the function's result: a number, a string, true, false or None."""
        value = self.find(function)(sim, dict(parameters))
        if hasattr(value, "item") and getattr(value, "shape", None) == ():
            value = value.item()  # a number of NumPy
        if value is not None and not isinstance(value, (bool, int, float, str)):
            raise MeasureError(f"measure '{function.name}': {function.function} returned a {type(value).__name__}, "
                               "not a number, text, true or false")
        return value
