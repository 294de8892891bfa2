"""Published robots: frames, descriptions and joints; and joints driven by controllers outside."""

import math
import re
import subprocess
import xml.etree.ElementTree as xml
from dataclasses import dataclass, field

import pytest
from cyclonedds.core import Policy, Qos
from cyclonedds.idl import IdlStruct
from cyclonedds.idl.types import float64, sequence
from cyclonedds.util import duration

import peers

DRIVE = peers.ROOT / "components/ros2/test/drive.sdf"
ARM = peers.ROOT / "components/ros2/test/arm.sdf"
URDF = peers.ROOT / "components/ros2/test/arm.urdf"
TRANSFORMS = Qos(Policy.Reliability.Reliable(duration(seconds=1)), Policy.History.KeepLast(100))


@dataclass
class Quaternion(IdlStruct, typename="geometry_msgs::msg::dds_::Quaternion_"):
    x: float64 = 0.0
    y: float64 = 0.0
    z: float64 = 0.0
    w: float64 = 1.0


@dataclass
class Transform(IdlStruct, typename="geometry_msgs::msg::dds_::Transform_"):
    translation: peers.Vector3 = field(default_factory=peers.Vector3)
    rotation: Quaternion = field(default_factory=Quaternion)


@dataclass
class TransformStamped(IdlStruct, typename="geometry_msgs::msg::dds_::TransformStamped_"):
    header: peers.Header = field(default_factory=peers.Header)
    child_frame_id: str = ""
    transform: Transform = field(default_factory=Transform)


@dataclass
class TFMessage(IdlStruct, typename="tf2_msgs::msg::dds_::TFMessage_"):
    transforms: sequence[TransformStamped] = field(default_factory=list)


@dataclass
class JointState(IdlStruct, typename="sensor_msgs::msg::dds_::JointState_"):
    header: peers.Header = field(default_factory=peers.Header)
    name: sequence[str] = field(default_factory=list)
    position: sequence[float64] = field(default_factory=list)
    velocity: sequence[float64] = field(default_factory=list)
    effort: sequence[float64] = field(default_factory=list)


def time_of(header):
    return header.stamp.sec + 1e-9 * header.stamp.nanosec


class Tree:
    """State of a tf subscriber: for each frame its parents and the times of the transforms."""

    def __init__(self, peer):
        self.moving = peer.reader("/tf", TFMessage, TRANSFORMS)
        self.static = peer.reader("/tf_static", TFMessage, peers.LATCHED)
        self.parents = {}
        self.times = {}

    def read(self):
        for reader in (self.static, self.moving):
            for message in peers.take(reader):
                for transform in message.transforms:
                    frame = transform.child_frame_id
                    self.parents.setdefault(frame, set()).add(transform.header.frame_id)
                    if reader is self.moving:
                        self.times.setdefault(frame, []).append(time_of(transform.header))
        return self

    def roots(self):
        return {parent for parents in self.parents.values() for parent in parents} - set(self.parents)

    def root_of(self, frame):
        while frame in self.parents:
            [frame] = self.parents[frame]
        return frame

    def has(self, *frames):
        return lambda: set(frames) <= set(self.read().parents)




@pytest.mark.parametrize("world,root,frames", [
    (peers.ROOT / "worlds/pong_world.sdf", "pong_bot/odom",
     ["pong_bot/chassis", "pong_bot/left_wheel", "pong_bot/caster"]),
    (peers.ROOT / "worlds/pong_lidar.sdf", "pong_bot/odom",
     ["pong_bot/chassis", "pong_bot/left_wheel", "pong_bot/caster", "pong_bot/chassis/lidar", "pong_bot/chassis/imu"]),
    # a robot without a drive
    (peers.ROOT / "worlds/building_robot.sdf", "world",
     ["pong_bot/chassis", "pong_bot/left_wheel", "pong_bot/caster"]),
    (DRIVE, "rover/odom", ["rover/chassis", "rover/left_wheel", "rover/caster", "rover/chassis/lidar"]),
])
def test_the_frames_are_one_tree(world, root, frames):
    with peers.running("--ros2", world):
        tree = Tree(peers.Peer())
        peers.until(tree.has(*frames), "all frames")
        peers.until(lambda: all(len(times) >= 3 for times in tree.read().times.values()), "three times each")
        assert {tree.root_of(frame) for frame in frames} == {root}
        # static models are attached to the world
        assert tree.roots() <= {"world", root}
        for frame, parents in tree.parents.items():
            assert len(parents) == 1, frame
        for frame, times in tree.times.items():
            assert times == sorted(set(times)), frame


def test_who_comes_late_gets_the_static_frames_and_the_description():
    with peers.running(DRIVE):
        first = peers.Peer()
        tree = Tree(first)
        links = {"rover/chassis", "rover/left_wheel", "rover/right_wheel", "rover/caster"}
        peers.until(tree.has(*links, "rover/chassis/lidar"), "the frames")
        description = peers.take_one(first.reader("/robot_description", peers.String, peers.LATCHED)).data
        # the lidar's scans are in a frame of the tree
        scan = peers.take_one(first.reader("/lidar", peers.LaserScan))
        assert scan.header.frame_id in tree.parents

        late = peers.Peer()
        peers.take_one(late.reader("/tf_static", TFMessage, peers.LATCHED), where=lambda static: "rover/chassis/lidar" in
                       {transform.child_frame_id for transform in static.transforms})
        assert peers.take_one(late.reader("/robot_description", peers.String, peers.LATCHED)).data == description

    # RViz's RobotModel finds each link in tf
    robot = xml.fromstring(description)
    assert {link.get("name") for link in robot.findall("link")} == links
    assert {joint.get("name"): joint.get("type") for joint in robot.findall("joint")} == {
        "left_wheel_joint": "continuous", "right_wheel_joint": "continuous", "caster_joint": "floating"}


def test_the_joints_turn_as_it_drives():
    with peers.running(DRIVE):
        peer = peers.Peer()
        states = peer.reader("/joint_states", JointState)
        start = peers.take_one(states)
        assert start.name == ["left_wheel_joint", "right_wheel_joint"]
        assert len(start.position) == len(start.velocity) == len(start.effort) == 2
        command = peer.writer("/cmd_vel", peers.Twist)

        def turning():
            command.write(peers.Twist(linear=peers.Vector3(x=0.5)))
            return [state for state in peers.take(states) if min(state.velocity) > 4.9]

        # 0.5 m/s on wheels of 0.1 m
        first = peers.until(turning, "wheels that turn at 5 rad/s")[-1]
        later = peers.take_one(states, where=lambda state: time_of(state.header) > time_of(first.header) + 0.2)
        span = time_of(later.header) - time_of(first.header)
        for before, after in zip(first.position, later.position):
            assert after - before == pytest.approx(5 * span, rel=0.05)


def test_a_robot_in_urdf_is_described_as_it_came_and_driven_from_outside(tmp_path):
    log_file = tmp_path / "log"
    with open(log_file, "w") as log, peers.running(ARM, log=log):
        peer = peers.Peer()
        assert peers.take_one(peer.reader("/robot_description", peers.String, peers.LATCHED)).data == URDF.read_text()

        # QoS of topic_based_ros2_control: a reliable writer, a best-effort reader
        states = peer.reader("/robot_joint_states", JointState, peers.BEST_EFFORT)
        commands = peer.writer("/robot_joint_commands", JointState)
        tree = Tree(peer)

        def there():
            commands.write(JointState(name=["shoulder"], position=[1.0]))
            return [state for state in peers.take(states) if state.position[0] == pytest.approx(1, abs=1e-4)]

        state = peers.until(there, "a joint at its target")[-1]
        assert state.name == ["shoulder"]
        peers.until(tree.has("base", "upper", "tool"), "all frames of the URDF")
        assert tree.roots() == {"world"}
        assert tree.parents["tool"] == {"upper"}

        # NaN moves nothing
        def refused():
            commands.write(JointState(name=["shoulder"], position=[math.nan]))
            return "a number in it is not finite" in log_file.read_text()

        peers.until(refused, "the warning")
        assert peers.take_one(states).position[0] == pytest.approx(1, abs=1e-3)
    said = log_file.read_text()
    assert said.count("topic_based_ros2_control/TopicBasedSystem") == 1
    assert "run with --ros2" not in said


def test_without_ros_a_world_with_controllers_says_what_to_do(tmp_path):
    world = tmp_path / "arm.sdf"
    world.write_text(re.sub(r"<plugin filename=.pongsim-ros2-system.*/>", "", ARM.read_text()))
    (tmp_path / "arm.urdf").write_text(URDF.read_text())
    result = subprocess.run([peers.PONGSIM, "run", world, "-z", "0", "--iterations", "10"], capture_output=True,
                            text=True, check=True)
    assert "run with --ros2 so that ROS nodes can reach these topics" in result.stderr


def hash_of(world, rate):
    result = subprocess.run([peers.PONGSIM, "run", world, "-z", rate, "--hash", "--iterations", "3000"],
                            capture_output=True, text=True, check=True)
    return re.search(r"state hash: (\w+)", result.stdout).group(1)


def test_the_bits_are_the_same_with_readers_and_without():
    alone = hash_of(DRIVE, "0")
    peer = peers.Peer()
    tree = Tree(peer)
    states = peer.reader("/joint_states", JointState)

    def is_the_same_and_was_heard():
        # slow enough to be discovered
        assert hash_of(DRIVE, "3000") == alone
        return peers.take(states) and tree.read().parents

    peers.until(is_the_same_and_was_heard, "messages of a run")
