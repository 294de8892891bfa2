"""The complete path: the clock, a command to the simulation, a scan from it."""

import peers


def test_a_node_drives_at_the_wall_and_sees_it_come_nearer():
    with peers.running(peers.ROOT / "components/ros2/test/drive.sdf"):
        peer = peers.Peer()
        clock = peer.reader("/clock", peers.Clock, peers.BEST_EFFORT)
        scans = peer.reader("/lidar", peers.LaserScan)
        command = peer.writer("/cmd_vel", peers.Twist)
        first = peers.take_one(clock)
        assert peers.take_one(clock, where=lambda sample: sample != first)

        start = peers.take_one(scans)
        assert start.header.frame_id == "rover/chassis/lidar"
        assert len(start.ranges) == 61
        ahead = start.ranges[30]
        assert 4 < ahead < 5

        def drive():
            command.write(peers.Twist(linear=peers.Vector3(x=0.5)))
            return [scan for scan in peers.take(scans) if scan.ranges[30] < ahead - 0.5]

        assert peers.until(drive, "a wall that is half a metre nearer")


def test_it_is_listed_as_a_node():
    with peers.running(peers.ROOT / "components/ros2/test/drive.sdf"):
        peer = peers.Peer()
        infos = peer.reader("ros_discovery_info", peers.ParticipantEntitiesInfo, peers.LATCHED)

        def complete():
            nodes = [node for info in peers.take(infos) for node in info.node_entities_info_seq]
            return [node for node in nodes if len(node.writer_gid_seq) > 1 and len(node.reader_gid_seq) > 0]

        node = peers.until(complete, "a node with its endpoints")[-1]
        assert (node.node_namespace, node.node_name) == ("/", "pongsim")
