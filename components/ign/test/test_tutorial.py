"""Fortress's moving robot tutorial, unmodified, with Debian's own clients and a program for Fortress."""

import re
import unittest

from ign_world import (DRIVER, PATIENCE, PONGSIM, TUTORIAL, call_once, client, described, ended, ign, listed, needs_ign,
                       needs_tutorial, run, running, until, world)

ODOMETRY = "/model/vehicle_blue/odometry"


def position():
    """The robot's position, as printed by Fortress's client."""
    text = ign("topic", "-e", "-t", ODOMETRY, "-n", "1")
    match = re.search(r"position \{\s*(?:x: (\S+))?", text)
    return float(match.group(1) or 0) if match else 0.0


def publish(topic, kind, content):
    """Publishes with Fortress's client, which may exit before the message is sent: repeat it until it has an effect."""
    ign("topic", "-t", topic, "-m", f"ignition.msgs.{kind}", "-p", content)


@needs_ign
@needs_tutorial
class MovingRobot(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.enterer = world(TUTORIAL)
        cls.simulation = cls.enterer.__enter__()

    @classmethod
    def tearDownClass(cls):
        cls.enterer.__exit__(None, None, None)

    def test_topics_have_fortress_names_and_types(self):
        names = {ODOMETRY, "/clock", "/stats", "/cmd_vel", *(f"/world/Moving_robot/{name}" for name in (
            "clock", "stats", "pose/info", "dynamic_pose/info", "scene/info", "state"))}
        topics = listed("topic", names)
        # the world only subscribes to it; Fortress does not list such topics either
        self.assertNotIn("/keyboard/keypress", topics)
        described("topic", "-t", ODOMETRY, r"Publishers \[Address, Message Type\]:\n"
                                           r"  tcp://127\.0\.0\.1:\d+, ignition\.msgs\.Odometry\n")
        self.assertIn("No publishers on topic [/nothing]", ign("topic", "-i", "-t", "/nothing"))

    def test_services_have_fortress_names_and_types(self):
        listed("service", {"/gazebo/worlds", *(f"/world/Moving_robot/{name}" for name in (
            "control", "create", "remove", "set_pose", "scene/info", "state", "state_async"))})
        described("service", "-s", "/world/Moving_robot/control",
                  r"tcp://127\.0\.0\.1:\d+, ignition\.msgs\.WorldControl, ignition\.msgs\.Boolean\n")

    def test_commands_move_the_robot_and_keys_do(self):
        before = position()

        def moved():
            publish("/cmd_vel", "Twist", "linear: {x: 0.5}, angular: {z: 0.05}")
            return position() > before + 0.1

        until(moved, "the robot to move")
        # an arrow key of the tutorial: a message to the world, whose system publishes a Twist, which drives the robot
        with running(client("topic"), "-e", "-t", "/cmd_vel") as echo:
            def turned():
                publish("/keyboard/keypress", "Int32", "data: 16777234")
                return "z: 0.5" in echo.output()
            until(turned, "the Twist of a key")

    def test_a_program_for_fortress_drives_it(self):
        # On a busy machine the driver stops the robot late, so it goes farther than 1 m. If ign-transport can't send
        # heartbeats for three seconds, other processes forget it, and the driver gives up after a minute.
        until(lambda: re.search(r"went [1-9]\d*\.\d+ m", ended(DRIVER).stdout), "the robot to go a metre")

    def test_absurd_commands_are_refused(self):
        for kind, content, words in (
                ("Twist", "linear: {x: 1e308}", r"/cmd_vel.*is refused: linear\.x is 1e\+308"),
                ("Int32", "data: 7", r"messages of ignition\.msgs\.Int32 arrived.*the world takes ignition\.msgs\.Twist")):
            def said(kind=kind, content=content, words=words):
                publish("/cmd_vel", kind, content)
                return re.search(words, self.simulation.output())

            until(said, words)

    def test_the_world_obeys_services(self):
        def call(name, request_type, reply_type, request):
            return ign("service", "-s", f"/world/Moving_robot/{name}", "--reqtype", f"ignition.msgs.{request_type}",
                       "--reptype", f"ignition.msgs.{reply_type}", *PATIENCE, "--req", request)

        self.assertIn("data: true", call("control", "WorldControl", "Boolean", "pause: true"))
        # also while it is paused
        self.assertIn("data: true", call("control", "WorldControl", "Boolean", "pause: false"))

        def is_there():
            return "box" in run(PONGSIM, "model", "--list")

        call_once("/world/Moving_robot/create", "ignition.msgs.EntityFactory",
                  "sdf: \"<sdf version='1.9'><model name='box'><link name='link'/></model></sdf>\"", is_there)
        until(is_there, "the box")
        # the request that `ign model` makes
        worlds = ign("service", "-s", "/gazebo/worlds", "--reqtype", "ignition.msgs.Empty", "--reptype",
                     "ignition.msgs.StringMsg_V", *PATIENCE, "--req", "")
        self.assertIn('data: "Moving_robot"', worlds)
        state = call("state", "Empty", "SerializedStepMap", "")
        self.assertIn("stats {", state)
        self.assertIn("entities {", state)


if __name__ == "__main__":
    unittest.main()
