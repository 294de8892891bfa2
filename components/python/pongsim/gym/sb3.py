"""Worlds of a task for stable-baselines3: `PPO("MlpPolicy", VecEnv(task, 16)).learn(100_000)`."""

from __future__ import annotations

from typing import Any, Sequence

import numpy as np
from gymnasium.vector import AutoresetMode
from numpy.typing import NDArray

try:
    from stable_baselines3.common.vec_env import VecEnv as _VecEnv  # type: ignore[import-not-found,unused-ignore]
except ImportError as missing:
    raise ImportError(
        "pongsim.gym.sb3 needs stable-baselines3 2 or later, which is not installed: pip install stable-baselines3"
    ) from missing

from ..simulation import Simulation
from .task import Task
from .vector_env import VectorEnv


class World:
    """One of the worlds, whose attributes `VecEnv.get_attr` and `set_attr` reach."""

    def __init__(self, simulation: Simulation, task: Task, render_mode: str | None) -> None:
        #: The running world.
        self.simulation = simulation
        #: What is learnt in it.
        self.task = task
        #: As of the `VecEnv`.
        self.render_mode = render_mode


class VecEnv(_VecEnv):  # type: ignore[misc,unused-ignore]  # its package need not be installed
    """Many worlds of a task in this process as a vector of stable-baselines3, stepped by one call into C++.

    A world whose episode has ended begins another in the same step: `infos[i]` then has the last observation as
    "terminal_observation", and whether the episode was truncated as "TimeLimit.truncated".
    """

    def __init__(
        self, task: Task, num_envs: int, *, threads: int | None = None, render_mode: str | None = None
    ) -> None:
        """Loads the worlds; see `VectorEnv`."""
        self._envs = VectorEnv(
            task, num_envs, threads=threads, autoreset_mode=AutoresetMode.SAME_STEP, render_mode=render_mode
        )
        self._single = [World(each, task, render_mode) for each in self._envs.simulations]
        self._actions: NDArray[Any] | None = None
        super().__init__(num_envs, self._envs.single_observation_space, self._envs.single_action_space)

    @property
    def simulations(self) -> Sequence[Simulation]:
        """The worlds, for inspection or changes between two steps."""
        return self._envs.simulations

    def reset(self) -> Any:
        """Begins an episode in each world, with the seeds of `seed`, and returns the observations."""
        options = next((each for each in self._options if each), None)
        observations, _ = self._envs.reset(seed=self._seeds, options=options)
        self._actions = None
        self.reset_infos: list[dict[str, Any]] = [{} for _ in range(self.num_envs)]
        self._reset_seeds()
        self._reset_options()
        return observations

    def step_async(self, actions: NDArray[Any]) -> None:
        """Notes the actions for `step_wait`."""
        self._actions = actions

    def step_wait(self) -> tuple[Any, NDArray[np.float32], NDArray[np.bool_], list[dict[str, Any]]]:
        """Takes a step. Returns observations, rewards, whether each episode has ended, and infos."""
        observations, rewards, terminated, truncated, last = self._envs.step(self._actions)
        done = terminated | truncated
        infos: list[dict[str, Any]] = [{} for _ in range(self.num_envs)]
        for i in np.flatnonzero(done).tolist():
            infos[i] = {
                "terminal_observation": last["final_obs"][i],
                "TimeLimit.truncated": bool(truncated[i] and not terminated[i]),
            }
        return observations, rewards.astype(np.float32), done, infos

    def close(self) -> None:
        """Closes the worlds."""
        self._envs.close()

    def get_images(self) -> Sequence[NDArray[np.uint8] | None]:
        """An image of each world; None without a `render_mode`."""
        return self._envs.render() or [None] * self.num_envs

    def get_attr(self, attr_name: str, indices: Any = None) -> list[Any]:
        """Returns an attribute of these worlds: "simulation", "task", "render_mode", or one set by `set_attr`."""
        return [getattr(self._single[i], attr_name) for i in self._get_indices(indices)]

    def set_attr(self, attr_name: str, value: Any, indices: Any = None) -> None:
        """Sets an attribute of these worlds."""
        for i in self._get_indices(indices):
            setattr(self._single[i], attr_name, value)

    def env_method(self, method_name: str, *method_args: Any, indices: Any = None, **method_kwargs: Any) -> list[Any]:
        """Calls a method of these worlds' simulations."""
        return [
            getattr(self._single[i].simulation, method_name)(*method_args, **method_kwargs)
            for i in self._get_indices(indices)
        ]

    def env_is_wrapped(self, wrapper_class: Any, indices: Any = None) -> list[bool]:
        """Returns False for each: no wrapper is around a single world."""
        return [False for _ in self._get_indices(indices)]
