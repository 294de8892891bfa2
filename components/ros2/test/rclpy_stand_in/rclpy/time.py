"""Points in time."""

import functools

from builtin_interfaces.msg import Time as TimeMessage

from rclpy.duration import Duration


@functools.total_ordering
class Time:
    def __init__(self, *, seconds=0, nanoseconds=0):
        self.nanoseconds = int(seconds * 10**9) + int(nanoseconds)

    @classmethod
    def from_msg(cls, message):
        return cls(seconds=message.sec, nanoseconds=message.nanosec)

    def to_msg(self):
        return TimeMessage(sec=self.nanoseconds // 10**9, nanosec=self.nanoseconds % 10**9)

    def __sub__(self, other):
        if isinstance(other, Time):
            return Duration(nanoseconds=self.nanoseconds - other.nanoseconds)
        return Time(nanoseconds=self.nanoseconds - other.nanoseconds)

    def __add__(self, other):
        return Time(nanoseconds=self.nanoseconds + other.nanoseconds)

    def __eq__(self, other):
        return self.nanoseconds == other.nanoseconds

    def __lt__(self, other):
        return self.nanoseconds < other.nanoseconds

    def __repr__(self):
        return f"Time(nanoseconds={self.nanoseconds})"
