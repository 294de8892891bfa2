"""Images of a world, drawn without a display."""

from __future__ import annotations

import math
import operator
from typing import TYPE_CHECKING, Any, Sequence

import numpy as np
from numpy.typing import NDArray

from . import _core
from .arrays import view
from .values import Pose

if TYPE_CHECKING:
    from .simulation import Simulation

#: Of an image that says nothing else: width and height [pixels], horizontal field of view [rad].
SIZE = (320, 240)
FIELD_OF_VIEW = 1.05
# the direction [rad] and distance of the default viewpoint, which looks down on the world
_YAW, _PITCH, _DISTANCE = 0.6, 0.7, 1.15


class Eye:
    """A viewpoint of a world: one of its cameras, or a pose. It changes nothing."""

    def __init__(
        self, simulation: Simulation, camera: str | Pose | Sequence[float] | None,
        size: tuple[int, int] | None = None, field_of_view: float | None = None,
    ) -> None:
        """See `Simulation.render`."""
        if simulation._painter is None:
            simulation._painter = _core.Painter(simulation)
        self._painter = simulation._painter
        self._sensor: _core.Sensor | None = None
        self._offset = Pose()
        if isinstance(camera, str):
            self._sensor = simulation._find_sensor(camera)
            width, height, own_field, self._offset = _core.lens(self._sensor)
        else:
            (width, height), own_field = SIZE, FIELD_OF_VIEW
        self.width, self.height = (width, height) if size is None else _checked(size)
        self._field_of_view = own_field if field_of_view is None else field_of_view
        if not 0 < self._field_of_view < math.pi:
            raise ValueError(f"a field of view must be above 0 and below pi rad, not {field_of_view}")
        self._pose: Pose | Sequence[float] = camera if camera is not None and not isinstance(camera, str) else Pose()
        if camera is None:
            self._pose = _above(self._painter.bounds(), self.width, self.height, self._field_of_view)

    @property
    def pose(self) -> Pose | Sequence[float]:
        """Where it is, in the world frame; of a camera, the sensor's frame."""
        return self._pose if self._sensor is None else self._sensor.pose

    def draw(self) -> NDArray[np.uint8]:
        """Returns what is seen now: a new array of rows x columns x red, green, blue from 0 to 255."""
        memory = self._painter.draw(self.pose, self._offset, self.width, self.height, self._field_of_view)
        return view(memory, "u1", (self.height, self.width, 3))


def _checked(size: Any) -> tuple[int, int]:
    try:
        width, height = (operator.index(each) for each in size)
    except TypeError as wrong:
        raise TypeError(f"a size must be a width and a height in pixels, not {size!r}") from wrong
    if width < 1 or height < 1:
        raise ValueError(f"a size must be a width and a height of 1 pixel or more, not {size!r}")
    return width, height


def _above(
    bounds: tuple[Sequence[float], Sequence[float]], width: int, height: int, field_of_view: float
) -> list[float]:
    """Returns x, y, z, roll, pitch, yaw of a viewpoint from which a box is visible."""
    low, high = (np.array(corner) for corner in bounds)
    middle = (low + high) / 2
    narrow = field_of_view * min(1.0, height / width)
    distance = _DISTANCE * float(np.linalg.norm(high - low)) / 2 / math.sin(min(narrow, math.pi) / 2)
    ahead = np.array([math.cos(_YAW) * math.cos(_PITCH), math.sin(_YAW) * math.cos(_PITCH), -math.sin(_PITCH)])
    return [*(middle - distance * ahead).tolist(), 0.0, _PITCH, _YAW]
