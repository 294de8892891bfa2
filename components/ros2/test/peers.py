"""What tests with peers share: a running simulation, and a node on Cyclone DDS."""

from dataclasses import dataclass, field

from cyclonedds.core import Policy, Qos
from cyclonedds.domain import DomainParticipant
from cyclonedds.idl import IdlStruct
from cyclonedds.idl.types import array, float32, float64, int32, sequence, uint8, uint32
from cyclonedds.pub import DataWriter, Publisher
from cyclonedds.sub import DataReader, Subscriber
from cyclonedds.topic import Topic
from cyclonedds.util import duration

from simulation import DOMAIN, PATIENCE, PONGSIM, ROOT, fortress, running, stop, take_domain, until  # noqa: F401

RELIABLE = Qos(Policy.Reliability.Reliable(duration(seconds=1)), Policy.History.KeepLast(10))
BEST_EFFORT = Qos(Policy.Reliability.BestEffort, Policy.History.KeepLast(10))
LATCHED = Qos(Policy.Reliability.Reliable(duration(seconds=1)), Policy.Durability.TransientLocal,
              Policy.History.KeepLast(1))


@dataclass
class Time(IdlStruct, typename="builtin_interfaces::msg::dds_::Time_"):
    sec: int32 = 0
    nanosec: uint32 = 0


@dataclass
class Clock(IdlStruct, typename="rosgraph_msgs::msg::dds_::Clock_"):
    clock: Time = field(default_factory=Time)


@dataclass
class Header(IdlStruct, typename="std_msgs::msg::dds_::Header_"):
    stamp: Time = field(default_factory=Time)
    frame_id: str = ""


@dataclass
class String(IdlStruct, typename="std_msgs::msg::dds_::String_"):
    data: str = ""


@dataclass
class Vector3(IdlStruct, typename="geometry_msgs::msg::dds_::Vector3_"):
    x: float64 = 0.0
    y: float64 = 0.0
    z: float64 = 0.0


@dataclass
class Twist(IdlStruct, typename="geometry_msgs::msg::dds_::Twist_"):
    linear: Vector3 = field(default_factory=Vector3)
    angular: Vector3 = field(default_factory=Vector3)


@dataclass
class LaserScan(IdlStruct, typename="sensor_msgs::msg::dds_::LaserScan_"):
    header: Header = field(default_factory=Header)
    angle_min: float32 = 0.0
    angle_max: float32 = 0.0
    angle_increment: float32 = 0.0
    time_increment: float32 = 0.0
    scan_time: float32 = 0.0
    range_min: float32 = 0.0
    range_max: float32 = 0.0
    ranges: sequence[float32] = field(default_factory=list)
    intensities: sequence[float32] = field(default_factory=list)


@dataclass
class Image(IdlStruct, typename="sensor_msgs::msg::dds_::Image_"):
    header: Header = field(default_factory=Header)
    height: uint32 = 0
    width: uint32 = 0
    encoding: str = ""
    is_bigendian: uint8 = 0
    step: uint32 = 0
    data: sequence[uint8] = field(default_factory=list)


@dataclass
class Gid24(IdlStruct, typename="rmw_dds_common::msg::dds_::Gid_"):
    data: array[uint8, 24] = field(default_factory=lambda: [0] * 24)


@dataclass
class NodeEntitiesInfo(IdlStruct, typename="rmw_dds_common::msg::dds_::NodeEntitiesInfo_"):
    node_namespace: str = ""
    node_name: str = ""
    reader_gid_seq: sequence[Gid24] = field(default_factory=list)
    writer_gid_seq: sequence[Gid24] = field(default_factory=list)


@dataclass
class ParticipantEntitiesInfo(IdlStruct, typename="rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_"):
    gid: Gid24 = field(default_factory=Gid24)
    node_entities_info_seq: sequence[NodeEntitiesInfo] = field(default_factory=list)


class Peer:
    """A participant with default settings, like that of a ROS node with rmw_cyclonedds."""

    def __init__(self, domain=DOMAIN):
        self.participant = DomainParticipant(domain)
        self._topics = {}

    def _topic(self, name, kind):
        wire = name if name == "ros_discovery_info" else "rt" + name
        key = (wire, kind)
        if key not in self._topics:
            self._topics[key] = Topic(self.participant, wire, kind)
        return self._topics[key]

    def reader(self, name, kind, qos=RELIABLE):
        return DataReader(Subscriber(self.participant), self._topic(name, kind), qos=qos)

    def writer(self, name, kind, qos=RELIABLE):
        return DataWriter(Publisher(self.participant), self._topic(name, kind), qos=qos)


def take(reader):
    """The received samples, without notices of removed writers."""
    return [sample for sample in reader.take(N=100) if sample.sample_info.valid_data]


def take_one(reader, patience=PATIENCE, where=lambda sample: True):
    """Waits for a sample that meets `where`, and returns the last of those that do."""
    def matching():
        fitting = [sample for sample in take(reader) if where(sample)]
        return fitting[-1:]

    return until(matching, "a sample", patience)[0]
