"""Tests of robots: what is expected of a world, in scenarios and in Python.

    from pongsim.testing import World, above, expect, topic

    with World("pong_world.sdf") as world:
        world.publish("/cmd_vel", {"linear": {"x": 0.5}})
        expect(topic("/model/pong_bot/odometry")).eventually(pose__position__x=above(0.3), within=5)
        world.run(10)
"""

from .scenario import Case, Scenario, read
from .world import (
    Expectation,
    Signal,
    World,
    above,
    at_least,
    at_most,
    below,
    between,
    contact,
    contains,
    differs,
    expect,
    joint,
    near,
    pose,
    recorded,
    topic,
    velocity,
)

__all__ = [
    "Case",
    "Expectation",
    "Scenario",
    "Signal",
    "World",
    "above",
    "at_least",
    "at_most",
    "below",
    "between",
    "contact",
    "contains",
    "differs",
    "expect",
    "joint",
    "near",
    "pose",
    "read",
    "recorded",
    "topic",
    "velocity",
]
