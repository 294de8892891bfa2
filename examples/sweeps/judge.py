"""Measures of speed.yaml in Python."""


def drift(sim, parameters):
    """How far the robot is beside its way [m]."""
    return abs(sim.model("pong_bot").pose.position[1])
