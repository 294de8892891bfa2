"""The worlds of environments, stepped together: the basis of `Env` and `VectorEnv`."""

from __future__ import annotations

import contextlib
import math
import warnings
from typing import Any, Mapping, Sequence

import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray

from .. import _core
from ..arrays import view
from ..errors import Gone, NoReading, Refused, SystemFailed, WorldWarning
from ..pictures import Eye
from ..simulation import Simulation
from .observing import Observations, box
from .parts import Image, Limits, Reading, Steering
from .pictures import eyes_of
from .task import NUMBERS, TRUTHS, Moment, Task, call, judge

#: The result of a step: rewards, whether terminated, whether truncated.
Verdict = tuple[NDArray[np.float64], NDArray[np.bool_], NDArray[np.bool_]]


class Worlds:
    """Several worlds of a task. Each array has one row per world."""

    def __init__(self, task: Task, count: int, threads: int) -> None:
        self.task = task
        self.count = count
        with contextlib.ExitStack() as undo:
            self.simulations: list[Simulation] = []
            for i in range(count):
                with warnings.catch_warnings():
                    if i > 0:
                        # the first world has given all warnings
                        warnings.simplefilter("ignore", WorldWarning)
                    self.simulations.append(Simulation(task.world, seed=i))
                undo.callback(self.simulations[-1].close)
            self._pool = _core.Pool(self.simulations, threads)
            self._read()
            self._steer()
            self._pool.seal()
            self._draws = [[each.attach(simulation) for each in task.randomise] for simulation in self.simulations]
            self._step_count = self._steps_in(task.step_time, "step_time")
            settle_time = task.step_time if task.settle_time is None else task.settle_time
            self._settle_count = self._steps_in(settle_time, "settle_time")
            undo.pop_all()
        self._steps_to_limit = (
            None if task.time_limit is None else max(1, math.ceil(task.time_limit / task.step_time - 1e-9))
        )
        #: Whether an episode begins with another state than the world does.
        self._changes = task.start is not None or len(task.randomise) > 0
        self._draws_noise = self._has_noise() if task.noise is None else task.noise
        #: Number of steps in each episode so far.
        self.elapsed: NDArray[np.int64] = np.zeros(count, np.int64)
        self._look_at_memory()
        self._no = np.zeros(count, np.bool_)
        self._no.flags.writeable = False
        self._is_saved = [False] * count
        self._all_go = False
        self._eyes: list[Eye] = []
        self.is_closed = False

    def _read(self) -> None:
        task = self.task
        #: The columns of each reading.
        self._columns: dict[str, slice] = {}
        observed = {} if callable(task.observation) else task.observation
        twice = set(observed) & set(task.extra)
        if twice:
            raise ValueError(f"'{min(twice)}' is both observed and extra; each reading needs a name of its own")
        limits: list[Limits] = []
        seen: dict[str, list[Limits]] = {}
        for name, reading in {**observed, **task.extra}.items():
            if isinstance(reading, Image) and name in observed:
                continue
            if not isinstance(reading, Reading):
                raise TypeError(f"'{name}' must be a Reading, such as Ranges(...), not {type(reading).__name__}")
            begin = len(limits)
            for i, simulation in enumerate(self.simulations):
                each = reading.attach(self._pool, i, simulation)
            limits += each
            self._columns[name] = slice(begin, len(limits))
            if name in observed:
                seen[name] = each
                for column in range(begin, len(limits)):
                    self._pool.observe(column, *limits[column])
        self._width = len(limits)
        self.observations = Observations(task, self.simulations, seen)
        self.observation_space = self.observations.space

    def _steer(self) -> None:
        task = self.task
        self.action_space: spaces.Space[Any]
        #: How many numbers each steering has.
        self.action_sizes: list[int] = []
        if callable(task.action):
            assert task.action_space is not None
            self.action_space = task.action_space
            return
        is_dict = isinstance(task.action, Mapping)
        named: Mapping[str, Steering | Sequence[Steering]]
        named = task.action if isinstance(task.action, Mapping) else {"": task.action}
        parts: dict[str, list[Limits]] = {}
        for name, steerings in named.items():
            limits = parts[name] = []
            for steering in [steerings] if isinstance(steerings, Steering) else steerings:
                if not isinstance(steering, Steering):
                    raise TypeError(
                        f"an action must be a list of actuators, such as Command(...), not {type(steering).__name__}"
                    )
                for i, simulation in enumerate(self.simulations):
                    each = steering.attach(self._pool, i, simulation)
                limits += each
                self.action_sizes.append(len(each))
            for each_limits in limits:
                self._pool.limit_action(*each_limits)
        spaces_of_parts: dict[str, spaces.Space[Any]] = {name: box(limits) for name, limits in parts.items()}
        # a Dict sorts some names, but the numbers stay in the order of the task
        self._action_names = list(parts)
        self.action_space = spaces.Dict(spaces_of_parts) if is_dict else spaces_of_parts[""]

    def numbers(self, action: Any, lead: tuple[int, ...] = ()) -> NDArray[Any]:
        """Returns the numbers of an action, or, with (worlds,) as `lead`, of one for each world. Raises ValueError for another
        shape."""
        what = "the actions have" if lead else "an action has"
        space = self.action_space
        if not isinstance(space, spaces.Dict):
            array = np.asarray(action)
            if array.shape != lead + (space.shape or ()):
                raise ValueError(f"{what} the shape {lead + (space.shape or ())}, not {array.shape}")
            return array
        if not isinstance(action, Mapping) or set(action) != set(space):
            given = ", ".join(map(repr, action)) if isinstance(action, Mapping) else type(action).__name__
            raise ValueError(f"an action must be a dict with {', '.join(map(repr, self._action_names))}, not {given}")
        parts = []
        for name in self._action_names:
            array = np.asarray(action[name])
            if array.shape != lead + (space[name].shape or ()):
                raise ValueError(f"{what} at '{name}' the shape {lead + (space[name].shape or ())}, not {array.shape}")
            parts.append(array)
        return np.concatenate(parts, axis=-1)

    def _steps_in(self, seconds: float, what: str) -> int:
        size = self.simulations[0].step_size
        count = round(seconds / size)
        if count < 1 or abs(count * size - seconds) > 1e-9:
            raise ValueError(f"{what} is {seconds:g} s, which is not a multiple of the world's step of {size:g} s")
        return count

    def _has_noise(self) -> bool:
        first = self.simulations[0]
        if any(each.what == "noise" for each in self.task.randomise):
            return True
        return any(first._find_sensor(name).has_noise for name in first.sensor_names)

    def _look_at_memory(self) -> None:
        pool, rows = self._pool, self.count
        self._actions = view(pool.actions, "f8", (rows, -1)) if pool.action_size else np.zeros((rows, 0))
        now, before = (
            view(memory, "f8", (rows, self._width)) if self._width else np.zeros((rows, 0))
            for memory in (pool.values, pool.before)
        )
        self.moment = Moment(
            {name: now[:, columns] for name, columns in self._columns.items()},
            {name: before[:, columns] for name, columns in self._columns.items()},
            rows,
            self.task.step_time,
        )
        self.moment.elapsed = self.elapsed
        self.moment.action = self._actions
        for array in (now, before):
            array.flags.writeable = False
        observed = len(memoryview(pool.observations)) // 4 // rows
        self.observations.lie_in(
            view(pool.observations, "f4", (rows, observed)) if observed else np.zeros((rows, 0), np.float32)
        )
        self._steps = view(pool.steps, "i8", (rows,))
        self._commanded = view(pool.commanded, "u1", (rows,))
        self._restored = view(pool.restored, "u1", (rows,))

    def begin(self, chosen: NDArray[np.bool_], seeds: Sequence[int | None], randoms: Sequence[np.random.Generator]) -> None:
        """Begins an episode in the chosen worlds. A world with a seed derives all its random numbers from it."""
        self._open()
        fresh = self._put_back(chosen, seeds, randoms)
        self._pool.step()
        self._have_begun(chosen, fresh)
        self.observations.look(np.flatnonzero(chosen).tolist())

    def step(
        self,
        actions: NDArray[Any],
        chosen: NDArray[np.bool_] | None = None,
        randoms: Sequence[np.random.Generator] = (),
    ) -> Verdict:
        """Takes a step in all worlds except the chosen ones, which begin an episode instead."""
        self._open()
        fresh: list[int] = []
        if chosen is not None:
            fresh = self._put_back(chosen, [None] * self.count, randoms)
            self._steps[~chosen] = self._step_count
            self._commanded[~chosen] = 1
        elif not self._all_go:
            self._steps[:] = self._step_count
            self._commanded[:] = 1
            self._all_go = True
        self._act(actions, chosen)
        self._pool.step()
        self.elapsed += 1
        if chosen is not None:
            self._have_begun(chosen, fresh)
        self.observations.look(range(self.count))
        return self._judge(chosen)

    def _act(self, actions: NDArray[Any], chosen: NDArray[np.bool_] | None) -> None:
        act = self.task.action
        if not callable(act):
            self._actions[...] = actions
            return
        for i, simulation in enumerate(self.simulations):
            if chosen is None or not chosen[i]:
                call("the action", act, simulation, actions[i])
        self.moment.action = actions

    def _put_back(
        self, chosen: NDArray[np.bool_], seeds: Sequence[int | None], randoms: Sequence[np.random.Generator]
    ) -> list[int]:
        """Resets the chosen worlds, and settles those that need it. Returns those to be saved afterwards."""
        task, pool = self.task, self._pool
        self._all_go = False
        self._steps[:] = 0
        self._commanded[:] = 0
        self._restored[:] = 0
        to_settle: list[int] = []
        to_save: list[int] = []
        for i in np.flatnonzero(chosen).tolist():
            seed = seeds[i]
            if seed is None and self._draws_noise:
                seed = int(randoms[i].integers(2**63))
            if seed is None and self._is_saved[i]:
                self._restored[i] = 1
                if self._changes:
                    to_settle.append(i)
                continue
            # seeds with more than 64 bits are cut
            self.simulations[i].reset(seed=None if seed is None else seed % 2**64)
            to_settle.append(i)
            if self._draws_noise:
                continue
            self._is_saved[i] = self._changes
            if self._changes:
                pool.save(i)
            else:
                to_save.append(i)
        if self._restored.any():
            try:
                pool.restore()
            except Refused:
                # models or systems have been added or removed since: starting again is slower, but always possible
                self._is_saved = [False] * self.count
                return self._put_back(chosen, seeds, randoms)
        for i in to_settle:
            for draw in self._draws[i]:
                draw(randoms[i])
            if task.start is not None:
                call("the start", task.start, self.simulations[i], randoms[i])
        self._steps[to_settle] = self._settle_count
        return to_save

    def _have_begun(self, chosen: NDArray[np.bool_], to_save: Sequence[int]) -> None:
        begun = np.flatnonzero(chosen).tolist()
        self.elapsed[begun] = 0
        for i in begun:
            missing = self._pool.missing(i)
            if missing:
                raise NoReading(
                    f"there is no reading of {missing} before the first observation; increase settle_time so that "
                    "one arrives, and check that the world publishes it"
                )
        for i in to_save:
            self._pool.save(i)
            self._is_saved[i] = True

    def _judge(self, chosen: NDArray[np.bool_] | None) -> Verdict:
        task, moment, no = self.task, self.moment, self._no
        # nothing counts for an episode that has just begun
        terminated = no if task.terminated is None else judge("terminated", task.terminated, moment, TRUTHS, chosen)
        moment.terminated = terminated
        rewards = judge("the reward", task.reward, moment, NUMBERS, chosen)
        truncated = no if task.truncated is None else judge("truncated", task.truncated, moment, TRUTHS, chosen)
        if self._steps_to_limit is not None:
            late = self.elapsed >= self._steps_to_limit
            truncated = late if truncated is no else truncated | late
        return rewards, terminated, truncated

    def draw(self) -> list[NDArray[np.uint8]]:
        """Returns an image of each world, of rows x columns x red, green, blue."""
        self._open()
        if not self._eyes:
            self._eyes = eyes_of(self.simulations, self.task.camera)
        return [eye.draw() for eye in self._eyes]

    def _open(self) -> None:
        if self.is_closed:
            raise Gone("the environment is closed")

    def close(self) -> None:
        """Closes all worlds. Raises the first SystemFailed of those whose files are not complete."""
        self.is_closed = True
        failed: list[SystemFailed] = []
        for simulation in self.simulations:
            try:
                simulation.close()
            except SystemFailed as error:
                failed.append(error)
        if failed:
            raise failed[0]
