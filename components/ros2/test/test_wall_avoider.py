"""The example ros2_wall_avoider, installed as by ROS and run unmodified on the stand-in for rclpy."""

import contextlib
import dataclasses
import math
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time
import xml.etree.ElementTree as xml
from collections.abc import Callable

import numpy as np
import peers
import pytest
import ros_messages
from client import Steps
from house import House
from tf_tree import DEEP

ros_messages.install()

from geometry_msgs.msg import Twist  # noqa: E402
from rosgraph_msgs.msg import Clock  # noqa: E402
from sensor_msgs.msg import LaserScan  # noqa: E402
from std_msgs.msg import Bool  # noqa: E402
from tf2_msgs.msg import TFMessage  # noqa: E402

PACKAGE = peers.ROOT / "examples/ros2_wall_avoider"
HERE = pathlib.Path(__file__).parent

sys.path.insert(0, str(PACKAGE))
from ros2_wall_avoider.steering import Steering  # noqa: E402


@pytest.fixture(scope="module")
def installed(tmp_path_factory):
    """Installs the package where colcon does, with the same command."""
    folder = tmp_path_factory.mktemp("workspace")
    shutil.copytree(PACKAGE, folder / "source")
    result = subprocess.run([sys.executable, "setup.py", "-q", "install", "--prefix", folder / "install",
                             "--single-version-externally-managed", "--record", folder / "record"],
                            cwd=folder / "source", capture_output=True, text=True)
    assert result.returncode == 0, result.stderr
    return folder / "install"


@contextlib.contextmanager
def node(installed, *arguments, log):
    """The program of the package, which runs until the end."""
    libraries = next(installed.glob("lib/python3*/site-packages"))
    process = subprocess.Popen(
        [installed / "lib/ros2_wall_avoider/wall_avoider", "--ros-args", *arguments], stderr=open(log, "w"),
        env={**os.environ, "PYTHONPATH": f"{HERE / 'rclpy_stand_in'}:{HERE}:{libraries}"})
    try:
        yield process
    finally:
        process.send_signal(signal.SIGINT)
        code = process.wait(peers.PATIENCE)
    assert code == 0, pathlib.Path(log).read_text()


def test_it_is_installed_as_ros_looks_for_it(installed):
    share = installed / "share/ros2_wall_avoider"
    assert (installed / "share/ament_index/resource_index/packages/ros2_wall_avoider").exists()
    manifest = xml.parse(share / "package.xml").getroot()
    assert manifest.findtext("name") == "ros2_wall_avoider"
    assert manifest.findtext("export/build_type") == "ament_python"
    metadata = next(installed.glob("lib/python3*/site-packages/*.egg-info/PKG-INFO")).read_text()
    assert f"\nVersion: {manifest.findtext('version')}\n" in metadata
    # everything that the launch file starts exists
    launch = xml.parse(share / "launch/wall_avoider.launch.xml").getroot()
    program = launch.find("node")
    assert os.access(installed / "lib" / program.get("pkg") / program.get("exec"), os.X_OK)
    assert program.find("param").attrib == {"name": "use_sim_time", "value": "true"}
    assert launch.find("executable").get("cmd") == "pongsim run $(var world) --ros2"


BIG_ROBOT = [(1.5, 0.5), (1.5, -0.5), (0.4, 0.7), (0.4, -0.7), (-0.4, 0.7), (-0.4, -0.7), (-0.5, 0.5), (-0.5, -0.5)]
SMALL_ROBOT = [(0.22 * math.cos(0.1 * i), 0.22 * math.sin(0.1 * i)) for i in range(63)]


@dataclasses.dataclass
class Place:
    """A world, and the requirements on the robot in it."""

    world: pathlib.Path
    name: str
    robot: str
    # its outline from above, with the wheels [m]
    outline: list
    # distance of points [n x 2] to the nearest wall [m]
    room: Callable
    # the distance to keep, and the distance to come within, so that there was something to avoid [m]
    least: float = 0.3
    most: float = 1.5
    # the topic that reports contact with a wall
    touched: str = "/none"
    arguments: tuple = ()


def tutorial():
    # the wall is a box of 0.5 m x 10 m about (5, 0)
    return Place(peers.fortress("tutorials/sensor_tutorial.sdf"), "sensor_world", "vehicle_blue", BIG_ROBOT,
                 lambda points: np.linalg.norm(np.maximum(np.abs(points - [5, 0]) - [0.25, 5], 0), axis=1),
                 touched="/wall/touched")


def court():
    # 20 m x 12 m
    return Place(peers.ROOT / "worlds/pong_lidar.sdf", "pong_lidar", "pong_bot", BIG_ROBOT,
                 lambda points: ([10, 6] - np.abs(points)).min(axis=1), touched="/court/touched")


def house():
    # another robot, with its names and dimensions
    return Place(peers.ROOT / "worlds/ros2_nav2.sdf", "ros2_nav2", "robot", SMALL_ROBOT, House().distance, least=0.1,
                 most=0.5, arguments=("-r", "/lidar:=/scan", "-p", "near:=0.4", "-p", "width:=0.7", "-p", "speed:=0.26"))


def outline_at(transform, outline):
    yaw = 2 * math.atan2(transform.rotation.z, transform.rotation.w)
    turn = np.array([[math.cos(yaw), math.sin(yaw)], [-math.sin(yaw), math.cos(yaw)]])
    return np.array(outline) @ turn + [transform.translation.x, transform.translation.y]


class Drive:
    """A simulation that steps from scan to scan, and continues when the node has answered the last one."""

    STEPS = 100
    # So long an answer is waited for [s]. A scan may be lost, for the node does not ask for those again.
    LONGEST = 2.0

    def __init__(self):
        peer = peers.Peer()
        self.steps = Steps(peer)
        self.commands = peer.reader("/cmd_vel", Twist)

    def go_on(self):
        """Whether the node answered."""
        peers.take(self.commands)
        self.steps(self.STEPS)
        end = time.monotonic() + self.LONGEST
        while time.monotonic() < end:
            if peers.take(self.commands):
                return True
            time.sleep(0.001)
        return False


@pytest.mark.parametrize("where", [tutorial, court, house])
def test_it_keeps_its_distance_for_a_minute(installed, tmp_path, where):
    place = where()
    log = tmp_path / "log"
    with peers.running(place.world, "--ros2", "--paused", "-z", "0"):
        peer = peers.Peer()
        poses = peer.reader(f"/world/{place.name}/dynamic_pose/info", TFMessage, DEEP)
        touches = peer.reader(place.touched, Bool)
        path = []

        def drive_until(seconds):
            """Whether the robot is where it is at that time."""
            for message in peers.take(poses):
                path.extend((each.header.stamp.sec, each.transform) for each in message.transforms
                            if each.child_frame_id == place.robot)
            if path and path[-1][0] >= seconds:
                return True
            drive.go_on()
            return False

        drive = Drive()
        with node(installed, "-p", "use_sim_time:=true", *place.arguments, log=log):
            peers.until(drive.go_on, "a node that answers")
            peers.until(lambda: drive_until(0), "where the robot is")
            begin = path[-1][0]
            peers.until(lambda: drive_until(begin + 60), "the end of the minute", patience=600)
        assert not peers.take(touches), "it touched a wall"
    nearest = min(place.room(outline_at(pose, place.outline)).min() for _, pose in path)
    assert place.least < nearest < place.most
    # it drove all the time
    ways = np.array([(pose.translation.x, pose.translation.y) for _, pose in path])
    assert np.linalg.norm(np.diff(ways, axis=0), axis=1).sum() > 8
    said = log.read_text()
    assert "A wall is near: turning" in said
    # by its clock the simulation has begun a moment ago
    stamps = [float(line.split("[")[2].split("]")[0]) for line in said.splitlines() if "[wall_avoider]" in line]
    assert all(stamp < begin + 90 for stamp in stamps), stamps


class Simulation:
    """The node's input and output, with the time set by the test."""

    def __init__(self):
        peer = peers.Peer()
        self.clock = peer.writer("/clock", Clock)
        self.scans = peer.writer("/lidar", LaserScan, peers.BEST_EFFORT)
        self.commands = peer.reader("/cmd_vel", Twist)
        self.seconds = 100.0

    def answer(self, *ranges, speed=None):
        """Sends the scan until a command arrives; one with that speed, if given, because others may be on their way."""
        peers.take(self.commands)
        scan = LaserScan(angle_min=-0.1, angle_increment=0.1, ranges=list(ranges))

        def command():
            self.scans.write(scan)
            return [each for each in peers.take(self.commands) if speed is None or each.linear.x == speed]

        return peers.until(command, "a command")[-1]

    def pass_time(self, seconds):
        self.seconds += seconds
        self.clock.write(Clock(clock=peers_time(self.seconds)))


def peers_time(seconds):
    return ros_messages.message("builtin_interfaces/msg/Time")(sec=int(seconds), nanosec=int(seconds % 1 * 1e9))


def test_it_stops_when_no_scan_comes_for_a_while_of_simulated_time(installed, tmp_path):
    with node(installed, "-p", "use_sim_time:=true", "-p", "speed:=0.25", log=tmp_path / "log"):
        simulation = Simulation()
        assert simulation.answer(9.0, 9.0, 9.0).linear.x == 0.25

        def stopped():
            simulation.pass_time(0.25)
            return [command for command in peers.take(simulation.commands) if command.linear.x == 0]

        peers.until(stopped, "a command to stop")
        assert "No scan comes: stopping" in (tmp_path / "log").read_text()
        # time has restarted, as after a reset
        simulation.seconds = 1.0
        simulation.answer(9.0, 9.0, 9.0, speed=0.25)
        peers.until(stopped, "a command to stop")
        assert simulation.seconds > 1.9


def test_parameters_and_names_are_those_of_the_command_line(installed, tmp_path):
    with node(installed, "-p", "near:=3.0", "-p", "turn:=0.75", "-r", "/cmd_vel:=/left/cmd_vel",
              log=tmp_path / "log"):
        simulation = Simulation()
        simulation.commands = peers.Peer().reader("/left/cmd_vel", Twist)
        command = simulation.answer(9.0, 2.9, 2.8)
        assert (command.linear.x, command.angular.z) == (0.0, -0.75)


def test_a_parameter_of_another_type_is_refused_as_by_rclpy(installed, tmp_path):
    with pytest.raises(AssertionError, match="InvalidParameterTypeException.*expecting type 'float'"):
        with node(installed, "-p", "near:=3", log=tmp_path / "log") as process:
            process.wait(peers.PATIENCE)


def command(steering, *ranges):
    return steering.command(ranges, -0.1 * (len(ranges) // 2), 0.1)


def test_steering_is_ahead_where_nothing_is_met():
    assert command(Steering(1.0, 1.8, 0.5, 0.4), math.inf, math.nan, math.inf) == (0.5, 0.0)


def test_steering_is_slower_before_a_wall_and_turns_to_the_freer_side():
    steering = Steering(1.0, 1.8, 0.5, 0.4)
    assert command(steering, 1.5, 1.5, 1.5)[0] == pytest.approx(0.375, rel=0.01)
    # beams are ordered from right to left
    assert command(steering, 0.9, 0.95, 1.2) == (0.0, 0.4)
    # it continues until there is room, although the other side is free by now
    assert command(steering, 1.9, 1.5, 1.2) == (0.0, 0.4)
    assert command(steering, 2.5, 2.5, 2.5) == (0.5, 0.0)
    assert command(steering, 1.2, 0.95, 0.9) == (0.0, -0.4)


def test_steering_turns_out_of_a_corner():
    # a wall 1 m ahead, nearer than the one 1.3 m to the left, and both are in view on the left
    steering = Steering(1.01, 1.8, 0.5, 0.4)
    angles = [-1.4 + 0.01 * i for i in range(281)]
    ranges = [min(1.0 / math.cos(angle), 1.3 / math.sin(angle) if angle > 0 else math.inf) for angle in angles]
    assert steering.command(ranges, -1.4, 0.01) == (0.0, -0.4)
    assert Steering(1.01, 1.8, 0.5, 0.4).command(ranges[::-1], -1.4, 0.01) == (0.0, 0.4)


def test_steering_leaves_aside_what_is_beside_the_way():
    steering = Steering(1.0, 1.8, 0.5, 0.4)
    # a wall 0.95 m to the left, all along
    ranges = [0.95 / math.sin(0.1 * i) if i > 0 else math.inf for i in range(-15, 16)]
    assert steering.command(ranges, -1.5, 0.1) == (0.5, 0.0)


def test_the_stand_in_refuses_integers_for_floating_point_numbers_as_rclpy_does():
    twist = Twist()
    ros_messages.check(twist)
    twist.linear.x = 0
    with pytest.raises(AssertionError, match="'linear.x' field must be of type 'float'"):
        ros_messages.check(twist)
