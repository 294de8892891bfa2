"""Values used by simulations."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray


class Pose(NamedTuple):
    """Position and orientation of a frame in another frame."""

    #: x, y, z [m].
    position: tuple[float, float, float] = (0.0, 0.0, 0.0)
    #: Unit quaternion x, y, z, w.
    orientation: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 1.0)

    @property
    def roll_pitch_yaw(self) -> tuple[float, float, float]:
        """Rotation about the fixed axes x, y, z [rad], as in SDF; the pitch is in [-pi/2, pi/2]."""
        x, y, z, w = self.orientation
        roll = math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y))
        pitch = math.asin(min(max(2 * (w * y - z * x), -1.0), 1.0))
        return roll, pitch, self.yaw

    @property
    def yaw(self) -> float:
        """Heading: the angle about z of the direction of the x axis, seen from above [rad]."""
        x, y, z, w = self.orientation
        return math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))


class JointAxis(NamedTuple):
    """An axis of a joint. Units are rad and N m for a rotational axis, m and N for a translational one, and their
    derivatives. Limits that the file does not set are infinite."""

    #: Unit vector in the joint frame.
    xyz: tuple[float, float, float]
    #: Limits of the position.
    lower: float
    upper: float
    #: Largest force of a drive.
    effort: float
    #: Largest velocity of a drive.
    velocity: float
    #: Force per velocity against the motion.
    damping: float
    #: Force against the motion.
    friction: float


class Noise(NamedTuple):
    """Noise on a value that a sensor reads, as in its `<noise>`. All but times are in the unit of the value; of a camera,
    the value is 0 to 1."""

    #: Standard deviation, drawn for each reading.
    stddev: float = 0.0
    #: Added to each reading.
    mean: float = 0.0
    #: An offset, with a random sign: its standard deviation, drawn at the start, and its mean.
    bias_stddev: float = 0.0
    bias_mean: float = 0.0
    #: How the offset drifts; constant if one of the two is zero [value, s].
    dynamic_bias_stddev: float = 0.0
    dynamic_bias_correlation_time: float = 0.0
    #: Readings are rounded to multiples of it; 0: not rounded.
    precision: float = 0.0


class Contacts(NamedTuple):
    """The contact points of the last step: arrays with one row each, grouped by pairs of collisions. All vectors are in
    the world frame."""

    #: The scoped names of the two collisions of each point: "model::link::collision".
    names: list[tuple[str, str]]
    #: Their ids: n x 2.
    ids: NDArray[np.uint64]
    #: Positions [m]: n x 3.
    points: NDArray[np.float64]
    #: Unit vectors out of the second collision and into the first: n x 3.
    normals: NDArray[np.float64]
    #: Penetration depths [m], not negative: n.
    depths: NDArray[np.float64]
    #: Forces on the first collision during the last step, with friction [N]: n x 3.
    forces: NDArray[np.float64]


class RayHit(NamedTuple):
    """What a ray hits first."""

    #: [m]; infinite without a hit.
    distance: float
    #: x, y, z in the world frame [m]; infinite or NaN without a hit.
    point: NDArray[np.float64]
    #: Scoped name of the link that is hit; None without a hit, and for an actor.
    link: str | None


class RayHits(NamedTuple):
    """What several rays hit first: one row each."""

    #: [m]; infinite without a hit: n.
    distances: NDArray[np.float64]
    #: World frame [m]; infinite or NaN without a hit: n x 3.
    points: NDArray[np.float64]
    #: Scoped names of the links that are hit; None without a hit, and for an actor.
    links: list[str | None]
