"""Nodes on this machine are discovered whoever starts first, and again after either was killed."""

import os
import signal
import subprocess
import sys
import textwrap

import peers

WORLD = peers.ROOT / "components/ros2/test/drive.sdf"

# How a node may be set up: as it comes; on 127.0.0.1 alone, where it meets others by their ports; on one interface.
LOOPBACK = ("<CycloneDDS><Domain><General><Interfaces><NetworkInterface address='127.0.0.1'/></Interfaces>"
            "</General><Discovery><ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>30"
            "</MaxAutoParticipantIndex><Peers><Peer Address='127.0.0.1'/></Peers></Discovery></Domain></CycloneDDS>")


class Listener:
    """A process that reports when it has received the clock, and stays."""

    PROGRAM = textwrap.dedent("""
        import sys, time
        sys.path.insert(0, sys.argv[1])
        import peers
        peer = peers.Peer()
        reader = peer.reader("/clock", peers.Clock)
        begin = time.monotonic()
        peers.take_one(reader)
        print(time.monotonic() - begin, flush=True)
        sys.stdin.read()
        """)

    def __init__(self, uri=None):
        environment = dict(os.environ)
        if uri is not None:
            environment["CYCLONEDDS_URI"] = uri
        self.process = subprocess.Popen([sys.executable, "-c", self.PROGRAM, str(peers.ROOT / "components/ros2/test")],
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=environment)

    def seconds(self):
        """Waits for the clock. Returns the time since the reader was created."""
        line = self.process.stdout.readline()
        assert line, "the listener ended without the clock"
        return float(line)

    def kill(self):
        self.process.kill()
        self.process.wait()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.kill()
        self.process.stdin.close()
        self.process.stdout.close()


def test_a_node_that_comes_later_hears_the_clock():
    with peers.running(WORLD), Listener() as first:
        first.seconds()
        with Listener() as second:
            second.seconds()


def test_a_node_that_is_there_already_hears_the_clock():
    with Listener() as listener, peers.running(WORLD):
        listener.seconds()


def test_a_node_on_127_0_0_1_alone_hears_the_clock():
    with peers.running(WORLD), Listener(LOOPBACK) as later:
        later.seconds()
    with Listener(LOOPBACK) as earlier, peers.running(WORLD):
        earlier.seconds()


def test_a_simulation_on_127_0_0_1_alone_meets_its_like():
    local = {"ROS_LOCALHOST_ONLY": "1"}
    with peers.running(WORLD, environment=local), Listener(LOOPBACK) as listener:
        listener.seconds()


def test_they_meet_again_after_a_node_was_killed():
    with peers.running(WORLD):
        for _ in range(5):
            with Listener() as listener:
                listener.seconds()


def test_they_meet_again_after_the_simulation_was_killed():
    peer = peers.Peer()
    clock = peer.reader("/clock", peers.Clock)
    for _ in range(3):
        with peers.running(WORLD) as simulation:
            peers.take_one(clock)
            simulation.send_signal(signal.SIGKILL)
            simulation.wait()
        while peers.take(clock):
            pass


def test_twenty_nodes_hear_the_clock():
    with peers.running(WORLD):
        listeners = [Listener() for _ in range(20)]
        try:
            for listener in listeners:
                listener.seconds()
        finally:
            for listener in listeners:
                listener.kill()


def test_a_domain_that_is_none_is_an_error(tmp_path):
    with open(tmp_path / "log", "w+") as log:
        with peers.running(WORLD, environment={"ROS_DOMAIN_ID": "233"}, log=log):
            peers.until(lambda: "ROS_DOMAIN_ID is '233', not an integer between 0 and 232"
                        in (tmp_path / "log").read_text(), "the message")
