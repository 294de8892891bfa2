"""Settings of ign-transport in a world's file and in the environment."""

import pathlib
import tempfile
import unittest

from ign_world import PATIENCE, PEER, PONGSIM, ROOT, Running, ended, ign, listed, needs_ign, running, world

WORLD = ROOT / "worlds/pong_world.sdf"
CLOCK = ("/clock", "ignition.msgs.Clock")
PLUGIN = '<plugin filename="pongsim-ign-system" name="pongsim::systems::Ign"/>'
CONTROL = ("-s", "/world/pong_world/control", "--reqtype", "ignition.msgs.WorldControl", "--reptype",
           "ignition.msgs.Boolean", *PATIENCE, "--req", "pause: false")


class Settings(unittest.TestCase):
    def peer(self, *words, environment=None):
        peer = Running(PEER, *words, environment=environment)
        self.addCleanup(peer.end)
        return peer

    def test_a_world_asks_for_it_itself(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "own.sdf")
            file.write_text(WORLD.read_text().replace("</world>", PLUGIN + "</world>"))
            with running(PONGSIM, "run", file) as simulation:
                self.peer("listen", *CLOCK).wait_for("heard")
                self.assertNotIn("warning", simulation.output())
            # a misspelt name is a warning, which --strict makes an error
            file.write_text(WORLD.read_text().replace("</world>", PLUGIN.replace("ign-system", "ing-system") + "</world>"))
            wrong = ended(PONGSIM, "run", file, "--strict", "--iterations", "1")
            self.assertEqual(wrong.returncode, 1, wrong.stderr)
            self.assertIn("pongsim-ing-system", wrong.stderr)

    def test_statistics_are_for_clients_with_the_same_setting(self):
        setting = {"IGN_TRANSPORT_TOPIC_STATISTICS": "1"}
        with world(WORLD, environment=setting):
            without = self.peer("listen", *CLOCK)
            without.wait_for("ready")
            self.peer("statistics", *CLOCK, environment=setting).wait_for("numbered")
            self.assertNotIn("heard", without.output())

    def test_a_password_is_wanted_of_topics(self):
        known = {"IGN_TRANSPORT_USERNAME": "user", "IGN_TRANSPORT_PASSWORD": "secret"}
        with world(WORLD, environment=known) as simulation:
            strangers = [self.peer("listen", *CLOCK, environment=each)
                         for each in ({}, {**known, "IGN_TRANSPORT_PASSWORD": "guess"})]
            unheard = self.peer("publish", "/cmd_vel", "no Twist")
            for stranger in strangers:
                stranger.wait_for("ready")
            unheard.wait_for("published")
            simulation.wait_for("Invalid username or password")
            self.peer("listen", *CLOCK, environment=known).wait_for("heard")
            self.assertNotIn("arrived by ign-transport", simulation.output())
            self.peer("publish", "/cmd_vel", "no Twist", environment=known)
            # a world reports messages of a wrong type, which shows that it has received one
            simulation.wait_for("messages of ignition.msgs.StringMsg arrived by ign-transport")
            for stranger in strangers:
                self.assertNotIn("heard", stranger.output())

    @needs_ign
    def test_a_password_is_not_wanted_of_services(self):
        known = {"IGN_TRANSPORT_USERNAME": "user", "IGN_TRANSPORT_PASSWORD": "secret"}
        with world(WORLD, environment=known):
            listed("service", {CONTROL[1]})
            self.assertIn("data: true", ign("service", *CONTROL))


if __name__ == "__main__":
    unittest.main()
