"""A run in lockstep with a controller on ign-transport: the same bits, however slow it is, and those of its replay."""

import pathlib
import re
import tempfile
import unittest

from ign_world import DEADLINE, PEER, PONGSIM, ROOT, run, running

WORLD = ROOT / "worlds/pong_world.sdf"


def state_hash(delay, *options):
    """The hash of a run with a controller that thinks up to `delay` ms before each answer."""
    with running(PEER, "answer", "/keyboard/keypress", str(delay)) as controller:
        # ZeroMQ connects some time after discovery: the run starts when the controller hears it
        with running(PONGSIM, "run", WORLD, "--ign", "--paused", "-z", "0", "--iterations", "400", "--hash",
                     "--lockstep", "/keyboard/keypress:10", *options) as world:
            controller.wait_for("^ready$")
            run(PONGSIM, "service", "-s", "/world/pong_world/control", "--reqtype", "ignition.msgs.WorldControl",
                "--reptype", "ignition.msgs.Boolean", "--timeout", "20000", "--req", "pause: false")
            found = world.wait_for("^state hash: ([0-9a-f]+)$")
            assert world.process.wait(DEADLINE) == 0
            return found.group(1)


class Lockstep(unittest.TestCase):
    def test_a_slow_controller_does_not_change_a_bit(self):
        hashes = {state_hash(delay) for delay in (0, 20, 50)}
        self.assertEqual(len(hashes), 1, hashes)
        alone = run(PONGSIM, "run", WORLD, "-z", "0", "--iterations", "400", "--hash")
        self.assertNotIn(re.search("state hash: (.*)", alone).group(1), hashes)

    def test_a_replay_has_the_bits_without_the_controller(self):
        with tempfile.TemporaryDirectory() as folder:
            recording = pathlib.Path(folder) / "run.inputs"
            recorded = state_hash(5, "--record-inputs", recording)
            self.assertIn(f"is as recorded up to step 400 (0.4 s), state hash {recorded}", run(PONGSIM, "replay", recording))


if __name__ == "__main__":
    unittest.main()
