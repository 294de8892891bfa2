"""A world as a Gymnasium environment."""

from __future__ import annotations

from typing import Any

import gymnasium
import numpy as np
from gymnasium import error, logger
from numpy.typing import NDArray

from ..errors import Gone
from ..simulation import Simulation
from .task import Moment, Task
from .worlds import Worlds

_RENDER_MODES = (None, "rgb_array")


class Env(gymnasium.Env[Any, Any]):
    """One world of a task.

    A reset restores a saved state, which costs a fraction of loading the world. A seed passed to `reset` also seeds the
    world. If sensors have noise, each reset draws a new seed for the episode.
    """

    metadata: dict[str, Any] = {"render_modes": ["rgb_array"]}

    def __init__(self, task: Task, *, render_mode: str | None = None) -> None:
        """Loads the world.

        render_mode: "rgb_array": `render` returns an image.
        Raises LoadError if the world can't run, KeyError for names that are not in it, ValueError and TypeError for
        errors in the task.
        """
        check_render_mode(render_mode)
        self._worlds = Worlds(task, 1, 1)
        self.task = task
        self.render_mode = render_mode
        self.metadata = {"render_modes": ["rgb_array"], "render_fps": max(1, round(1 / task.step_time))}
        self.action_space = self._worlds.action_space
        self.observation_space = self._worlds.observation_space
        self._has_begun = False

    @property
    def simulation(self) -> Simulation:
        """The world, for inspection or changes between two steps."""
        return self._worlds.simulations[0]

    @property
    def moment(self) -> Moment:
        """What the task's functions received last."""
        return self._worlds.moment

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Any, dict[str, Any]]:
        """Begins an episode.

        seed: seed of the environment's random numbers, and of all those of the world in this episode.
        options: none exist.
        Returns the first observation, and an empty dict.
        """
        if options:
            raise ValueError(f"reset has no option '{next(iter(options))}'")
        super().reset(seed=seed)
        self._has_begun = False
        self._worlds.begin(np.ones(1, np.bool_), [seed], [self.np_random])
        self._has_begun = True
        return self._worlds.observations.row(0), {}

    def step(self, action: Any) -> tuple[Any, float, bool, bool, dict[str, Any]]:
        """Takes a step of the task's `step_time`.

        action: from the action space; numbers beyond its limits are clamped.
        Returns the observation, the reward, whether the episode is terminated, whether it is truncated, and an empty
        dict. Raises ValueError for an action with the wrong shape or a number that is not finite, and Gymnasium's
        ResetNeeded after the end of an episode.
        """
        if not self._has_begun:
            if self._worlds.is_closed:
                raise Gone("the environment is closed")
            raise error.ResetNeeded(
                "call reset before the first step, after the end of an episode, and after a step that raised an exception"
            )
        numbers = self._worlds.numbers(action)
        self._has_begun = False
        rewards, terminated, truncated = self._worlds.step(numbers[None])
        self._has_begun = not (terminated.item() or truncated.item())
        return self._worlds.observations.row(0), rewards.item(), terminated.item(), truncated.item(), {}

    def render(self) -> NDArray[np.uint8] | None:
        """An image of the current world: rows x columns x red, green, blue. None without a `render_mode`."""
        if self.render_mode is None:
            logger.warn("render needs an environment made with render_mode=\"rgb_array\"")
            return None
        return self._worlds.draw()[0]

    def close(self) -> None:
        """Closes the world."""
        self._has_begun = False
        self._worlds.close()


def check_render_mode(mode: str | None) -> None:
    """Raises ValueError for an unknown mode."""
    if mode not in _RENDER_MODES:
        raise ValueError(f"there is no render_mode {mode!r}; there is \"rgb_array\"")
