"""Measures of speed.yaml in Python."""


def drift(sim, parameters):
    """Distance of the robot from its path [m]."""
    return abs(sim.model("pong_bot").pose.position[1])
