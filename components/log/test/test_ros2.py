"""Recordings of ROS 2 messages: rosbags reads the same content as in a plain recording."""

import json
import math
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import unittest

from mcap.reader import make_reader
from mcap_protobuf.decoder import DecoderFactory
from place import FORTRESS, PATIENCE, PONGSIM, ROOT, Place, until
from rosbags.highlevel import AnyReader
from rosbags.interfaces import QosDurability, QosReliability

GOLDEN = FORTRESS.parent / "golden/log/double_pendulum.tlog"
CAMERA, SCAN, IMU, ODOMETRY = "/camera/image_raw", "/scan", "/imu", "/odom"
TYPES = {CAMERA: "sensor_msgs/msg/Image", SCAN: "sensor_msgs/msg/LaserScan", IMU: "sensor_msgs/msg/Imu",
         ODOMETRY: "nav_msgs/msg/Odometry", "/clock": "rosgraph_msgs/msg/Clock",
         "/camera/camera_info": "sensor_msgs/msg/CameraInfo"}


def plain(file):
    """(topic, time, message) of a recording in protobuf."""
    with open(file, "rb") as stream:
        reader = make_reader(stream, decoder_factories=[DecoderFactory()])
        return [(channel.topic, message.log_time, decoded)
                for _, channel, message, decoded in reader.iter_decoded_messages()]


def of_ros(file):
    """(topic, type, time, message, payload) of a ROS recording, each message read with the definition in the file."""
    with AnyReader([pathlib.Path(file)]) as reader:
        return [(connection.topic, connection.msgtype, time, reader.deserialize(data, connection.msgtype), bytes(data))
                for connection, time, data in reader.messages()]


def stamp(header):
    return header.stamp.sec, getattr(header.stamp, "nanosec", getattr(header.stamp, "nsec", None))


def three(vector):
    return [vector.x, vector.y, vector.z]


def four(rotation):
    return [rotation.x, rotation.y, rotation.z, rotation.w]


def frame_of(header, key="frame_id"):
    return next((entry.value[0] for entry in header.data if entry.key == key), "").replace("::", "/")


class Robot(unittest.TestCase):
    """A robot with lidar, camera, IMU and odometry, recorded plainly and as ROS messages."""

    @classmethod
    def setUpClass(cls):
        cls.place = Place().__enter__()
        cls.addClassCleanup(cls.place.__exit__, None, None, None)
        bag = cls.place.record("-o", "bag.mcap", "--ros2")
        also = cls.place.record("-o", "plain.mcap", ".*(scan|camera|imu|odom|clock|stats|tf).*")
        # topics that appear later
        cls.place.start("run", ROOT / "worlds/ros2_nav2.sdf")

        of_all = dict.fromkeys(TYPES, 4)
        cls.place.wait_for_messages("plain.mcap", of_all)
        cls.place.wait_for_messages("bag.mcap", {**of_all, ODOMETRY: 10, "/tf": 10})
        until(lambda: "'/stats' is left out" in cls.place.said(bag), "a warning")
        for recorder in (bag, also):
            assert cls.place.end(recorder) == 0, cls.place.said(recorder)
        cls.said = cls.place.said(bag)
        cls.live = of_ros(cls.place.path / "bag.mcap")
        # the same messages
        cls.place.log("convert", "plain.mcap", "-o", "same.mcap", "--ros2")
        cls.plain = plain(cls.place.path / "plain.mcap")
        cls.same = of_ros(cls.place.path / "same.mcap")

    def pairs(self, topic):
        """Each message of the plain recording, with its ROS counterpart."""
        before = [(time, message) for name, time, message in self.plain if name == topic]
        after = [(time, message) for name, _, time, message, _ in self.same if name == topic]
        self.assertEqual([time for time, _ in before], [time for time, _ in after])
        self.assertGreaterEqual(len(before), 4)
        return [(one, other) for (_, one), (_, other) in zip(before, after)]

    def test_types_and_names_are_those_of_ros(self):
        for messages in (self.live, self.same):
            types = {topic: kind for topic, kind, *_ in messages}
            for topic, kind in TYPES.items():
                self.assertEqual(types[topic], kind)

    def test_a_live_recording_has_the_same_payloads(self):
        payloads = {topic: {data for name, _, _, _, data in self.same if name == topic} for topic in TYPES}
        for topic in TYPES:
            live = [data for name, _, _, _, data in self.live if name == topic]
            # messages before or after the other recorder's are in one file only
            self.assertGreaterEqual(sum(data in payloads[topic] for data in live), 3, topic)
        # one stamp, one payload
        stamps = {(topic, stamp(message.header)): data for topic, _, _, message, data in self.same
                  if topic in TYPES and hasattr(message, "header")}
        for topic, _, _, message, data in self.live:
            if topic in TYPES and hasattr(message, "header"):
                self.assertEqual(stamps.get((topic, stamp(message.header)), data), data, topic)

    def test_scans_have_their_values(self):
        for one, other in self.pairs(SCAN):
            self.assertEqual(stamp(other.header), stamp(one.header))
            self.assertEqual(other.header.frame_id, one.frame.replace("::", "/"))
            self.assertEqual(len(other.ranges), 360)
            self.assertTrue(all(a == b or math.isclose(a, b, rel_tol=1e-6)
                                for a, b in zip(other.ranges.tolist(), one.ranges)))
            self.assertAlmostEqual(other.angle_min, one.angle_min, places=6)
            self.assertAlmostEqual(other.range_max, one.range_max, places=5)

    def test_pictures_have_their_pixels(self):
        for one, other in self.pairs(CAMERA):
            self.assertEqual(stamp(other.header), stamp(one.header))
            self.assertEqual((other.width, other.height, other.step), (one.width, one.height, one.step))
            self.assertEqual(other.encoding, "rgb8")
            self.assertEqual(bytes(other.data), one.data)
        for one, other in self.pairs("/camera/camera_info"):
            self.assertEqual(other.k.tolist(), list(one.intrinsics.k))

    def test_the_imu_has_its_values(self):
        for one, other in self.pairs(IMU):
            self.assertEqual(stamp(other.header), stamp(one.header))
            self.assertEqual(other.header.frame_id, frame_of(one.header))
            self.assertEqual(four(other.orientation), four(one.orientation))
            self.assertEqual(three(other.angular_velocity), three(one.angular_velocity))
            self.assertEqual(three(other.linear_acceleration), three(one.linear_acceleration))

    def test_odometry_and_clock_have_their_values(self):
        for one, other in self.pairs(ODOMETRY):
            self.assertEqual(stamp(other.header), stamp(one.header))
            self.assertEqual((other.header.frame_id, other.child_frame_id), ("odom", "base_footprint"))
            self.assertEqual(three(other.pose.pose.position), three(one.pose.position))
            self.assertEqual(four(other.pose.pose.orientation), four(one.pose.orientation))
            self.assertEqual(three(other.twist.twist.linear), three(one.twist.linear))
            self.assertEqual(three(other.twist.twist.angular), three(one.twist.angular))
        for one, other in self.pairs("/clock"):
            self.assertEqual((other.clock.sec, other.clock.nanosec), (one.sim.sec, one.sim.nsec))

    def test_transforms_have_the_odometry(self):
        transforms = [each for topic, _, _, message, _ in self.live if topic == "/tf" for each in message.transforms]
        poses = {stamp(message.header): three(message.pose.pose.position)
                 for topic, _, _, message, _ in self.live if topic == ODOMETRY}
        self.assertEqual({(each.header.frame_id, each.child_frame_id) for each in transforms},
                         {("odom", "base_footprint")})
        told = [each for each in transforms if stamp(each.header) in poses]
        self.assertGreater(len(told), 4)
        for each in told:
            self.assertEqual(three(each.transform.translation), poses[stamp(each.header)])

    def test_schemas_and_channels_are_as_bags_have_them(self):
        with open(self.place.path / "bag.mcap", "rb") as stream:
            reader = make_reader(stream, validate_crcs=True)
            self.assertEqual(reader.get_header().profile, "ros2")
            summary = reader.get_summary()
        by_name = {schema.name: schema for schema in summary.schemas.values()}
        for kind in TYPES.values():
            self.assertEqual(by_name[kind].encoding, "ros2msg")
        self.assertIn("\n" + "=" * 80 + "\nMSG: std_msgs/Header\n", by_name["sensor_msgs/msg/LaserScan"].data.decode())
        for channel in summary.channels.values():
            self.assertEqual(channel.message_encoding, "cdr")
            self.assertEqual(set(channel.metadata), {"offered_qos_profiles", "topic_type_hash"})
        with AnyReader([self.place.path / "bag.mcap"]) as reader:
            for connection in reader.connections:
                quality, = connection.ext.offered_qos_profiles
                self.assertEqual((quality.reliability, quality.durability),
                                 (QosReliability.RELIABLE, QosDurability.VOLATILE))
                self.assertEqual(quality.depth, 100 if connection.msgtype == "tf2_msgs/msg/TFMessage" else 10)

    def test_what_has_no_partner_is_said_once(self):
        self.assertEqual(self.said.count("'/stats' is left out: ignition.msgs.WorldStatistics has no counterpart in ROS"), 1)
        self.assertNotIn("/stats", {topic for topic, *_ in self.live})
        messages = len(self.live)
        topics = len({topic for topic, *_ in self.live})
        self.assertIn(f"{messages} messages of {topics} topics in bag.mcap", self.said)

    def test_info_tells_of_it(self):
        told = self.place.log("info", "bag.mcap")
        self.assertIn("profile:     ros2", told)
        self.assertRegex(told, r"/scan +sensor_msgs/msg/LaserScan +\d+")

    def test_a_bag_that_was_cut_off_is_saved(self):
        self.place.cut("bag.mcap", "cut.mcap")
        self.place.log("convert", "cut.mcap", "-o", "saved.mcap", "--force")
        saved = of_ros(self.place.path / "saved.mcap")
        self.assertGreater(len(saved), 0)
        everything = {(topic, time, data) for topic, _, time, _, data in self.live}
        self.assertTrue(all((topic, time, data) in everything for topic, _, time, _, data in saved))

    def test_a_configuration_names_topics(self):
        (self.place.path / "bridge.yaml").write_text(
            "- {ros_topic_name: /front, gz_topic_name: /scan, ros_type_name: sensor_msgs/msg/LaserScan,\n"
            "   gz_type_name: ignition.msgs.LaserScan, frame_id: laser, qos_profile: SENSOR_DATA}\n")
        self.place.log("convert", "plain.mcap", "-o", "named.mcap", "--ros2-config", "bridge.yaml", "--topic", "/scan",
                       "--topic", "/imu")
        named = of_ros(self.place.path / "named.mcap")
        self.assertEqual({topic for topic, *_ in named}, {"/front", "/imu"})
        self.assertEqual({message.header.frame_id for topic, _, _, message, _ in named if topic == "/front"}, {"laser"})
        with AnyReader([self.place.path / "named.mcap"]) as reader:
            quality, = next(each for each in reader.connections if each.topic == "/front").ext.offered_qos_profiles
        self.assertEqual(quality.reliability, QosReliability.BEST_EFFORT)
        (self.place.path / "wrong.yaml").write_text("- {topic_name: /scan, ros_type_name: sensor_msgs/msg/LaserScn,\n"
                                                    "   gz_type_name: ignition.msgs.LaserScan}\n")
        said = self.place.log("convert", "plain.mcap", "-o", "x.mcap", "--ros2-config", "wrong.yaml", code=1)
        self.assertRegex(said, r"error: wrong.yaml:1:\d+: 'sensor_msgs/msg/LaserScn' is not a ROS type")
        self.assertIn("hint: did you mean 'sensor_msgs/msg/LaserScan'?", said)
        self.assertIn("nothing.yaml", self.place.log("convert", "plain.mcap", "-o", "x.mcap", "--ros2-config",
                                                     "nothing.yaml", code=1))
        self.assertEqual(list(self.place.path.glob("x*")), [])

    def test_mistakes_are_said(self):
        said = self.place.log("convert", "plain.mcap", "-o", "x.tlog", "--ros2", code=2)
        self.assertIn("'x.tlog' can't contain ROS messages", said)
        self.assertIn("can't contain ROS messages",
                      self.place.log("record", "-o", "x.tlog", "--ros2", "--duration", "0.1", code=2))
        said = self.place.log("convert", "plain.mcap", "-o", "x.mcap", "--ros2", "--topic", "/stats", code=1)
        self.assertIn("no message of 'plain.mcap' can be written as a ROS message", said)
        said = self.place.log("convert", "bag.mcap", "-o", "x.mcap", "--ros2", code=1)
        self.assertIn("'/scan' is left out: its messages are in 'cdr', not in 'protobuf'", said)
        self.assertIn("already exists", self.place.log("convert", "plain.mcap", "-o", "bag.mcap", "--ros2", code=1))
        self.assertEqual(list(self.place.path.glob("x*")), [])

    def test_a_missing_package_is_named(self):
        """An installation without pongsim-ros2."""
        built = pathlib.Path(PONGSIM).parents[1]
        bare = self.place.path / "bare"
        for name in ("bin/pongsim", "libexec/pongsim/pongsim-log", "share/pongsim/extensions/log.json",
                     *(str(each.relative_to(built)) for each in (built / "lib").glob("libpongsim*.so*"))):
            (bare / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(built / name, bare / name)
        done = subprocess.run([bare / "libexec/pongsim/pongsim-log", "record", "--ros2", "-o", "x.mcap"],
                              cwd=self.place.path, env={**os.environ, "LD_LIBRARY_PATH": str(bare / "lib")},
                              capture_output=True, text=True, timeout=PATIENCE)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("is not installed\n  hint: the package pongsim-ros2 has it: apt-get install pongsim-ros2",
                      done.stderr)
        self.assertEqual(list(self.place.path.glob("x*")), [])


class Alone(unittest.TestCase):
    def setUp(self):
        self.place = Place()
        self.place.__enter__()
        self.addCleanup(self.place.__exit__, None, None, None)

    def test_what_was_recorded_outlives_the_recorder(self):
        self.place.start("run", ROOT / "worlds/pong_world.sdf")
        recorder = self.place.record("-o", "a.mcap", "--ros2")
        until(lambda: json.loads(self.place.log("info", "a.mcap", "--json"))["messages"] > 200, "messages")
        self.place.end(recorder, signal.SIGKILL)
        self.place.log("convert", "a.mcap", "-o", "whole.mcap")
        self.assertGreater(len(of_ros(self.place.path / "whole.mcap")), 200)

    def test_a_full_disk_and_topics_without_partners_end_it(self):
        self.place.start("run", ROOT / "worlds/pong_world.sdf")
        (self.place.path / "full.mcap").symlink_to("/dev/full")
        said = self.place.log("record", "-o", "full.mcap", "--force", "--ros2", code=1)
        self.assertIn("'full.mcap' can't be written: No space left on device", said)
        recorder = self.place.record("-o", "none.mcap", "--ros2", "/stats")
        until(lambda: "'/stats' is left out" in self.place.said(recorder), "a warning")
        self.assertEqual(self.place.end(recorder), 1)
        self.assertIn("no message of the recorded topics can be written as a ROS message", self.place.said(recorder))
        # the same command is not refused
        self.assertFalse((self.place.path / "none.mcap").exists())

    def test_a_tlog_of_fortress_becomes_a_bag(self):
        if not GOLDEN.exists():
            self.skipTest("Fortress's recording is not here")
        said = subprocess.run([PONGSIM, "log", "convert", GOLDEN, "-o", "a.mcap", "--ros2"], cwd=self.place.path,
                              capture_output=True, text=True, timeout=PATIENCE, check=True).stderr
        self.assertEqual(said.count("is left out: ignition.msgs.SerializedStateMap has no counterpart in ROS"), 1)
        (topic, kind, _, message, _), = of_ros(self.place.path / "a.mcap")
        self.assertEqual((topic, kind), ("/_ignition/sdf", "std_msgs/msg/String"))
        self.assertIn("<world name='log_pendulum'>", message.data)


if __name__ == "__main__":
    unittest.main()
