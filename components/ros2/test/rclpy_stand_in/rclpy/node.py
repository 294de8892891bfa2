"""A node: its topics, timers and parameters."""

import os

import peers
import rclpy
import ros_messages
from cyclonedds.core import InstanceState, ReadCondition, SampleState, ViewState, WaitSet
from cyclonedds.domain import DomainParticipant
from cyclonedds.pub import DataWriter
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic
from rosgraph_msgs.msg import Clock as ClockMessage

from rclpy.clock import Clock
from rclpy.exceptions import InvalidParameterTypeException, ParameterAlreadyDeclaredException
from rclpy.exceptions import ParameterNotDeclaredException
from rclpy.logging import Logger
from rclpy.qos import QoSProfile, ReliabilityPolicy
from rclpy.time import Time
from rclpy.timer import Timer


class Parameter:
    def __init__(self, name, value):
        self.name = name
        self.value = value


class Publisher:
    def __init__(self, writer):
        self._writer = writer

    def publish(self, message):
        ros_messages.check(message)
        self._writer.write(message)


class Subscription:
    def __init__(self, reader, callback):
        self._reader = reader
        self._callback = callback

    def call_with_what_has_come(self):
        """Not of rclpy: for the executor."""
        messages = peers.take(self._reader)
        for message in messages:
            self._callback(message)
        return bool(messages)


class Node:
    def __init__(self, node_name, *, namespace="/"):
        context = rclpy.context()
        self._arguments = context.arguments
        self._name = self._arguments.remappings.get("__node", node_name)
        self._namespace = self._arguments.remappings.get("__ns", namespace)
        self._clock = Clock()
        self._logger = Logger(self._full("~").strip("/").replace("/", "."), self._clock)
        self._participant = DomainParticipant(int(os.environ.get("ROS_DOMAIN_ID", "0")))
        self._topics = {}
        self._readers, self._writers = [], []
        self.wait_set = WaitSet(self._participant)
        self._conditions = []
        self.timers = []
        self.subscriptions = []
        self._parameters = {}
        self._discovery = DataWriter(
            self._participant, Topic(self._participant, "ros_discovery_info", peers.ParticipantEntitiesInfo),
            qos=peers.LATCHED)
        self._clock_reader = None
        if self.declare_parameter("use_sim_time", False).value:
            self._clock.simulated = 0
            self._clock_reader = self._reader("/clock", ClockMessage,
                                              QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT))
        self._tell()

    def get_name(self):
        return self._name

    def get_namespace(self):
        return self._namespace

    def get_clock(self):
        return self._clock

    def get_logger(self):
        return self._logger

    def declare_parameter(self, name, value):
        if name in self._parameters:
            raise ParameterAlreadyDeclaredException(name)
        given = self._arguments.parameters.get(name, value)
        if type(given) is not type(value):
            raise InvalidParameterTypeException(
                f"Trying to set parameter '{name}' to '{given}' of type '{type(given).__name__}', "
                f"expecting type '{type(value).__name__}'")
        self._parameters[name] = Parameter(name, given)
        return self._parameters[name]

    def get_parameter(self, name):
        if name not in self._parameters:
            raise ParameterNotDeclaredException(name)
        return self._parameters[name]

    def create_publisher(self, msg_type, topic, qos_profile):
        writer = DataWriter(self._participant, self._topic(topic, msg_type), qos=QoSProfile.of(qos_profile).for_dds())
        self._writers.append(writer)
        self._tell()
        return Publisher(writer)

    def create_subscription(self, msg_type, topic, callback, qos_profile):
        self.subscriptions.append(Subscription(self._reader(topic, msg_type, QoSProfile.of(qos_profile)), callback))
        self._tell()
        return self.subscriptions[-1]

    def create_timer(self, timer_period_sec, callback):
        self.timers.append(Timer(timer_period_sec, callback, self._clock))
        return self.timers[-1]

    def destroy_node(self):
        self.timers.clear()
        self.subscriptions.clear()
        self._readers.clear()
        self._writers.clear()

    def follow_clock(self):
        """Not part of rclpy: takes the last time from /clock; returns whether there was one."""
        times = peers.take(self._clock_reader) if self._clock_reader is not None else []
        for each in times:
            self._clock.simulated = Time.from_msg(each.clock).nanoseconds
        return bool(times)

    def _full(self, name):
        """The name of a topic with the namespace, and after remapping."""
        if name.startswith("~"):
            name = f"{self._name}{name[1:]}"
        absolute = name if name.startswith("/") else f"{self._namespace.rstrip('/')}/{name}"
        remappings = self._arguments.remappings
        return remappings.get(name, remappings.get(absolute, absolute))

    def _topic(self, name, kind):
        wire = "rt" + self._full(name)
        if (wire, kind) not in self._topics:
            self._topics[wire, kind] = Topic(self._participant, wire, kind)
        return self._topics[wire, kind]

    def _reader(self, name, kind, profile):
        reader = DataReader(self._participant, self._topic(name, kind), qos=profile.for_dds())
        self._conditions.append(ReadCondition(reader, SampleState.NotRead | ViewState.Any | InstanceState.Any))
        self.wait_set.attach(self._conditions[-1])
        self._readers.append(reader)
        return reader

    def _tell(self):
        """Announces to other participants which node owns the endpoints."""
        def gid(entity):
            return peers.Gid24(data=[*entity.guid.bytes, *bytes(8)])

        self._discovery.write(peers.ParticipantEntitiesInfo(
            gid=gid(self._participant),
            node_entities_info_seq=[peers.NodeEntitiesInfo(
                node_namespace=self._namespace, node_name=self._name, reader_gid_seq=[*map(gid, self._readers)],
                writer_gid_seq=[*map(gid, self._writers)])]))
