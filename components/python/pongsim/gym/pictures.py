"""Images of a task's worlds."""

from __future__ import annotations

from typing import Sequence

from ..pictures import Eye
from ..simulation import Simulation
from .parts import Camera


def eyes_of(simulations: Sequence[Simulation], camera: str | Camera, size: tuple[int, int] | None = None) -> list[Eye]:
    """Returns a viewpoint of each world: the world's camera with that name, or one pose for all.

    size: width and height [pixels]; None: the camera's.
    """
    if isinstance(camera, str):
        return [Eye(each, camera, size) for each in simulations]
    size = (camera.width, camera.height) if size is None else size
    first = Eye(simulations[0], camera.pose, size, camera.field_of_view)
    return [first, *(Eye(each, first.pose, size, camera.field_of_view) for each in simulations[1:])]
