"""A learning task: a world, actions, observations, rewards, and termination."""

from __future__ import annotations

import math
import os
from dataclasses import dataclass, field
from typing import Any, Callable, Mapping, Sequence, Union

import numpy as np
from gymnasium import spaces
from numpy.typing import ArrayLike, NDArray

from ..errors import Error
from ..simulation import Simulation
from .parts import Camera, Image, Reading, Steering
from .randomise import Randomise


#: What functions return: a number, or true or false.
NUMBERS = np.dtype(np.float64)
TRUTHS = np.dtype(np.bool_)


class TaskError(Error):
    """A function of a task has raised an exception, which is the `__cause__`, or returned an invalid value. The text
    names the function."""


class Moment:
    """The argument of a task's functions: all worlds after a step, one row each. For `Env` there is one row.

    `moment["pose"]` is the current reading with that name, an array of worlds x numbers; `moment.before["pose"]` is the
    one before the step. They refer to memory that the next step overwrites: `copy()` what you want to keep.
    """

    def __init__(
        self, now: Mapping[str, NDArray[np.float64]], before: Mapping[str, NDArray[np.float64]],
        worlds: int, step_time: float
    ) -> None:
        self._now = now
        self._step_time = step_time
        #: Like the moment itself, but before the step.
        self.before = before
        #: The action of each world, one row each; clamped to the limits if the task has steerings.
        self.action: NDArray[Any] = np.zeros((worlds, 0))
        #: Number of steps in each episode so far, one per world.
        self.elapsed: NDArray[np.int64] = np.zeros(worlds, np.int64)
        #: Whether each episode has terminated: the result of the task's `terminated`, which is called before the other
        #: functions.
        self.terminated: NDArray[np.bool_] = np.zeros(worlds, np.bool_)
        #: Number of worlds.
        self.worlds = worlds
        #: Shape of what functions return: (worlds,).
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


#: A reward, or whether an episode ends, for each world.
Judgement = Callable[[Moment], ArrayLike]


@dataclass(frozen=True, kw_only=True)
class Task:
    """What to learn in a world. Its functions get a `Moment` with all worlds, and return one number (or True or
    False) for each, or one for all."""

    #: An SDF or URDF file, or its text.
    world: str | os.PathLike[str]
    #: What an action does: steerings, whose numbers are concatenated; or steerings by names, for an action that is a dict of
    #: arrays; or a function of the simulation and the action, called between two steps, which requires `action_space`.
    action: Union[
        Sequence[Steering], Mapping[str, Union[Steering, Sequence[Steering]]], Callable[[Simulation, Any], object]
    ]
    #: What is observed: readings, whose numbers are concatenated, and images; or a function of the simulation that
    #: returns an array, or a dict of arrays, which requires `observation_space`.
    observation: Union[Mapping[str, Union[Reading, Image]], Callable[[Simulation], Any]]
    #: The reward of a step.
    reward: Judgement
    #: Whether the episode has terminated, for example by a crash. None: never.
    terminated: Judgement | None = None
    #: Whether the episode is truncated. None: never, except by the `time_limit`.
    truncated: Judgement | None = None
    #: Readings for the functions only, which are not observed.
    extra: Mapping[str, Reading] = field(default_factory=dict)
    #: Sets up the start of each episode: a function of the simulation and the environment's random numbers that moves
    #: models and so on.
    start: Callable[[Simulation, np.random.Generator], object] | None = None
    #: Properties of the world that each episode draws anew.
    randomise: Sequence[Randomise] = ()
    #: Simulated time of an environment step [s]: a multiple of the world's step.
    step_time: float = 0.1
    #: Simulated time before the first observation, so that each sensor has a reading [s]. None: `step_time`.
    settle_time: float | None = None
    #: Time after which an episode is truncated [s]. None: never.
    time_limit: float | None = None
    #: Whether each episode has its own sensor noise, with its own seed. None: if a sensor of the world has noise.
    noise: bool | None = None
    #: For a function instead of steerings: a space of arrays or numbers (Box, Discrete, MultiDiscrete, MultiBinary).
    action_space: spaces.Space[Any] | None = None
    #: For a function instead of readings: a Box, or a Dict of Boxes.
    observation_space: spaces.Box | spaces.Dict | None = None
    #: Whether an observation is a dict, with an array for each name of `observation`, instead of one array. None: if
    #: there are images and something else.
    dictionary: bool | None = None
    #: What `render` draws: the view of one of the world's cameras, by name, or a viewpoint.
    camera: str | Camera = Camera()

    def __post_init__(self) -> None:
        for name in ("step_time", "settle_time", "time_limit"):
            seconds = getattr(self, name)
            if seconds is not None and not (math.isfinite(seconds) and seconds > 0):
                raise ValueError(f"{name} must be above 0 s and finite, not {seconds}")
        for name, space in (("action", self.action_space), ("observation", self.observation_space)):
            if callable(getattr(self, name)) == (space is None):
                raise ValueError(f"give {name}_space if, and only if, {name} is a function")
        if callable(self.observation) and self.dictionary is not None:
            raise ValueError("a function's observation_space says whether its observations are dicts; leave out dictionary")
        for each in self.randomise:
            if not isinstance(each, Randomise):
                raise TypeError(f"randomise must be a list of Randomise, not of {type(each).__name__}")
        functions = {"reward": self.reward, "terminated": self.terminated, "truncated": self.truncated, "start": self.start}
        for name, function in functions.items():
            if function is not None and not callable(function):
                raise TypeError(f"{name} must be a function, not {type(function).__name__}")


def name_of(function: Any) -> str:
    """Returns the name of a function, for messages."""
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
    """Returns a function's value for each world, with 0 for the ignored ones whatever it returns. Raises TaskError
    if a value is not a finite number."""
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
    # a sum is finite if all its numbers are, unless they exceed 1e308
    if kind is NUMBERS and not math.isfinite(np.add.reduce(array)):
        raise TaskError(f"{what} '{name_of(function)}' returned {array}, but all must be finite")
    return array
