"""Readings and actions of a world that need no Python code in a step."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from ..arrays import view
from ..pictures import FIELD_OF_VIEW, SIZE

if TYPE_CHECKING:
    from .._core import Joint as CoreJoint
    from .._core import Pool
    from .. import values
    from ..simulation import Simulation

#: The smallest and the largest value of a number.
Limits = tuple[float, float]
_ANY: Limits = (-math.inf, math.inf)


class Reading:
    """Numbers read from a world after each step of an environment."""

    def attach(self, pool: Pool, world: int, simulation: Simulation) -> list[Limits]:
        """Starts reading them in a world. Returns the range of each number for the observation space."""
        raise NotImplementedError


class Steering:
    """Numbers of an action that command a world."""

    def attach(self, pool: Pool, world: int, simulation: Simulation) -> list[Limits]:
        """Connects them to a world. Returns the range of each number."""
        raise NotImplementedError


@dataclass(frozen=True)
class Ranges(Reading):
    """The range of each beam of a lidar [m], row by row from the lowest. Without a hit, a range is infinite, and
    observed as the lidar's maximum; too close, it is minus infinity, and observed as 0."""

    #: Its scoped name, "model::link::sensor", or its own name if that is unique.
    sensor: str

    def attach(self, pool: Pool, world: int, simulation: Simulation) -> list[Limits]:
        """See `Reading.attach`."""
        from .. import _core

        sensor = simulation._find_sensor(self.sensor)
        limits = _core.lidar_limits(sensor)
        pool.read_ranges(world, sensor)
        return [(0.0, limits.farthest)] * limits.beams


@dataclass(frozen=True)
class Pose(Reading):
    """Pose of a model in the world frame: x, y, z [m] and a unit quaternion x, y, z, w."""

    #: The model's scoped name.
    model: str

    def attach(self, pool: Pool, world: int, simulation: Simulation) -> list[Limits]:
        """See `Reading.attach`."""
        pool.read_pose(world, simulation.model(self.model))
        return [_ANY] * 3 + [(-1.0, 1.0)] * 4


@dataclass(frozen=True)
class Velocity(Reading):
    """Velocity of a model's canonical link in its own axes: linear x, y, z [m/s], angular x, y, z [rad/s]."""

    #: The model's scoped name.
    model: str

    def attach(self, pool: Pool, world: int, simulation: Simulation) -> list[Limits]:
        """See `Reading.attach`."""
        pool.read_velocity(world, simulation.model(self.model))
        return [_ANY] * 6


@dataclass(frozen=True)
class Joint(Reading):
    """Position [rad or m] and velocity [rad/s or m/s] of a joint's first axis."""

    #: "model::joint".
    joint: str

    def attach(self, pool: Pool, world: int, simulation: Simulation) -> list[Limits]:
        """See `Reading.attach`."""
        pool.read_joint(world, _joint(simulation, self.joint))
        return [_ANY] * 2


@dataclass(frozen=True)
class Fields(Reading):
    """Numbers of the last message on a topic, given by their paths: `Fields("/imu", "linear_acceleration.x")`."""

    topic: str
    #: A path, or several.
    paths: str | tuple[str, ...]
    #: The messages' type, such as "IMU"; not needed if the topic exists in the world.
    type: str = ""
    #: The range of each number.
    limits: Limits = _ANY

    def attach(self, pool: Pool, world: int, simulation: Simulation) -> list[Limits]:
        """See `Reading.attach`."""
        paths = [self.paths] if isinstance(self.paths, str) else list(self.paths)
        pool.read_fields(world, simulation, self.topic, self.type, paths)
        return [_checked(self.limits, f"topic {self.topic}")] * len(paths)


@dataclass(frozen=True)
class Camera:
    """A viewpoint for images. It is not a sensor and does not affect the world."""

    #: Pose of the viewpoint in the world frame, looking along its x axis with z up; None: from the side and above, with
    #: everything in view.
    pose: values.Pose | Sequence[float] | None = None
    #: [pixels]
    width: int = SIZE[0]
    height: int = SIZE[1]
    #: Horizontal field of view [rad].
    field_of_view: float = FIELD_OF_VIEW


@dataclass(frozen=True)
class Image:
    """What a camera sees after each step of an environment: rows x columns x red, green, blue, 0 to 255. It is drawn when
    it is observed, one world after the other, without the camera's noise, distortion and rate."""

    #: A camera of the world, by its scoped name or its own, or any viewpoint.
    camera: str | Camera
    #: Width and height [pixels]; None: the camera's.
    size: tuple[int, int] | None = None


@dataclass(frozen=True)
class Command(Steering):
    """A message published at the start of each step of the environment: `Command("/cmd_vel", {"linear.x": (0, 1),
    "angular.z": (-1, 1)})`."""

    topic: str
    #: The path and the range of each number of the action.
    fields: Mapping[str, Limits] = field(hash=False)
    #: The message's type, such as "Twist"; not needed if the topic exists in the world.
    type: str = ""

    def attach(self, pool: Pool, world: int, simulation: Simulation) -> list[Limits]:
        """See `Steering.attach`."""
        limits = [_checked(each, f"field '{path}' of {self.topic}", finite=True) for path, each in self.fields.items()]
        pool.steer_fields(world, simulation, self.topic, self.type, list(self.fields))
        return limits


@dataclass(frozen=True)
class JointVelocity(Steering):
    """Drives a joint's first axis at a velocity [rad/s or m/s]."""

    #: "model::joint".
    joint: str
    low: float
    high: float

    def attach(self, pool: Pool, world: int, simulation: Simulation) -> list[Limits]:
        """See `Steering.attach`."""
        pool.steer_velocity(world, _joint(simulation, self.joint))
        return [_checked((self.low, self.high), f"joint '{self.joint}'", finite=True)]


@dataclass(frozen=True)
class JointPosition(Steering):
    """Moves a joint's first axis to a position [rad or m] by the force stiffness (position - present position) - damping
    velocity, computed before each physics step and limited by the joint's effort. Steps of length h follow it smoothly
    where damping h and stiffness h^2 are well below the inertia that the joint moves."""

    #: "model::joint".
    joint: str
    #: Range of the position; None: the limits of the joint.
    low: float | None = None
    high: float | None = None
    #: [N m/rad or N/m]
    stiffness: float = field(kw_only=True)
    #: [N m s/rad or N s/m]
    damping: float = field(kw_only=True)

    def attach(self, pool: Pool, world: int, simulation: Simulation) -> list[Limits]:
        """See `Steering.attach`."""
        if not all(math.isfinite(each) and each >= 0 for each in (self.stiffness, self.damping)):
            raise ValueError(f"stiffness and damping of joint '{self.joint}' must be 0 or more and finite")
        joint = _joint(simulation, self.joint)
        gains = view(pool.steer_position(world, joint), "f8", (2,))
        gains[:] = self.stiffness, self.damping
        simulation._gains[self.joint] = gains
        own = joint.axis()
        limits = own.lower if self.low is None else self.low, own.upper if self.high is None else self.high
        return [_checked(limits, f"joint '{self.joint}'", finite=True)]


@dataclass(frozen=True)
class JointForce(Steering):
    """Applies a force along a joint's first axis [N m or N] in all physics steps of an environment step."""

    #: "model::joint".
    joint: str
    low: float
    high: float

    def attach(self, pool: Pool, world: int, simulation: Simulation) -> list[Limits]:
        """See `Steering.attach`."""
        pool.steer_force(world, _joint(simulation, self.joint))
        return [_checked((self.low, self.high), f"joint '{self.joint}'", finite=True)]


def _joint(simulation: Simulation, name: str) -> CoreJoint:
    model, colons, joint = name.rpartition("::")
    if not colons:
        raise ValueError(f"name a joint with its model, such as 'robot::{name}', not '{name}'")
    return simulation.model(model).joint(joint)


def _checked(limits: Limits, what: str, finite: bool = False) -> Limits:
    low, high = (float(each) for each in limits)
    if not low < high or (finite and not (math.isfinite(low) and math.isfinite(high))):
        raise ValueError(f"{what} must lie between two {'finite ' if finite else ''}numbers, the lesser first, not {limits}")
    return low, high
