"""A world on ROS 2 and on ign-transport at once: what it says goes to both, what one of them says goes to the world
alone."""

import contextlib
import os
import pathlib
import signal
import subprocess

import peers
import pytest

PEER = pathlib.Path(os.environ.get("PONGSIM_IGN_PEER", peers.ROOT / "build/release/test/ign_peer"))
if not PEER.exists():
    pytest.skip("there is no peer of ign-transport", allow_module_level=True)

# Answers each text on /said with "yes", and each on /hello with "hello", both on /answer.
TRIGGER = """<plugin filename="ignition-gazebo-triggered-publisher-system"
      name="ignition::gazebo::systems::TriggeredPublisher">
    <input type="ignition.msgs.StringMsg" topic="{}"/>
    <output type="ignition.msgs.StringMsg" topic="/answer">data: "{}"</output></plugin>"""
WORLD = ("<sdf version='1.9'><world name='w'>" + TRIGGER.format("/said", "yes") + TRIGGER.format("/hello", "hello") +
         "</world></sdf>")
ENVIRONMENT = {**os.environ, "IGN_PARTITION": f"pongsim_both_{peers.DOMAIN}_{os.getpid()}", "IGN_IP": "127.0.0.1"}


class IgnPeer:
    """A program that uses only ign-transport; its output goes to a file."""

    def __init__(self, folder, *words):
        self.file = folder / f"peer_{'_'.join(words).replace('/', '')}"
        with open(self.file, "w") as said:
            self.process = subprocess.Popen([PEER, *words], stdout=said, env=ENVIRONMENT, stdin=subprocess.DEVNULL)

    def lines(self):
        return self.file.read_text().split()

    def end(self):
        self.process.send_signal(signal.SIGINT)
        self.process.wait(peers.PATIENCE)


@contextlib.contextmanager
def ign_peer(folder, *words):
    peer = IgnPeer(folder, *words)
    try:
        yield peer
    finally:
        peer.end()


class Listener:
    """The messages received by a ROS reader."""

    def __init__(self, topic):
        self.reader = peers.Peer().reader(topic, peers.String)
        self.texts = []

    def lines(self):
        self.texts += [sample.data for sample in peers.take(self.reader)]
        return self.texts


def test_what_is_said_goes_to_the_world_once_and_its_answer_to_both(tmp_path):
    file = tmp_path / "world.sdf"
    file.write_text(WORLD)
    ros = peers.Peer()
    with peers.running(file, "--ros2", "--ign", environment=ENVIRONMENT), \
            ign_peer(tmp_path, "texts", "/answer") as ign_answers, ign_peer(tmp_path, "texts", "/said") as ign_said:
        ros_answers, ros_said = Listener("/answer"), Listener("/said")
        greeter, writer = ros.writer("/hello", peers.String), ros.writer("/said", peers.String)

        def greeted(more_than):
            """Whether both have received more than this many answers to a greeting."""
            greeter.write(peers.String("hello"))
            return all(each.lines().count("hello") > more_than for each in (ros_answers, ign_answers))

        peers.until(lambda: greeted(0), "answers in ROS and by ign-transport")
        # the subscriber here, and the world
        peers.until(lambda: len(writer.get_matched_subscriptions()) >= 2, "who listens in ROS")
        for text in ("r1", "r2"):
            writer.write(peers.String(text))
        with ign_peer(tmp_path, "publish", "/said", "a", "b", "c"):
            for each in (ros_answers, ign_answers):
                peers.until(lambda each=each: each.lines().count("yes") >= 5, "an answer to each")
            peers.until(lambda: len(ign_said.lines()) >= 3, "what was said by ign-transport")
        # a duplicate would have arrived by the time of this many more messages
        count = max(each.lines().count("hello") for each in (ros_answers, ign_answers))
        peers.until(lambda: greeted(count + 20), "more answers")
        for each in (ros_answers, ign_answers):
            assert each.lines().count("yes") == 5
        # neither forwarded nor sent back
        assert ign_said.lines() == ["a", "b", "c"]
        assert ros_said.lines() == ["r1", "r2"]
