"""What the simulation says about nodes beside it that do not fit."""

import pytest
import ros
import simulation
from geometry_msgs.msg import TransformStamped
from rclpy.duration import Duration
from rclpy.qos import DurabilityPolicy, LivelinessPolicy, QoSProfile
from sensor_msgs.msg import JointState, LaserScan
from tf2_msgs.msg import TFMessage


def says(log, text):
    return simulation.until(lambda: text in log.read_text() and log.read_text(), f"'{text}'")


@pytest.mark.parametrize("qos, promise", [(QoSProfile(depth=1, deadline=Duration(seconds=1)), "deadline"),
                                          (QoSProfile(depth=1, liveliness=LivelinessPolicy.MANUAL_BY_TOPIC), "liveliness")],
                         ids=["deadline", "liveliness"])
def test_a_reader_that_wants_a_promise(tmp_path, qos, promise):
    log = tmp_path / "log"
    with open(log, "w") as file, simulation.running(ros.WORLD, log=file), ros.node() as tester:
        tester.create_subscription(LaserScan, "/lidar", lambda scan: None, qos)
        says(log, f"subscribes to '/lidar' with a {promise}, but it is published without: it receives no messages")


def test_a_second_source_of_joints_and_a_second_parent(tmp_path):
    log = tmp_path / "log"
    with open(log, "w") as file, simulation.running(ros.WORLD, log=file), ros.node("controllers") as tester:
        frames = []
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        tester.create_subscription(TFMessage, "/tf", lambda each: frames.extend(each.transforms), 100)
        tester.create_subscription(TFMessage, "/tf_static", lambda each: frames.extend(each.transforms), latched)
        tester.create_publisher(JointState, "/joint_states", 1)
        says(log, "another node publishes '/joint_states', too: joints have two sources; --ros2-no-joint-states")
        child = simulation.until(lambda: frames, "a frame")[0].child_frame_id
        publisher = tester.create_publisher(TFMessage, "/tf", 10)
        transform = TransformStamped(child_frame_id=child)
        transform.header.frame_id = "elsewhere"

        def said():
            publisher.publish(TFMessage(transforms=[transform]))
            return f"another node publishes the frame '{child}' in 'elsewhere'" in log.read_text()

        simulation.until(said, "the warning")


def test_ours_can_be_left_out(tmp_path):
    options = ["--ros2-no-tf", "--ros2-no-joint-states", "--ros2-no-robot-description"]
    world = tmp_path / "world.sdf"
    # the options are for the system that they bring
    plugin = '<plugin filename="pongsim-ros2-system" name="pongsim::systems::Ros2"/>'
    world.write_text(ros.WORLD.read_text().replace(plugin, ""))
    with simulation.running(world, "--ros2", *options), ros.node() as tester:
        simulation.until(lambda: tester.get_publishers_info_by_topic("/lidar"), "the lidar")
        for topic in ("/tf", "/tf_static", "/joint_states", "/robot_description"):
            assert not tester.get_publishers_info_by_topic(topic), topic


@pytest.mark.parametrize("name, value", [("ROS_DISCOVERY_SERVER", "127.0.0.1:11811"),
                                         ("FASTDDS_BUILTIN_TRANSPORTS", "LARGE_DATA"),
                                         ("ROS_AUTOMATIC_DISCOVERY_RANGE", "OFF"),
                                         ("FASTRTPS_DEFAULT_PROFILES_FILE", "/profiles.xml")])
def test_variables_that_it_cannot_obey(tmp_path, name, value):
    log = tmp_path / "log"
    with open(log, "w") as file, simulation.running(ros.WORLD, log=file, environment={name: value}):
        says(log, name + " is ")
