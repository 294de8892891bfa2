"""The worlds of the tutorials, unmodified: a node drives them, and reads what is there."""

import math
import struct

import peers
import pytest
import ros_messages

ros_messages.install()

from geometry_msgs.msg import Twist, TwistStamped, Vector3  # noqa: E402
from nav_msgs.msg import Odometry  # noqa: E402
from ros_gz_interfaces.msg import Contacts  # noqa: E402
from rosgraph_msgs.msg import Clock  # noqa: E402
from sensor_msgs.msg import CameraInfo, Image, Imu, LaserScan, PointCloud2  # noqa: E402
from std_msgs.msg import Bool, Int32, String  # noqa: E402
from tf2_msgs.msg import TFMessage  # noqa: E402


def yaw_of(rotation):
    return 2 * math.atan2(rotation.z, rotation.w)


def seconds(stamp):
    return stamp.sec + stamp.nanosec * 1e-9


def publish_until(writer, message, condition, what):
    def attempt():
        writer.write(message)
        return condition()

    return peers.until(attempt, what)


def poses(message):
    return {each.child_frame_id: each.transform for each in message.transforms}


def test_moving_the_robot():
    with peers.running(peers.fortress("tutorials/moving_robot.sdf"), "--ros2"):
        peer = peers.Peer()
        commands = peer.writer("/cmd_vel", Twist)
        odometry = peer.reader("/model/vehicle_blue/odometry", Odometry)
        transforms = peer.reader("/model/vehicle_blue/tf", TFMessage)
        truth = peer.reader("/world/Moving_robot/dynamic_pose/info", TFMessage)
        command = Twist(linear=Vector3(x=0.5), angular=Vector3(z=0.05))
        moving = publish_until(
            commands, command,
            lambda: [each for each in peers.take(odometry) if each.twist.twist.linear.x > 0.49], "a robot that drives")[0]
        assert moving.header.frame_id == "vehicle_blue/odom"
        assert moving.child_frame_id == "vehicle_blue/chassis"
        assert moving.twist.twist.angular.z == pytest.approx(0.05, abs=0.01)

        # it drives as far as odometry reports, and the transform agrees
        far = peers.take_one(odometry, where=lambda each: each.pose.pose.position.x > 1)
        told, seen = {}, {}

        def both_said():
            """What the transform says and where it is, at times that lie beside each other, when it had come so far."""
            for reader, to in ((transforms, told), (truth, seen)):
                to.update((seconds(each.transforms[0].header.stamp), each) for each in peers.take(reader))
            return [(told[at], seen[then]) for at in told if at >= seconds(far.header.stamp)
                    for then in seen if abs(then - at) <= 0.02]

        same, place = peers.until(both_said, "the transform and the truth of a time")[0]
        assert same.transforms[0].header.frame_id == "vehicle_blue/odom"
        assert same.transforms[0].child_frame_id == "vehicle_blue/chassis"
        assert same.transforms[0].transform.translation.x >= far.pose.pose.position.x
        assert poses(place)["vehicle_blue"].translation.x == pytest.approx(
            same.transforms[0].transform.translation.x, abs=0.1)


def test_moving_the_robot_by_the_keys_of_the_tutorial():
    with peers.running(peers.fortress("tutorials/moving_robot.sdf"), "--ros2"):
        peer = peers.Peer()
        keys = peer.writer("/keyboard/keypress", Int32)
        commands = peer.reader("/cmd_vel", Twist)
        odometry = peer.reader("/model/vehicle_blue/odometry", Odometry)
        up = 16777235
        # messages that a system publishes in response arrive, too
        publish_until(keys, Int32(data=up), lambda: [each for each in peers.take(commands) if each.linear.x == 0.5],
                      "the command of the key")
        peers.take_one(odometry, where=lambda each: each.twist.twist.linear.x > 0.45)


def points(cloud):
    """The points of a cloud in the sensor's frame [m]."""
    offsets = {each.name: each.offset for each in cloud.fields}
    data = bytes(cloud.data)
    for i in range(cloud.width * cloud.height):
        yield tuple(struct.unpack_from("<f", data, i * cloud.point_step + offsets[name])[0] for name in "xyz")


def test_sensors():
    with peers.running(peers.fortress("tutorials/sensor_tutorial.sdf"), "--ros2"):
        peer = peers.Peer()
        scans, clouds = peer.reader("/lidar", LaserScan), peer.reader("/lidar/points", PointCloud2)
        imu = peer.reader("/imu", Imu)
        touches = peer.reader("/wall/touched", Bool)
        contacts = peer.reader("/world/sensor_world/model/wall/link/box/sensor/sensor_contact/contact", Contacts)
        commands = peer.writer("/cmd_vel", Twist)

        # the robot falls 0.6 m at the start, and rests from then on
        still = peers.take_one(imu, where=lambda each: each.header.stamp.sec >= 2)
        assert still.header.frame_id == "vehicle_blue/chassis/imu_sensor"
        assert still.linear_acceleration.z == pytest.approx(9.8, abs=0.05)

        # the near face of the wall is 3.45 m in front of the lidar
        scan = peers.take_one(scans, where=lambda each: each.header.stamp.sec >= 2)
        assert scan.header.frame_id == "vehicle_blue/chassis/gpu_lidar"
        assert len(scan.ranges) == 640
        assert scan.ranges[320] == pytest.approx(3.45, abs=0.02)
        cloud = peers.take_one(clouds, where=lambda each: each.header.stamp.sec >= 2)
        assert cloud.header.frame_id == scan.header.frame_id
        assert (cloud.width, cloud.height) == (640, 1)
        met = [point for point in points(cloud) if math.isfinite(point[0])]
        assert len(met) > 300
        for x, _, z in met:
            assert x == pytest.approx(3.45, abs=0.03) and z == pytest.approx(0, abs=1e-3)

        # into the wall, which reports it and stops the robot
        publish_until(commands, Twist(linear=Vector3(x=2.0)), lambda: peers.take(touches), "a wall that is touched")
        contact = peers.take_one(contacts).contacts[0]
        assert "wall" in contact.collision1.name + contact.collision2.name
        assert "vehicle_blue" in contact.collision1.name + contact.collision2.name


def test_this_projects_world_has_a_camera_too():
    with peers.running(peers.ROOT / "worlds/pong_lidar.sdf", "--ros2"):
        peer = peers.Peer()
        images, infos = peer.reader("/camera", Image), peer.reader("/camera_info", CameraInfo)
        info = peers.take_one(infos)
        assert (info.width, info.height) == (320, 240)
        assert info.k[0] == pytest.approx(160 / math.tan(0.6))
        image = peers.take_one(images)
        assert (image.width, image.height, image.step, image.encoding) == (320, 240, 960, "rgb8")
        assert len(image.data) == 320 * 240 * 3
        assert image.header.frame_id == info.header.frame_id == "pong_bot/chassis/camera"
        # sky above, ground below
        assert image.data[:3] != image.data[-3:]


def test_building_a_robot():
    for world in (peers.ROOT / "worlds/building_robot.sdf", peers.fortress("tutorials/building_robot.sdf")):
        with peers.running(world, "--ros2"):
            clock = peers.Peer().reader("/clock", Clock)
            first = peers.take_one(clock)
            assert seconds(peers.take_one(clock).clock) > seconds(first.clock)


def test_a_command_of_another_type_is_said_and_not_obeyed(tmp_path):
    with open(tmp_path / "log", "w") as log, peers.running(peers.ROOT / "worlds/pong_world.sdf", "--ros2", log=log):
        peer, other = peers.Peer(), peers.Peer()
        wrong = peer.writer("/cmd_vel", String)
        stamped = other.writer("/cmd_vel", TwistStamped)
        right = peers.Peer().writer("/cmd_vel", Twist)
        odometry = peer.reader("/model/pong_bot/odometry", Odometry)

        def said():
            wrong.write(String(data="go"))
            stamped.write(TwistStamped())
            text = (tmp_path / "log").read_text()
            return "std_msgs/msg/String" in text and "TwistStamped" in text and text

        text = peers.until(said, "a warning")
        assert ("a node publishes '/cmd_vel' as std_msgs/msg/String, which is geometry_msgs/msg/Twist here: no messages "
                "arrive") in text
        assert "--ros2-topic '/cmd_vel@geometry_msgs/msg/TwistStamped@ignition.msgs.Twist' bridges that type" in text
        # a correct publisher is obeyed, and no warning is repeated
        publish_until(right, Twist(linear=Vector3(x=0.5)),
                      lambda: [each for each in peers.take(odometry) if each.twist.twist.linear.x > 0.4], "a drive")
    assert (tmp_path / "log").read_text().count("a node publishes") == 2


def test_a_reader_that_asks_for_more_is_told(tmp_path):
    with open(tmp_path / "log", "w") as log, peers.running(peers.ROOT / "worlds/pong_lidar.sdf", "--ros2", log=log):
        reader = peers.Peer().reader("/lidar", LaserScan, peers.LATCHED)
        peers.until(lambda: "a node subscribes to '/lidar' as transient local, but it is published as not transient local: it receives no messages"
                    in (tmp_path / "log").read_text(), "a warning")
        assert not peers.take(reader)


def test_another_domain_is_another_world(tmp_path):
    log_file = tmp_path / "log"
    other = peers.take_domain()
    world = peers.ROOT / "worlds/pong_world.sdf"
    with open(log_file, "w") as log, peers.running(world, "--ros2", "-v", "3", log=log):
        stranger = peers.Peer(other).reader("/clock", Clock)
        assert peers.take_one(peers.Peer().reader("/clock", Clock))
        # as long again
        for _ in range(3):
            peers.take_one(peers.Peer().reader("/clock", Clock))
        assert not peers.take(stranger)
    # users need to know its domain
    assert f"node '/pongsim' in domain {peers.DOMAIN}\n" in log_file.read_text()
