"""How real nodes are met, with ROS's variables for that."""

import contextlib
import os
import pathlib
import subprocess
import sys

import pytest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import simulation  # noqa: E402

WORLD = simulation.ROOT / "components/ros2/test/drive.sdf"
DISTRO = os.environ["ROS_DISTRO_OF_TEST"]


@contextlib.contextmanager
def clock_listener(environment):
    process = subprocess.Popen([sys.executable, HERE / "clock_listener.py"], stdout=subprocess.PIPE, text=True,
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
    with simulation.running(WORLD, "--ros2-distro", DISTRO, environment=environment):
        with clock_listener(environment) as later:
            assert later.wait(simulation.PATIENCE) == 0
    with clock_listener(environment) as earlier, simulation.running(WORLD, "--ros2-distro", DISTRO,
                                                                    environment=environment):
        assert earlier.wait(simulation.PATIENCE) == 0
