"""Clients that die, stop, flood or send garbage: the world continues, and its memory stays constant."""

import os
import pathlib
import re
import signal
import socket
import tempfile
import time
import unittest

from ign_world import ENVIRONMENT, PEER, PONGSIM, ROOT, Running, resident, run, running, steps, until, world

WORLD = ROOT / "worlds/pong_world.sdf"
NAME = "pong_world"
DISCOVERY = ("239.255.0.7", 10317, 10318)


def steps_on(test):
    before = steps(NAME)
    until(lambda: steps(NAME) > before + 20, "the world to step")


class Clients(unittest.TestCase):
    def listening(self, topic, kind):
        peer = Running(PEER, "listen", topic, kind)
        self.addCleanup(peer.end)
        peer.wait_for("heard")
        return peer

    def test_killed_clients_leave_nothing_behind(self):
        with world(WORLD) as simulation:
            handles = []
            for _ in range(3):
                peers = [Running(PEER, "listen", "/clock", "ignition.msgs.Clock") for _ in range(4)]
                for peer in peers:
                    peer.wait_for("heard")
                for peer in peers:
                    peer.process.kill()
                    peer.process.wait()
                    peer.end()
                steps_on(self)
                handles.append(len(list(pathlib.Path(f"/proc/{simulation.pid}/fd").iterdir())))
            # sockets of the last clients may still exist
            self.assertLessEqual(handles[-1], handles[0] + 8)

    def test_a_stopped_reader_holds_up_nobody(self):
        with world(WORLD) as simulation:
            stopped = self.listening("/world/pong_world/pose/info", "ignition.msgs.Pose_V")
            other = self.listening("/clock", "ignition.msgs.Clock")
            stopped.process.send_signal(signal.SIGSTOP)
            before = resident(simulation.pid)
            first = steps(NAME)
            until(lambda: steps(NAME) > first + 3000, "3000 steps")
            self.assertLess(resident(simulation.pid), before + 200)
            count = int(other.finish().split()[-1])
            self.assertGreater(count, 500)

    def test_a_flood_is_borne(self):
        with world(WORLD) as simulation, running(PEER, "flood", "/keyboard/keypress") as flood:
            flood.wait_for("ready")
            before = resident(simulation.pid)
            first = steps(NAME)
            until(lambda: steps(NAME) > first + 500, "500 steps")
            self.assertLess(resident(simulation.pid), before + 200)

    def test_garbage_in_discovery_is_borne(self):
        with world(WORLD) as simulation, socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as noise:
            noise.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton("127.0.0.1"))
            seed = 1
            for length in [0, 1, 2, 3, 7, 64, 500, 1400, 9000] * 20:
                seed = (seed * 1103515245 + 12345) % 2**31
                body = bytes((seed >> (i % 23)) & 255 for i in range(length))
                for port in DISCOVERY[1:]:
                    noise.sendto(body, (DISCOVERY[0], port))
                    # with the right length prefix, so that it is passed to the parser of protobuf
                    noise.sendto(length.to_bytes(2, "little") + body, (DISCOVERY[0], port))
            steps_on(self)
            self.listening("/clock", "ignition.msgs.Clock")
            self.assertIsNone(simulation.process.poll())

    def test_two_worlds_share_a_partition(self):
        with tempfile.TemporaryDirectory() as folder:
            other = pathlib.Path(folder, "other.sdf")
            other.write_text(WORLD.read_text().replace('world name="pong_world"', 'world name="other"'))
            with world(WORLD), running(PONGSIM, "run", other, "--ign") as second:
                first = self.listening("/world/pong_world/clock", "ignition.msgs.Clock")
                self.listening("/world/other/clock", "ignition.msgs.Clock")
                # each world publishes for its own robot, and does not repeat what the other publishes: one Twist of
                # each per key
                twists = Running(PEER, "raw", "/cmd_vel")
                self.addCleanup(twists.end)
                twists.wait_for("ready")

                def key():
                    with running(PEER, "listen", "/clock", "ignition.msgs.Clock") as clock:
                        clock.wait_for("heard")
                    run(PONGSIM, "topic", "-t", "/keyboard/keypress", "-m", "ignition.msgs.Int32", "-p", "data: 16777235")
                    return "Twist" in twists.output()

                until(key, "a Twist")
                before = twists.output().count("Twist")
                time.sleep(1)
                self.assertLess(twists.output().count("Twist"), before + 3)
                self.assertIsNone(second.process.poll())
                self.assertTrue(first)


class Place(unittest.TestCase):
    def test_sockets_are_on_this_machine_alone(self):
        with world(WORLD, environment={"IGN_IP": ""}) as simulation:
            simulation.wait_for(".*") if simulation.output() else None
            inodes = set()
            for handle in pathlib.Path(f"/proc/{simulation.pid}/fd").iterdir():
                try:
                    target = os.readlink(handle)
                except OSError:
                    continue
                if match := re.match(r"socket:\[(\d+)\]", target):
                    inodes.add(match.group(1))
            listening = [line.split() for line in pathlib.Path("/proc/net/tcp").read_text().splitlines()[1:]]
            own = [line[1] for line in listening if line[9] in inodes and line[3] == "0A"]
            self.assertTrue(own)
            for address in own:
                self.assertTrue(address.startswith("0100007F:"), address)

    def test_a_wrong_address_is_an_error(self):
        import subprocess
        for name, value, words in (("IGN_IP", "192.0.2.77", "not an IPv4 address of this machine"),
                                   ("IGN_PARTITION", "a b", "is not a partition")):
            result = subprocess.run([PONGSIM, "run", str(WORLD), "--ign", "--iterations", "1"],
                                    env={**ENVIRONMENT, name: value}, capture_output=True, text=True, timeout=90)
            self.assertNotEqual(result.returncode, 0)
            self.assertIn(words, result.stderr)


class Bits(unittest.TestCase):
    def test_they_are_the_same_with_and_without(self):
        words = [PONGSIM, "run", WORLD, "--iterations", "3000", "--hash"]
        plain = run(*words, "-z", "0")
        with running(PEER, "listen", "/clock", "ignition.msgs.Clock") as first, \
                running(PEER, "listen", "/model/pong_bot/odometry", "ignition.msgs.Odometry") as second:
            first.wait_for("ready")
            second.wait_for("ready")
            bridged = run(*words, "--ign")
            first.wait_for("heard")
        self.assertIn("state hash", plain)
        self.assertEqual(bridged, plain)


if __name__ == "__main__":
    unittest.main()
