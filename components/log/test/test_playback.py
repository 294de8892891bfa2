"""Playing a recorded run: to its end, to subscribers, controlled by requests."""

import json
import os
import re
import subprocess
import time
import unittest

from place import PATIENCE, PONGSIM, WORLD, Place, until

CONTROL = ("service", "-s", "/world/drive/playback/control", "--timeout", "60000", "--req")
# Reads with Debian's own log library (transport_log_main.cc), if it is installed.
READER = os.environ.get("PONGSIM_TRANSPORT_LOG")


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
        until(lambda: self.state() == (0.2, True), "the end")
        for _ in range(2):
            self.assertIsNone(played.poll())
            self.run_pongsim(*CONTROL, "rewind: true, pause: true")
            self.assertEqual(self.state(), (0, True))
            self.run_pongsim(*CONTROL, "pause: false")
            until(lambda: self.state() == (0.2, True), "the end")
        self.assertEqual(self.place.end(played), 0, self.place.said(played))

    def test_more_steps_than_it_has_are_waited_for_with_a_word(self):
        played = self.place.start("run", "--playback", "rec", "-z", "0", "--iterations", "300")
        until(lambda: "end of the recording at 0.2" in self.place.said(played), "the end")
        self.run_pongsim(*CONTROL, "rewind: true, pause: false")
        self.assertEqual(played.wait(PATIENCE), 0, self.place.said(played))

    def test_steps_go_on_after_a_rewind_among_them(self):
        # so slow that the second request arrives between steps on a busy machine, too
        self.place.start("run", "--playback", "rec", "--paused", "-z", "20")
        until(lambda: self.state() == (0, True), "the recording")
        self.run_pongsim(*CONTROL, "pause: true, multi_step: 150")
        self.run_pongsim(*CONTROL, "rewind: true")
        until(lambda: self.state()[1], "the end of the steps")
        # those made before the request arrived, and the start, were some of them
        self.assertLess(self.state()[0], 0.15)

    def test_who_listens_hears_what_was_recorded(self):
        self.place.start("run", "--playback", "rec", "--paused")
        until(lambda: self.state() == (0, True), "the recording")
        listener = self.listen()
        until(lambda: re.search(r"/model/box/pose .*1 subscriber", self.run_pongsim("topic", "-l", "-v")), "the listener")
        self.run_pongsim(*CONTROL, "pause: false")
        self.assertEqual(self.times_of(listener), [1, 10, 20])

    def test_messages_of_a_log_come_on_their_topics(self):
        listener = self.listen()
        self.place.log("playback", "--file", "rec/state.tlog", "--pattern", "/model/.*", "--wait", "60000")
        rows = self.place.log("export", "rec/state.tlog", "/model/box/pose", "header.stamp.nsec", "--csv").splitlines()
        self.assertEqual(self.times_of(listener), [int(row.split(",")[1]) // 1_000_000 for row in rows[1:4]])

    def test_it_is_as_fast_as_asked(self):
        self.place.start("run", "--playback", "rec", "--paused", "-z", "50")
        until(lambda: self.state() == (0, True), "the recording")
        start = time.monotonic()
        self.run_pongsim(*CONTROL, "pause: false")
        until(lambda: self.state() == (0.2, True), "the end")
        # 200 steps, which took 0.2 s when they were recorded
        self.assertGreater(time.monotonic() - start, 3.5)

    @unittest.skipUnless(READER, "Debian's library of logs is not here")
    def test_fortresss_library_of_logs_reads_it(self):
        done = subprocess.run([READER, self.place.path / "rec/state.tlog"], capture_output=True, text=True,
                              timeout=PATIENCE)
        self.assertEqual(done.returncode, 0, done.stderr)
        topics = json.loads(self.place.log("info", "rec/state.tlog", "--json"))["topics"]
        self.assertGreaterEqual({topic["name"] for topic in topics},
                                {"/rec/sdf", "/world/drive/changed_state", "/model/box/pose"})
        self.assertEqual(sorted(done.stdout.splitlines()),
                         sorted(f"{topic['name']} {topic['type']} {topic['count']}" for topic in topics))

    def listen(self):
        listener = subprocess.Popen([PONGSIM, "topic", "-e", "-t", "/model/box/pose", "-n", "3", "--json-output"],
                                    stdout=subprocess.PIPE, text=True)
        self.addCleanup(listener.kill)
        self.addCleanup(listener.stdout.close)
        return listener

    def times_of(self, listener):
        """The times of the poses in milliseconds."""
        lines = listener.communicate(timeout=PATIENCE)[0].splitlines()
        return [json.loads(line)["header"]["stamp"].get("nsec", 0) // 1_000_000 for line in lines]


if __name__ == "__main__":
    unittest.main()
