"""The worlds in which steps are timed, each with a number that says how true it was."""

import functools
import math

import numpy

import trees
from scene import Body, Joint, Scene, matrix, moments_of, solid, turn

RADIUS, HALF_SEPARATION = 0.4, 0.6
LINEAR, ANGULAR = 0.5, 0.4

SYSTEMS = "".join(
    f"<plugin filename='libignition-gazebo-{name}-system.so' name='ignition::gazebo::systems::{kind}'/>"
    for name, kind in (("user-commands", "UserCommands"), ("scene-broadcaster", "SceneBroadcaster"))
)


def robots(count, linear, angular, systems=True):
    """The robots of the moving-robot tutorial, driving; in pongsim by DiffDrive, where there are to be systems."""
    left, right = ((linear + side * angular * HALF_SEPARATION) / RADIUS for side in (-1, 1))
    bodies, joints, drives = [], [], {}
    upright = turn((1, 0, 0), -math.pi / 2)
    for i in range(count):
        model, y = f"robot{i}", 3.0 * i
        bodies += [
            Body(
                f"chassis{i}", ("box", 2, 1, 0.5), 1.14395, (0.126164, 0.416519, 0.481014), (0.5, y, 0.4), model=model
            ),
            Body(
                f"left{i}",
                ("cylinder", 0.4, 0.2),
                2.0,
                (0.145833, 0.145833, 0.125),
                (0, y + 0.6, 0.4),
                upright,
                model=model,
            ),
            Body(
                f"right{i}",
                ("cylinder", 0.4, 0.2),
                1.0,
                (0.145833, 0.145833, 0.125),
                (0, y - 0.6, 0.4),
                upright,
                model=model,
            ),
            Body(f"caster{i}", ("sphere", 0.2), 1.0, (0.1, 0.1, 0.1), (1.3, y, 0.2), model=model),
        ]
        joints += [
            Joint(f"left_joint{i}", "hinge", f"chassis{i}", f"left{i}", (0, y + 0.6, 0.4), drive=left),
            Joint(f"right_joint{i}", "hinge", f"chassis{i}", f"right{i}", (0, y - 0.6, 0.4), drive=right),
            Joint(f"caster_joint{i}", "ball", f"chassis{i}", f"caster{i}", (1.3, y, 0.2)),
        ]
        drives[model] = (
            "<plugin filename='libignition-gazebo-diff-drive-system.so' name='ignition::gazebo::systems::"
            f"DiffDrive'><left_joint>left_joint{i}</left_joint><right_joint>right_joint{i}</right_joint>"
            f"<wheel_separation>{2 * HALF_SEPARATION}</wheel_separation><wheel_radius>{RADIUS}</wheel_radius>"
            "<odom_publish_frequency>1</odom_publish_frequency><topic>cmd_vel</topic></plugin>"
        )
    scene = Scene(bodies, joints)
    if systems:
        scene.systems, scene.model_systems = SYSTEMS, drives
        scene.message = ("/cmd_vel", {"linear": {"x": linear}, "angular": {"z": angular}})
    return scene


class Robots:
    """Robots that drive in a circle; the error is that of the way of one, straight ahead for 5 s [m]."""

    unit = "m"

    def __init__(self, count):
        self.name = f"robots x{count}"
        self.count = count
        self.contacts = 5 * count
        self.skipped, self.measured = 500, max(100, 2000 // count)

    def scene(self):
        return robots(self.count, LINEAR, ANGULAR)

    def check(self, made):
        place = numpy.asarray(made.body("chassis0")[0])
        way = float(numpy.linalg.norm(place - (0.5, 0, 0.4)))
        if not 0.15 < way < 0.3:
            raise RuntimeError(f"a robot went {way} m and not as commanded")

    def error(self, engine, step):
        if self.count > 1:
            return None
        made = engine(robots(1, LINEAR, 0.0), step)
        made.step(round(0.5 / step))
        before = numpy.asarray(made.body("chassis0")[0])
        made.step(round(5 / step))
        way = float(numpy.linalg.norm(numpy.asarray(made.body("chassis0")[0]) - before))
        made.close()
        return abs(way - 5 * LINEAR)


class Resting:
    """A world at rest: the error is how far the farthest body is from its place after 0.3 s [m]."""

    unit = "m"
    skipped = 500

    def __init__(self, name, bodies, contacts, measured):
        self.name, self.bodies, self.contacts, self.measured = name, bodies, contacts, measured

    def scene(self):
        return Scene(self.bodies)

    def check(self, made):
        pass

    def error(self, engine, step):
        made = engine(self.scene(), step)
        made.step(round(0.3 / step))
        off = max(
            float(numpy.linalg.norm(numpy.asarray(made.body(body.name)[0]) - body.position)) for body in self.bodies
        )
        made.close()
        return off


def shapes(count=3000):
    """As 3k_shapes.sdf of gz-sim's examples has it: shapes of 1 m that stand beside each other."""
    bodies = []
    for i in range(count // 3):
        x = 1.5 * (i - count // 6)
        bodies += [
            Body(f"box{i}", ("box", 1, 1, 1), 1.0, (1, 1, 1), (x, 0, 0.5)),
            Body(f"cylinder{i}", ("cylinder", 0.5, 1), 2.0, (2, 2, 2), (x, -1.5, 0.5)),
            Body(f"sphere{i}", ("sphere", 0.5), 3.0, (3, 3, 3), (x, 1.5, 0.5)),
        ]
    return Resting("3k_shapes.sdf", bodies, 5000, 10)


def pile():
    """500 boxes in a pyramid, each upon four others, a gap of 1 cm between neighbours."""
    bodies, side = [], 0.2
    for layer in range(11):
        across = 11 - layer
        for i in range(across):
            for j in range(across):
                place = tuple(0.21 * (k - (across - 1) / 2) for k in (i, j))
                bodies.append(
                    solid(f"box{len(bodies)}", ("box", side, side, side), 1.0, (*place, side * (layer + 0.5)))
                )
    return Resting("pile of 500 boxes", bodies[:500], 6500, 10)


class Swinging:
    """Bodies on joints; the error is the energy lost or won in 2 s, in parts of what the motion has to begin with."""

    unit = ""
    contacts = 0
    skipped = 100

    def __init__(self, name, scene, count=1):
        self.name, self.scene, self.count = name, scene, count
        self.measured = max(10, 100 // count)

    def check(self, made):
        pass

    def error(self, engine, step):
        if self.count > 1:
            return None
        scene = self.scene()
        made = engine(scene, step)
        made.step(1)
        before, scale = energy(made, scene)
        made.step(round(2 / step) - 1)
        after, _ = energy(made, scene)
        made.close()
        return abs(after - before) / scale


def energy(made, scene):
    """Of all bodies, and a measure of it: the kinetic part, or what falling by a metre gives [J]."""
    total, kinetic, mass = 0.0, 0.0, 0.0
    for body in scene.bodies:
        place, rotation, velocity, turning = (numpy.asarray(each, float) for each in made.body(body.name))
        own = matrix(rotation).T @ turning
        moving = body.mass * velocity @ velocity / 2 + own @ (numpy.asarray(body.moments) * own) / 2
        kinetic += moving
        mass += body.mass
        total += moving - body.mass * place @ numpy.asarray(scene.gravity, float)
    return total, max(kinetic, mass * numpy.linalg.norm(scene.gravity))


def chain():
    """100 rods of 0.1 m on hinges, level at the start."""
    shape, bodies, joints = ("box", 0.1, 0.02, 0.02), [], []
    for i in range(100):
        bodies.append(Body(f"rod{i}", None, 0.1, moments_of(shape, 0.1), (0.1 * i + 0.05, 0, 12), model="chain"))
        joints.append(Joint(f"hinge{i}", "hinge", f"rod{i - 1}" if i else "", f"rod{i}", (0.1 * i, 0, 12)))
    return Scene(bodies, joints, ground=False)


class Standing:
    """Robots on the ground, moved by their motors; the error is how far parts of one are from their places after 0.3 s.

    places: where these are after a time [s], by name.
    """

    unit = "m"
    skipped = 300

    def __init__(self, name, scene, count, contacts, places):
        self.name, self.scene, self.count, self.contacts, self.places = name, scene, count, contacts * count, places
        self.measured = max(10, 100 // count)

    def check(self, made):
        self.off(made, self.skipped * 0.001, 0.05)

    def error(self, engine, step):
        if self.count > 1:
            return None
        made = engine(self.scene(), step)
        made.step(round(0.3 / step))
        off = self.off(made, 0.3)
        made.close()
        return off

    def off(self, made, seconds, most=math.inf):
        """How far the farthest part is from its place; raises RuntimeError where that is more than `most` [m]."""
        off = max(
            float(numpy.linalg.norm(numpy.subtract(made.body(name)[0], place)))
            for name, place in self.places(seconds).items()
        )
        if off > most:
            raise RuntimeError(f"{self.name} does not stand: it is {off} m from its place")
        return off


#: Trees of links, free and standing: their names, scenes and points of contact, and where parts of them have to be.
TREES = (
    ("humanoid, 18 links", "humanoid standing", trees.humanoid, 8, trees.humanoid_places),
    ("quadruped, 13 links", "quadruped standing", trees.quadruped, 4, trees.quadruped_places),
    ("arm of 7 joints", "arm on a base", trees.arm, 4, trees.arm_places),
)


def on_trees():
    for free, standing, scene, contacts, places in TREES:
        for count in (1, 50):
            suffix = f" x{count}" if count > 1 else ""
            yield Swinging(free + suffix, functools.partial(scene, count, False), count)
            yield Standing(standing + suffix, functools.partial(scene, count, True), count, contacts, places)


#: Worlds whose error depends on the length of a step.
ON_JOINTS = ("chain of 100 links", TREES[0][0])


def cases(counts):
    return [
        *(Robots(count) for count in counts),
        shapes(),
        pile(),
        Swinging(ON_JOINTS[0], chain),
        *on_trees(),
    ]
