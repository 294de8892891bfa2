"""Scenarios that compare with a recorded run."""

import re
import shutil
import subprocess

import jsonschema
import pytest
import yaml
from scenarios import HEAD, WORLD, command, write
from test_scenario_examples import SCHEMA

from pongsim.testing import World, expect, pose, recorded
from pongsim.testing.recordings import Kept

ARM = """<model name="arm"><pose>3 0 1 0 0 0</pose><link name="base"/>
  <link name="rod"><inertial><pose>0.5 0 0 0 0 0</pose></inertial></link>
  <joint name="fix" type="fixed"><parent>world</parent><child>base</child></joint>
  <joint name="hinge" type="revolute"><parent>base</parent><child>rod</child><axis><xyz>0 1 0</xyz></axis></joint></model>"""
WITH_ARM = WORLD.replace("</world>", ARM + "</world>").replace("0 0 2 0 0 0", "0 0 2 0 1 0.2")


@pytest.fixture(scope="module")
def good(tmp_path_factory):
    """A folder with a world and a recording of two seconds of it."""
    import os

    folder = tmp_path_factory.mktemp("good")
    write(folder, "w.sdf", WITH_ARM)
    subprocess.run([os.environ["PONGSIM"], "run", "w.sdf", "-z", "0", "--iterations", "2000", "--record-path", "good"], cwd=folder,
                   check=True, capture_output=True)
    return folder


def compare(good, entry, world=WITH_ARM):
    """Runs the world against the recording."""
    write(good, "v.sdf", world)
    write(good, "s.yaml", HEAD.replace("w.sdf", "v.sdf") + f"expect:\n  - {entry}\n")
    return command(good, "s.yaml")


def test_the_same_world_is_as_recorded(good):
    entry = "{recorded: good, tolerance: 0.00001}"
    code, out, err = compare(good, entry)
    assert (code, err) == (0, ""), out
    assert "(2 s in " in out, "it is compared to the end"
    jsonschema.validate(yaml.safe_load(HEAD + f"expect: [{entry}]"), SCHEMA)
    for entry in ("{recorded: good, tolerance: 0.1, at: 3}", "{recorded: good}"):
        with pytest.raises(jsonschema.ValidationError):
            jsonschema.validate(yaml.safe_load(HEAD + f"expect: [{entry}]"), SCHEMA)


def test_the_first_difference_is_told_with_its_step(good):
    # it begins with a push at 1 s
    push = "request: [{service: /world/w/set_pose, type: Pose, message: {name: ball, position: {x: 0.5, z: 0.5}}, at: 1}]\n"
    write(good, "v.sdf", WITH_ARM)
    write(good, "s.yaml", HEAD + "expect:\n  - {recorded: good, tolerance: 0.001}\n" + push)
    code, out, _ = command(good, "s.yaml")
    assert code == 1
    seen = re.search(r"seen      ball: x = 0\.5 instead of 0 at (1\S*) s, step (\d+); [23] of \d+ numbers differ$", out, re.MULTILINE)
    assert seen, out
    assert 1000 <= int(seen[2]) <= 1001
    assert "expected  always pose of ball: x as recorded ± 0.001, from 0.001 s to 2 s" in out


def test_a_changed_joint_is_told(good):
    world = WITH_ARM.replace("<xyz>0 1 0</xyz>", "<xyz>0 1 0</xyz><dynamics><damping>0.5</damping></dynamics>")
    code, out, _ = compare(good, "{recorded: good, tolerance: {position: 0.01, angle: 0.01, joint: 0.002}}", world)
    assert code == 1
    assert re.search(r"seen      arm::hinge: position = \S+ instead of \S+ at \S+ s, step \d+", out), out
    for entry in ("{recorded: good, tolerance: 0.001, of: [ball]}", "{recorded: good, tolerance: 0.01, during: [0, 0.01]}"):
        assert compare(good, entry, world)[0] == 0


def test_a_pitch_of_a_right_angle_is_told(tmp_path, program):
    """Roll and yaw are undetermined there."""
    up = WORLD.replace("0 0 2 0 0 0", "0 0 2 0 1.5707 0.2")
    write(tmp_path, "w.sdf", up)
    subprocess.run([program, "run", "w.sdf", "-z", "0", "--iterations", "300", "--record-path", "good"], cwd=tmp_path, check=True,
                   capture_output=True)
    for window in ("", ", during: [0, 0.2]"):
        code, out, err = compare(tmp_path, f"{{recorded: good, tolerance: 1e-5{window}}}", up)
        assert code == 0, out
        assert "s.yaml:4:16: warning: roll and yaw of 'ball' are compared up to 0.001 s only, where its pitch comes near" in err


def test_a_field_of_a_pose_and_of_a_joint(good):
    for entry in ("{pose: ball, always: {z: {recorded: good, tolerance: 1e-4}, yaw: {recorded: good, tolerance: 0.01}}}",
                  "{joint: 'arm::hinge', always: {position: {recorded: good/state.tlog, tolerance: 1e-4}}}"):
        code, out, err = compare(good, entry)
        assert (code, err) == (0, ""), out
    code, out, _ = compare(good, "{pose: ball, always: {z: {recorded: good, tolerance: 1e-4}}}", WITH_ARM.replace("0 0 2 0", "0 0 2.01 0"))
    assert code == 1 and " instead of " in out


MISTAKES = {
    "no file": ("{recorded: god, tolerance: 1}", "s.yaml:4:16: error: there is no file god"),
    "no tolerance": ("{recorded: good}", "s.yaml:4:5: error: a comparison with a recorded run needs a 'tolerance' (write"),
    "half a tolerance": ("{recorded: good, tolerance: {position: 1}}", "'tolerance' has no 'angle' (write {position: 0.001"),
    "no such thing": ("{recorded: good, tolerance: 1, of: [bal]}", "good has no model or joint 'bal' (did you mean 'ball'?)"),
    "a word": ("{recorded: good, tolerance: 1, off: [bal]}", "a comparison with a recorded run has no 'off' (did you mean 'of'?)"),
    "a time": ("{recorded: good, tolerance: 1, at: 1}", "'at' does not go with a recorded run (write during: [1, 3])"),
    "no model": ("{pose: bal, always: {x: {recorded: good, tolerance: 1}}}", "good/state.tlog has no pose of 'bal' (did you mean 'ball'?)"),
    "no time": ("{recorded: good, tolerance: 1, during: [5, 6]}", "error: the recorded run has nothing at that time"),
    "no velocity": ("{joint: 'arm::hinge', always: {velocity: {recorded: good, tolerance: 1}}}", "a recording has no 'velocity' of a joint"),
}


@pytest.mark.parametrize("entry, words", MISTAKES.values(), ids=MISTAKES.keys())
def test_mistakes(good, entry, words):
    code, out, err = compare(good, entry)
    assert (code, out) == (2, "")
    assert words in err


def test_what_the_world_lacks_is_a_mistake(good):
    code, out, _ = compare(good, "{recorded: good, tolerance: 1}", WORLD)
    assert code == 2
    assert "s.yaml:4:5: error: there is no model 'arm' (there is: ground, ball)" in out


def test_what_is_kept_of_recordings_is_bounded():
    kept = Kept(100)
    made = []

    def get(key, size):
        return kept.get(key, lambda: made.append(key) or key, lambda _: size)

    for key, size in [("a", 60), ("b", 40), ("a", 60), ("c", 30), ("a", 60), ("b", 40), ("large", 101), ("large", 101)]:
        assert get(key, size) == key
    assert made == ["a", "b", "c", "b", "large", "large"], "the one not used for longest goes, and one beyond the bound at once"


def test_a_recording_that_is_made_anew_is_read_anew(tmp_path, program):
    for height in (2, 3):
        world = write(tmp_path, "w.sdf", WORLD.replace("0 0 2 0 0 0", f"0 0 {height} 0 0 0"))
        shutil.rmtree(tmp_path / "good", ignore_errors=True)
        subprocess.run([program, "run", world, "-z", "0", "--iterations", "200", "--record-path", "good"], cwd=tmp_path, check=True,
                       capture_output=True)
        with World(str(world)) as opened:
            expect(pose("ball")).always(z=recorded(tmp_path / "good", 0.001))
            opened.run(0.2)


def test_a_recording_that_is_cut_is_compared_up_to_there(good):
    whole = (good / "good/state.tlog").read_bytes()
    (good / "cut.tlog").write_bytes(whole[:len(whole) * 2 // 3])
    code, out, err = compare(good, "{recorded: cut.tlog, tolerance: 1e-5}")
    assert code == 0, out + err
    assert re.fullmatch(r"s\.yaml:4:16: warning: .*; it is compared up to there\n", err), err
    assert "(2 s in " not in out
    (good / "cut.tlog").write_bytes(whole[:5000])
    code, out, err = compare(good, "{recorded: cut.tlog, tolerance: 1e-5}")
    assert (code, out) == (2, "")
    assert "s.yaml:4:16: error: " in err
