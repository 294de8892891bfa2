"""A stand-in for rclpy, for tests: see README.md beside it."""

import signal

from rclpy import arguments, executors
from rclpy.executors import ExternalShutdownException  # noqa: F401

_context = None


class _Context:
    """Created by `init` and ended by `shutdown`: the arguments, and whether to continue."""

    def __init__(self, args):
        self.arguments = arguments.parse(args)
        self.nodes = []
        self.is_valid = True
        self.was_interrupted = False
        self._old = {number: signal.signal(number, self._end) for number in (signal.SIGINT, signal.SIGTERM)}

    def _end(self, number, _frame):
        self.was_interrupted = number == signal.SIGINT
        self.is_valid = False

    def end(self):
        self.is_valid = False
        for number, handler in self._old.items():
            signal.signal(number, handler)


def init(*, args=None):
    global _context
    if _context is not None:
        raise RuntimeError("Context.init() must only be called once")
    _context = _Context(args)


def context():
    """Not part of rclpy: state shared by the other modules."""
    if _context is None:
        raise RuntimeError("rclpy.init() has not been called")
    return _context


def ok():
    return _context is not None and _context.is_valid


def try_shutdown():
    global _context
    if _context is not None:
        _context.end()
        _context = None


def shutdown():
    if _context is None:
        raise RuntimeError("rclpy.shutdown() called without rclpy.init()")
    try_shutdown()


def spin(node):
    while True:
        spin_once(node)


def spin_once(node, *, timeout_sec=None):
    executors.spin_once(node, timeout_sec)
