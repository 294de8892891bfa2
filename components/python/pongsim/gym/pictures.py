"""Images of worlds."""

from __future__ import annotations

import math
from typing import Sequence

import numpy as np
from numpy.typing import NDArray

from .. import _core, values
from ..arrays import view
from ..simulation import Simulation
from .task import Camera

# the direction [rad] and distance of the default viewpoint, which looks down on the world
_YAW, _PITCH, _DISTANCE = 0.6, 0.7, 1.15


class Pictures:
    """Draws worlds as seen by one of their cameras, or from any viewpoint."""

    def __init__(self, simulations: Sequence[Simulation], camera: str | Camera) -> None:
        self._painters: list[_core.Painter] = []
        self._sensors: list[tuple[_core.Sensor, values.Pose]] = []
        self._place: values.Pose | Sequence[float] | None = None
        if isinstance(camera, str):
            for simulation in simulations:
                sensor = simulation._find_sensor(camera)
                self._width, self._height, field_of_view, offset = _core.lens(sensor)
                self._sensors.append((sensor, offset))
                self._painters.append(_core.Painter(simulation, self._width, self._height, field_of_view))
            return
        self._width, self._height = camera.width, camera.height
        for simulation in simulations:
            self._painters.append(_core.Painter(simulation, self._width, self._height, camera.field_of_view))
        self._place = camera.pose if camera.pose is not None else _above(self._painters[0].bounds(), camera)

    def draw(self) -> list[NDArray[np.uint8]]:
        """Returns a new array for each world, of rows x columns x 3: red, green, blue from 0 to 255."""
        pictures = []
        for i, painter in enumerate(self._painters):
            if self._place is not None:
                memory = painter.draw(self._place, values.Pose())
            else:
                sensor, offset = self._sensors[i]
                memory = painter.draw(sensor.pose, offset)
            pictures.append(view(memory, "u1", (self._height, self._width, 3)).copy())
        return pictures


def _above(bounds: tuple[Sequence[float], Sequence[float]], camera: Camera) -> list[float]:
    """Returns x, y, z, roll, pitch, yaw of a viewpoint from which a box is visible."""
    low, high = (np.array(corner) for corner in bounds)
    middle = (low + high) / 2
    narrow = camera.field_of_view * min(1.0, camera.height / camera.width)
    distance = _DISTANCE * float(np.linalg.norm(high - low)) / 2 / math.sin(min(narrow, math.pi) / 2)
    ahead = np.array([math.cos(_YAW) * math.cos(_PITCH), math.sin(_YAW) * math.cos(_PITCH), -math.sin(_PITCH)])
    return [*(middle - distance * ahead).tolist(), 0.0, _PITCH, _YAW]
