"""Nodes on Fast DDS with the settings of rmw_fastrtps (fast_peer_main.cc): shared memory and UDP, by default."""

import os
import queue
import signal
import subprocess
import threading

import pytest
from rosbags.typesys import Stores, get_typestore

import peers

WORLD = peers.ROOT / "components/ros2/test/drive.sdf"
PROGRAM = os.environ.get("PONGSIM_FAST_PEER", str(peers.ROOT / "build/release/test/ros2_fast_peer"))
TYPES = get_typestore(Stores.ROS2_HUMBLE)
CAMERA = """
<sensor name="camera" type="camera"><topic>camera</topic><update_rate>30</update_rate><camera>
  <image><width>640</width><height>480</height></image></camera></sensor>
"""


def on_wire(name):
    package, kind, message = name.split("/")
    return f"{package}::{kind}::dds_::{message}_"


class Node:
    """A process with one reader or one writer."""

    def __init__(self, *arguments, environment=None, wrapper=()):
        self.process = subprocess.Popen([*wrapper, PROGRAM, *map(str, arguments)], stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, text=True,
                                        env={**os.environ, **(environment or {})})
        self.lines = queue.Queue()
        self._thread = threading.Thread(target=self._read, daemon=True)
        self._thread.start()

    def _read(self):
        for line in self.process.stdout:
            self.lines.put(line.split())
        self.lines.put(None)

    def next(self, word):
        """Waits for a line that begins so. What follows in it."""
        while True:
            line = self.lines.get(timeout=peers.PATIENCE)
            assert line is not None, "the node has ended"
            if line[0] == word:
                return line[1:]

    def kill(self):
        self.process.kill()
        self.process.wait()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.kill()
        self._thread.join()
        self.process.stdin.close()
        self.process.stdout.close()


class Reader(Node):
    def __init__(self, topic, name, qos="reliable", **options):
        super().__init__("read", topic, on_wire(name), qos, **options)
        self.name = name

    def payload(self):
        return bytes.fromhex(self.next("read")[1])

    def message(self):
        return TYPES.deserialize_cdr(self.payload(), self.name)


class Writer(Node):
    def __init__(self, topic, name, message, qos="reliable", period=20):
        super().__init__("write", topic, on_wire(name), qos, TYPES.serialize_cdr(message, name).hex(), period)


def clock_reader(qos="reliable", **options):
    return Reader("rt/clock", "rosgraph_msgs/msg/Clock", qos, **options)


def scan_reader():
    return Reader("rt/lidar", "sensor_msgs/msg/LaserScan")


def forward():
    vector = TYPES.types["geometry_msgs/msg/Vector3"]
    return TYPES.types["geometry_msgs/msg/Twist"](linear=vector(1.0, 0.0, 0.0), angular=vector(0.0, 0.0, 0.0))


def nanoseconds(message):
    return message.clock.sec * 10**9 + message.clock.nanosec


@pytest.mark.parametrize("qos", ["reliable", "best_effort"])
def test_the_clock_is_heard_whoever_comes_first(qos):
    with clock_reader(qos) as earlier, peers.running(WORLD):
        first = nanoseconds(earlier.message())
        with clock_reader(qos) as later:
            assert nanoseconds(later.message()) > first
        assert nanoseconds(earlier.message()) > first


@pytest.mark.parametrize("qos", ["reliable", "best_effort", "latched"])
def test_its_commands_drive_the_robot(qos):
    with peers.running(WORLD), scan_reader() as scans:
        ahead = scans.message().ranges[30]
        with Writer("rt/cmd_vel", "geometry_msgs/msg/Twist", forward(), qos):
            peers.until(lambda: scans.message().ranges[30] < ahead - 0.3, "a wall that is nearer")


def test_who_comes_late_hears_what_was_latched():
    name = "rmw_dds_common/msg/ParticipantEntitiesInfo"
    with peers.running(WORLD):
        with clock_reader() as clock:
            clock.message()
        with Reader("ros_discovery_info", name, "latched") as late:
            peers.until(lambda: b"pongsim\0" in late.payload(), "the node")


def test_a_writer_that_was_there_first_drives_the_robot():
    with Writer("rt/cmd_vel", "geometry_msgs/msg/Twist", forward()), peers.running(WORLD), scan_reader() as scans:
        peers.until(lambda: scans.message().ranges[30] < 4.5, "a wall that is nearer")


def test_pictures_come_whole(tmp_path):
    world = tmp_path / "camera.sdf"
    world.write_text(WORLD.read_text().replace('<sensor name="lidar"', CAMERA + '<sensor name="lidar"'))
    with peers.running(world), Reader("rt/camera", "sensor_msgs/msg/Image") as reader:
        stamps = []
        for _ in range(10):
            image = reader.message()
            assert (image.width, image.height, image.encoding) == (640, 480, "rgb8")
            assert image.data.size == 640 * 480 * 3 and len(set(image.data[::997].tolist())) > 1
            stamps.append(image.header.stamp.sec * 10**9 + image.header.stamp.nanosec)
        assert stamps == sorted(set(stamps))


def test_both_on_127_0_0_1_alone():
    local = {"ROS_LOCALHOST_ONLY": "1"}
    with clock_reader(environment=local) as earlier, peers.running(WORLD, environment=local):
        earlier.message()
        with clock_reader(environment=local) as later:
            later.message()


def test_they_meet_again_after_a_node_was_killed():
    with peers.running(WORLD):
        for _ in range(5):
            with clock_reader() as reader:
                reader.message()


def test_they_meet_again_after_the_simulation_was_killed():
    with scan_reader() as scans:
        for name in ("first", "second", "third"):
            # which identifies the simulation whose scans arrive
            with peers.running(WORLD, "--ros2-frame-prefix", f"{name}/") as simulation:
                peers.until(lambda: scans.message().header.frame_id.startswith(f"{name}/"), f"a scan of the {name} one")
                simulation.send_signal(signal.SIGKILL)
                simulation.wait()


def test_a_node_of_a_container_without_shared_memory_hears_the_clock():
    # another user, with other mounts, on the same network
    wrapper = ["unshare", "--user", "--map-root-user", "--mount", "--ipc", "sh", "-c",
               'mount -t tmpfs -o ro none /dev/shm && exec "$0" "$@"']
    may = subprocess.run([*wrapper, "true"], capture_output=True, text=True, timeout=60)
    if may.returncode != 0:
        pytest.skip(f"no namespaces can be made here: {may.stderr.strip()}")
    with peers.running(WORLD), clock_reader(wrapper=wrapper) as reader:
        first = nanoseconds(reader.message())
        assert nanoseconds(reader.message()) > first
