"""Environments of Gymnasium: worlds to learn in, one at a time or many at once.

    import gymnasium
    import pongsim.gym

    env = gymnasium.make("pongsim/WallAvoid-v0")
    observation, info = env.reset(seed=7)

A `Task` says what one is to learn: a world, what an action does, what is observed, and functions for the reward and the
end. `Env` is one world with it, `VectorEnv` many of them in this process, on all cores.
"""

try:
    import gymnasium
    from gymnasium.vector import AutoresetMode
except ImportError as missing:
    raise ImportError(
        "pongsim.gym needs Gymnasium 1.1 or later, which is not installed: pip install 'gymnasium>=1.1'"
    ) from missing

from .env import Env
from .parts import Command, Fields, Joint, JointForce, JointVelocity, Pose, Ranges, Reading, Steering, Velocity
from .task import Camera, Moment, Task, TaskError
from .vector_env import VectorEnv
from .wall_avoid import wall_avoid

__all__ = [
    "AutoresetMode",
    "Camera",
    "Command",
    "Env",
    "Fields",
    "Joint",
    "JointForce",
    "JointVelocity",
    "Moment",
    "Pose",
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
