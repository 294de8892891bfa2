"""What differs between Humble and later distributions on the wire, both of which it speaks, and what identifies a ROS node."""

import re
from dataclasses import dataclass, field

import pytest
from cyclonedds.builtin import BuiltinDataReader, BuiltinTopicDcpsParticipant, BuiltinTopicDcpsPublication
from cyclonedds.core import Policy, Qos
from cyclonedds.idl import IdlStruct
from cyclonedds.idl.types import array, sequence, uint8
from rosbags.typesys import Stores, get_typestore

import peers

WORLD = peers.ROOT / "components/ros2/test/drive.sdf"


@dataclass
class Gid16(IdlStruct, typename="rmw_dds_common::msg::dds_::Gid_"):
    data: array[uint8, 16] = field(default_factory=lambda: [0] * 16)


@dataclass
class JazzyNode(IdlStruct, typename="rmw_dds_common::msg::dds_::NodeEntitiesInfo_"):
    node_namespace: str = ""
    node_name: str = ""
    reader_gid_seq: sequence[Gid16] = field(default_factory=list)
    writer_gid_seq: sequence[Gid16] = field(default_factory=list)


@dataclass
class JazzyInfo(IdlStruct, typename="rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_"):
    gid: Gid16 = field(default_factory=Gid16)
    node_entities_info_seq: sequence[JazzyNode] = field(default_factory=list)


def publications(peer):
    """The endpoints that the simulation publishes: type and user data, keyed by topic on the wire."""
    reader = BuiltinDataReader(peer.participant, BuiltinTopicDcpsPublication)
    found = {}

    def complete():
        for sample in reader.take(N=100):
            if not sample.sample_info.valid_data:
                continue
            policy = sample.qos[Policy.Userdata] if sample.qos is not None and Policy.Userdata in sample.qos else None
            found[sample.topic_name] = (sample.type_name, bytes(policy.data) if policy else b"", sample.key)
        return {"rt/lidar", "rt/clock", "ros_discovery_info"} <= found.keys()

    peers.until(complete, "the publications")
    return found


# what nodes from Iron on announce with each endpoint, and those of Humble do not
HASH = Policy.Userdata(b"typehash=RIHS01_" + b"0" * 64 + b";")
LATCHED_WITH_HASH = Qos(*peers.LATCHED.policies, HASH)


@pytest.mark.parametrize("info, qos", [(peers.ParticipantEntitiesInfo, peers.LATCHED), (JazzyInfo, LATCHED_WITH_HASH)],
                         ids=["humble", "jazzy"])
def test_nodes_of_any_distribution_learn_its_nodes(info, qos):
    types = get_typestore(Stores.ROS2_JAZZY)
    with peers.running(WORLD):
        peer = peers.Peer()
        found = publications(peer)
        for topic, name in [("rt/lidar", "sensor_msgs/msg/LaserScan"), ("rt/clock", "rosgraph_msgs/msg/Clock")]:
            assert found[topic][1] == f"typehash={types.hash_rihs01(name)};".encode(), topic

        # the node's endpoints are named by the ids that they have
        infos = peer.reader("ros_discovery_info", info, qos)
        lidar = list(found["rt/lidar"][2].bytes)

        def names_lidar():
            for sample in peers.take(infos):
                for node in sample.node_entities_info_seq:
                    if any(list(gid.data)[:16] == lidar for gid in node.writer_gid_seq):
                        return (node.node_namespace, node.node_name)
            return None

        assert peers.until(names_lidar, "a node that has the lidar") == ("/", "pongsim")


def test_its_participant_says_that_it_is_ros():
    with peers.running(WORLD):
        peer = peers.Peer()
        reader = BuiltinDataReader(peer.participant, BuiltinTopicDcpsParticipant)

        def says_so():
            for sample in reader.take(N=100):
                if sample.sample_info.valid_data and sample.qos is not None and Policy.Userdata in sample.qos:
                    if re.fullmatch(rb"enclave=/;(\w+=\w+;)*\0", bytes(sample.qos[Policy.Userdata].data)):
                        return True
            return False

        assert peers.until(says_so, "a participant of ROS")
