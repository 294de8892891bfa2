"""Worlds as plain values, from which each engine makes its own. SI units; the world's axes, z up."""

import dataclasses

import numpy


def turn(axis, angle):
    """The quaternion w x y z of a turn about an axis [rad]."""
    axis = numpy.asarray(axis, float) / numpy.linalg.norm(axis)
    return (numpy.cos(angle / 2), *(numpy.sin(angle / 2) * axis))


def matrix(quaternion):
    """The rotation matrix of a quaternion w x y z."""
    w, x, y, z = quaternion
    return numpy.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def product(a, b):
    """Of two quaternions w x y z: the turn b, then a."""
    a, b = numpy.asarray(a, float), numpy.asarray(b, float)
    return numpy.concatenate([[a[0] * b[0] - a[1:] @ b[1:]], a[0] * b[1:] + b[0] * a[1:] + numpy.cross(a[1:], b[1:])])


def inverse(quaternion):
    return (quaternion[0], -quaternion[1], -quaternion[2], -quaternion[3])


@dataclasses.dataclass
class Body:
    """A rigid body; its frame lies at the centre of mass, along the principal axes."""

    name: str
    #: box (three sides), sphere (radius), cylinder (radius, length along z), ellipsoid (three semi-axes), or None.
    shape: tuple | None
    mass: float
    moments: tuple
    position: tuple = (0, 0, 0)
    rotation: tuple = (1, 0, 0, 0)
    #: Initial velocity. Must be consistent with the joints: engines in reduced coordinates use only that of roots.
    velocity: tuple = (0, 0, 0)
    turning: tuple = (0, 0, 0)
    #: Bodies of one model do not collide. Empty: the body is a model of its own.
    model: str = ""


@dataclasses.dataclass
class Joint:
    """Holds a child to a parent ("" is the world); a body has one joint as a child, but for those that close loops."""

    name: str
    #: hinge, ball or slide.
    kind: str
    parent: str
    child: str
    anchor: tuple
    axis: tuple = (0, 1, 0)
    #: Velocity that a motor holds.
    drive: float | None = None
    closes: bool = False


@dataclasses.dataclass
class Scene:
    bodies: list
    joints: list = dataclasses.field(default_factory=list)
    gravity: tuple = (0, 0, -9.8)
    #: The same for all bodies and the ground, so that it does not matter how an engine combines two values.
    friction: float = 1.0
    restitution: float = 0.0
    #: Whether there is ground at z = 0.
    ground: bool = True
    #: For pongsim, as SDF: systems of the world, systems of models by name; and the messages published at the start.
    systems: str = ""
    model_systems: dict = dataclasses.field(default_factory=dict)
    message: tuple | None = None

    def model_of(self, body):
        return body.model or body.name

    def body(self, name):
        return next(each for each in self.bodies if each.name == name)


def moments_of(shape, mass):
    """Principal moments of inertia of a solid."""
    kind, *size = shape
    if kind == "box":
        x, y, z = size
        return (mass / 12 * (y * y + z * z), mass / 12 * (x * x + z * z), mass / 12 * (x * x + y * y))
    if kind == "sphere":
        return (0.4 * mass * size[0] ** 2,) * 3
    if kind == "cylinder":
        radius, length = size
        across = mass * (3 * radius**2 + length**2) / 12
        return (across, across, mass * radius**2 / 2)
    if kind == "ellipsoid":
        a, b, c = size
        return (mass / 5 * (b * b + c * c), mass / 5 * (a * a + c * c), mass / 5 * (a * a + b * b))
    raise ValueError(kind)


def solid(name, shape, mass, position, **rest):
    """A body of even density."""
    return Body(name, shape, mass, moments_of(shape, mass), position, **rest)
