"""A learning task: a world, actions, observations, rewards, and termination."""

from __future__ import annotations

import math
import os
from dataclasses import dataclass, field
from typing import Any, Callable, Mapping, Sequence, Union

import numpy as np
from gymnasium import spaces
from numpy.typing import ArrayLike, NDArray

from .. import values
from ..errors import Error
from ..simulation import Simulation
from .parts import Reading, Steering


#: Of what functions give: a number, or true or false.
NUMBERS = np.dtype(np.float64)
TRUTHS = np.dtype(np.bool_)


class TaskError(Error):
    """A function of a task has raised something, which is the `__cause__`, or gave what can't be used. The text names
    the function."""


class Moment:
    """What the functions of a task look at: all worlds after a step, a row each. For `Env` it is one row.

    `moment["pose"]` is what was read now by that name, an array of worlds x numbers; `moment.before["pose"]` what was read
    before the step. They look at memory that the next step writes to: take a `copy()` of what is to stay.
    """

    def __init__(
        self, now: Mapping[str, NDArray[np.float64]], before: Mapping[str, NDArray[np.float64]],
        worlds: int, step_time: float
    ) -> None:
        self._now = now
        self._step_time = step_time
        #: As the moment itself, before the step.
        self.before = before
        #: What each world was told, a row each; within its limits where the task has steerings.
        self.action: NDArray[Any] = np.zeros((worlds, 0))
        #: Steps of each episode by now, a number for each world.
        self.elapsed: NDArray[np.int64] = np.zeros(worlds, np.int64)
        #: Whether each episode has come to its end: what the task's `terminated` said before it was asked for the rest.
        self.terminated: NDArray[np.bool_] = np.zeros(worlds, np.bool_)
        #: How many worlds there are.
        self.worlds = worlds
        #: Of what functions give: (worlds,).
        self.shape = (worlds,)

    def __getitem__(self, name: str) -> NDArray[np.float64]:
        try:
            return self._now[name]
        except KeyError:
            known = ", ".join(self._now) or "nothing"
            raise KeyError(f"the task has no reading '{name}'; it has {known}") from None

    @property
    def time(self) -> NDArray[np.float64]:
        """Duration of each episode so far [s of simulated time], one number per world."""
        time: NDArray[np.float64] = self.elapsed * self._step_time
        return time


@dataclass(frozen=True)
class Camera:
    """A viewpoint for images. It is not a sensor and does not affect the world."""

    #: Of the eye in the world frame, which looks along its x axis with z up; None: from above and beside all there is.
    pose: values.Pose | Sequence[float] | None = None
    #: [pixels]
    width: int = 320
    height: int = 240
    #: Horizontally [rad].
    field_of_view: float = 1.05


#: How well, or whether it ends, for each world.
Judgement = Callable[[Moment], ArrayLike]


@dataclass(frozen=True, kw_only=True)
class Task:
    """What is to be learnt in a world. The functions get a `Moment` with all worlds in it, and give a number (or one of
    True and False) for each, or one for all."""

    #: A file in SDF or URDF, or its text.
    world: str | os.PathLike[str]
    #: What an action does: steerings, whose numbers stand one behind the other in it; or a function that gets the
    #: simulation and the action, between two steps. That needs `action_space`.
    action: Union[Sequence[Steering], Callable[[Simulation, Any], object]]
    #: What is observed: readings, whose numbers stand one behind the other; or a function that gives it for a simulation,
    #: as an array. That needs `observation_space`.
    observation: Union[Mapping[str, Reading], Callable[[Simulation], ArrayLike]]
    #: How well the step was.
    reward: Judgement
    #: Whether the episode has come to its end, as by a crash. None: never.
    terminated: Judgement | None = None
    #: Whether the episode is broken off. None: never, but for the `time_limit`.
    truncated: Judgement | None = None
    #: Readings for the functions alone, which are not observed.
    extra: Mapping[str, Reading] = field(default_factory=dict)
    #: Arranges each episode's start: gets the simulation and the environment's random numbers, moves models and so on.
    start: Callable[[Simulation, np.random.Generator], object] | None = None
    #: Simulated time of a step of the environment [s]: a whole number of the world's steps.
    step_time: float = 0.1
    #: Simulated time before the first observation, so that each sensor has a reading [s]. None: `step_time`.
    settle_time: float | None = None
    #: After so long an episode is truncated [s]. None: never.
    time_limit: float | None = None
    #: Whether each episode draws its own noise, by a seed of its own. None: where a sensor of the world has noise.
    noise: bool | None = None
    #: Of a function in place of steerings: arrays or numbers (Box, Discrete, MultiDiscrete, MultiBinary).
    action_space: spaces.Space[Any] | None = None
    #: Of a function in place of readings.
    observation_space: spaces.Box | None = None
    #: What `render` draws: what a camera of the world sees, by its name, or from a place of its own.
    camera: str | Camera = Camera()

    def __post_init__(self) -> None:
        for name in ("step_time", "settle_time", "time_limit"):
            seconds = getattr(self, name)
            if seconds is not None and not (math.isfinite(seconds) and seconds > 0):
                raise ValueError(f"{name} must be above 0 s and finite, not {seconds}")
        for name, space in (("action", self.action_space), ("observation", self.observation_space)):
            if callable(getattr(self, name)) == (space is None):
                raise ValueError(f"{name}_space and a function as {name} need each other")
        functions = {"reward": self.reward, "terminated": self.terminated, "truncated": self.truncated, "start": self.start}
        for name, function in functions.items():
            if function is not None and not callable(function):
                raise TypeError(f"{name} must be a function, not {type(function).__name__}")


def name_of(function: Any) -> str:
    """The name of a function, for messages."""
    return str(getattr(function, "__qualname__", None) or type(function).__qualname__)


def call(what: str, function: Callable[..., Any], *arguments: Any) -> Any:
    """Calls a function of a task. Raises TaskError, which names it."""
    try:
        return function(*arguments)
    except Exception as raised:
        raise TaskError(f"{what} '{name_of(function)}' raised {type(raised).__name__}: {raised}") from raised


def judge(
    what: str, function: Judgement, moment: Moment, kind: np.dtype[Any], ignored: NDArray[np.bool_] | None = None
) -> NDArray[Any]:
    """What a function gives for each world; for the ignored ones 0, whatever it gives for them. Raises TaskError where that
    is not a finite number each."""
    given = call(what, function, moment)
    array: NDArray[Any]
    if type(given) is np.ndarray and given.dtype is kind:
        array = given
    else:
        try:
            array = np.asarray(given, kind)
        except (TypeError, ValueError) as wrong:
            raise TaskError(f"{what} '{name_of(function)}' returned {given!r}, which are not numbers") from wrong
        if array.ndim == 0:
            array = np.full(moment.worlds, array)
    if array.shape != moment.shape:
        raise TaskError(
            f"{what} '{name_of(function)}' returned an array of shape {array.shape}; it must be ({moment.worlds},), one for "
            "each world"
        )
    if ignored is not None:
        array = np.where(ignored, kind.type(0), array)
    # a sum is finite where all numbers are, but for those beyond 1e308
    if kind is NUMBERS and not math.isfinite(np.add.reduce(array)):
        raise TaskError(f"{what} '{name_of(function)}' returned {array}, but all must be finite")
    return array
