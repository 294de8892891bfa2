"""Values used by simulations."""

from __future__ import annotations

import math
from typing import NamedTuple


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
