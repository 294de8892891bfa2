"""pongsim's MCAP files, read by readers from PyPI, and theirs, read by pongsim."""

import csv
import io
import json
import shutil
import sqlite3
import sys
import unittest

from google.protobuf import json_format
from mcap.reader import NonSeekingReader, make_reader
from mcap.writer import CompressionType, Writer
from mcap_protobuf.decoder import DecoderFactory
from place import FORTRESS, Place


def messages(file, topics=None):
    """All messages of a file, read with the index and the checksums."""
    with open(file, "rb") as stream:
        reader = make_reader(stream, validate_crcs=True, decoder_factories=[DecoderFactory()])
        return [(channel.topic, schema.name, message.log_time, message.data, decoded)
                for schema, channel, message, decoded in reader.iter_decoded_messages(topics=topics)]


def size_of(path):
    return path.stat().st_size if path.exists() else 0


class Recorded(unittest.TestCase):
    """A Fortress world, recorded as it runs."""

    @classmethod
    def setUpClass(cls):
        worlds = sorted(FORTRESS.glob("**/diff_drive.sdf"))
        if not worlds:
            print("Fortress's worlds are not here")
            sys.exit(77)
        cls.place = Place().__enter__()
        cls.addClassCleanup(cls.place.__exit__, None, None, None)
        recorder = cls.place.record("-o", "run.mcap")
        # topics that appear later
        cls.place.start("run", worlds[0])
        cls.place.wait_for_messages("run.mcap", {"/clock": 100, "/model/vehicle_green/odometry": 5})
        assert cls.place.end(recorder) == 0, cls.place.said(recorder)
        cls.said = cls.place.said(recorder)
        cls.file = cls.place.path / "run.mcap"
        cls.messages = messages(cls.file)

    def test_others_read_it(self):
        types = {topic: kind for topic, kind, *_ in self.messages}
        self.assertEqual(types["/clock"], "ignition.msgs.Clock")
        self.assertEqual(types["/model/vehicle_green/odometry"], "ignition.msgs.Odometry")
        clocks = [decoded.sim.sec + decoded.sim.nsec * 1e-9 for topic, _, _, _, decoded in self.messages
                  if topic == "/clock"]
        self.assertGreater(len(clocks), 50)
        self.assertEqual(clocks, sorted(clocks))
        with open(self.file, "rb") as stream:
            summary = make_reader(stream).get_summary()
        self.assertEqual(summary.statistics.message_count, len(self.messages))
        self.assertEqual(len(summary.chunk_indexes), summary.statistics.chunk_count)
        self.assertGreater(len(summary.chunk_indexes), 0)
        self.assertIn(f"{len(self.messages)} messages of {len(types)} topics in run.mcap", self.said)

    def test_it_reads_without_the_index_too(self):
        with open(self.file, "rb") as stream:
            count = sum(1 for _ in NonSeekingReader(stream, validate_crcs=True).iter_messages(log_time_order=False))
        self.assertEqual(count, len(self.messages))

    def test_info_tells_of_it(self):
        info = json.loads(self.place.log("info", "run.mcap", "--json"))
        self.assertEqual(info["messages"], len(self.messages))
        self.assertEqual(info["compression"], "zstd")
        self.assertIsNone(info["torn"])
        self.assertEqual(info["start_ns"], min(time for _, _, time, _, _ in self.messages))
        counts = {topic["name"]: topic["count"] for topic in info["topics"]}
        for name, count in counts.items():
            self.assertEqual(count, sum(1 for topic, *_ in self.messages if topic == name))
        self.assertRegex(self.place.log("info", "run.mcap"), r"/clock +ignition.msgs.Clock +\d+ +[\d.]+ Hz\n")

    def test_it_packs_otherwise(self):
        sizes = {}
        for name in ("zstd", "lz4", "none"):
            self.place.log("convert", "run.mcap", "-o", f"{name}.mcap", "--compression", name, "--force")
            self.assertEqual([each[:4] for each in messages(self.place.path / f"{name}.mcap")],
                             [each[:4] for each in self.messages])
            sizes[name] = size_of(self.place.path / f"{name}.mcap")
        self.assertLess(sizes["zstd"], sizes["none"] / 2)
        self.assertLess(sizes["lz4"], sizes["none"])

    def test_it_becomes_a_tlog_and_comes_back(self):
        self.place.log("convert", "run.mcap", "-o", "run.tlog", "--force")
        with sqlite3.connect(self.place.path / "run.tlog") as database:
            rows = database.execute(
                "SELECT topics.name, message_types.name, time_recv, message FROM messages"
                " JOIN topics ON topics.id = messages.topic_id"
                " JOIN message_types ON message_types.id = topics.message_type_id ORDER BY time_recv").fetchall()
        self.assertEqual(sorted((topic, kind, time, bytes(data)) for topic, kind, time, data in rows),
                         sorted(each[:4] for each in self.messages))
        self.place.log("convert", "run.tlog", "-o", "back.mcap", "--force")
        self.assertEqual(sorted(each[:4] for each in messages(self.place.path / "back.mcap")),
                         sorted(each[:4] for each in self.messages))

    def test_values_are_exported_as_a_table(self):
        topic = "/model/vehicle_green/odometry"
        text = self.place.log("export", "run.mcap", topic, "twist.linear.x", "pose.position.x", "--csv")
        rows = list(csv.reader(io.StringIO(text)))
        wanted = [(time, decoded) for name, _, time, _, decoded in self.messages if name == topic]
        self.assertEqual(rows[0], ["time_s", "twist.linear.x", "pose.position.x"])
        self.assertEqual(len(rows) - 1, len(wanted))
        for row, (time, decoded) in zip(rows[1:], wanted):
            self.assertEqual(int(row[0].replace(".", "")), time)
            self.assertEqual(float(row[1]), decoded.twist.linear.x)
            self.assertEqual(float(row[2]), decoded.pose.position.x)

    def test_messages_are_exported_as_json(self):
        lines = [json.loads(line) for line in self.place.log("export", "run.mcap", "/clock").splitlines()]
        wanted = [json_format.MessageToDict(decoded) for topic, _, _, _, decoded in self.messages if topic == "/clock"]
        self.assertEqual([line["message"] for line in lines], wanted)
        everything = self.place.log("export", "run.mcap").splitlines()
        self.assertEqual(len(everything), len(self.messages))

    def test_a_cut_off_file_is_read_up_to_there(self):
        self.place.cut("run.mcap", "cut.mcap")
        info = json.loads(self.place.log("info", "cut.mcap", "--json"))
        self.assertRegex(info["torn"], r"'cut.mcap': byte \d+: it is truncated")
        self.place.log("convert", "cut.mcap", "-o", "saved.mcap", "--force")
        saved = messages(self.place.path / "saved.mcap")
        self.assertGreater(len(saved), 0)
        self.assertEqual(len(saved), info["messages"])
        everything = {each[:4] for each in self.messages}
        self.assertTrue(all(each[:4] in everything for each in saved))

    def test_mistakes_are_said(self):
        self.assertIn("did you mean '/clock'?", self.place.log("export", "run.mcap", "/clok", code=1))
        self.assertIn("field 'simm' is not in ignition.msgs.Clock\n  hint: did you mean 'sim'?",
                      self.place.log("export", "run.mcap", "/clock", "simm", "--csv", code=1))
        (self.place.path / "text.mcap").write_text("I am not a log at all\n")
        self.assertIn("it is not an MCAP file", self.place.log("info", "text.mcap", code=1))
        self.assertIn("No such file", self.place.log("info", "nothing.mcap", code=1))
        self.assertIn("already exists", self.place.log("convert", "run.mcap", "-o", "text.mcap", code=1))
        self.assertIn("is also the input", self.place.log("convert", "run.mcap", "-o", "run.mcap", "--force", code=2))
        self.assertIn("must end in .mcap or .tlog", self.place.log("convert", "run.mcap", "-o", "run.bag", code=2))
        self.assertIn("'brotli' is not a compression",
                      self.place.log("convert", "run.mcap", "-o", "x.mcap", "--compression", "brotli", code=2))
        self.assertIn("unknown action 'inof'", self.place.log("inof", code=2))
        self.assertIn("neither a topic nor a regular expression", self.place.log("record", "-o", "x.mcap", "/a(", code=2))
        self.assertEqual([each.name for each in self.place.path.glob("x*")], [])
        # a chunk in the middle: its position is reported, and no partial file is left
        damaged = bytearray(self.file.read_bytes())
        with open(self.file, "rb") as stream:
            chunk = make_reader(stream).get_summary().chunk_indexes[0]
        damaged[chunk.chunk_start_offset + chunk.chunk_length // 2] ^= 0xFF
        (self.place.path / "damaged.mcap").write_bytes(damaged)
        self.assertRegex(self.place.log("convert", "damaged.mcap", "-o", "y.mcap", code=1), r"byte \d+: the chunk is damaged")
        self.assertEqual([each.name for each in self.place.path.glob("y*")], [])


class OfOthers(unittest.TestCase):
    def test_a_file_of_another_writer_is_read(self):
        with Place() as place:
            for compression in CompressionType:
                for chunking in (True, False):
                    with open(place.path / "other.mcap", "wb") as stream:
                        writer = Writer(stream, compression=compression, use_chunking=chunking, chunk_size=500)
                        writer.start("", "another program")
                        schema = writer.register_schema("a.B", "jsonschema", b"{}")
                        channel = writer.register_channel("/a", "json", schema)
                        bare = writer.register_channel("/bare", "json", 0)
                        for i in range(200):
                            writer.add_message(channel, i, b'{"x": 1}', i)
                            writer.add_message(bare, i, b'{}', i)
                        writer.add_attachment(0, 0, "a.txt", "text/plain", b"hello")
                        writer.finish()
                    info = json.loads(place.log("info", "other.mcap", "--json"))
                    self.assertEqual([(each["name"], each["type"], each["count"]) for each in info["topics"]],
                                     [("/a", "a.B", 200), ("/bare", "", 200)])
                    self.assertIn("encoding is 'json'", place.log("export", "other.mcap", "/a", code=1))
                    self.assertIn("can't be written to a tlog", place.log("convert", "other.mcap", "-o", "a.tlog", code=1))
                    place.log("convert", "other.mcap", "-o", "again.mcap", "--force")
                    with open(place.path / "again.mcap", "rb") as stream:
                        read = [(channel.topic, schema and schema.name, message.log_time, message.data)
                                for schema, channel, message in make_reader(stream, validate_crcs=True).iter_messages()]
                    self.assertEqual(len(read), 400)
                    self.assertIn(("/bare", None, 7, b"{}"), read)
                    self.assertIn(("/a", "a.B", 7, b'{"x": 1}'), read)

    def test_a_bag_of_ros_stays_one(self):
        from rosbags.highlevel import AnyReader
        from rosbags.rosbag2 import StoragePlugin
        from rosbags.rosbag2 import Writer as BagWriter
        from rosbags.typesys import Stores, get_typestore
        import pathlib

        store = get_typestore(Stores.ROS2_HUMBLE)
        text = store.types["std_msgs/msg/String"]
        with Place() as place:
            bag = place.path / "bag"
            with BagWriter(bag, version=9, storage_plugin=StoragePlugin.MCAP) as writer:
                connection = writer.add_connection("/chatter", "std_msgs/msg/String", typestore=store)
                for i in range(50):
                    writer.write(connection, i * 1000, store.serialize_cdr(text(f"hello {i}"), "std_msgs/msg/String"))
            file = next(bag.glob("*.mcap"))
            info = json.loads(place.log("info", file, "--json"))
            self.assertEqual(info["profile"], "ros2")
            self.assertEqual(info["topics"][0]["type"], "std_msgs/msg/String")
            place.log("convert", file, "-o", "lz4.mcap", "--compression", "lz4")
            shutil.move(place.path / "lz4.mcap", file)
            with AnyReader([pathlib.Path(bag)]) as reader:
                read = [reader.deserialize(data, connection.msgtype).data for connection, _, data in reader.messages()]
            self.assertEqual(read, [f"hello {i}" for i in range(50)])


if __name__ == "__main__":
    unittest.main()
