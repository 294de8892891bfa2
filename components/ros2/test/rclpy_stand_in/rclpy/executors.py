"""Runs a node's callbacks one after the other, on the thread that spins."""

import time

import rclpy
from cyclonedds.util import duration

# Maximum delay until a signal is noticed.
LONGEST_WAIT = 0.1


class ExternalShutdownException(Exception):
    """The context ended while spinning."""


def spin_once(node, timeout_sec):
    context = rclpy.context()
    end = None if timeout_sec is None else time.monotonic() + timeout_sec
    while True:
        if not context.is_valid:
            raise KeyboardInterrupt if context.was_interrupted else ExternalShutdownException
        if _work(node):
            return
        wait = LONGEST_WAIT
        for timer in node.timers:
            wait = min(wait, timer.seconds_left())
        if end is not None:
            wait = min(wait, end - time.monotonic())
            if wait <= 0:
                return
        node.wait_set.wait(duration(seconds=max(wait, 0.0)))


def _work(node):
    """Runs due callbacks, and returns whether there were any."""
    done = node.follow_clock()
    for timer in node.timers:
        done = timer.call_when_due() or done
    for subscription in node.subscriptions:
        done = subscription.call_with_what_has_come() or done
    return done
