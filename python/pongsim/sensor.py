"""What sensors read, as arrays."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _core
from .arrays import view
from .errors import NoReading
from .values import Pose


class Sensor:
    """One sensor of a running world.

    Arrays look at the memory that the sensor's readings are written to: nothing is copied when they are read, and they
    change with the next reading that is due. Take a `copy()` of what is to stay. They can't be written to. A sensor that
    nobody listens to costs nothing, so it is listened to from the first time that something of it is asked for on: until
    its next reading that raises NoReading.
    """

    def __init__(self, core: _core.Sensor, kinds: tuple[str, ...]) -> None:
        self._core = core
        self._arrays: dict[str, tuple[object, NDArray[Any]]] = {}
        for kind in kinds or tuple(core.kinds[:1]):
            core.stream(kind)

    @property
    def exists(self) -> bool:
        """Whether it is still there. If not, everything else raises Gone."""
        return self._core.exists

    @property
    def name(self) -> str:
        """Its own name."""
        return self._core.name

    @property
    def scoped_name(self) -> str:
        """Its name with what holds it: "model::link::sensor"."""
        return self._core.scoped_name

    @property
    def type(self) -> str:
        """Its type as the file has it: "gpu_lidar"."""
        return self._core.type

    @property
    def kinds(self) -> list[str]:
        """What it reads, the main one first: "ranges", "points", "image", "depth" or "message"."""
        return self._core.kinds

    @property
    def pose(self) -> Pose:
        """Pose of its frame in the world frame."""
        return self._core.pose

    @property
    def update_rate(self) -> float:
        """Readings a simulated second; 0: one every step."""
        return self._core.update_rate

    @property
    def ranges(self) -> NDArray[np.float64]:
        """Of a lidar: how far it is along each beam [m], infinite where nothing is. Rows from the lowest one where there
        are several."""
        return self._array("ranges")

    @property
    def intensities(self) -> NDArray[np.float64]:
        """Of a lidar: how strongly each beam comes back."""
        stream = self._read("ranges")
        if stream.intensities is None:
            raise NoReading(f"sensor '{self.scoped_name}' has no intensities")
        return view(stream.intensities, stream.format, stream.shape)

    @property
    def points(self) -> NDArray[np.float32]:
        """Of a lidar or a depth camera: x, y, z of each point in the sensor frame [m], in rows and columns."""
        return self._array("points")

    @property
    def image(self) -> NDArray[Any]:
        """Of a camera: rows and columns of pixels; red, green, blue for R8G8B8, one number for L8 and L16."""
        return self._array("image")

    @property
    def depth(self) -> NDArray[np.float32]:
        """Of a depth camera: how far ahead of it each pixel is [m], infinite where nothing is."""
        return self._array("depth")

    def message(self, type: Any = None) -> Any:
        """Of a sensor without arrays, as an IMU: its last message, as a dict or as the class that is asked for."""
        return self._read("message").message(type)

    def count(self, kind: str | None = None) -> int:
        """How many readings of that kind, or of the main one, have come since it is listened to."""
        return self._core.stream(kind or self.kinds[0]).count

    def time(self, kind: str | None = None) -> float:
        """Simulated time of the last reading [s]."""
        return self._read(kind or self.kinds[0]).time_ns / 1e9

    def written_at(self, kind: str | None = None) -> int:
        """Where in memory the last reading was written: where its array is."""
        return self._read(kind or self.kinds[0]).written_at

    def _read(self, kind: str) -> _core.Stream:
        stream = self._core.stream(kind)
        if stream.count == 0:
            raise NoReading(
                f"sensor '{self.scoped_name}' has no {kind} yet: it is listened to from now on, and takes the next "
                "reading that is due in a step"
            )
        return stream

    def _array(self, kind: str) -> NDArray[Any]:
        stream = self._read(kind)
        memory = stream.memory
        known = self._arrays.get(kind)
        if known is not None and known[0] is memory:
            return known[1]
        array = view(memory, stream.format, stream.shape)
        if kind == "points":
            array = array[..., :3]
        self._arrays[kind] = (memory, array)
        return array
