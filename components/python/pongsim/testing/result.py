"""What became of a run."""

from __future__ import annotations

import dataclasses
import enum


class Status(enum.Enum):
    """How a run ended."""

    PASSED = "passed"
    #: An expectation was not met, or the world or a program failed.
    FAILED = "failed"
    #: The scenario asks for what its world does not have; nothing was run.
    MISTAKE = "mistake"


@dataclasses.dataclass(frozen=True)
class Judged:
    """An expectation after a run."""

    #: Where it is in the scenario's file: "wall.yaml:12:5".
    at: str
    name: str
    met: bool
    #: Simulated time at which it was decided [s].
    time: float
    expected: str
    seen: str
    #: Values for a plot.
    field: str = ""
    times: list[float] = dataclasses.field(default_factory=list)
    values: list[float] = dataclasses.field(default_factory=list)


@dataclasses.dataclass
class Result:
    """The result of one run."""

    status: Status = Status.FAILED
    #: Why it failed apart from expectations; of a mistake, with its position.
    reason: str = ""
    judged: list[Judged] = dataclasses.field(default_factory=list)
    #: Simulated and wall time at the end [s].
    sim_time: float = 0.0
    wall_time: float = 0.0
    #: As printed by `pongsim run --hash`; empty if the world did not run.
    state_hash: str = ""
    warnings: list[str] = dataclasses.field(default_factory=list)
    #: What the programs printed, by their names.
    printed: dict[str, str] = dataclasses.field(default_factory=dict)
    #: Files that were kept, and why others were not.
    kept: list[str] = dataclasses.field(default_factory=list)

    @property
    def failures(self) -> list[Judged]:
        """Returns what was not met."""
        return [each for each in self.judged if not each.met]
