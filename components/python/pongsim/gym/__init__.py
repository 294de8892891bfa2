"""Gymnasium environments: worlds for reinforcement learning, one or many at a time.

    import gymnasium
    import pongsim.gym

    env = gymnasium.make("pongsim/WallAvoid-v0")
    observation, info = env.reset(seed=7)

A `Task` defines what to learn: a world, what an action does, what is observed, and functions for the reward and the end
of an episode. `Env` is one world of a task, `VectorEnv` many of them in this process, on all cores.
"""

try:
    import gymnasium
    from gymnasium.vector import AutoresetMode
except ImportError as missing:
    raise ImportError(
        "pongsim.gym needs Gymnasium 1.1 or later, which is not installed: pip install 'gymnasium>=1.1'"
    ) from missing

from .env import Env
from .parts import (
    Camera,
    Command,
    Fields,
    Image,
    Joint,
    JointForce,
    JointPosition,
    JointVelocity,
    Pose,
    Ranges,
    Reading,
    Steering,
    Velocity,
)
from .randomise import Randomise
from .task import Moment, Task, TaskError
from .vector_env import VectorEnv
from .wall_avoid import wall_avoid

__all__ = [
    "AutoresetMode",
    "Camera",
    "Command",
    "Env",
    "Fields",
    "Image",
    "Joint",
    "JointForce",
    "JointPosition",
    "JointVelocity",
    "Moment",
    "Pose",
    "Randomise",
    "Ranges",
    "Reading",
    "Steering",
    "Task",
    "TaskError",
    "VectorEnv",
    "Velocity",
    "wall_avoid",
]

gymnasium.register(
    id="pongsim/WallAvoid-v0",
    entry_point="pongsim.gym.wall_avoid:WallAvoidEnv",
    vector_entry_point="pongsim.gym.wall_avoid:WallAvoidVectorEnv",
)
