"""How real nodes are met, with ROS's variables for that."""

import contextlib
import os
import pathlib
import subprocess
import sys

import pytest
import ros
import simulation


LISTENER = pathlib.Path(__file__).with_name("clock_listener.py")


@contextlib.contextmanager
def clock_listener(environment):
    process = subprocess.Popen([sys.executable, LISTENER], stdout=subprocess.PIPE, text=True,
                               env={**os.environ, **environment})
    try:
        assert process.stdout.readline() == "listens\n"
        yield process
    finally:
        process.kill()
        process.communicate()


@pytest.mark.parametrize("environment", [{}, {"ROS_LOCALHOST_ONLY": "1"}, {"ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}],
                         ids=lambda each: " ".join(each) or "none")
def test_the_same_variables_on_both_sides(environment):
    with simulation.running(ros.WORLD, environment=environment):
        with clock_listener(environment) as later:
            assert later.wait(simulation.PATIENCE) == 0
    with clock_listener(environment) as earlier, simulation.running(ros.WORLD, environment=environment):
        assert earlier.wait(simulation.PATIENCE) == 0
