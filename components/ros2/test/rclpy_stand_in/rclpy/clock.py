"""The time of a node: wall time, or that of the topic /clock."""

import time

from rclpy.time import Time


class Clock:
    def __init__(self):
        # set if the node has use_sim_time: 0 until the first message on /clock
        self.simulated = None

    def now(self):
        return Time(nanoseconds=time.time_ns() if self.simulated is None else self.simulated)
