"""pongsim log record: ends cleanly, survives being killed, records what is selected."""

import json
import signal
import unittest

from mcap.reader import make_reader
from place import PATIENCE, WORLD, Place, until


def size_of(path):
    return path.stat().st_size if path.exists() else 0


class Record(unittest.TestCase):
    def setUp(self):
        self.place = Place()
        self.place.__enter__()
        self.addCleanup(self.place.__exit__, None, None, None)
        (self.place.path / "world.sdf").write_text(WORLD)
        self.file = self.place.path / "a.mcap"

    def info(self, name="a.mcap"):
        return json.loads(self.place.log("info", name, "--json"))

    def test_a_signal_ends_it_with_a_whole_file(self):
        self.place.start("run", "world.sdf")
        for each in (signal.SIGINT, signal.SIGTERM):
            recorder = self.place.record("-o", "a.mcap", "--force", "/clock")
            until(lambda: self.info()["messages"] > 100, "messages")
            self.assertEqual(self.place.end(recorder, each), 0, self.place.said(recorder))
            info = self.info()
            self.assertIsNone(info["torn"])
            self.assertEqual([topic["name"] for topic in info["topics"]], ["/clock"])

    def test_what_was_recorded_outlives_it(self):
        self.place.start("run", "world.sdf")
        recorder = self.place.record("-o", "a.mcap")
        until(lambda: self.info()["messages"] > 200, "messages")
        before = self.info()["messages"]
        self.place.end(recorder, signal.SIGKILL)
        info = self.info()
        self.assertGreaterEqual(info["messages"], before)
        self.assertIn("it is truncated", info["torn"])
        self.place.log("convert", "a.mcap", "-o", "whole.mcap")
        with open(self.place.path / "whole.mcap", "rb") as stream:
            self.assertEqual(sum(1 for _ in make_reader(stream, validate_crcs=True).iter_messages()), info["messages"])

    def test_topics_are_chosen(self):
        self.place.start("run", "world.sdf")
        recorder = self.place.record("--file", "a.mcap", "--pattern", "/model/.*", "/stats")
        wanted = {"/stats", "/model/box/pose"}
        until(lambda: wanted <= {topic["name"] for topic in self.info()["topics"]}, "both topics")
        self.assertEqual(self.place.end(recorder), 0)
        names = {topic["name"] for topic in self.info()["topics"]}
        self.assertNotIn("/clock", names)

    def test_it_ends_by_itself(self):
        recorder = self.place.record("-o", "a.mcap", "--duration", "0.3", "/nothing")
        self.assertEqual(recorder.wait(PATIENCE), 0)
        self.assertIn("no messages on '/nothing'", self.place.said(recorder))
        info = self.info()
        self.assertEqual((info["messages"], info["topics"], info["torn"]), (0, [], None))
        self.assertIn("already exists", self.place.log("record", "-o", "a.mcap", "--duration", "0.1", code=1))
        self.assertIn("takes a number of seconds", self.place.log("record", "--duration", "soon", code=2))

    def test_a_full_disk_is_said(self):
        self.place.start("run", "world.sdf")
        (self.place.path / "full.mcap").symlink_to("/dev/full")
        said = self.place.log("record", "-o", "full.mcap", "--force", code=1)
        self.assertIn("'full.mcap' can't be written: No space left on device", said)


if __name__ == "__main__":
    unittest.main()
