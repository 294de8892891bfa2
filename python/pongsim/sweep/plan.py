"""What a sweep is, as plain values that travel to the processes that make the runs."""

from __future__ import annotations

import dataclasses
from typing import Any

#: A parameter's or measure's value.
Value = Any

TAKES = ("last", "first", "min", "max", "mean", "count", "time")


@dataclasses.dataclass(frozen=True)
class Target:
    """A place in the world's text that gets a parameter's value."""

    parameter: str
    #: In place of the value alone: a text with $NAME in it.
    text: str | None
    #: The bytes of the text, in UTF-8, that it takes the place of.
    begin: int
    end: int
    #: What stands around it.
    before: str
    after: str


@dataclasses.dataclass(frozen=True)
class Condition:
    """What a value has to be: above and below a number, or equal to something. All that is given has to hold."""

    above: float | None = None
    below: float | None = None
    equals: Value = None

    def holds(self, value: Value) -> bool:
        """Whether it does. Raises TypeError for what has no order."""
        if self.above is not None and not value > self.above:
            return False
        if self.below is not None and not value < self.below:
            return False
        return self.equals is None or bool(value == self.equals)


@dataclasses.dataclass(frozen=True)
class Command:
    """A message that is published when the simulated time is `time` [s]."""

    topic: str
    type: str
    time: float
    #: A dict or protobuf's text, with $NAME in its texts.
    message: Any


@dataclasses.dataclass(frozen=True)
class Measure:
    """A number, or a text, that a topic gives: the field's last, first, smallest, largest, mean value, how many messages
    came, or the first time [s] at which the condition holds."""

    name: str
    topic: str
    field: str
    take: str
    condition: Condition | None


@dataclasses.dataclass(frozen=True)
class Function:
    """A function of a Python file, called with the simulation and the run's parameters."""

    #: The measure that it gives; empty for the one that is called before the first step.
    name: str
    file: str
    function: str


@dataclasses.dataclass(frozen=True)
class Until:
    """What ends a run: the first message that meets a condition."""

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
    """All that the runs of a sweep share."""

    #: Which sweep it is: changes with all that is in it.
    key: str
    #: pongsim's own.
    version: str
    #: The world's file, and its text where something is put into it; else it is read by each process.
    world: str
    text: str | None
    targets: tuple[Target, ...]
    commands: tuple[Command, ...]
    measures: tuple[Measure | Function, ...]
    setup: Function | None
    #: Simulated time at which a run ends [s]; with `until`: by which it has to have ended.
    duration: float
    until: Until | None
    #: How long a run may take [s of wall time].
    wall_limit: float
    #: Each run loads its world anew.
    fresh: bool
    #: The texts of the Python files, by their names.
    sources: dict[str, str]

    @property
    def measure_names(self) -> list[str]:
        """In the order of the file."""
        return [each.name for each in self.measures]


@dataclasses.dataclass
class Row:
    """What has come of one run."""

    run: int
    parameters: dict[str, Value]
    seed: int
    measures: dict[str, Value] = dataclasses.field(default_factory=dict)
    #: "done" or "failed".
    status: str = "failed"
    #: Why it has failed.
    reason: str = ""
    #: As `pongsim run --hash` prints it; empty where it has failed.
    state_hash: str = ""
    #: Where simulated time was at the end [s].
    sim_time: float = 0.0
    #: How long it took [s].
    wall_time: float = 0.0
    #: What was said of the world when it was loaded.
    warnings: list[str] = dataclasses.field(default_factory=list)

    @property
    def is_done(self) -> bool:
        """Whether it has all its measures."""
        return self.status == "done"
