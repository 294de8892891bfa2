"""Sensor readings as arrays."""

from __future__ import annotations

import fnmatch
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _core
from .arrays import view
from .errors import NoReading
from .names import closest
from .values import Noise, Pose


class Sensor:
    """A sensor of a running world.

    Arrays are read-only views of the memory with the sensor's latest reading: nothing is copied, and they change with the
    next reading. Use `copy()` to keep one. A sensor is switched on when one of its readings is first used, since an unused
    sensor costs nothing, and stays on until `switch_off`; all objects for it share its readings. Access raises NoReading
    until the next reading, and so it does after a reset or after a state was restored.
    """

    __slots__ = ("_core", "_arrays")

    def __init__(self, core: _core.Sensor, kinds: tuple[str, ...]) -> None:
        self._core = core
        self._arrays: dict[str, tuple[object, NDArray[Any]]] = {}
        for kind in kinds or tuple(core.kinds[:1]):
            core.stream(kind)

    @property
    def exists(self) -> bool:
        """Whether it exists. If not, everything else raises Gone."""
        return self._core.exists

    @property
    def name(self) -> str:
        """Its own name."""
        return self._core.name

    @property
    def scoped_name(self) -> str:
        """Its name with its parents: "model::link::sensor"."""
        return self._core.scoped_name

    @property
    def type(self) -> str:
        """Its type as in the file: "gpu_lidar"."""
        return self._core.type

    @property
    def kinds(self) -> list[str]:
        """Its kinds of readings, the main one first: "ranges", "points", "image", "depth", "message" or another word.

        The systems of the world declare them; without a system for its type there are none.
        """
        return self._core.kinds

    @property
    def pose(self) -> Pose:
        """Pose of its frame in the world frame."""
        return self._core.pose

    @property
    def pose_in_link(self) -> Pose:
        """Pose of its frame in the frame of its link; for a sensor on a joint, of the joint's child."""
        return self._core.pose_in_link

    @property
    def link_name(self) -> str:
        """The scoped name of that link."""
        return self._core.link_name

    @property
    def frame_name(self) -> str:
        """Its frame's name in messages."""
        return self._core.frame_name

    @property
    def topics(self) -> dict[str, str]:
        """The topic of each of its kinds of readings."""
        return {kind: "/" + topic.lstrip("/") for kind, topic in self._core.topics.items()}

    @property
    def has_noise(self) -> bool:
        """Whether its readings depend on the seed: it has noise now."""
        return self._core.has_noise

    @property
    def noise(self) -> dict[str, Noise]:
        """The noise of each value that it reads, by its name: "range", or "acceleration x"."""
        return self._core.noise

    def set_noise(self, value: str = "*", **numbers: float) -> None:
        """Changes noise from the next reading on, between two steps, until the world is reset. Offsets begin again.

        value: the name of the value in `noise`, with "*" and "?" for several.
        numbers: those of `Noise` to change: `set_noise(stddev=0.01)`; the others stay.
        Raises KeyError for an unknown value, TypeError for an unknown number, and Refused.
        """
        known = self.noise
        found = [name for name in known if fnmatch.fnmatchcase(name, value)]
        if not found:
            raise KeyError(f"sensor '{self.scoped_name}' has no noise of a value '{value}'{closest(value, known)}"
                           if known else f"no system of the world gives the readings of sensor '{self.scoped_name}' noise")
        for number in numbers:
            if number not in Noise._fields:
                raise TypeError(f"noise has no '{number}'{closest(number, Noise._fields)}")
        for name in found:
            self._core.set_noise(name, known[name]._replace(**numbers))

    @property
    def update_rate(self) -> float:
        """Readings per simulated second; 0: one per step."""
        return self._core.update_rate

    @property
    def ranges(self) -> NDArray[np.float64]:
        """Lidars: the range of each beam [m], infinite without a hit. Several rows begin with the lowest."""
        return self._array("ranges")

    @property
    def intensities(self) -> NDArray[np.float64]:
        """Lidars: the intensity of each beam."""
        stream = self._read("ranges")
        if stream.intensities is None:
            raise NoReading(f"sensor '{self.scoped_name}' has no intensities")
        return view(stream.intensities, stream.format, stream.shape)

    @property
    def points(self) -> NDArray[np.float32]:
        """Lidars and depth cameras: x, y, z of each point in the sensor frame [m], in rows and columns."""
        return self._array("points")

    @property
    def image(self) -> NDArray[Any]:
        """Cameras: rows and columns of pixels; red, green, blue for R8G8B8, one number for L8 and L16.

        Of a thermal camera the temperatures in units of its resolution, of a segmentation camera its coloured map.
        """
        return self._array("image")

    @property
    def labels(self) -> NDArray[np.uint8]:
        """Segmentation cameras: three numbers for each pixel, as in the map of labels."""
        return self._array("labels")

    @property
    def depth(self) -> NDArray[np.float32]:
        """Depth cameras: the depth of each pixel along the viewing axis [m], infinite where nothing is visible."""
        return self._array("depth")

    def message(self, type: Any = None, kind: str = "message") -> Any:
        """Readings without arrays, such as an IMU's: the last message, as a dict or as an object of the given class."""
        return self._read(kind).message(type)

    def count(self, kind: str | None = None) -> int:
        """Number of readings of that kind, or of the main one, since it was switched on, or since the last reset or
        restored state."""
        return self._core.stream(kind or self.kinds[0]).count

    def time(self, kind: str | None = None) -> float:
        """Simulated time of the last reading [s]."""
        return self._read(kind or self.kinds[0]).time_ns / 1e9

    def written_at(self, kind: str | None = None) -> int:
        """Memory address of the last reading, where its array is."""
        return self._read(kind or self.kinds[0]).written_at

    def switch_off(self, *kinds: str) -> None:
        """Switches readings of these kinds off, by default of all: the sensor costs nothing until it is used again.

        It does so for all objects for the sensor. Arrays of its last readings stay as they are.
        """
        for kind in kinds or tuple(self.kinds):
            self._core.stop(kind)

    def _read(self, kind: str) -> _core.Stream:
        stream = self._core.stream(kind)
        if stream.count == 0:
            raise NoReading(
                f"sensor '{self.scoped_name}' has no {kind} yet: it takes the next one in a step in which one is due "
                f"({f'{self.update_rate:g} per second' if self.update_rate else 'each'}), so step the simulation first"
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
