"""Files of xacro are expanded by the real xacro, wherever a file is read."""

import os
import pathlib
import subprocess
import sys

import pytest
import simulation

ROBOT = """<?xml version="1.0"?>
<robot name="cart" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="$(find cart_parts)/wheel.xacro"/>
  <xacro:arg name="mass" default="1"/>
  <link name="base"><inertial><mass value="$(arg mass)"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
  </link>
  <xacro:wheel name="left" y="${0.1 + 0.2}"/>
  <xacro:wheel name="right" y="-0.3"/>
</robot>
"""
WHEEL = """<?xml version="1.0"?>
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="wheel" params="name y">
    <link name="${name}"><visual><geometry><mesh filename="package://cart_parts/tyre.obj"/></geometry></visual>
      <inertial><mass value="0.5"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
    </link>
    <joint name="${name}_joint" type="continuous"><parent link="base"/><child link="${name}"/>
      <origin xyz="0 ${y} 0"/><axis xyz="0 1 0"/>
    </joint>
  </xacro:macro>
</robot>
"""
WORLD = """<sdf version="1.9"><world name="yard"><include><uri>%s</uri></include></world></sdf>"""


@pytest.fixture
def workspace(tmp_path):
    for name in ("cart", "cart_parts"):
        package = tmp_path / "ws/src" / (name + "-ros2" if name == "cart_parts" else name)
        package.mkdir(parents=True)
        (package / "package.xml").write_text(f"<package><name>{name}</name></package>")
    (tmp_path / "ws/src/cart_parts-ros2/tyre.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    (tmp_path / "ws/src/cart/cart.urdf.xacro").write_text(ROBOT)
    (tmp_path / "ws/src/cart_parts-ros2/wheel.xacro").write_text(WHEEL)
    return tmp_path / "ws"


def pongsim(*arguments, **environment):
    path = f"{pathlib.Path(sys.executable).parent}:{os.environ['PATH']}"
    return subprocess.run([simulation.PONGSIM, *map(str, arguments)], capture_output=True, text=True,
                          env={**os.environ, "PATH": path, "PYTHONDONTWRITEBYTECODE": "1", **environment})


def test_a_robot_with_arguments_and_packages(workspace):
    robot = workspace / "src/cart/cart.urdf.xacro"
    printed = pongsim("sdf", "--print", robot, "mass:=7", "--packages", workspace)
    assert printed.returncode == 0, printed.stderr
    assert "<mass>7</mass>" in printed.stdout and "0.3" in printed.stdout and '<link name="right">' in printed.stdout
    ran = pongsim("run", robot, "mass:=7", "--packages", workspace / "src", "--iterations", "10", "-z", "0", "-v", "3")
    assert ran.returncode == 0 and "2 models" in ran.stderr and "warning" not in ran.stderr, ran.stderr


def test_packages_that_are_installed(workspace):
    installed = workspace / "install"
    (installed / "share").mkdir(parents=True)
    (workspace / "src/cart_parts-ros2").rename(installed / "share/cart_parts")
    checked = pongsim("sdf", "--check", workspace / "src/cart/cart.urdf.xacro", AMENT_PREFIX_PATH=f"/none:{installed}")
    assert checked.returncode == 0 and "Valid." in checked.stdout, checked.stderr


def test_a_world_that_includes_one(workspace, tmp_path):
    world = tmp_path / "yard.sdf"
    world.write_text(WORLD % "ws/src/cart/cart.urdf.xacro")
    printed = pongsim("sdf", "--print", world, "mass:=9", "--packages", workspace)
    assert printed.returncode == 0, printed.stderr
    assert "<mass>9</mass>" in printed.stdout


@pytest.mark.parametrize("before, after, file, line, message", [
    ('y="-0.3"', 'y="${z}"', "cart/cart.urdf.xacro", 8, "name 'z' is not defined"),
    ('y="-0.3"', "", "cart/cart.urdf.xacro", 8, "Undefined parameters [y]"),
    ("xacro:wheel name", "xacro:whel name", "cart/cart.urdf.xacro", 7, "unknown macro name: xacro:whel"),
    ("cart_parts)", "other)", "cart/cart.urdf.xacro", 3, "there is no package 'other'"),
    ('"$(arg mass)"', '"$(arg weight)"', "cart/cart.urdf.xacro", 5, "Undefined substitution argument weight"),
    ("</robot>", "</robo>", "cart/cart.urdf.xacro", 9, "mismatched tag"),
    ("0 ${y} 0", "0 ${1 / 0} 0", "cart_parts-ros2/wheel.xacro", 8, "division by zero")])
def test_mistakes_have_their_file_and_line(workspace, before, after, file, line, message):
    path = workspace / "src" / file
    text = path.read_text()
    assert before in text
    path.write_text(text.replace(before, after))
    checked = pongsim("sdf", "--check", workspace / "src/cart/cart.urdf.xacro", "--packages", workspace)
    assert checked.returncode == 1
    assert f"src/{file}:{line}: error: xacro: " in checked.stderr and message in checked.stderr, checked.stderr


def test_mistakes_of_the_result_say_that_it_is_expanded(workspace, tmp_path):
    robot = workspace / "src/cart/cart.urdf.xacro"
    robot.write_text(ROBOT.replace('type="continuous"', 'type="none"').replace('<link name="base">', '<link name="">'))
    checked = pongsim("sdf", "--check", robot, "--packages", workspace)
    assert checked.returncode == 1 and "cart.urdf.xacro (expanded):" in checked.stderr, checked.stderr
    world = tmp_path / "yard.sdf"
    world.write_text(WORLD % "ws/src/cart/cart.urdf.xacro")
    checked = pongsim("sdf", "--check", world, "--packages", workspace)
    assert "cart.urdf.xacro (expanded):" in checked.stderr and "yard.sdf:1" in checked.stderr, checked.stderr


def test_without_xacro(workspace, tmp_path):
    (tmp_path / "none").mkdir()
    (tmp_path / "none/xacro.py").write_text("raise ImportError")
    checked = pongsim("sdf", "--check", workspace / "src/cart/cart.urdf.xacro", PYTHONPATH=str(tmp_path / "none"))
    assert checked.returncode == 1
    assert "is a xacro file, and xacro is not installed" in checked.stderr and "pip install xacro" in checked.stderr


@pytest.mark.parametrize("arguments, message", [(["mass=7"], "unexpected argument 'mass=7'"),
                                                (["--packages", "/none"], "there is no ROS package in '/none'")])
def test_wrong_command_lines(workspace, arguments, message):
    ran = pongsim("run", workspace / "src/cart/cart.urdf.xacro", *arguments)
    assert ran.returncode == 2 and message in ran.stderr, ran.stderr
