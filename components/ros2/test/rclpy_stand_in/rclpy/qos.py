"""Quality of service."""

import enum

from cyclonedds.core import Policy, Qos
from cyclonedds.util import duration

ReliabilityPolicy = enum.Enum("ReliabilityPolicy", {"RELIABLE": 1, "BEST_EFFORT": 2})
DurabilityPolicy = enum.Enum("DurabilityPolicy", {"TRANSIENT_LOCAL": 1, "VOLATILE": 2})
HistoryPolicy = enum.Enum("HistoryPolicy", {"KEEP_LAST": 1})


class QoSProfile:
    def __init__(self, *, depth, reliability=ReliabilityPolicy.RELIABLE, durability=DurabilityPolicy.VOLATILE,
                 history=HistoryPolicy.KEEP_LAST):
        self.depth = depth
        self.reliability = reliability
        self.durability = durability
        self.history = history

    @classmethod
    def of(cls, profile_or_depth):
        return profile_or_depth if isinstance(profile_or_depth, cls) else cls(depth=profile_or_depth)

    def for_dds(self):
        """Not of rclpy."""
        reliability = (Policy.Reliability.Reliable(duration(milliseconds=100))
                       if self.reliability == ReliabilityPolicy.RELIABLE else Policy.Reliability.BestEffort)
        durability = (Policy.Durability.TransientLocal if self.durability == DurabilityPolicy.TRANSIENT_LOCAL
                      else Policy.Durability.Volatile)
        return Qos(reliability, durability, Policy.History.KeepLast(self.depth))


qos_profile_sensor_data = QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)
