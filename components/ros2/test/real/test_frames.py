"""The robot's frames, in tf2's own buffer."""

import ros
import simulation
from geometry_msgs.msg import Twist
from rclpy.duration import Duration
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.time import Time
from sensor_msgs.msg import LaserScan
from tf2_msgs.msg import TFMessage

WORLD = simulation.ROOT / "worlds/ros2_nav2.sdf"
SCANS = 40
LATCHED = QoSProfile(depth=100, durability=DurabilityPolicy.TRANSIENT_LOCAL)


def buffer_of(tester):
    """The buffer, filled as tf2_ros's TransformListener fills it."""
    import tf2_py

    buffer = tf2_py.BufferCore(Duration(seconds=10))

    def fill(put):
        return lambda message: [put(each, "tester") for each in message.transforms]

    tester.create_subscription(TFMessage, "/tf", fill(buffer.set_transform), 100)
    tester.create_subscription(TFMessage, "/tf_static", fill(buffer.set_transform_static), LATCHED)
    return buffer


def knows(buffer, frame, stamp):
    known, _ = buffer.can_transform_core("odom", frame, stamp)
    return known


@ros.needs_tools
def test_every_scan_can_be_transformed_to_odom():
    with simulation.running(WORLD, "--ros2"), ros.node() as tester:
        buffer = buffer_of(tester)
        scans = []
        tester.create_subscription(LaserScan, "/scan", scans.append, 100)
        publisher = tester.create_publisher(Twist, "/cmd_vel", 10)
        simulation.until(lambda: knows(buffer, "base_scan", Time()), "the frames")
        scans.clear()
        command = Twist()
        command.linear.x, command.angular.z = 0.2, 0.3
        places = []
        while len(places) < SCANS:
            publisher.publish(command)
            simulation.until(lambda: len(scans) > len(places), "a scan")
            frame, stamp = scans[len(places)].header.frame_id, Time.from_msg(scans[len(places)].header.stamp)
            simulation.until(lambda: knows(buffer, frame, stamp), lambda: f"a transform at {stamp}")
            places.append((stamp, buffer.lookup_transform_core("odom", frame, stamp).transform.translation))
        assert all(abs(place.z - 0.18) < 0.01 for _, place in places)
        # it moves as it is told, between any two scans
        for (before, a), (after, b) in zip(places[10:], places[11:]):
            speed = ((b.x - a.x)**2 + (b.y - a.y)**2)**0.5 / (1e-9 * (after - before).nanoseconds)
            assert abs(speed - 0.2) < 0.03, (before, a, after, b)
