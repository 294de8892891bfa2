"""Engines beside what mechanics say, all in one run: run by tools/bench truth [CASE...].

Prints a table with a line for each case; what an engine can't do is a dash, what goes astray is said in words.
"""

import argparse
import math

import numpy

import references
from engines import load
from scene import Body, Joint, Scene, matrix, moments_of, solid, turn

STEP = 0.001


def angle_about(axis, rotation):
    """The angle of a turn about an axis, of a quaternion w x y z [rad]."""
    w, *rest = rotation
    return 2 * math.atan2(float(numpy.dot(rest, axis)), w)


def start(engine):
    """How far the tutorial's robot is after 30 ms of its start, its wheels spinning, its caster in the air."""
    from worlds import robots

    made = engine(robots(1, 0.5, 0.0, systems=False), STEP)
    before = made.body("chassis0")[0][0]
    made.step(30)
    chassis, rotation, _, _ = made.body("chassis0")
    # the distance of the axle: the wheel's angle includes the pitch of the chassis
    pitch = math.asin(2 * (rotation[0] * rotation[2] - rotation[3] * rotation[1]))
    way = chassis[0] - 0.5 * math.cos(pitch) - (before - 0.5)
    return way / references.wheelie_way(0.030, 0.5) - 1


def ellipsoid(engine):
    """The period of an ellipsoid that rolls to and fro by 0.3 rad on its flat side."""
    shape, lean = ("ellipsoid", 0.3, 0.2, 0.2), 0.3
    height = math.hypot(0.3 * math.sin(lean), 0.2 * math.cos(lean))
    made = engine(Scene([solid("egg", shape, 1.0, (0, 0, height), rotation=turn((0, 1, 0), lean))]), STEP)
    crossings, before, now = [], lean, 0
    while len(crossings) < 11 and now < 20000:
        made.step(1)
        now += 1
        angle = angle_about((0, 1, 0), made.body("egg")[1])
        if before > 0 >= angle:
            crossings.append(now - 1 + before / (before - angle))
        before = angle
    if len(crossings) < 11:
        return "stops"
    found = (crossings[10] - crossings[0]) / 10 * STEP
    return found / references.rocking_period(0.3, 0.2, 1.0, moments_of(shape, 1.0)[1], lean) - 1


def edge(engine, radius, length, tilt, circle, seconds):
    """A cylinder that rolls steadily on its edge: how much its middle comes up or down, in parts of its height."""
    shape = ("cylinder", radius, length)
    across, _, along = moments_of(shape, 1.0)
    rate, spin, height = references.rolling_cylinder(radius, length, 1.0, (across, along), tilt, circle)
    turning = numpy.array([0, 0, rate]) + spin * numpy.array([math.sin(tilt), 0, math.cos(tilt)])
    body = solid(
        "coin",
        shape,
        1.0,
        (circle, 0, height),
        rotation=turn((0, 1, 0), tilt),
        velocity=(0, rate * circle, 0),
        turning=tuple(turning),
    )
    made = engine(Scene([body]), STEP)
    worst = 0.0
    for _ in range(round(seconds / STEP / 10)):
        made.step(10)
        worst = max(worst, abs(made.body("coin")[0][2] / height - 1))
    return worst


def wheel(engine):
    return edge(engine, 0.25, 0.1, math.radians(60), 1.0, 5)


def coin(engine):
    return edge(engine, 0.1, 0.005, math.radians(40), 0.0, 2)


def stack(engine):
    """How far from its place any of 50 boxes is that stood on each other for 3 s [m]."""
    size = (0.5, 0.5, 0.2)
    made = engine(Scene([solid(f"box{i}", ("box", *size), 1.0, (0, 0, 0.1 + 0.2 * i)) for i in range(50)]), STEP)
    made.step(3000)
    places = [numpy.asarray(made.body(f"box{i}")[0]) for i in range(50)]
    return max(float(numpy.linalg.norm(place - (0, 0, 0.1 + 0.2 * i))) for i, place in enumerate(places))


def dominoes(engine):
    """The time from the fifth of twenty dominoes on hinges to the fifteenth."""
    height, width, pitch, mass, lean = 0.2, 0.03, 0.1, 0.5, 0.3
    half = numpy.array([-width / 2, 0, height / 2])
    moments = moments_of(("box", width, 0.1, height), mass)
    bodies, joints = [], []
    for i in range(20):
        rotation = turn((0, 1, 0), lean if i == 0 else 0)
        foot = numpy.array([pitch * i, 0, 0.0])
        bodies.append(
            Body(f"d{i}", ("box", width, 0.1, height), mass, moments, tuple(foot + matrix(rotation) @ half), rotation)
        )
        joints.append(Joint(f"foot{i}", "hinge", "", f"d{i}", tuple(foot)))
    made = engine(Scene(bodies, joints, friction=1e-6), STEP)
    times = {}
    for now in range(3000):
        made.step(1)
        for i in (5, 15):
            if i not in times and angle_about((0, 1, 0), made.body(f"d{i}")[1]) > 0.02:
                times[i] = now
        if 15 in times:
            break
    if 15 not in times:
        return "do not fall"
    expected = references.domino_times(20, height, width, pitch, mass, lean)
    return (times[15] - times[5]) * STEP / (expected[15] - expected[5]) - 1


def cradle(engine, gap):
    """How high the last ball of a Newton's cradle comes, of where the first one came from; how high the others do."""
    radius, rod, lift, count = 0.05, 1.0, math.radians(20), 5
    bodies, joints = [], []
    for i in range(count):
        anchor = numpy.array([(2 * radius + gap) * i, 0, 2.0])
        rotation = turn((0, 1, 0), lift if i == 0 else 0)
        bodies.append(
            solid(
                f"ball{i}", ("sphere", radius), 1.0, tuple(anchor + matrix(rotation) @ (0, 0, -rod)), rotation=rotation
            )
        )
        joints.append(Joint(f"rod{i}", "hinge", "", f"ball{i}", tuple(anchor)))
    made = engine(Scene(bodies, joints, restitution=1.0, friction=1e-6, ground=False), STEP)
    made.step(500)
    highest = [0.0] * count
    for _ in range(900):
        made.step(1)
        for i in range(count):
            highest[i] = max(highest[i], 1 - math.cos(angle_about((0, 1, 0), made.body(f"ball{i}")[1])))
    full = 1 - math.cos(lift)
    return highest[-1] / full - 1


def touching_cradle(engine):
    return cradle(engine, 0.0)


def spaced_cradle(engine):
    return cradle(engine, 0.004)


def slider_crank(engine):
    """The largest distance of a slider from where its crank's angle has it, in 5 s at 10 rad/s [m]."""
    crank, rod, height = 0.1, 0.3, 1.0
    pin, end = numpy.array([crank, 0, height]), numpy.array([crank + rod, 0, height])
    scene = Scene(
        [
            Body("crank", None, 0.5, (0.001, 0.001, 0.001), (crank / 2, 0, height), model="engine"),
            Body("rod", None, 0.3, (0.0001, 0.00225, 0.00225), (crank + rod / 2, 0, height), model="engine"),
            Body("slider", None, 1.0, (0.001, 0.001, 0.001), tuple(end), model="engine"),
        ],
        [
            Joint("shaft", "hinge", "", "crank", (0, 0, height), drive=10.0),
            Joint("big_end", "hinge", "crank", "rod", tuple(pin)),
            Joint("guide", "slide", "", "slider", tuple(end), axis=(1, 0, 0)),
            Joint("small_end", "ball", "rod", "slider", tuple(end), closes=True),
        ],
        ground=False,
    )
    made = engine(scene, STEP)
    worst = 0.0
    for _ in range(5000):
        made.step(1)
        angle = angle_about((0, 1, 0), made.body("crank")[1])
        worst = max(worst, abs(made.body("slider")[0][0] - references.crank_way(crank, rod, angle)))
    return worst


def anchor(engine, seconds=600):
    """How far a box creeps that stands on a slope which is a tenth less steep than it could bear [m]."""
    slope, friction = math.atan(0.45), 0.5
    gravity = (9.8 * math.sin(slope), 0, -9.8 * math.cos(slope))
    made = engine(
        Scene([solid("box", ("box", 0.4, 0.4, 0.2), 2.0, (0, 0, 0.1))], gravity=gravity, friction=friction), STEP
    )
    made.step(1000)
    before = numpy.asarray(made.body("box")[0])
    made.step(round(seconds / STEP) - 1000)
    way = float(numpy.linalg.norm(numpy.asarray(made.body("box")[0]) - before))
    return way if way < 1e3 else "slides off"


#: Name, function, and whether the error is relative or a length.
CASES = {
    "start": ("robot that rears up as it starts, way in 30 ms, beside the formula", start, "part"),
    "ellipsoid": ("ellipsoid that rolls to and fro, period, beside the quadrature", ellipsoid, "part"),
    "wheel": ("wheel that leans by 30° and rolls in a circle for 5 s, height of its middle", wheel, "part"),
    "coin": ("coin that spins on its edge at 40° for 2 s, likewise", coin, "part"),
    "stack": ("50 boxes in a stack for 3 s, farthest from its place", stack, "length"),
    "dominoes": ("row of dominoes, time from the 5th to the 15th, beside van Leeuwen's", dominoes, "part"),
    "cradle": ("Newton's cradle, balls 4 mm apart, height of the last ball", spaced_cradle, "part"),
    "touching": ("likewise, balls that touch", touching_cradle, "part"),
    "slider": ("slider-crank at 10 rad/s for 5 s, slider from where the crank has it", slider_crank, "length"),
    "anchor": ("box on a slope for 10 min, way", anchor, "length"),
}


def text_of(found, kind):
    if isinstance(found, str):
        return found
    if not math.isfinite(found):
        return "flies apart"
    if kind == "part":
        return f"{100 * found:+.2g} %" if abs(found) < 1 else f"{100 * found:+.0f} %"
    return f"{found * 1000:.2g} mm" if found >= 1e-6 else f"{found * 1e9:.2g} nm"


def measure(engine, function, kind):
    try:
        return text_of(function(engine), kind)
    except NotImplementedError as error:
        return str(error)


def main():
    parser = argparse.ArgumentParser(
        prog="tools/bench truth",
        description="Engines beside what mechanics say.",
        epilog="tools/bench truth slider coin",
    )
    parser.add_argument("case", nargs="*", help=", ".join(CASES) + "; all of them where none is named")
    names = parser.parse_args().case
    unknown = [name for name in names if name not in CASES]
    if unknown:
        parser.error(f"there is no case '{unknown[0]}': {', '.join(CASES)}")
    engines = load()
    print("| case | " + " | ".join(engine.NAME for engine in engines) + " |")
    print("|---" * (len(engines) + 1) + "|")
    for name in names or CASES:
        what, function, kind = CASES[name]
        print(f"| {what} | " + " | ".join(measure(each.Engine, function, kind) for each in engines) + " |", flush=True)


if __name__ == "__main__":
    main()
