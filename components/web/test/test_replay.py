"""What comes by the web is recorded as input, and replays to the same bits without it."""

import json
import pathlib
import signal
import tempfile
import unittest

from web_world import PATIENCE, ROOT, Connection, ended, running

WORLD = ROOT / "worlds/pong_world.sdf"


def send(connection, **request):
    """Sends a request of rosbridge's protocol."""
    connection.send(json.dumps(request))


def answer(connection, holds):
    """The first message that is as wanted."""
    while True:
        message = json.loads(connection.next()[1])
        if holds(message):
            return message


class Replay(unittest.TestCase):
    def test_messages_and_requests(self):
        with tempfile.TemporaryDirectory() as folder:
            recording = pathlib.Path(folder) / "run.inputs"
            with running(WORLD, "--web", "0", "--hash", "--record-inputs", recording) as world:
                host, port, _ = world.address()
                with Connection(host, port) as client:
                    self.assertEqual(client.open(protocol=None), 101)
                    send(client, op="subscribe", topic="/model/pong_bot/odometry", type="nav_msgs/Odometry")
                    send(client, op="publish", topic="/cmd_vel", type="geometry_msgs/Twist", msg={"linear": {"x": 0.5}})
                    answer(client, lambda heard: heard["op"] == "publish" and heard["msg"]["twist"]["twist"]["linear"]["x"] > 0.1)
                    send(client, op="call_service", service="/world/pong_world/set_pose",
                         args={"name": "pong_bot", "position": {"y": 0.5}})
                    self.assertTrue(answer(client, lambda heard: heard["op"] == "service_response")["result"])
                world.process.send_signal(signal.SIGINT)
                self.assertEqual(world.process.wait(PATIENCE), 0)
                recorded = world.wait_for("^state hash: ([0-9a-f]+)$")[1]
            for threads in ("1", "3"):
                replay = ended("replay", recording, "--threads", threads)
                self.assertEqual(replay.returncode, 0, replay.stderr)
                self.assertIn(f"state hash {recorded}", replay.stdout)


if __name__ == "__main__":
    unittest.main()
