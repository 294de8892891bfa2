"""Several worlds of one process on ign-transport: topics and services of each world, and those of the process."""

import re
import unittest

from ign_world import DEADLINE, PATIENCE, PEER, PONGSIM, ROOT, Running, call_once, ign, listed, needs_ign, run, until, world

WORLD = ROOT / "worlds/three_worlds.sdf"
WORLDS = ("fine", "coarse", "fast")


def x_of(name):
    """The distance that a world's cart has driven [m]."""
    return float(run(PONGSIM, "topic", "-e", "-t", f"/model/cart_{name}/odometry", "-n", "1", "--field", "pose.position.x"))


class Worlds(unittest.TestCase):
    def listening(self, topic, kind):
        peer = Running(PEER, "listen", topic, kind)
        self.addCleanup(peer.end)
        return peer

    def test_each_tells_of_itself(self):
        with world(WORLD):
            for name in WORLDS:
                self.listening(f"/world/{name}/clock", "ignition.msgs.Clock").wait_for("heard")
                self.listening(f"/model/cart_{name}/odometry", "ignition.msgs.Odometry").wait_for("heard")
            # the topic of the first world
            self.listening("/clock", "ignition.msgs.Clock").wait_for("heard")

    @needs_ign
    def test_each_takes_its_commands_alone(self):
        def moved():
            # repeated, because the client may exit before the message is sent
            ign("topic", "-t", "/model/cart_coarse/cmd_vel", "-m", "ignition.msgs.Twist", "-p", "linear: {x: 0.5}")
            return x_of("coarse") > 0.1

        with world(WORLD):
            until(moved, "the cart to move")
            for name in ("fine", "fast"):
                self.assertAlmostEqual(x_of(name), 0, 3)

    @needs_ign
    def test_services_are_there_once(self):
        with world(WORLD):
            names = [f"/world/{name}/control" for name in WORLDS]
            services = listed("service", set(names))
            for name in WORLDS:
                self.assertEqual(services.count(f"/world/{name}/control"), 1)
                answer = ign("service", "-s", f"/world/{name}/control", "--reqtype", "ignition.msgs.WorldControl",
                             "--reptype", "ignition.msgs.Boolean", *PATIENCE, "--req", "pause: true")
                self.assertIn("data: true", answer)

    @needs_ign
    def test_what_the_process_has_once_is_the_first_worlds(self):
        def ask(service, kinds, request):
            return ign("service", "-s", service, "--reqtype", kinds[0], "--reptype", kinds[1], *PATIENCE,
                       "--req", request)

        with world(WORLD) as simulation:
            names = ("/gazebo/worlds", "/server_control")
            services = listed("service", set(names))
            self.assertEqual([services.count(name) for name in names], [1, 1])
            answer = ask("/gazebo/worlds", ("ignition.msgs.Empty", "ignition.msgs.StringMsg_V"), "")
            self.assertEqual(re.findall(r'data: "(\w+)"', answer), list(WORLDS))
            call_once("/server_control", "ignition.msgs.ServerControl", "stop: true",
                      lambda: simulation.process.poll() is not None)
            self.assertEqual(simulation.process.wait(DEADLINE), 0)


if __name__ == "__main__":
    unittest.main()
