"""pongsim/WallAvoid-v0: a robot drives among walls without hitting them."""

from __future__ import annotations

import pathlib
import numpy as np
from gymnasium.vector import AutoresetMode
from numpy.typing import NDArray

from ..simulation import Simulation
from .env import Env
from .parts import Camera, Command, Ranges, Velocity
from .task import Moment, Task
from .vector_env import VectorEnv

_WORLD = pathlib.Path(__file__).with_name("wall_avoid.sdf")

# directions of the beams in the robot's frame [rad], starting at -pi
_ANGLES = np.arange(64) * (2 * np.pi / 64) - np.pi
# distance from the lidar to the robot's outline along each beam [m]: half its length, or half its width including the
# wheels
_OUTLINE = np.minimum(1.0 / np.maximum(np.abs(np.cos(_ANGLES)), 1e-9), 0.7 / np.maximum(np.abs(np.sin(_ANGLES)), 1e-9))
# distance from the outline that counts as a hit [m]
_TOO_NEAR = _OUTLINE + 0.1
_HIT_COSTS = 5.0
_STEP_TIME = 0.05  # [s]


def _hits(now: Moment) -> NDArray[np.bool_]:
    """Whether a wall is this close to the robot's outline."""
    near: NDArray[np.bool_] = np.logical_or.reduce(now["ranges"] < _TOO_NEAR, axis=1)
    return near


def _reward(now: Moment) -> NDArray[np.float64]:
    """The distance driven ahead in a step [m], reduced when turning, down to zero in the sharpest turn. A hit costs
    5."""
    ahead = now["velocity"][:, 0] * _STEP_TIME
    reward: NDArray[np.float64] = ahead * (1 - np.abs(now.action[:, 1])) - _HIT_COSTS * now.terminated
    return reward


def _start(simulation: Simulation, random: np.random.Generator) -> None:
    """Puts the robot next to the island in the middle, in any direction."""
    x = random.uniform(-7.0, 7.0)
    y = random.uniform(2.5, 4.0) * (1.0 if random.random() < 0.5 else -1.0)
    yaw = random.uniform(-np.pi, np.pi)
    simulation.model("pong_bot").move((x, y, 0.0, 0.0, 0.0, yaw), stop=True)


def wall_avoid() -> Task:
    """The task of pongsim/WallAvoid-v0.

    A robot with two driven wheels, 2 m long, in a court of 20 by 12 m with an island in the middle. The action is its
    forward speed (0 to 1 m/s) and its turning rate (-1 to 1 rad/s, positive to the left). It observes the range of 64
    beams all around, from the back by the right (0 to 10 m). The reward is the distance driven ahead, less in turns. An
    episode ends when it hits a wall, which costs 5, and is truncated after 30 s. A step takes 0.05 s, in five physics
    steps.
    """
    return Task(
        world=_WORLD,
        action=[Command("/cmd_vel", {"linear.x": (0.0, 1.0), "angular.z": (-1.0, 1.0)}, type="Twist")],
        observation={"ranges": Ranges("lidar")},
        extra={"velocity": Velocity("pong_bot")},
        reward=_reward,
        terminated=_hits,
        start=_start,
        step_time=_STEP_TIME,
        time_limit=30.0,
        camera=Camera(pose=(-9.0, -9.0, 12.0, 0.0, 0.8, 0.75)),
    )


class WallAvoidEnv(Env):
    """pongsim/WallAvoid-v0; see `wall_avoid`."""

    def __init__(self, *, render_mode: str | None = None) -> None:
        """See `Env`."""
        super().__init__(wall_avoid(), render_mode=render_mode)


class WallAvoidVectorEnv(VectorEnv):
    """Several worlds of pongsim/WallAvoid-v0; see `wall_avoid`."""

    def __init__(
        self,
        num_envs: int = 1,
        *,
        threads: int | None = None,
        autoreset_mode: AutoresetMode | str = AutoresetMode.NEXT_STEP,
        render_mode: str | None = None,
    ) -> None:
        """See `VectorEnv`."""
        super().__init__(
            wall_avoid(), num_envs, threads=threads, autoreset_mode=autoreset_mode, render_mode=render_mode
        )
