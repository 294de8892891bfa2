"""The clients of later releases: names of types and of environment variables."""

import os
import re
import unittest

from ign_world import ENVIRONMENT, PONGSIM, ROOT, Running, described, ended, listed, needs_ign, running

GZ_PEER = os.environ["PONGSIM_GZ_PEER"]
WORLD = ROOT / "worlds/pong_world.sdf"

#: As later clients have it: nothing under Fortress's names.
LATER = {"GZ_PARTITION": ENVIRONMENT["IGN_PARTITION"], "GZ_IP": "127.0.0.1"}


class Gz(unittest.TestCase):
    def peer(self, *words):
        peer = Running(GZ_PEER, *words)
        self.addCleanup(peer.end)
        return peer

    def world(self, *options):
        return running("env", "--unset=IGN_PARTITION", "--unset=IGN_IP", PONGSIM, "run", WORLD, *options,
                       environment=LATER)

    def test_a_world_is_where_later_variables_say(self):
        with self.world("--gz", "-v", "3") as simulation:
            simulation.wait_for(f"partition '{re.escape(LATER['GZ_PARTITION'])}' at 127.0.0.1")
            self.peer("listen", "/clock", "gz.msgs.Clock").wait_for("heard")
            self.assertNotIn("warning", simulation.output())

    @needs_ign
    def test_topics_and_services_have_their_later_types(self):
        with self.world("--gz"):
            listed("topic", {"/clock", "/stats", "/world/pong_world/pose/info"})
            described("topic", "-t", "/clock", r"tcp://127\.0\.0\.1:\d+, gz\.msgs\.Clock\n")
            listed("service", {"/world/pong_world/control"})
            described("service", "-s", "/world/pong_world/control",
                      r"tcp://127\.0\.0\.1:\d+, gz\.msgs\.WorldControl, gz\.msgs\.Boolean\n")

    def test_variables_of_fortress_have_no_effect(self):
        with running(PONGSIM, "run", WORLD, "--gz", environment={"IGN_PARTITION": "there"}) as simulation:
            simulation.wait_for("IGN_PARTITION has no effect, since these clients read GZ_PARTITION")

    def test_a_process_is_for_one_generation(self):
        both = ended(PONGSIM, "run", WORLD, "--ign", "--gz", "--iterations", "1")
        self.assertEqual(both.returncode, 2)
        self.assertIn("options '--ign' and '--gz' can't be used together", both.stderr)


if __name__ == "__main__":
    unittest.main()
