"""Expectations in Python: worlds under test, and the plugin of pytest."""

import os
import re
import subprocess
import sys

import pytest
from conftest import BALL
from scenarios import PACKAGES

import pongsim.testing
from pongsim.testing import (
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
    topic,
    velocity,
)


def test_what_is_met():
    with World(BALL) as world:
        world.publish("/flag", {"data": True}, type="Boolean")
        expect(topic("/flag")).eventually(data=True, within=0.1)
        expect(pose("ball")).eventually(z=below(1), within=1)
        expect(pose("ball")).always({"x": near(0, 0.01)}, y=between(-0.01, 0.01))
        expect(velocity("ball")).never(z=above(0.1), until=contact("ball", "ground"))
        expect(joint("arm::hinge")).always(position=at_most(0.1), velocity=at_least(-0.1))
        expect(contact("ball", "ground")).eventually(after=(pose("ball"), {"z": below(1)}), within=0.2)
        expect(pose("ball")).in_order({"z": below(1.9)}, (pose("ball"), {"z": below(1.5)}), contact("ball"), within=1)
        world.run(1)
        assert world.sim.time == 1


def test_what_is_not_met_is_told_with_its_line():
    with World(BALL) as world:
        expect(pose("ball")).always(z=above(1))
        expect(contact("ball", "ground")).never()
        expect(pose("ball")).always(x=0, during=(0, 0.1))
        with pytest.raises(AssertionError) as raised:
            world.run(1)
    text = str(raised.value)
    assert f"{__file__}:" in text
    assert "expected  always pose of ball: z > 1\n" in text and "seen      z = " in text
    assert "expected  never contact of ball with ground\n" in text
    assert "x = 0" not in text


def test_a_world_that_was_not_run_is_a_failure():
    with pytest.raises(AssertionError, match="but the world was not run"):
        with World(BALL):
            expect(pose("ball")).always(z=above(1))


@pytest.mark.parametrize("make, words", [
    (lambda: expect(pose("bal")).always(z=above(1)), r"there is no model 'bal' \(did you mean 'ball'\?\)"),
    (lambda: expect(pose("ball")).always(z={"abve": 1}), "there is no comparison 'abve'"),
    (lambda: expect(pose("ball")).always(), "needs a condition"),
    (lambda: expect(pose("ball")), "nothing is expected"),
    (lambda: expect(topic("/a")).eventually(data=contains("")), "must be text"),
])
def test_mistakes(make, words):
    world = World(BALL)
    try:
        with pytest.raises(ValueError, match=words):
            make()
            world.run(1)
    finally:
        world.close()


def test_without_a_world():
    with pytest.raises(RuntimeError, match="there is no world"):
        expect(topic("/a"))


def test_texts():
    with World(BALL) as world:
        world.publish("/text", {"data": "up and away"}, type="StringMsg")
        expect(topic("/text")).eventually(data=contains("away"))
        expect(topic("/text")).eventually(data=differs("down"))
        world.run(0.1)


def test_everything_has_a_docstring():
    assert [name for name in pongsim.testing.__all__ if not (getattr(pongsim.testing, name).__doc__ or "").strip()] == []


SUITE = '''
from pongsim.testing import above, expect, pose, topic

def test_it_drives(pongsim_world):
    world = pongsim_world("pong_world.sdf", seed=3)
    world.publish("/cmd_vel", {"linear": {"x": 0.5}})
    expect(topic("/model/pong_bot/odometry")).eventually(pose__position__x=above(0.3), within=5)
    world.run(10)

def test_it_flies(pongsim_world):
    world = pongsim_world("pong_world.sdf")
    expect(pose("pong_bot")).eventually(z=above(1))
    world.run(1)

def test_it_was_forgotten(pongsim_world):
    pongsim_world("pong_world.sdf")
    expect(pose("pong_bot")).eventually(z=above(1))
'''


def test_the_plugin_of_pytest(tmp_path):
    (tmp_path / "test_robot.py").write_text(SUITE)
    (tmp_path / "conftest.py").write_text('pytest_plugins = ["pongsim.testing.pytest_plugin"]\n')
    done = subprocess.run([sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider"], cwd=tmp_path, capture_output=True,
                          text=True, env={**os.environ, "PYTHONPATH": PACKAGES})
    assert done.returncode == 1
    assert "1 failed, 2 passed, 1 error in" in done.stdout, done.stdout
    assert "expected  eventually pose of pong_bot: z > 1" in done.stdout
    assert re.search(r"test_robot\.py:\d+: it is expected, but the world was not run: call run", done.stdout), done.stdout
