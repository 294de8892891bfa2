"""Packets from another machine, simulated by a network namespace, are dropped unless the world is open to it."""

import pathlib
import sys
import unittest

from ign_world import PEER, ROOT, client, needs_ign, run, running, world
from other_machine import HERE, ON_THE_OTHER, THERE, Unavailable, beside_another

# Packets to the discovery sockets: unicast and multicast.
NOISE = f"""
import socket, sys
noise = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
noise.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton(sys.argv[1]))
for i in range(10):
    for port in (10317, 10318):
        for address in ("{HERE}", "239.255.0.7"):
            noise.sendto(b"\\x05\\x00hello", (address, port))
"""


def drops(port):
    """The number of packets that the sockets at a port have dropped."""
    lines = [line.split() for line in pathlib.Path("/proc/net/udp").read_text().splitlines()[1:]]
    return sum(int(line[-1]) for line in lines if line[1].endswith(f":{port:04X}"))


class Inside(unittest.TestCase):
    """Tests that run within the namespaces."""

    def test_noise_of_another_machine_is_dropped_and_clients_here_are_met(self):
        with world(ROOT / "worlds/pong_world.sdf", environment={"IGN_IP": ""}):
            before = drops(10317), drops(10318)
            run(sys.executable, "-c", NOISE, HERE)
            self.assertEqual((drops(10317), drops(10318)), before)
            run(*ON_THE_OTHER, sys.executable, "-c", NOISE, THERE)
            self.assertGreaterEqual(drops(10317), before[0] + 10)
            self.assertGreaterEqual(drops(10318), before[1] + 10)
            # a client with default settings, which sends from the network interface's address
            with running(PEER, "listen", "/clock", "ignition.msgs.Clock", environment={"IGN_IP": ""}) as listener:
                listener.wait_for("heard")
            # the other machine discovers no topics
            if client("topic").exists():
                there = run(*ON_THE_OTHER, client("topic"), "-l", environment={"IGN_IP": ""})
                self.assertNotIn("/clock", there)

    @needs_ign
    def test_a_relay_reaches_another_machine(self):
        # another multicast group, so that discovery works only by the relay
        apart = {"IGN_IP": HERE, "IGN_DISCOVERY_MULTICAST_IP": "239.255.0.8"}
        there = {"IGN_IP": THERE}
        with world(ROOT / "worlds/pong_world.sdf", environment=apart):
            self.assertNotIn("/clock", run(*ON_THE_OTHER, client("topic"), "-l", environment=there))
        with world(ROOT / "worlds/pong_world.sdf", environment={**apart, "IGN_RELAY": THERE}), \
                running(*ON_THE_OTHER, PEER, "listen", "/clock", "ignition.msgs.Clock", environment=there) as listener:
            listener.wait_for("heard")


class Closed(unittest.TestCase):
    def test_it_is(self):
        try:
            result = beside_another([sys.executable, __file__, "Inside"])
        except Unavailable as why:
            self.skipTest(str(why))
        self.assertEqual(result.returncode, 0, result.stderr[-3000:])


if __name__ == "__main__":
    unittest.main(argv=sys.argv if len(sys.argv) > 1 else [sys.argv[0], "Closed"])
