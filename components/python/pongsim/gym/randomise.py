"""Properties of a world that each episode draws anew: domain randomisation."""

from __future__ import annotations

import fnmatch
import math
from dataclasses import dataclass
from typing import Callable, Iterator, Literal

import numpy as np

from .. import _core
from ..names import closest
from ..simulation import Simulation

#: What can be drawn.
Property = Literal["mass", "inertia", "friction", "restitution", "damping", "joint_friction"]


@dataclass(frozen=True)
class Randomise:
    """Draws a property of some links, collisions or joints at each reset, uniformly between two numbers: `Randomise("mass",
    "robot::*", 0.8, 1.2)`. The world is not loaded again.

    The draws come from the environment's random numbers, in the order of the task and of the world, before its `start`.
    Simulations that are reset by other means have the properties of their file.
    """

    #: "mass" of links, with which their inertia grows; "inertia" of links, as multiples of the file's; "friction" and
    #: "restitution" of collisions; "damping" and "joint_friction" of the first axis of joints.
    what: Property
    #: Scoped name of the link, collision or joint, with "*" and "?" for several: "robot::wheel_*".
    name: str
    low: float
    high: float
    #: True: the numbers are multiples of the values of the file; False: they are the values.
    relative: bool = True
    #: Draw one number for all; False: one for each.
    together: bool = False

    def __post_init__(self) -> None:
        if self.what not in _KINDS:
            raise ValueError(f"'{self.what}' can't be drawn{closest(self.what, _KINDS)}; it can be {', '.join(_KINDS)}")
        if not (math.isfinite(self.low) and math.isfinite(self.high) and 0 <= self.low <= self.high):
            raise ValueError(f"{self.what} must be drawn between two finite numbers, 0 or more and the lesser first, not "
                             f"{self.low} and {self.high}")

    def attach(self, simulation: Simulation) -> Callable[[np.random.Generator], None]:
        """Returns a function that draws and sets the property in a world, which is as its file says now. Raises KeyError if
        nothing has such a name."""
        parts, get, put = _KINDS[self.what]
        known = dict(parts(simulation))
        found = [part for name, part in known.items() if fnmatch.fnmatchcase(name, self.name)]
        if not found:
            raise KeyError(f"there is nothing called '{self.name}' that has {self.what}{closest(self.name, known)}")
        bases = [get(part) if self.relative else 1.0 for part in found]

        def draw(random: np.random.Generator) -> None:
            count = 1 if self.together else len(found)
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


def _joints(simulation: Simulation) -> Iterator[tuple[str, _core.Joint]]:
    for name in simulation.model_names:
        yield from ((f"{name}::{joint.name}", joint) for joint in simulation.model(name).joints if joint.axis_count)


def _set_friction(collision: _core.Collision, friction: float) -> None:
    # a second coefficient keeps its ratio to the first
    first, second = collision.friction
    collision.set_friction(friction, friction if first == second or first == 0 else friction * second / first)


#: Which parts have it, how it is read, and how it is set.
_KINDS: dict[str, tuple[Callable[..., Iterator[tuple[str, object]]], Callable[..., float], Callable[..., None]]] = {
    "mass": (_links, lambda link: link.mass, lambda link, mass: link.set_mass(mass)),
    "inertia": (_links, lambda link: 1.0, lambda link, factor: link.set_mass(link.mass, factor)),
    "friction": (_collisions, lambda collision: collision.friction[0], _set_friction),
    "restitution": (_collisions, lambda collision: collision.restitution, lambda collision, e: collision.set_restitution(e)),
    "damping": (_joints, lambda joint: joint.axis().damping, lambda joint, damping: joint.set_damping(damping)),
    "joint_friction": (_joints, lambda joint: joint.axis().friction, lambda joint, friction: joint.set_friction(friction)),
}
