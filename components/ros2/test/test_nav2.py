"""worlds/ros2_nav2.sdf has what Nav2 asks for: topics, types, frames, rates; and where the lidar says that walls are, there
they are."""

import collections
import re
import xml.etree.ElementTree as xml

import numpy as np
import peers
import pytest
import ros_messages
from house import WORLD, House
from tf_tree import TfTree, matrix, nanoseconds

ros_messages.install()

from geometry_msgs.msg import Twist, TwistStamped, Vector3  # noqa: E402
from nav_msgs.msg import Odometry  # noqa: E402
from rosgraph_msgs.msg import Clock  # noqa: E402
from sensor_msgs.msg import CameraInfo, Image, Imu, JointState, LaserScan  # noqa: E402
from std_msgs.msg import String  # noqa: E402

MANY = peers.Qos(peers.Policy.Reliability.Reliable(peers.duration(seconds=1)), peers.Policy.History.KeepLast(1000))


def test_the_frames_of_the_robot_are_one_tree():
    with peers.running(WORLD, "--ros2"):
        peer = peers.Peer()
        tree = TfTree(peer)

        def connected():
            tree.update()
            return all(tree.chain(frame)[-1] == "odom"
                       for frame in ("base_scan", "imu_link", "camera_optical_frame", "left_wheel", "right_wheel"))

        peers.until(connected, "a tree below odom")
        assert tree.chain("base_scan") == ["base_scan", "base_link", "base_footprint", "odom"]
        # the description has the same frames as tf, and the same joints as /joint_states
        robot = xml.fromstring(peers.take_one(peer.reader("/robot_description", String, peers.LATCHED)).data)
        links = {link.get("name") for link in robot.findall("link")}
        peers.until(lambda: tree.update() or links <= tree.parents.keys(), "a transform for each link")
        assert links == tree.parents.keys()
        joints = peers.take_one(peer.reader("/joint_states", JointState))
        assert list(joints.name) == [joint.get("name") for joint in robot.findall("joint")
                                     if joint.get("type") != "fixed"]
        # an optical frame has z ahead and x to the right
        peers.until(lambda: tree.update() or tree.moving, "a transform that moves")
        time = tree.known_until("camera_optical_frame")
        R = tree.lookup("camera_optical_frame", "base_link", time)[:3, :3]
        assert R @ [0, 0, 1] == pytest.approx([1, 0, 0], abs=1e-6)
        assert R @ [1, 0, 0] == pytest.approx([0, -1, 0], abs=1e-6)


def test_a_node_that_comes_late_has_the_frames_that_do_not_move():
    with peers.running(WORLD, "--ros2"):
        peers.take_one(peers.Peer().reader("/clock", Clock), where=lambda each: each.clock.sec >= 1)
        tree = TfTree(peers.Peer())
        frames = {"base_link", "base_scan", "imu_link", "camera_link", "camera_optical_frame"}
        peers.until(lambda: tree.update() or frames <= tree.static.keys(), "the frames that do not move")


def test_messages_come_as_often_as_the_robot_says():
    topics = {"/scan": (LaserScan, 10, "base_scan"), "/odom": (Odometry, 50, "odom"), "/imu": (Imu, 100, "imu_link"),
              "/camera/image_raw": (Image, 10, "camera_optical_frame"),
              "/camera/camera_info": (CameraInfo, 10, "camera_optical_frame")}
    with peers.running(WORLD, "--ros2"):
        peer = peers.Peer()
        readers = {topic: peer.reader(topic, kind, MANY) for topic, (kind, _, _) in topics.items()}
        stamps = collections.defaultdict(list)

        def enough():
            for topic, reader in readers.items():
                for message in peers.take(reader):
                    assert message.header.frame_id == topics[topic][2], topic
                    stamps[topic].append(nanoseconds(message.header.stamp))
            return all(len(stamps[topic]) > 10 for topic in topics)

        peers.until(enough, "ten messages of each")
        # in simulated time, whatever the pace
        for topic, (_, rate, _) in topics.items():
            gaps = collections.Counter(np.diff(stamps[topic])).most_common(1)[0]
            assert gaps[0] == 10**9 // rate, topic


def test_what_the_lidar_sees_falls_on_the_walls_while_the_robot_drives_and_turns():
    house = House()
    # speeds as Nav2 commands them, for so many simulated seconds
    plan = [(0.26, 0.0, 3), (0.0, 1.0, 4), (0.2, 0.6, 4), (0.26, -0.4, 4), (-0.15, 0.0, 2)]
    with peers.running(WORLD, "--ros2", "-z", "2000"):
        peer = peers.Peer()
        tree = TfTree(peer)
        scans, odometry = peer.reader("/scan", LaserScan, MANY), peer.reader("/odom", Odometry, MANY)
        commands = peer.writer("/cmd_vel", Twist)
        waiting, odometries, checked, farthest, path = [], [], 0, 0.0, []
        for speed, turn, span in plan:
            begin = None

            def passed():
                nonlocal begin, checked, farthest
                commands.write(Twist(linear=Vector3(x=speed), angular=Vector3(z=turn)))
                tree.update()
                waiting.extend(peers.take(scans))
                odometries.extend(peers.take(odometry))
                known = tree.known_until("base_scan") if "base_scan" in tree.parents and tree.moving else None
                first = tree.moving["base_footprint"][0][0] if "base_footprint" in tree.moving else None
                while known and waiting and nanoseconds(waiting[0].header.stamp) <= known:
                    scan = waiting.pop(0)
                    time = nanoseconds(scan.header.stamp)
                    # a reader without processor time has lost transforms, and interpolation over gaps is not exact
                    if time < first or tree.gap("base_scan", "odom", time) > 30_000_000:
                        continue
                    points = in_odom(scan, tree.lookup("base_scan", "odom", time))
                    on_ground = (house.start @ points.T).T
                    away = house.distance(on_ground[:, :2])
                    assert len(away) > 300
                    assert away.max() < 0.02, f"at {time * 1e-9} s, {points[away.argmax()]}"
                    assert points[:, 2] == pytest.approx(0.18, abs=0.01)
                    checked += 1
                    path.append(tree.lookup("base_footprint", "odom", time))
                if odometries and begin is None:
                    begin = nanoseconds(odometries[-1].header.stamp)
                return begin is not None and odometries and nanoseconds(
                    odometries[-1].header.stamp) > begin + span * 10**9

            peers.until(passed, f"{span} s of simulated time")
    assert checked > 100
    # it has driven about, and turned all round
    ways = np.array([each[:2, 3] for each in path])
    assert np.linalg.norm(np.diff(ways, axis=0), axis=1).sum() > 2
    # odometry and transforms agree
    times, transforms = tree.moving["base_footprint"]
    told = {time: matrix(each.translation, each.rotation) for time, each in zip(times, transforms)}
    same = [each for each in odometries if nanoseconds(each.header.stamp) in told]
    assert len(same) > 100
    for each in same:
        assert each.child_frame_id == "base_footprint"
        pose = matrix(each.pose.pose.position, each.pose.pose.orientation)
        assert told[nanoseconds(each.header.stamp)] == pytest.approx(pose, abs=1e-9)


def test_nav2_of_kilted_drives_by_stamped_commands_where_a_rule_says_so():
    rule = "/cmd_vel@geometry_msgs/msg/TwistStamped@ignition.msgs.Twist"
    with peers.running(WORLD, "--ros2-topic", rule):
        peer = peers.Peer()
        commands, odometry = peer.writer("/cmd_vel", TwistStamped), peer.reader("/odom", Odometry)

        def drives():
            commands.write(TwistStamped(twist=Twist(linear=Vector3(x=0.2))))
            return [each for each in peers.take(odometry) if each.twist.twist.linear.x > 0.19]

        peers.until(drives, "a robot that drives")


def rover_with_names_of_ros(folder, prefix):
    """drive.sdf as users of ros_gz write robots: frames by their names in ROS, a lidar above the link that is for it."""
    text = (peers.ROOT / "components/ros2/test/drive.sdf").read_text().replace("chassis", "base_link")
    lidar = re.search(r'<sensor name="lidar".*?</sensor>', text, re.DOTALL).group()
    own_link = (f'<link name="base_scan"><pose>0.1 0 0 0 0 0</pose>{lidar}</link><joint name="scan_joint" type="fixed">'
                "<parent>base_link</parent><child>base_scan</child></joint>")
    own_link = own_link.replace("<topic>lidar", f"<frame_id>{prefix}base_scan</frame_id><topic>scan")
    imu = (f'<sensor name="imu" type="imu"><topic>imu</topic><gz_frame_id>{prefix}base_link</gz_frame_id><imu>'
           '<angular_velocity><z><noise type="gaussian"><stddev>0.5</stddev></noise></z></angular_velocity></imu></sensor>')
    odometry = (f"<odom_topic>odom</odom_topic><frame_id>{prefix}odom</frame_id>"
                f"<child_frame_id>{prefix}base_link</child_frame_id>")
    text = text.replace(lidar, imu).replace('<link name="left_wheel">', own_link + '<link name="left_wheel">')
    text = text.replace("<topic>cmd_vel", odometry + "<topic>cmd_vel").replace(
        '<plugin filename="pongsim-ros2',
        '<plugin filename="gz-sim-imu-system" name="gz::sim::systems::Imu"/><plugin filename="pongsim-ros2')
    world = folder / "rover.sdf"
    world.write_text(text)
    return world


@pytest.mark.parametrize("prefix", ["", "robot1/"])
def test_a_robot_in_sdf_has_the_frames_that_its_file_names(tmp_path, prefix):
    with peers.running(rover_with_names_of_ros(tmp_path, prefix)):
        peer = peers.Peer()
        tree = TfTree(peer)
        scans, imu, odometry = (peer.reader(topic, kind, MANY) for topic, kind in
                                (("/scan", LaserScan), ("/imu", Imu), ("/odom", Odometry)))
        frame, root = f"{prefix}base_scan", f"{prefix}odom"
        waiting, checked = [], 0

        def placed():
            nonlocal checked
            tree.update()
            waiting.extend(peers.take(scans))
            known = tree.known_until(frame) if tree.moving and frame in tree.parents else None
            while known and waiting and nanoseconds(waiting[0].header.stamp) <= known:
                scan = waiting.pop(0)
                assert scan.header.frame_id == frame
                if nanoseconds(scan.header.stamp) < tree.moving[f"{prefix}base_link"][0][0]:
                    continue
                points = in_odom(scan, tree.lookup(frame, root, nanoseconds(scan.header.stamp)))
                # the face of the wall, and the lidar's place on the robot
                assert points[:, 0] == pytest.approx(4.9, abs=0.02)
                assert points[:, 2] == pytest.approx(0.2, abs=0.02)
                checked += 1
            return checked > 5

        peers.until(placed, "scans with their transforms")
        assert tree.chain(frame)[-2:] == [f"{prefix}base_link", root]
        # one tree
        assert {tree.chain(each)[-1] for each in tree.parents} == {root}
        assert peers.take_one(odometry).child_frame_id == f"{prefix}base_link"
        reading = peers.take_one(imu)
        assert reading.header.frame_id == f"{prefix}base_link"
        assert list(reading.angular_velocity_covariance) == [0, 0, 0, 0, 0, 0, 0, 0, 0.25]
        assert reading.orientation_covariance[0] == 0


def in_odom(scan, X_odom_scan):
    """The points of a scan, [n x 4] with ones."""
    ranges = np.array(scan.ranges)
    angles = scan.angle_min + scan.angle_increment * np.arange(len(ranges))
    met = np.isfinite(ranges)
    points = np.stack([ranges * np.cos(angles), ranges * np.sin(angles), np.zeros(len(ranges)), np.ones(len(ranges))])
    return (X_odom_scan @ points[:, met]).T
