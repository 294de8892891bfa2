"""The time of a node: that of the wall, or that of the topic /clock."""

import time

from rclpy.time import Time


class Clock:
    def __init__(self):
        # set where the node has use_sim_time: 0 until the first message on /clock
        self.simulated = None

    def now(self):
        return Time(nanoseconds=time.time_ns() if self.simulated is None else self.simulated)
