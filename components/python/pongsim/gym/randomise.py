"""Properties of a world that each episode draws anew: domain randomisation."""

from __future__ import annotations

import fnmatch
import math
from dataclasses import dataclass
from typing import Any, Callable, Iterator, Literal

import numpy as np
from numpy.typing import NDArray

from .. import _core
from ..names import closest
from ..simulation import Simulation

#: What can be drawn.
Property = Literal[
    "mass", "inertia", "size", "friction", "restitution", "damping", "joint_friction", "servo_stiffness", "servo_damping",
    "noise", "color", "light_intensity",
]


@dataclass(frozen=True)
class Randomise:
    """Draws a property of some parts of the world at each reset, uniformly between two numbers: `Randomise("mass",
    "robot::*", 0.8, 1.2)`. The world is not loaded again.

    The draws come from the environment's random numbers, in the order of the task and of the world, before its `start`.
    Simulations that are reset by other means have the properties of their file.
    """

    #: "mass" of links, with which their inertia grows; "inertia" of links, as multiples of the file's; "size" of
    #: collisions that are boxes, spheres, cylinders, capsules or ellipsoids, with the visuals of the same shape, size and
    #: pose; "friction" and "restitution" of collisions; "damping" and "joint_friction" of the first axis of joints;
    #: "servo_stiffness" and "servo_damping" of a `JointPosition`; "noise" of sensors: multiples of its standard deviations,
    #: or the `stddev`; "color" of visuals, of which red, green and blue are each drawn; and "light_intensity".
    what: Property
    #: Scoped name of the link, collision, joint, visual, light, or of a sensor and its value ("robot::link::lidar::range"),
    #: with "*" and "?" for several: "robot::wheel_*".
    name: str
    low: float
    high: float
    #: True: the numbers are multiples of the values of the file; False: they are the values.
    relative: bool = True
    #: Draw one number for all; False: one for each.
    together: bool = False
    #: With "size": mass and inertia of the link follow at the same density (`Collision.set_size`).
    with_mass: bool = False

    def __post_init__(self) -> None:
        if self.what not in _KINDS:
            raise ValueError(f"'{self.what}' can't be drawn{closest(self.what, _KINDS)}; it can be {', '.join(_KINDS)}")
        if not (math.isfinite(self.low) and math.isfinite(self.high) and 0 <= self.low <= self.high):
            raise ValueError(f"{self.what} must be drawn between two finite numbers, 0 or more and the lesser first, not "
                             f"{self.low} and {self.high}")
        if self.what == "color" and (self.relative or self.high > 1):
            raise ValueError("a color is drawn between two numbers from 0 to 1, with relative=False")
        if self.what == "size" and self.low == 0:
            raise ValueError("a size must be above 0")
        if self.with_mass and self.what != "size":
            raise ValueError(f"with_mass goes with \"size\", not with \"{self.what}\"")

    def attach(self, simulation: Simulation) -> Callable[[np.random.Generator], None]:
        """Returns a function that draws and sets the property in a world, which is as its file says now. Raises KeyError if
        nothing has such a name."""
        parts, get, put = _KINDS[self.what]
        known = dict(parts(simulation))
        found = [part for name, part in known.items() if fnmatch.fnmatchcase(name, self.name)]
        if not found:
            raise KeyError(f"there is nothing called '{self.name}' that has {self.what}{closest(self.name, known)}")
        if self.what == "size":
            put = _resizer(self.with_mass)
            if not self.relative and any(len(part.size) > 1 for part in found):
                raise ValueError("only radii of spheres are drawn in metres: draw multiples of other sizes (relative=True)")
        bases = [get(part) if self.relative else 1.0 for part in found]

        def draw(random: np.random.Generator) -> None:
            count = 1 if self.together else len(found)
            if self.what == "color":
                colors = np.broadcast_to(random.uniform(self.low, self.high, (count, 3)), (len(found), 3))
                for part, color in zip(found, colors.tolist()):
                    put(part, color)
                return
            factors = np.broadcast_to(random.uniform(self.low, self.high, count), len(found))
            for part, base, factor in zip(found, bases, factors.tolist()):
                put(part, base * factor)

        return draw


def _links(simulation: Simulation) -> Iterator[tuple[str, _core.Link]]:
    for name in simulation.model_names:
        model = simulation.model(name)
        if not model.is_static:
            yield from ((link.scoped_name, link) for link in model.links)


def _collisions(simulation: Simulation) -> Iterator[tuple[str, _core.Collision]]:
    for name in simulation.model_names:
        for link in simulation.model(name).links:
            yield from ((each.scoped_name, each) for each in link.collisions)


def _simple_shapes(simulation: Simulation) -> Iterator[tuple[str, _core.Collision]]:
    yield from ((name, each) for name, each in _collisions(simulation) if each.shape in _SIMPLE)


def _resizer(with_mass: bool) -> Callable[..., None]:
    return lambda collision, size: collision.set_size(size, mass=with_mass)


def _noises(simulation: Simulation) -> Iterator[tuple[str, tuple[_core.Sensor, str]]]:
    for name in simulation.sensor_names:
        # not switched on by that
        sensor = simulation._find_sensor(name)
        yield from ((f"{name}::{value}", (sensor, value)) for value in sensor.noise)


def _deviations(part: tuple[_core.Sensor, str]) -> NDArray[np.float64]:
    noise = part[0].noise[part[1]]
    return np.array([noise.stddev, noise.bias_stddev, noise.dynamic_bias_stddev])


def _set_noise(part: tuple[_core.Sensor, str], deviations: NDArray[np.float64] | float) -> None:
    sensor, value = part
    noise = sensor.noise[value]
    if isinstance(deviations, float):
        noise = noise._replace(stddev=deviations)
    else:
        stddev, bias, dynamic_bias = deviations.tolist()
        noise = noise._replace(stddev=stddev, bias_stddev=bias, dynamic_bias_stddev=dynamic_bias)
    sensor.set_noise(value, noise)


def _joints(simulation: Simulation) -> Iterator[tuple[str, _core.Joint]]:
    for name in simulation.model_names:
        yield from ((f"{name}::{joint.name}", joint) for joint in simulation.model(name).joints if joint.axis_count)


def _visuals(simulation: Simulation) -> Iterator[tuple[str, tuple[_core.Link, str]]]:
    for name in simulation.model_names:
        for link in simulation.model(name).links:
            yield from ((f"{link.scoped_name}::{visual}", (link, visual)) for visual in link.visual_names)


def _lights(simulation: Simulation) -> Iterator[tuple[str, tuple[Simulation, dict[str, Any]]]]:
    yield from ((name, (simulation, light)) for name, light in simulation.lights().items())


def _set_intensity(part: tuple[Simulation, dict[str, Any]], intensity: float) -> None:
    simulation, light = part
    simulation.change_light({**light, "intensity": intensity})


def _gains(simulation: Simulation) -> Iterator[tuple[str, NDArray[np.float64]]]:
    yield from simulation._gains.items()


def _set_friction(collision: _core.Collision, friction: float) -> None:
    # a second coefficient keeps its ratio to the first
    first, second = collision.friction
    collision.set_friction(friction, friction if first == second or first == 0 else friction * second / first)


_SIMPLE = ("box", "sphere", "cylinder", "capsule", "ellipsoid")

#: Which parts have it, how it is read, and how it is set.
_KINDS: dict[str, tuple[Callable[..., Iterator[tuple[str, Any]]], Callable[..., Any], Callable[..., None]]] = {
    "mass": (_links, lambda link: link.mass, lambda link, mass: link.set_mass(mass)),
    "inertia": (_links, lambda link: 1.0, lambda link, factor: link.set_mass(link.mass, factor)),
    "size": (_simple_shapes, lambda collision: np.array(collision.size), _resizer(False)),
    "noise": (_noises, _deviations, _set_noise),
    "friction": (_collisions, lambda collision: collision.friction[0], _set_friction),
    "restitution": (_collisions, lambda collision: collision.restitution, lambda collision, e: collision.set_restitution(e)),
    "damping": (_joints, lambda joint: joint.axis().damping, lambda joint, damping: joint.set_damping(damping)),
    "joint_friction": (_joints, lambda joint: joint.axis().friction, lambda joint, friction: joint.set_friction(friction)),
    "servo_stiffness": (_gains, lambda gains: float(gains[0]), lambda gains, number: gains.__setitem__(0, number)),
    "servo_damping": (_gains, lambda gains: float(gains[1]), lambda gains, number: gains.__setitem__(1, number)),
    "color": (_visuals, lambda part: 1.0, lambda part, color: part[0].set_color(part[1], color)),
    "light_intensity": (_lights, lambda part: float(part[1]["intensity"]), _set_intensity),
}
