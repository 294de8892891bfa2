"""Helpers of the tests of `pongsim test`."""

import os
import pathlib
import subprocess
import sys

import pongsim

PACKAGES = str(pathlib.Path(pongsim.__file__).parents[1])
_CODE = "import sys; sys.path[0] = sys.argv.pop(1); from pongsim.testing.command import main; sys.exit(main())"


def start(folder, *arguments, **environment):
    """Runs the command in the folder, in a process group of its own."""
    return subprocess.Popen([sys.executable, "-c", _CODE, PACKAGES, *map(str, arguments)], cwd=folder, text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True,
                            env={**os.environ, **environment})


def command(folder, *arguments, **environment):
    """Its exit code, its output, and its error messages."""
    process = start(folder, *arguments, **environment)
    out, err = process.communicate(timeout=300)
    return process.returncode, out, err


def write(folder, name, text):
    path = pathlib.Path(folder, name)
    path.write_text(text)
    return path


#: A ball of 1 m that falls from 2 m, and says where it is 50 times a second.
WORLD = """<?xml version="1.0"?>
<sdf version="1.9"><world name="w">
  <plugin filename="ignition-gazebo-physics-system" name="ignition::gazebo::systems::Physics"/>
  <model name="ground"><static>true</static><link name="link"><collision name="c"><geometry><plane/></geometry></collision>
  </link></model>
  <model name="ball"><pose>0 0 2 0 0 0</pose><link name="link"><inertial><mass>2</mass></inertial>
    <collision name="c"><geometry><sphere><radius>0.5</radius></sphere></geometry></collision></link>
    <plugin filename="ignition-gazebo-odometry-publisher-system" name="ignition::gazebo::systems::OdometryPublisher">
      <dimensions>3</dimensions></plugin></model>
</world></sdf>
"""

HEAD = "world: w.sdf\nduration: 2\n"
LANDS = HEAD + "expect:\n  - contact: [ball, ground]\n    eventually: true\n"


def run(folder, text, *arguments):
    """Runs a scenario of the ball: exit code, output, error messages."""
    write(folder, "w.sdf", WORLD)
    write(folder, "s.yaml", text)
    return command(folder, "s.yaml", *arguments)
