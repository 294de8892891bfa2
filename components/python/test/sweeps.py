"""A small world to sweep over, and helpers of the tests of sweeps."""

import copy
import pathlib
import subprocess
import sys

import pongsim
from pongsim import sweep

# programs of tests import this file without conftest.py
sys.path.append(str(pathlib.Path(__file__).resolve().parents[3] / "test/support"))
from waiting import until  # noqa: E402

PACKAGES = str(pathlib.Path(pongsim.__file__).parents[1])

#: A ball that falls, and a system that publishes its position.
WORLD = """<?xml version="1.0"?>
<sdf version="1.9"><world name="w">
  <plugin filename="ignition-gazebo-physics-system"
          name="ignition::gazebo::systems::Physics"/>
  <model name="ground"><static>true</static><link name="link"><collision name="c"><geometry><plane/></geometry></collision>
  </link></model>
  <model name="ball"><pose>0 0 2 0 0 0</pose><link name="link"><inertial><mass>2</mass></inertial>
    <collision name="c"><geometry><sphere><radius>0.5</radius></sphere></geometry></collision></link>
    <plugin filename="ignition-gazebo-odometry-publisher-system" name="ignition::gazebo::systems::OdometryPublisher">
      <dimensions>3</dimensions></plugin></model>
  <model name="other"><static>true</static><pose>9 0 0 0 0 0</pose><link name="link"/></model>
</world></sdf>
"""

BALL = {
    "world": "w.sdf",
    "duration": 0.2,
    "parameters": {"height": {"xpath": "//model[@name='ball']/pose", "text": "0 0 $height 0 0 0", "values": [2, 3]}},
    "measures": {"z": {"topic": "/model/ball/odometry", "field": "pose.position.z"}},
}


def ball(**changes):
    """The sweep of the ball; None takes a part away."""
    made = {**copy.deepcopy(BALL), **changes}
    return {key: value for key, value in made.items() if value is not None}


def write(folder, name, text):
    path = pathlib.Path(folder, name)
    path.write_text(text)
    return path


def make(folder, **changes):
    """Writes the sweep of the ball into the folder, which has its world."""
    options = changes.pop("options", {})
    place = pathlib.Path(folder)
    if not (place / "w.sdf").exists():
        write(place, "w.sdf", WORLD)
    made = ball(**changes)
    made["world"] = str(place / made["world"])
    return sweep.run(made, folder=place / "out", **{"jobs": 2, **options})


def start(folder, *arguments):
    """Runs the command in a separate process, in the folder."""
    code = "import sys; sys.path[0] = sys.argv.pop(1); from pongsim.sweep.command import main; sys.exit(main())"
    return subprocess.Popen([sys.executable, "-c", code, PACKAGES, *map(str, arguments)], cwd=folder, text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE)


def command(folder, *arguments):
    """Its exit code, its output, and its error messages."""
    process = start(folder, *arguments)
    out, err = process.communicate(timeout=300)
    return process.returncode, out, err


def children(pid):
    """The child processes of a process."""
    with open(f"/proc/{pid}/task/{pid}/children") as file:
        return [int(each) for each in file.read().split()]


def wait_for(condition, process=None):
    """Waits until the condition holds; fails if the process ends before."""
    def holds():
        value = condition()
        assert value or process is None or process.poll() is None, process.communicate()
        return value
    until(holds)

