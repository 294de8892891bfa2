"""Readers and writers of either reliability, late joiners, names within a namespace, damaged payloads."""

import re
import subprocess
import time
from dataclasses import dataclass, field

from cyclonedds.core import Policy, Qos
from cyclonedds.idl import IdlStruct
from cyclonedds.idl.types import array, uint8
from cyclonedds.util import duration

import peers

WORLD = peers.ROOT / "components/ros2/test/drive.sdf"
TRANSIENT = Qos(Policy.Reliability.Reliable(duration(seconds=1)), Policy.Durability.TransientLocal,
                Policy.History.KeepLast(1))


def moves(scans, write):
    """Waits until the wall comes closer while `write` is called."""
    ahead = peers.take_one(scans).ranges[30]

    def nearer():
        write()
        return any(scan.ranges[30] < ahead - 0.2 for scan in peers.take(scans))

    assert peers.until(nearer, "a wall that is nearer")


def test_writers_of_each_kind_are_obeyed():
    for qos in (peers.RELIABLE, peers.BEST_EFFORT, TRANSIENT):
        with peers.running(WORLD):
            peer = peers.Peer()
            scans = peer.reader("/lidar", peers.LaserScan)
            command = peer.writer("/cmd_vel", peers.Twist, qos)
            moves(scans, lambda: command.write(peers.Twist(linear=peers.Vector3(x=1.0))))


def test_readers_of_each_kind_hear_the_same():
    with peers.running(WORLD):
        peer = peers.Peer()
        readers = [peer.reader("/lidar", peers.LaserScan, qos) for qos in (peers.RELIABLE, peers.BEST_EFFORT)]
        stamps = [set(), set()]

        def have_common():
            for reader, seen in zip(readers, stamps):
                seen.update((scan.header.stamp.sec, scan.header.stamp.nanosec) for scan in peers.take(reader))
            return len(stamps[0] & stamps[1]) >= 10

        assert peers.until(have_common, "ten scans that both have")


def test_a_late_reader_hears_what_comes_from_then_on():
    with peers.running(WORLD):
        early = peers.Peer().reader("/clock", peers.Clock)
        first = peers.take_one(early).clock
        late = peers.take_one(peers.Peer().reader("/clock", peers.Clock)).clock
        assert (late.sec, late.nanosec) > (first.sec, first.nanosec)


def world_with(folder, name, settings):
    """The world with settings for the system."""
    text = WORLD.read_text().replace('name="pongsim::systems::Ros2"/>', f'name="pongsim::systems::Ros2">{settings}</plugin>')
    file = folder / name
    file.write_text(text)
    return file


def test_two_simulations_have_a_namespace_each(tmp_path):
    worlds = [world_with(tmp_path, f"{name}.sdf", f"<namespace>/{name}</namespace><frame_prefix>{name}/</frame_prefix>")
              for name in ("red", "blue")]
    # their own topics have the same names
    other = {"PONGSIM_DOMAIN": str(peers.take_domain())}
    with peers.running(worlds[0]), peers.running(worlds[1], environment=other):
        peer = peers.Peer()
        scans = {name: peer.reader(f"/{name}/lidar", peers.LaserScan) for name in ("red", "blue")}
        for name, reader in scans.items():
            assert peers.take_one(reader).header.frame_id == f"{name}/rover/chassis/lidar"
        command = peer.writer("/red/cmd_vel", peers.Twist)
        moves(scans["red"], lambda: command.write(peers.Twist(linear=peers.Vector3(x=1.0))))
        assert peers.take_one(scans["blue"]).ranges[30] > 4.5


@dataclass
class Damaged(IdlStruct, typename="geometry_msgs::msg::dds_::Twist_"):
    """Claims to be a Twist, but has the bytes of only one of its numbers, with DDS's padding."""
    few: array[uint8, 5] = field(default_factory=lambda: [255] * 5)


def test_what_is_damaged_or_no_number_is_said_and_the_rest_goes_on(tmp_path):
    log_file = tmp_path / "log"
    begin = time.monotonic()
    with open(log_file, "w") as log, peers.running(WORLD, log=log):
        peer = peers.Peer()
        scans = peer.reader("/lidar", peers.LaserScan)
        other = peers.Peer()
        damaged = other.writer("/cmd_vel", Damaged)

        def said(what, write):
            def look():
                write()
                return what in log_file.read_text()
            return look

        peers.until(said("a message on '/cmd_vel' is damaged: field 'y' is cut off; dropped",
                         lambda: damaged.write(Damaged())), "the warning")
        good = peer.writer("/cmd_vel", peers.Twist)
        nan = peers.Twist(linear=peers.Vector3(x=float("nan")))
        peers.until(said("a number in it is not finite", lambda: good.write(nan)), "the warning")
        moves(scans, lambda: good.write(peers.Twist(linear=peers.Vector3(x=1.0))))
        # once per second at most, whatever arrives
        for _ in range(2000):
            good.write(nan)
        peers.take_one(scans)
    lines = [line for line in log_file.read_text().splitlines() if "is damaged" in line]
    assert len(lines) <= time.monotonic() - begin + 1


def hash_of(*arguments):
    result = subprocess.run([peers.PONGSIM, "run", WORLD, "--hash", *arguments], capture_output=True,
                            text=True, check=True)
    return re.search(r"state hash: (\w+)", result.stdout).group(1)


def test_the_bits_are_the_same_with_readers_and_without():
    alone = hash_of("--iterations", "5000", "-z", "0")
    peer = peers.Peer()
    clock, scans = peer.reader("/clock", peers.Clock), peer.reader("/lidar", peers.LaserScan)

    def is_the_same_and_was_heard():
        # slow enough to be discovered
        assert hash_of("--iterations", "5000", "-z", "3000") == alone
        return peers.take(clock) and peers.take(scans)

    peers.until(is_the_same_and_was_heard, "messages of a run")
