import os
import pathlib
import signal
import sys

import pytest

PROJECT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(PROJECT / "test/support"))

import pongsim  # noqa: E402
from test_domain import take_domain  # noqa: E402

# for the programs that tests run
os.environ["PONGSIM_DOMAIN"] = str(take_domain())
# a shell lets what it runs in the background ignore Ctrl-C, and so would they
signal.signal(signal.SIGINT, signal.default_int_handler)

COURT = PROJECT / "worlds/pong_world.sdf"
LIDAR = PROJECT / "worlds/pong_lidar.sdf"

BALL = """<?xml version="1.0"?>
<sdf version="1.9"><world name="w">
  <model name="ground"><static>true</static><link name="link"><collision name="c"><geometry><plane/></geometry></collision>
  </link></model>
  <model name="ball"><pose>0 0 2 0 0 0</pose><link name="link"><inertial><mass>2</mass></inertial>
    <collision name="c"><geometry><sphere><radius>0.5</radius></sphere></geometry></collision></link></model>
  <model name="arm"><pose>3 0 1 0 0 0</pose>
    <link name="base"/><link name="rod"><inertial><pose>0.5 0 0 0 0 0</pose></inertial></link>
    <joint name="fix" type="fixed"><parent>world</parent><child>base</child></joint>
    <joint name="hinge" type="revolute"><parent>base</parent><child>rod</child>
      <axis><xyz>0 0 1</xyz></axis></joint></model>
</world></sdf>"""


@pytest.fixture
def court():
    with pongsim.Simulation(COURT, seed=7) as simulation:
        yield simulation


@pytest.fixture
def ball():
    with pongsim.Simulation(BALL) as simulation:
        yield simulation


@pytest.fixture
def program():
    return os.environ["PONGSIM"]
