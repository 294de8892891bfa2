"""Many nodes with two simulations: each receives everything from its own one, and none disturbs another."""

import peers
import pytest
import ros_messages
from client import Steps

ros_messages.install()

from geometry_msgs.msg import Twist, Vector3  # noqa: E402
from sensor_msgs.msg import LaserScan  # noqa: E402

WORLD = peers.ROOT / "components/ros2/test/drive.sdf"
NODES = 20
DEEP = peers.Qos(peers.Policy.Reliability.Reliable(peers.duration(seconds=1)), peers.Policy.History.KeepLast(1000))


def world_in(folder, name):
    text = WORLD.read_text().replace(
        'name="pongsim::systems::Ros2"/>',
        f'name="pongsim::systems::Ros2"><namespace>/{name}</namespace><frame_prefix>{name}/</frame_prefix></plugin>')
    file = folder / f"{name}.sdf"
    file.write_text(text)
    return file


def nanoseconds(scan):
    return scan.header.stamp.sec * 10**9 + scan.header.stamp.nanosec


def test_twenty_nodes_hear_every_scan_of_the_simulation_in_their_namespace(tmp_path):
    # the simulations' own topics have the same names
    other = {"PONGSIM_DOMAIN": str(peers.take_domain())}
    # a writer keeps ten scans for slow readers, so no more at once, and on when they have arrived
    stepped = ["--paused", "-z", "0"]
    with (peers.running(world_in(tmp_path, "red"), *stepped),
          peers.running(world_in(tmp_path, "blue"), *stepped, environment=other)):
        steps = [Steps(peers.Peer(), f"/{name}/pongsim") for name in ("red", "blue")]
        nodes = [peers.Peer() for _ in range(NODES)]
        names = ["red" if i % 2 == 0 else "blue" for i in range(NODES)]
        # every fourth with the QoS that is usual for sensors
        qualities = [peers.BEST_EFFORT if i % 4 == 3 else DEEP for i in range(NODES)]
        readers = [node.reader(f"/{name}/lidar", LaserScan, quality)
                   for node, name, quality in zip(nodes, names, qualities)]
        command = nodes[0].writer("/red/cmd_vel", Twist)
        heard = [[] for _ in range(NODES)]
        now = 0

        def hear():
            for scans, reader in zip(heard, readers):
                scans.extend(peers.take(reader))

        def last_is_heard():
            """Whether every reader has received some, and misses none."""
            hear()
            return all(nanoseconds(scans[-1]) == now for scans, quality in zip(heard, qualities)
                       if quality is DEEP and scans)

        def all_have_enough():
            nonlocal now
            command.write(Twist(linear=Vector3(x=0.3)))
            for each in steps:
                each(200)
            now += 200_000_000
            peers.until(last_is_heard, f"the scan of {now} ns")
            return all(len(scans) > 30 for scans in heard)

        peers.until(all_have_enough, "thirty scans for each", patience=200)
        step = 50_000_000
        for scans, name, quality in zip(heard, names, qualities):
            assert {scan.header.frame_id for scan in scans} == {f"{name}/rover/chassis/lidar"}
            stamps = [nanoseconds(scan) for scan in scans]
            if quality is DEEP:
                # the first clock message is that of the first step, one step late
                stamps = [0 if stamp == 1_000_000 else stamp for stamp in stamps]
                assert {b - a for a, b in zip(stamps, stamps[1:])} == {step}
            else:
                assert all(b > a for a, b in zip(stamps, stamps[1:]))
        # what they have in common is the same
        for name in ("red", "blue"):
            by_stamp = {}
            for scans, own in zip(heard, names):
                for scan in scans if own == name else []:
                    stamp = (scan.header.stamp.sec, scan.header.stamp.nanosec)
                    assert by_stamp.setdefault(stamp, scan.ranges) == scan.ranges
        # the command was for one of them
        assert heard[0][-1].ranges[30] < heard[0][0].ranges[30] - 0.2
        assert heard[1][-1].ranges[30] == pytest.approx(heard[1][0].ranges[30], abs=1e-3)
