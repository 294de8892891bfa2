"""What is observed of worlds."""

from __future__ import annotations

from typing import Any, Iterable, Mapping, Sequence, Union

import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray

from ..pictures import Eye
from ..simulation import Simulation
from .parts import Image, Limits
from .pictures import eyes_of
from .task import Task, TaskError, call, name_of

#: One array, or one for each name.
Observation = Union[NDArray[Any], "dict[str, NDArray[Any]]"]


class Observations:
    """The observations of several worlds, one row each."""

    def __init__(self, task: Task, simulations: Sequence[Simulation], limits: Mapping[str, Sequence[Limits]]) -> None:
        """limits: the range of each number of the observed readings, by their names in the order of the task."""
        self._simulations = simulations
        self._function = task.observation if callable(task.observation) else None
        self._limits = limits
        self._eyes: dict[str, list[Eye]] = {}
        self.space: spaces.Box | spaces.Dict
        if self._function is not None:
            self.space = _checked(task.observation_space)
            return
        assert not callable(task.observation)
        images = {name: each for name, each in task.observation.items() if isinstance(each, Image)}
        for name, image in images.items():
            self._eyes[name] = eyes_of(simulations, image.camera, image.size)
        is_dict = bool(images) and len(task.observation) > 1 if task.dictionary is None else task.dictionary
        if not is_dict and images and len(task.observation) > 1:
            raise ValueError("images and readings don't fit into one array; leave out dictionary=False")
        if is_dict:
            self.space = spaces.Dict({
                name: _seen(self._eyes[name][0]) if name in images else box(limits[name]) for name in task.observation
            })
        elif images:
            self.space = _seen(next(iter(self._eyes.values()))[0])
        else:
            self.space = box([each for some in limits.values() for each in some])

    def lie_in(self, numbers: NDArray[np.float32]) -> None:
        """Tells where the numbers of the observed readings are: a row for each world, in the order of the task."""
        self._arrays: Observation
        rows = len(self._simulations)
        if self._function is None and not self._eyes and isinstance(self.space, spaces.Box):
            self._arrays = numbers
            return
        if isinstance(self.space, spaces.Box):
            self._arrays = np.zeros((rows, *self.space.shape), self.space.dtype)
            return
        self._arrays = {name: np.zeros((rows, *(each.shape or ())), each.dtype) for name, each in self.space.items()}
        begin = 0
        for name, limits in self._limits.items():
            self._arrays[name] = numbers[:, begin : begin + len(limits)]
            begin += len(limits)

    def look(self, worlds: Iterable[int]) -> None:
        """Draws the images of these worlds, or calls the task's function for them."""
        if self._function is None and not self._eyes:
            return
        for i in worlds:
            if self._function is not None:
                self._put(i, call("the observation", self._function, self._simulations[i]))
            for name, eyes in self._eyes.items():
                array = self._arrays[name] if isinstance(self._arrays, dict) else self._arrays
                array[i] = eyes[i].draw()

    def _put(self, world: int, given: Any) -> None:
        if not isinstance(self._arrays, dict):
            assert isinstance(self.space, spaces.Box)
            self._put_part(self._arrays, self.space, world, given, "")
            return
        if not isinstance(given, Mapping) or set(given) != set(self._arrays):
            raise TaskError(
                f"the observation '{name_of(self._function)}' must return a dict with {', '.join(map(repr, self._arrays))}, "
                f"not {', '.join(map(repr, given)) if isinstance(given, Mapping) else type(given).__name__}"
            )
        for name, array in self._arrays.items():
            assert isinstance(self.space, spaces.Dict)
            self._put_part(array, self.space[name], world, given[name], f" of '{name}'")

    def _put_part(self, array: NDArray[Any], space: Any, world: int, given: Any, part: str) -> None:
        wrong = f"the observation '{name_of(self._function)}' returned a value{part} outside its space, {space}"
        try:
            array[world] = given
        except (TypeError, ValueError) as error:
            raise TaskError(f"{wrong}: {error}") from error
        inside = (array[world] >= space.low) & (array[world] <= space.high)
        if not inside.all():
            place = tuple(int(each) for each in np.argwhere(~inside)[0])
            raise TaskError(f"{wrong}: number {list(place)} is {array[world][place]}")

    def row(self, world: int) -> Any:
        """Returns a copy of a world's observation."""
        if isinstance(self._arrays, dict):
            return {name: array[world].copy() for name, array in self._arrays.items()}
        return self._arrays[world].copy()

    def all(self) -> Any:
        """Returns a copy of all, worlds x one observation."""
        if isinstance(self._arrays, dict):
            return {name: array.copy() for name, array in self._arrays.items()}
        return self._arrays.copy()


def box(limits: Sequence[Limits]) -> spaces.Box:
    """Returns the space of numbers with these limits."""
    low, high = (np.array([each[k] for each in limits], np.float32) for k in (0, 1))
    return spaces.Box(low, high, dtype=np.float32)


def _seen(eye: Eye) -> spaces.Box:
    return spaces.Box(0, 255, (eye.height, eye.width, 3), np.uint8)


def _checked(space: Any) -> Any:
    if isinstance(space, spaces.Box):
        return space
    if isinstance(space, spaces.Dict) and all(isinstance(each, spaces.Box) for each in space.values()):
        return space
    raise TypeError(f"observation_space must be a Box or a Dict of Boxes, not {space}")
