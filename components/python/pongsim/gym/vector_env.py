"""Many worlds as a Gymnasium vector environment."""

from __future__ import annotations

import os
from typing import Any, Sequence

import gymnasium
import numpy as np
from gymnasium import error, logger
from gymnasium.utils import seeding
from gymnasium.vector import AutoresetMode
from gymnasium.vector.utils import batch_space
from numpy.typing import NDArray

from ..errors import Gone
from ..simulation import Simulation
from .env import check_render_mode
from .task import Moment, Task
from .worlds import Worlds


class VectorEnv(gymnasium.vector.VectorEnv[Any, NDArray[Any], NDArray[Any]]):
    """Many worlds of a task in this process, each bit-for-bit the same as in an `Env` of its own.

    A step of all worlds is one call to C++, which distributes them over threads. The number of threads only affects the
    time it takes.
    """

    def __init__(
        self,
        task: Task,
        num_envs: int,
        *,
        threads: int | None = None,
        autoreset_mode: AutoresetMode | str = AutoresetMode.NEXT_STEP,
        render_mode: str | None = None,
    ) -> None:
        """Loads the worlds.

        threads: number of worlds stepped in parallel; None: the number of processors available to this process.
        autoreset_mode: when a world whose episode has ended begins another: in the next step, which ignores its action;
        in the same step, which returns the last observation as `final_obs` in the infos; or never: then call `reset`
        with a "reset_mask" in its options.
        render_mode: "rgb_array": `render` returns images.
        Raises the same exceptions as `Env`.
        """
        super().__init__()
        check_render_mode(render_mode)
        if num_envs < 1:
            raise ValueError(f"num_envs must be 1 or more, not {num_envs}")
        self.threads = len(os.sched_getaffinity(0)) if threads is None else threads
        self.autoreset_mode = AutoresetMode(autoreset_mode)
        self._worlds = Worlds(task, num_envs, self.threads)
        self.task = task
        self.num_envs = num_envs
        self.render_mode = render_mode
        self.metadata = {
            "render_modes": ["rgb_array"],
            "render_fps": max(1, round(1 / task.step_time)),
            "autoreset_mode": self.autoreset_mode,
        }
        self.single_action_space = self._worlds.action_space
        self.single_observation_space = self._worlds.observation_space
        self.action_space = batch_space(self.single_action_space, num_envs)
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self._randoms: list[np.random.Generator | None] = [None] * num_envs
        self._seeds: list[int] = [-1] * num_envs
        self._has_begun = False
        self._done: NDArray[np.bool_] = np.zeros(num_envs, np.bool_)

    @property
    def simulations(self) -> Sequence[Simulation]:
        """The worlds, for inspection or changes between two steps."""
        return tuple(self._worlds.simulations)

    @property
    def moment(self) -> Moment:
        """What the task's functions received last."""
        return self._worlds.moment

    @property  # type: ignore[misc]  # as Gymnasium's own vectors have it
    def np_random(self) -> tuple[np.random.Generator, ...]:  # type: ignore[override]
        """The random numbers of each environment."""
        return tuple(self._random(i) for i in range(self.num_envs))

    @property
    def np_random_seed(self) -> tuple[int, ...]:  # type: ignore[override]
        """The seed of each environment's random numbers."""
        return tuple((self._random(i), self._seeds[i])[1] for i in range(self.num_envs))

    def _random(self, world: int) -> np.random.Generator:
        random = self._randoms[world]
        if random is None:
            random, self._seeds[world] = seeding.np_random()
            self._randoms[world] = random
        return random

    def reset(
        self, *, seed: int | Sequence[int | None] | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Any, dict[str, Any]]:
        """Begins an episode in all worlds, or in those selected by a mask.

        seed: seed of the first environment, with consecutive numbers for the others; or one for each.
        options: {"reset_mask": an array of num_envs booleans}.
        Returns the observations, num_envs x those of one, and an empty dict.
        """
        if self._worlds.is_closed:
            raise Gone("the environment is closed")
        chosen = self._mask(options)
        if not self._has_begun and not chosen.all():
            raise error.ResetNeeded("the first reset, and a reset after a step that raised an exception, must include all environments")
        seeds = self._one_each(seed)
        for i in np.flatnonzero(chosen).tolist():
            if (each := seeds[i]) is not None:
                self._randoms[i], self._seeds[i] = seeding.np_random(each)
        self._has_begun = False
        self._worlds.begin(chosen, seeds, self.np_random)
        self._has_begun = True
        self._done[chosen] = False
        return self._worlds.observations.all(), {}

    def _one_each(self, seed: int | Sequence[int | None] | None) -> list[int | None]:
        if seed is None:
            return [None] * self.num_envs
        if isinstance(seed, (int, np.integer)):
            return [int(seed) + i for i in range(self.num_envs)]
        if len(seed) != self.num_envs:
            raise ValueError(f"there are {len(seed)} seeds for {self.num_envs} environments")
        return list(seed)

    def _mask(self, options: dict[str, Any] | None) -> NDArray[np.bool_]:
        mask = np.ones(self.num_envs, np.bool_)
        for name, value in (options or {}).items():
            if name != "reset_mask":
                raise ValueError(f"reset has no option '{name}', only 'reset_mask'")
            mask = np.asarray(value)
            if mask.dtype != np.bool_ or mask.shape != (self.num_envs,) or not mask.any():
                raise ValueError(f"'reset_mask' must be an array of {self.num_envs} booleans, at least one of them True")
        return mask

    def step(
        self, actions: Any
    ) -> tuple[Any, NDArray[np.float64], NDArray[np.bool_], NDArray[np.bool_], dict[str, Any]]:
        """Takes a step in all worlds.

        actions: num_envs x one action; numbers beyond the limits are clamped.
        Returns observations (num_envs x those of one), rewards, terminated, truncated (num_envs each), and infos, which
        are empty except for what `autoreset_mode` adds. Raises ValueError for actions with the wrong shape or with
        numbers that are not finite.
        """
        if not self._has_begun:
            if self._worlds.is_closed:
                raise Gone("the environment is closed")
            raise error.ResetNeeded("call reset before the first step, and after a step that raised an exception")
        batch = self._worlds.numbers(actions, (self.num_envs,))
        ended = self._done if self._done.any() else None
        if ended is not None and self.autoreset_mode is AutoresetMode.DISABLED:
            raise error.ResetNeeded(
                f"the episodes of environments {np.flatnonzero(ended).tolist()} have ended: reset them with a 'reset_mask'"
            )
        self._has_begun = False
        rewards, terminated, truncated = self._worlds.step(batch, ended, self.np_random if ended is not None else ())
        # the functions' results may refer to memory that will be overwritten
        rewards, terminated, truncated = rewards.copy(), terminated.copy(), truncated.copy()
        self._done = terminated | truncated
        infos: dict[str, Any] = {}
        if self.autoreset_mode is AutoresetMode.SAME_STEP and self._done.any():
            infos = self._begin_anew()
        self._has_begun = True
        return self._worlds.observations.all(), rewards, terminated, truncated, infos

    def _begin_anew(self) -> dict[str, Any]:
        infos: dict[str, Any] = {}
        for i in np.flatnonzero(self._done).tolist():
            last = {"final_obs": self._worlds.observations.row(i), "final_info": {}}
            infos = self._add_info(infos, last, i)
        self._worlds.begin(self._done, [None] * self.num_envs, self.np_random)
        self._done = np.zeros(self.num_envs, np.bool_)
        return infos

    def render(self) -> tuple[NDArray[np.uint8], ...] | None:
        """An image of each current world: rows x columns x red, green, blue. None without a `render_mode`."""
        if self.render_mode is None:
            logger.warn("render needs an environment made with render_mode=\"rgb_array\"")
            return None
        return tuple(self._worlds.draw())

    def close_extras(self, **kwargs: Any) -> None:
        """Closes the worlds."""
        self._has_begun = False
        self._worlds.close()
