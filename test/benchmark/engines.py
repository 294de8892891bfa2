"""Engines side by side on the same robots, in one run: run by tools/bench engines.

MuJoCo comes from PyPI (`pip install mujoco`); where it is missing, ours is measured alone.
"""

import math
import statistics
import subprocess
import sys
import time

try:
    import mujoco
except ImportError:
    mujoco = None

PROGRAM = sys.argv[1]
COUNTS = [int(each) for each in sys.argv[2:]] or [1, 10, 50, 200, 1000]
ROUNDS = 9
LINEAR, ANGULAR = 0.5, 0.4
RADIUS, HALF_SEPARATION = 0.4, 0.6
SETTLING_STEPS = 500

# the robot of the moving-robot tutorial: inertias, shapes and joints of its file
ROBOT = """
<body name="chassis{i}" pos="0.5 {y} 0.4"><freejoint/>
  <inertial pos="0 0 0" mass="1.14395" diaginertia="0.126164 0.416519 0.481014"/>
  <geom type="box" size="1 0.5 0.25"/>
  <body pos="-0.5 0.6 0" euler="-1.5707 0 0">
    <inertial pos="0 0 0" mass="2" diaginertia="0.145833 0.145833 0.125"/>
    <joint name="left{i}" type="hinge" axis="0 {across} {along}"/><geom type="cylinder" size="0.4 0.1"/></body>
  <body pos="-0.5 -0.6 0" euler="-1.5707 0 0">
    <inertial pos="0 0 0" mass="1" diaginertia="0.145833 0.145833 0.125"/>
    <joint name="right{i}" type="hinge" axis="0 {across} {along}"/><geom type="cylinder" size="0.4 0.1"/></body>
  <body pos="0.8 0 -0.2">
    <inertial pos="0 0 0" mass="1" diaginertia="0.1 0.1 0.1"/>
    <joint type="ball"/><geom type="sphere" size="0.2"/></body>
</body>
"""


class MuJoCo:
    """Robots whose wheels are held at their speed by a stiff servo, integrated implicitly."""

    def __init__(self, count, angular):
        robots = "".join(
            ROBOT.format(i=i, y=3 * i, across=math.cos(1.5707), along=math.sin(1.5707)) for i in range(count)
        )
        servos = "".join(
            f'<velocity joint="{side}{i}" kv="100"/>' for i in range(count) for side in ("left", "right")
        )
        self.model = mujoco.MjModel.from_xml_string(
            '<mujoco><compiler angle="radian" autolimits="true"/><size memory="512M"/>'
            '<option timestep="0.001" integrator="implicitfast" gravity="0 0 -9.8"/>'
            f'<worldbody><geom type="plane" size="0 0 1"/>{robots}</worldbody><actuator>{servos}</actuator></mujoco>'
        )
        self.data = mujoco.MjData(self.model)
        turning = angular * HALF_SEPARATION
        for i in range(count):
            self.data.ctrl[2 * i] = (LINEAR - turning) / RADIUS
            self.data.ctrl[2 * i + 1] = (LINEAR + turning) / RADIUS
        start = self.place()
        self.steps(SETTLING_STEPS)
        way = math.dist(start, self.place())
        if not 0.15 < way < 0.3:
            sys.exit(f"engines benchmark: error: MuJoCo's robot went {way} m and not as commanded")

    def place(self):
        return tuple(self.data.qpos[:3])

    def steps(self, count):
        """Processor time of so many steps [us]."""
        begin = time.process_time_ns()
        mujoco.mj_step(self.model, self.data, count)
        return (time.process_time_ns() - begin) / 1000

    @staticmethod
    def error():
        """How far off the way of its wheels a robot is that goes straight ahead for 5 s [m]."""
        world = MuJoCo(1, 0)
        start = world.place()
        world.steps(5000)
        return abs(math.dist(start, world.place()) - 5 * LINEAR)


class Pongsim:
    """The whole simulation, systems included, in a process of its own."""

    def __init__(self, what, count):
        self.process = subprocess.Popen(
            [PROGRAM, what, str(count)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )
        if self.process.stdout.readline() != "ready\n":
            sys.exit("engines benchmark: error: our program did not start")

    def steps(self, count):
        self.process.stdin.write(f"{count}\n")
        self.process.stdin.flush()
        return float(self.process.stdout.readline())

    def close(self):
        self.process.stdin.close()
        self.process.wait()


def compare(count):
    ours = Pongsim("robots", count)
    theirs = MuJoCo(count, ANGULAR) if mujoco else None
    steps = max(10, 4000 // count)
    own, other, ratios = [], [], []
    for _ in range(ROUNDS):
        own.append(ours.steps(steps) / steps)
        if theirs:
            other.append(theirs.steps(steps) / steps)
            ratios.append(own[-1] / other[-1])
    ours.close()
    line = f"{count:6d} {statistics.median(own):12.1f} {statistics.median(own) / count:10.2f}"
    if theirs:
        line += f" {statistics.median(other):12.1f} {statistics.median(other) / count:10.2f}"
        line += f" {statistics.median(ratios):8.2f}"
    print(line, flush=True)


def shapes(name, what, skipped, measured):
    """What a step of 3,000 shapes takes while they fall, or once they rest."""
    world = Pongsim(what, 3000)
    if skipped:
        world.steps(skipped)
    times = [world.steps(measured) / measured for _ in range(5)]
    world.close()
    print(f"{name:<40} {statistics.median(times) / 1000:8.2f}  ({min(times) / 1000:.2f} to {max(times) / 1000:.2f})")


print(f"processor time of a step of 1 ms [us], medians of {ROUNDS}, by turns; and for each robot")
print("robots      pongsim     a robot" + ("       MuJoCo     a robot    ratio" if mujoco else ""))
for each in COUNTS:
    compare(each)
own_error = float(subprocess.run([PROGRAM, "error", "1"], capture_output=True, text=True, check=True).stdout)
print(f"\nstraight ahead for 5 s, off by [mm]: pongsim {1000 * own_error:.3f}", end="")
print(f", MuJoCo {mujoco.__version__} {1000 * MuJoCo.error():.3f}" if mujoco else "")
print("\n3,000 shapes of 1 m on a plane, a step [ms]")
shapes("as in 3k_shapes.sdf, first 100 steps", "shapes", 0, 20)
shapes("likewise, after 2 s", "shapes", 2000, 20)
shapes("tilted and falling, first 0.5 s", "falling", 0, 100)
shapes("likewise, after 5 s", "falling", 5000, 20)
