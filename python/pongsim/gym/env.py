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


class Env(gymnasium.Env[NDArray[Any], Any]):
    """One world of a task.

    The world is set back to its start by restoring a saved state, which costs a fraction of loading it. A seed that is
    given to `reset` is the world's, too. Where sensors have noise, each reset draws a seed for the episode.
    """

    metadata: dict[str, Any] = {"render_modes": ["rgb_array"]}

    def __init__(self, task: Task, *, render_mode: str | None = None) -> None:
        """Loads the world.

        render_mode: "rgb_array", and `render` gives a picture.
        Raises LoadError where the world can't run, KeyError for names that are not in it, ValueError and TypeError for
        what is wrong with the task.
        """
        check_render_mode(render_mode)
        self._worlds = Worlds(task, 1, 1)
        self.task = task
        self.render_mode = render_mode
        self.metadata = {"render_modes": ["rgb_array"], "render_fps": max(1, round(1 / task.step_time))}
        self.action_space = self._worlds.action_space
        self.observation_space = self._worlds.observation_space
        self._action_shape = self.action_space.shape
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
    ) -> tuple[NDArray[Any], dict[str, Any]]:
        """Begins an episode.

        seed: of the environment's random numbers, and of all of the world's in this episode.
        options: there are none.
        Returns the first observation, and an empty dict.
        """
        if options:
            raise ValueError(f"there is no option '{next(iter(options))}' of a reset")
        super().reset(seed=seed)
        self._has_begun = False
        self._worlds.begin(np.ones(1, np.bool_), [seed], [self.np_random])
        self._has_begun = True
        return self._worlds.observations[0].copy(), {}

    def step(self, action: Any) -> tuple[NDArray[Any], float, bool, bool, dict[str, Any]]:
        """Takes a step of the task's `step_time`.

        action: of the action space; numbers beyond its limits count as the limits.
        Returns what is observed then, the reward, whether the episode is terminated and whether truncated, and an empty
        dict. Raises ValueError for an action of another shape or with a number that is not finite.
        """
        if not self._has_begun:
            if self._worlds.is_closed:
                raise Gone("the environment is closed")
            raise error.ResetNeeded("call reset before the first step, and after one that raised")
        action = np.asarray(action)
        if action.shape != self._action_shape:
            raise ValueError(f"an action has the shape {self._action_shape}, not {action.shape}")
        self._has_begun = False
        rewards, terminated, truncated = self._worlds.step(action[None])
        self._has_begun = True
        return self._worlds.observations[0].copy(), rewards.item(), terminated.item(), truncated.item(), {}

    def render(self) -> NDArray[np.uint8] | None:
        """An image of the current world: rows x columns x red, green, blue. None without a `render_mode`."""
        if self.render_mode is None:
            logger.warn("render needs an environment made with render_mode=\"rgb_array\"")
            return None
        return self._worlds.draw()[0]

    def close(self) -> None:
        """Ends the world."""
        self._has_begun = False
        self._worlds.close()


def check_render_mode(mode: str | None) -> None:
    """Raises ValueError for one that is not there."""
    if mode not in _RENDER_MODES:
        raise ValueError(f"there is no render_mode {mode!r}; there is \"rgb_array\"")
