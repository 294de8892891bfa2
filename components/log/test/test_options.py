"""Fortress's options for recording a run and playing a log."""

import json
import os
import subprocess
import unittest

from place import PATIENCE, PONGSIM, WORLD, Place

TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
MODEL = """<model name="sign"><static>true</static><link name="l"><visual name="v"><geometry><mesh>
  <uri>triangle.obj</uri></mesh></geometry></visual></link></model>"""


class Options(unittest.TestCase):
    def setUp(self):
        self.place = Place()
        self.place.__enter__()
        self.addCleanup(self.place.__exit__, None, None, None)
        (self.place.path / "world.sdf").write_text(WORLD)

    def run_world(self, *words, world="world.sdf"):
        """Makes 100 steps, with the folder as home, and returns what is in it then."""
        done = subprocess.run([PONGSIM, "run", world, "-z", "0", "--iterations", "100", *words], cwd=self.place.path,
                              env={**os.environ, "HOME": str(self.place.path)}, capture_output=True, text=True,
                              timeout=PATIENCE)
        self.assertEqual(done.returncode, 0, done.stderr)
        return sorted(each.name for each in self.place.path.glob("rec*"))

    def states(self, log):
        topics = json.loads(self.place.log("info", log, "--json"))["topics"]
        return sum(topic["count"] for topic in topics if topic["name"] == "/world/drive/changed_state")

    def test_record_alone_takes_the_folder_of_the_time(self):
        self.assertEqual(self.run_world("--record"), [])
        log, = (self.place.path / ".ignition/gazebo/log").glob("*/state.tlog")
        self.assertRegex(log.parent.name, r"^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{9}$")
        self.assertGreater(self.states(log), 0)

    def test_a_period_leaves_time_between_states(self):
        self.run_world("--record-path", "rec_all")
        self.run_world("--record-path", "rec_few", "--record-period", "0.02")
        self.assertGreaterEqual(self.states("rec_all/state.tlog"), 100)
        self.assertIn(self.states("rec_few/state.tlog"), range(5, 8))
        wrong = subprocess.run([PONGSIM, "run", "world.sdf", "--record-period", "-1"], cwd=self.place.path,
                               capture_output=True, text=True, timeout=PATIENCE)
        self.assertEqual(wrong.returncode, 2, wrong.stderr)
        self.assertIn("--record-period", wrong.stderr)

    def test_resources_are_copied_where_they_are_asked_for(self):
        (self.place.path / "triangle.obj").write_text(TRIANGLE)
        (self.place.path / "sign.sdf").write_text(WORLD.replace("</world>", MODEL + "</world>"))
        self.run_world("--record-path", "rec_without", world="sign.sdf")
        self.run_world("--record-path", "rec_with", "--record-resources", world="sign.sdf")
        self.assertEqual(list((self.place.path / "rec_without").rglob("triangle.obj")), [])
        copy, = (self.place.path / "rec_with").rglob("triangle.obj")
        self.assertEqual(copy.read_text(), TRIANGLE)

    def test_what_is_there_is_overwritten_where_it_is_asked_for(self):
        self.assertEqual(self.run_world("--record-path", "rec"), ["rec"])
        (self.place.path / "rec/mine").write_text("")
        self.assertEqual(self.run_world("--record-path", "rec"), ["rec", "rec(1)"])
        self.assertTrue((self.place.path / "rec/mine").exists())
        self.assertEqual(self.run_world("--record-path", "rec", "--log-overwrite"), ["rec", "rec(1)"])
        self.assertFalse((self.place.path / "rec/mine").exists())

    def test_a_compressed_recording_plays(self):
        self.assertEqual(self.run_world("--record-path", "rec", "--log-compress"), ["rec.zip"])
        said = subprocess.run([PONGSIM, "run", "--playback", "rec.zip", "-z", "0", "--iterations", "50", "-v", "2"],
                              cwd=self.place.path, capture_output=True, text=True, timeout=PATIENCE)
        self.assertEqual(said.returncode, 0, said.stderr)

    def test_a_topic_is_played_on_another_and_without_pauses(self):
        # longer than the test may take
        (self.place.path / "slow.sdf").write_text(WORLD.replace("<update_frequency>100<", "<update_frequency>1<").replace(
            "<model ", f"<physics name='p' type='ode'><max_step_size>{PATIENCE / 50}</max_step_size></physics><model "))
        self.run_world("--record-path", "rec", "--record-topic", "/model/box/pose", world="slow.sdf")
        listener = subprocess.Popen([PONGSIM, "topic", "-e", "-t", "/elsewhere", "-n", "3", "--json-output"],
                                    stdout=subprocess.PIPE, text=True)
        self.addCleanup(listener.kill)
        self.addCleanup(listener.stdout.close)
        self.place.log("playback", "--file", "rec/state.tlog", "--remap", "/model/box/pose:=/elsewhere", "--wait",
                       "60000", "-f")
        heard = [json.loads(line) for line in listener.communicate(timeout=PATIENCE)[0].splitlines()]
        self.assertEqual([message["name"] for message in heard], ["box::body"] * 3)
        self.assertIn("is not a renaming", self.place.log("playback", "--file", "rec/state.tlog", "--remap", "/a", code=2))


if __name__ == "__main__":
    unittest.main()
