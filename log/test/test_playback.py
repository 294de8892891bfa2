"""Playing what a run recorded: to its end, to who listens, as requests steer it."""

import json
import re
import subprocess
import unittest

from place import PATIENCE, PONGSIM, WORLD, Place, wait_until

CONTROL = ("service", "-s", "/world/drive/playback/control", "--timeout", "60000", "--req")


class Playback(unittest.TestCase):
    def setUp(self):
        self.place = Place()
        self.place.__enter__()
        self.addCleanup(self.place.__exit__, None, None, None)
        (self.place.path / "world.sdf").write_text(WORLD)
        self.run_pongsim("run", "world.sdf", "-z", "0", "--iterations", "200", "--record-path", "rec", "--record-topic",
                         "/model/box/pose")

    def run_pongsim(self, *words):
        """What a command prints."""
        done = subprocess.run([PONGSIM, *words], cwd=self.place.path, capture_output=True, text=True, timeout=PATIENCE)
        self.assertEqual(done.returncode, 0, (words, done.stdout[-2000:], done.stderr[-2000:]))
        return done.stdout

    def state(self):
        """Simulated seconds, and whether it is paused."""
        text = self.run_pongsim("world", "stats", "-n", "1", "--timeout", "60000")
        return float(re.search(r"simulated (\S+) s", text).group(1)), ", paused" in text

    def test_it_pauses_at_the_end_and_can_be_played_again(self):
        played = self.place.start("run", "--playback", "rec")
        wait_until(lambda: self.state() == (0.2, True), "the end")
        for _ in range(2):
            self.assertIsNone(played.poll())
            self.run_pongsim(*CONTROL, "rewind: true, pause: true")
            self.assertEqual(self.state(), (0, True))
            self.run_pongsim(*CONTROL, "pause: false")
            wait_until(lambda: self.state() == (0.2, True), "the end")
        self.assertEqual(self.place.end(played), 0, self.place.said(played))

    def test_steps_go_on_after_a_rewind_among_them(self):
        self.place.start("run", "--playback", "rec", "--paused", "-z", "100")
        wait_until(lambda: self.state() == (0, True), "the recording")
        self.run_pongsim(*CONTROL, "pause: true, multi_step: 150")
        self.run_pongsim(*CONTROL, "rewind: true")
        wait_until(lambda: self.state()[1], "the end of the steps")
        # those made before the request came, and the start, were some of them
        self.assertLess(self.state()[0], 0.15)

    def test_who_listens_hears_what_was_recorded(self):
        self.place.start("run", "--playback", "rec", "--paused")
        wait_until(lambda: self.state() == (0, True), "the recording")
        listener = self.listen()
        wait_until(lambda: re.search(r"/model/box/pose .*1 subscriber", self.run_pongsim("topic", "-l", "-v")), "the listener")
        self.run_pongsim(*CONTROL, "pause: false")
        self.assertEqual(self.times_of(listener), [1, 10, 20])

    def test_messages_of_a_log_come_on_their_topics(self):
        listener = self.listen()
        self.place.log("playback", "--file", "rec/state.tlog", "--pattern", "/model/.*", "--wait", "60000")
        rows = self.place.log("export", "rec/state.tlog", "/model/box/pose", "header.stamp.nsec", "--csv").splitlines()
        self.assertEqual(self.times_of(listener), [int(row.split(",")[1]) // 1_000_000 for row in rows[1:4]])

    def listen(self):
        listener = subprocess.Popen([PONGSIM, "topic", "-e", "-t", "/model/box/pose", "-n", "3", "--json-output"],
                                    stdout=subprocess.PIPE, text=True)
        self.addCleanup(listener.kill)
        self.addCleanup(listener.stdout.close)
        return listener

    def times_of(self, listener):
        """When the poses were, in milliseconds."""
        lines = listener.communicate(timeout=PATIENCE)[0].splitlines()
        return [json.loads(line)["header"]["stamp"].get("nsec", 0) // 1_000_000 for line in lines]


if __name__ == "__main__":
    unittest.main()
