"""The definition of a sweep, as plain values that are sent to the processes that make the runs."""

from __future__ import annotations

import dataclasses
from typing import Any

#: A parameter's or measure's value.
Value = Any

TAKES = ("last", "first", "min", "max", "mean", "count", "time")


@dataclasses.dataclass(frozen=True)
class Target:
    """A place in the world's text where a parameter's value is inserted."""

    parameter: str
    #: A text with $NAME in it, to be inserted instead of the value alone.
    text: str | None
    #: The range of bytes in the UTF-8 text that is replaced.
    begin: int
    end: int
    #: The text around it.
    before: str
    after: str


@dataclasses.dataclass(frozen=True)
class Condition:
    """A condition on a value: above or below a number, or equal to something. All given parts must hold."""

    above: float | None = None
    below: float | None = None
    equals: Value = None

    def holds(self, value: Value) -> bool:
        """Whether it holds. Raises TypeError for values without an order."""
        if self.above is not None and not value > self.above:
            return False
        if self.below is not None and not value < self.below:
            return False
        return self.equals is None or bool(value == self.equals)


@dataclasses.dataclass(frozen=True)
class Command:
    """A message to be published at the simulated time `time` [s]."""

    topic: str
    type: str
    time: float
    #: A dict or protobuf's text format, with $NAME in its strings.
    message: Any


@dataclasses.dataclass(frozen=True)
class Measure:
    """A number or text measured on a topic: the last, first, smallest, largest or mean value of a field, the number
    of messages, or the first time [s] at which the condition holds."""

    name: str
    topic: str
    field: str
    take: str
    condition: Condition | None


@dataclasses.dataclass(frozen=True)
class Function:
    """A function of a Python file, called with the simulation and the run's parameters."""

    #: The measure that it returns; empty for the function called before the first step.
    name: str
    file: str
    function: str


@dataclasses.dataclass(frozen=True)
class Until:
    """The condition that ends a run: the first message that meets it."""

    topic: str
    field: str
    condition: Condition


@dataclasses.dataclass(frozen=True)
class Run:
    """One run."""

    number: int
    parameters: dict[str, Value]
    seed: int


@dataclasses.dataclass(frozen=True)
class Plan:
    """Everything that the runs of a sweep share."""

    #: Identifies the sweep: changes with any of its content.
    key: str
    #: pongsim's version.
    version: str
    #: The world's file, and its text if parameters are inserted; otherwise each process reads the file.
    world: str
    text: str | None
    targets: tuple[Target, ...]
    commands: tuple[Command, ...]
    measures: tuple[Measure | Function, ...]
    setup: Function | None
    #: Simulated time at which a run ends [s]; with `until`: the time limit.
    duration: float
    until: Until | None
    #: Limit on a run's duration [s of wall time].
    wall_limit: float
    #: Whether each run loads its world again.
    fresh: bool
    #: The texts of the Python files, by name.
    sources: dict[str, str]

    @property
    def measure_names(self) -> list[str]:
        """Returns the names in the order of the file."""
        return [each.name for each in self.measures]


@dataclasses.dataclass
class Row:
    """The result of one run."""

    run: int
    parameters: dict[str, Value]
    seed: int
    measures: dict[str, Value] = dataclasses.field(default_factory=dict)
    #: "done" or "failed".
    status: str = "failed"
    #: Why it failed.
    reason: str = ""
    #: As printed by `pongsim run --hash`; empty if it failed.
    state_hash: str = ""
    #: Simulated time at the end [s].
    sim_time: float = 0.0
    #: Wall time of the run [s].
    wall_time: float = 0.0
    #: Warnings from loading the world.
    warnings: list[str] = dataclasses.field(default_factory=list)

    @property
    def is_done(self) -> bool:
        """Whether it has all its measures."""
        return self.status == "done"
