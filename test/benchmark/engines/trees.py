"""Robots whose links form trees: a humanoid, a quadruped and an arm, free and standing on the ground."""

import math

import numpy

from scene import Body, Joint, Scene, moments_of

#: Between robots of one world [m].
APART = 3.0


class Tree:
    """Collects the bodies and joints of one robot: `number` tells it from others, which it is beside."""

    def __init__(self, scene, kind, number):
        self.scene, self.model, self.number = scene, f"{kind}{number}", number

    def at(self, place):
        return (place[0], place[1] + APART * self.number, place[2])

    def body(self, name, size, mass, place, shape=None, **rest):
        """A box of even density, which collides as `shape` does, or not at all."""
        moments = moments_of(("box", *size), mass)
        self.scene.bodies.append(
            Body(f"{name}{self.number}", shape, mass, moments, self.at(place), model=self.model, **rest)
        )

    def hinge(self, name, parent, anchor, axis=(0, 1, 0), drive=None):
        """Holds a body; `parent` is "" for the world."""
        parent = parent and f"{parent}{self.number}"
        self.scene.joints.append(
            Joint(f"{name}_joint{self.number}", "hinge", parent, f"{name}{self.number}", self.at(anchor), axis, drive)
        )


def humanoid(count, stands):
    """18 bodies and 17 hinges as those of a humanoid: one that tumbles without gravity, or one whose motors hold it
    upright on box feet while it nods and bends its forearms."""
    scene = Scene([], ground=stands, gravity=(0, 0, -9.8 if stands else 0))
    # initially, all links move like one rigid body that turns about the pelvis
    spin, middle = (0.5, 2.0, 1.0), numpy.array((0, 0, 1.0))
    # the soles are 2 cm above zero
    shift = (0, 0, -0.02 if stands else 0)

    for number in range(count):
        tree = Tree(scene, "humanoid", number)

        def add(name, size, mass, place, parent=None, anchor=None, axis=(0, 1, 0)):
            rest = {}
            if not stands:
                rest = {"turning": spin, "velocity": tuple(numpy.cross(spin, place - middle))}
            shape = ("box", *size) if stands and name.endswith("foot") else None
            tree.body(name, size, mass, numpy.add(place, shift), shape, **rest)
            if parent:
                moves = name == "head" or name.endswith("forearm")
                drive = (0.2 if moves else 0.0) if stands else None
                tree.hinge(name, parent, numpy.add(anchor, shift), axis, drive)

        add("pelvis", (0.2, 0.3, 0.15), 9.0, (0, 0, 1.0))
        add("waist", (0.18, 0.25, 0.15), 6.0, (0, 0, 1.15), "pelvis", (0, 0, 1.08))
        add("torso", (0.2, 0.35, 0.3), 15.0, (0, 0, 1.38), "waist", (0, 0, 1.22), (0, 0, 1))
        add("head", (0.18, 0.16, 0.22), 4.5, (0, 0, 1.68), "torso", (0, 0, 1.56))
        for side, y in (("left", 1), ("right", -1)):
            add(f"{side}_shoulder", (0.1, 0.1, 0.1), 1.0, (0, 0.22 * y, 1.48), "torso", (0, 0.2 * y, 1.48), (1, 0, 0))
            add(f"{side}_arm", (0.08, 0.08, 0.28), 2.0, (0, 0.24 * y, 1.33), f"{side}_shoulder", (0, 0.24 * y, 1.47))
            add(f"{side}_forearm", (0.07, 0.07, 0.25), 1.5, (0, 0.24 * y, 1.06), f"{side}_arm", (0, 0.24 * y, 1.19))
            add(f"{side}_hip", (0.1, 0.1, 0.1), 1.5, (0, 0.1 * y, 0.92), "pelvis", (0, 0.1 * y, 0.95), (1, 0, 0))
            add(f"{side}_thigh", (0.13, 0.13, 0.4), 7.0, (0, 0.1 * y, 0.7), f"{side}_hip", (0, 0.1 * y, 0.9))
            add(f"{side}_shin", (0.1, 0.1, 0.4), 4.0, (0, 0.1 * y, 0.29), f"{side}_thigh", (0, 0.1 * y, 0.49))
        for side, y in (("left", 1), ("right", -1)):
            add(f"{side}_foot", (0.25, 0.1, 0.06), 1.2, (0.05, 0.1 * y, 0.05), f"{side}_shin", (0, 0.1 * y, 0.09))
    return scene


def humanoid_places(seconds):
    """Its motors hold it where it is."""
    return {"pelvis0": (0, 0, 0.98), "left_foot0": (0.05, 0.1, 0.03), "right_foot0": (0.05, -0.1, 0.03)}


#: Of the quadruped: length of a thigh and of a shank, radius of a foot [m]; angle of the thighs at the start, and what
#: its motors turn them by [rad, rad/s].
LENGTH, FOOT, BENT, RISE = 0.2, 0.02, 0.8, -0.2


def trunk_height(bent):
    """Hips are above feet, since thighs and shanks lean alike."""
    return FOOT + 2 * LENGTH * math.cos(bent)


def quadruped(count, stands):
    """A trunk and four legs of three hinges: tumbling without gravity, or rising on its feet. The mass of a shank is in
    its foot."""
    scene = Scene([], ground=stands, gravity=(0, 0, -9.8 if stands else 0))
    spin, trunk = (0.5, 2.0, 1.0), numpy.array((0, 0, trunk_height(BENT)))
    for number in range(count):
        tree = Tree(scene, "quadruped", number)

        def add(name, size, mass, place, joint=None, shape=None):
            rest = {}
            if not stands:
                rest = {"turning": spin, "velocity": tuple(numpy.cross(spin, numpy.subtract(place, trunk)))}
            tree.body(name, size, mass, tuple(place), shape, **rest)
            if joint:
                parent, anchor, axis, drive = joint
                tree.hinge(name, parent, tuple(anchor), axis, drive if stands else None)

        add("trunk", (0.5, 0.2, 0.12), 6.0, trunk)
        for leg, x, y in (("lf", 0.2, 0.1), ("rf", 0.2, -0.1), ("lh", -0.2, 0.1), ("rh", -0.2, -0.1)):
            hip = trunk + (x, y, 0)
            knee = hip + (-LENGTH * math.sin(BENT), 0, -LENGTH * math.cos(BENT))
            foot = hip + (0, 0, -2 * LENGTH * math.cos(BENT))
            add(f"{leg}_hip", (0.08, 0.08, 0.08), 0.7, hip, ("trunk", hip, (1, 0, 0), 0.0))
            add(f"{leg}_thigh", (0.04, 0.04, LENGTH), 0.9, (hip + knee) / 2, (f"{leg}_hip", hip, (0, 1, 0), RISE))
            add(f"{leg}_shank", (0.05, 0.05, 0.05), 0.3, foot, (f"{leg}_thigh", knee, (0, 1, 0), -2 * RISE),
                ("sphere", FOOT) if stands else None)
    return scene


def quadruped_places(seconds):
    """The trunk rises as the legs straighten, and goes ahead as the feet roll with the shanks."""
    return {"trunk0": (-FOOT * RISE * seconds, 0, trunk_height(BENT + RISE * seconds))}


#: Mass and length of the arm's links [kg, m], and the axes of its joints; it is level at the start.
ARM = (
    (4.0, 0.12, (0, 0, 1)),
    (4.0, 0.2, (0, 1, 0)),
    (3.0, 0.2, (1, 0, 0)),
    (2.7, 0.2, (0, 1, 1)),
    (1.7, 0.2, (1, 0, 0)),
    (1.8, 0.12, (0, 1, -1)),
    (0.3, 0.06, (1, 0, 0)),
)
BASE = (0.8, 0.8, 0.1)


def arm(count, stands):
    """An arm of seven joints: falling from level about a fixed point, or held by its motors, of which one turns, on a
    base that stands on the ground."""
    scene = Scene([], ground=stands)
    for number in range(count):
        tree = Tree(scene, "arm", number)
        if stands:
            tree.body("base", BASE, 40.0, (0, 0, BASE[2] / 2), ("box", *BASE))
        x, parent = 0.0, "base" if stands else ""
        for i, (mass, length, axis) in enumerate(ARM):
            tree.body(f"part{i}", (length, 0.1, 0.08), mass, (x + length / 2, 0, 0.5))
            tree.hinge(f"part{i}", parent, (x, 0, 0.5), axis, (0.2 if i == 2 else 0.0) if stands else None)
            x, parent = x + length, f"part{i}"
    return scene


def arm_places(seconds):
    return {"base0": (0, 0, BASE[2] / 2)}
