"""Mistakes in scenarios: told with file, line and column, before anything runs."""

import pytest
from scenarios import HEAD, LANDS, WORLD, command, run, write

BALL = "  - {pose: ball, always: {z: {below: 3}}}\n"
EXPECT = HEAD + "expect:\n"
LOCKSTEP = "programs: [{{command: sleep 60}}]\nlockstep: {{topics: ['{}']}}\n"

IN_THE_FILE = {
    "empty": ("", r"s.yaml:1:1: error: the file is empty"),
    "no world": ("duration: 1\nexpect: []\n", r"s.yaml:1:1: error: a scenario has no 'world'"),
    "no file": (LANDS.replace("w.sdf", "v.sdf"), r"s.yaml:1:8: error: there is no file v.sdf (did you mean 'w.sdf'?)"),
    "a known world": (LANDS.replace("w.sdf", "pong_wrld.sdf"), "there is no file pong_wrld.sdf (did you mean 'pong_world.sdf'?)"),
    "a key": (LANDS + "expct: 1\n", r"s.yaml:6:8: error: a scenario has no 'expct' (did you mean 'expect'?)"),
    "nothing expected": (HEAD + "expect: []\n", r"s.yaml:3:1: error: expect is empty"),
    "no mode": (EXPECT + "  - pose: ball\n", "s.yaml:4:5: error: an expectation has none of eventually, always, never, in_order"),
    "two modes": (EXPECT + "  - {pose: ball, always: {z: 1}, never: {z: 2}}\n", "s.yaml:4:5: error: an expectation has always and never"),
    "no signal": (EXPECT + "  - always: {z: 1}\n", "s.yaml:4:5: error: an expectation has nothing to watch (give one of topic, pose"),
    "two signals": (EXPECT + "  - {pose: ball, topic: /a, always: {z: 1}}\n", "has topic and pose"),
    "a comparison": (EXPECT + "  - pose: ball\n    always: {z: {blow: 3}}\n",
                     "s.yaml:5:24: error: there is no comparison 'blow' (did you mean 'below'?)"),
    "an inner field": (EXPECT + "  - topic: /a\n    always: {pose: {position: {x: 3}}}\n", "write 'pose.position'"),
    "no tolerance": (EXPECT + "  - {pose: ball, always: {z: {near: 3}}}\n", "'near' of 'z' needs a 'tolerance' (write z: {near: 3, tolerance: 0.1})"),
    "a tolerance alone": (EXPECT + "  - {pose: ball, always: {z: {above: 3, tolerance: 1}}}\n", "'tolerance' goes with near"),
    "bounds": (EXPECT + "  - {pose: ball, always: {z: {between: [2, 1]}}}\n", "2 is above 1"),
    "no fields": (EXPECT + "  - {pose: ball, always: true}\n", "a pose is always there"),
    "a text": (EXPECT + "  - {pose: ball, always: {z: {below: high}}}\n", "s.yaml:4:38: error: 'below' of 'z' must be a number, not 'high'"),
    "no window": (EXPECT + "  - {pose: ball, always: {z: 1}, within: 3}\n", "'within' does not go with 'always' (write during: [0, 3]"),
    "until": (EXPECT + "  - {pose: ball, eventually: {z: 1}, until: {topic: /a}}\n", "'until' goes with 'always' or 'never'"),
    "order": (EXPECT + "  - {in_order: [{pose: ball, is: {z: 1}}], topic: /a}\n", "'topic' goes into the events of 'in_order'"),
    "an event": (EXPECT + "  - {pose: ball, always: {z: 1}, after: {topic: /a, data: 1}}\n", "'after' has no 'data'"),
    "during": (EXPECT + "  - {pose: ball, always: {z: 1}, during: [3, 1]}\n", "'during' is [from, to]"),
    "a parameter": (EXPECT + "  - {pose: ball, always: {z: {below: $hight}}}\nparameters: {height: {values: [1]}}\n",
                    "$hight is not a parameter (did you mean 'height'?)"),
    "unused": (LANDS + "parameters: {height: {values: [1]}}\n", "s.yaml:6:14: error: parameter 'height' is not used"),
    "a program": (LANDS + "programs: [{comand: x}]\n", "a program has no 'comand' (did you mean 'command'?)"),
    "ready": (LANDS + "programs: [{command: x, ready: {prints: '('}}]\n", "'(' is not a regular expression"),
    "a request": (LANDS + "request: [{service: /x, message: {}}]\n", "a request has no 'type' (for example type: EntityFactory)"),
    "a system": (LANDS + "systems: [{filename: x}]\n", "a system has no 'name'"),
    "xml": (LANDS + "systems: [{filename: x, name: y, xml: <a>}]\n", "s.yaml:6:39: error: 'xml' is not the inside of a <plugin>: mismatched tag"),
    "a fault": (LANDS + "faults: [{type: dorp, topic: /a}]\n", "s.yaml:6:17: error: there is no fault 'dorp' (did you mean 'drop'?)"),
    "a fault without a type": (LANDS + "faults: [{topic: /a}]\n", "s.yaml:6:10: error: a fault has no 'type' (types are drop, "),
    "a word of a fault": (LANDS + "faults: [{type: drop, topic: /a, probabilty: 1}]\n",
                          "a fault of type 'drop' has no 'probabilty' (did you mean 'probability'?)"),
    "a fault of nothing": (LANDS + "faults: [{type: drop}]\n", "s.yaml:6:10: error: a fault of type 'drop' has no 'topic'"),
    "a lockstep without programs": (LANDS + "lockstep: {topics: [/a]}\n", "s.yaml:6:1: error: 'lockstep' waits for messages of programs"),
    "a lockstep without topics": (LANDS + "lockstep: {topic: /a}\n", "lockstep has no 'topic' (did you mean 'topics'?)"),
    "a lockstep of no steps": (LANDS + LOCKSTEP.format("/a:0"), "s.yaml:7:21: error: '/a:0' has '0' where a whole number from 1 belongs (a topic"),
    "a start": (LANDS + LOCKSTEP.format("/a'], start: ['/b c"), "error: '/b c' has a space"),
    "late": (LANDS + LOCKSTEP.format("/a'], late: ['x").replace("['x']", "contnue"), "'late' is end or continue, not 'contnue' (did you mean 'continue'?)"),
    "keep": (LANDS + "keep: [recordings]\n", "there is no 'recordings' to keep (did you mean 'recording'?)"),
    "a recording": (EXPECT + "  - {topic: /a, always: {z: {recorded: old.mcap, tolerance: 1}}}\n", "there is no file old.mcap"),
    "too many": (LANDS + "seeds: 20000\n", "these are 20000 runs, more than 10000 (pongsim sweep makes that many)"),
}


@pytest.mark.parametrize("text, words", IN_THE_FILE.values(), ids=IN_THE_FILE.keys())
def test_of_the_file(tmp_path, text, words):
    code, out, err = run(tmp_path, text)
    assert (code, out) == (2, "")
    assert words in err


IN_THE_WORLD = {
    "a model": ("  - {pose: bal, always: {z: {below: 3}}}\n", "s.yaml:4:5: error: there is no model 'bal' (did you mean 'ball'?)"),
    "a joint": ("  - {joint: ball::hinge, always: {position: 3}}\n", "s.yaml:4:5: error: there is no joint 'ball::hinge'"),
    "a contact": ("  - {contact: [ball, groud], eventually: true}\n", "there is no model, link or collision 'groud' (did you mean 'ground'?)"),
    "a field": ("  - {pose: ball, always: {height: {below: 3}}}\n", "it has no field 'height' (there is: x, y, z, roll, pitch, yaw)"),
    "a field of a topic": ("  - {topic: /model/ball/odometry, never: {pose.positon.z: 0}}\n", "field 'positon' is not in ignition.msgs.Pose (did you mean 'position'?)"),
    "a text for a number": ("  - {topic: /model/ball/odometry, never: {pose.position.z: high}}\n", "is a number, and not 'high'"),
    "a topic to publish on": (BALL + "publish: [{topic: /model/ball/odometri, message: {}, at: 1}]\n",
                              "s.yaml:5:11: error: the world has no topic /model/ball/odometri (did you mean '/model/ball/odometry'?"),
    "a message": (BALL + "publish: [{topic: /a, type: Twist, message: {liner: {x: 1}}, at: 1}]\n", "no field 'liner'"),
    "a value of a fault": (BALL + "faults: [{type: drop, topic: /model/ball/odometry, probability: 2}]\n",
                           "s.yaml:5:65: error: 'probability' of a fault must be a number from 0 to 1, not '2'"),
    "a joint with a fault": (BALL + "faults: [{type: stick, joint: ball::hinge}]\n",
                             "s.yaml:5:31: error: there is no joint 'ball::hinge'"),
    "a type": (BALL + "publish: [{topic: /a, type: Twst, message: {}, at: 1}]\n", "Twist"),
}


@pytest.mark.parametrize("entry, words", IN_THE_WORLD.values(), ids=IN_THE_WORLD.keys())
def test_of_the_world(tmp_path, entry, words):
    code, out, err = run(tmp_path, EXPECT + entry)
    assert (code, err) == (2, "")
    assert words in out
    assert "(0 s in " in out, "nothing was run"


def test_all_mistakes_are_told_at_once(tmp_path):
    text = """world: w.sdf
duration: -1
programs: [{comand: foo}]
publish:
  - {topic: /a, mesage: {}}
  - {topic: /b, message: 3}
expect:
  - {pose: ball, always: {z: {blow: 1}}}
  - {pose: ball, alwys: {z: 1}}
faults: [{type: drp, topic: /a}]
keep: [pictures]
"""
    code, out, err = run(tmp_path, text, "--github")
    assert (code, out.count("::error file=s.yaml,line=")) == (2, 8)
    places = [line.split(": ")[0] for line in err.splitlines()]
    assert places == [f"s.yaml:{place}" for place in ("2:11", "3:21", "5:17", "6:26", "8:37", "9:18", "10:17", "11:8")]


def test_all_mistakes_of_the_world_are_told_at_once(tmp_path):
    code, out, _ = run(tmp_path, EXPECT + "  - {pose: bal, always: {z: 1}}\n  - {pose: ball, always: {w: 1}}\npublish:\n"
                       "  - {topic: /b, message: {}}\n", "--github")
    assert code == 2
    for place in ("4:5", "5:5", "7:5"):
        assert f"\n     s.yaml:{place}: error: " in out
    assert out.count("::error file=s.yaml,line=") == 3


def test_all_files_are_checked_before_anything_runs(tmp_path):
    write(tmp_path, "w.sdf", WORLD)
    write(tmp_path, "good.yaml", LANDS)
    write(tmp_path, "one.yaml", LANDS + "a: 1\n")
    write(tmp_path, "two.yaml", LANDS + "b: 1\n")
    code, out, err = command(tmp_path, "good.yaml", "one.yaml", "two.yaml", "--github")
    assert code == 2
    assert "one.yaml:6:4: error: " in err and "two.yaml:6:4: error: " in err
    assert "good" not in out
    assert "::error file=one.yaml,line=6,col=4,title=one.yaml::a scenario has no 'a'" in out


def test_a_topic_that_nobody_publishes_is_named_with_the_nearest(tmp_path):
    for mode in ("eventually", "never"):
        code, out, _ = run(tmp_path, EXPECT + f"  - {{topic: /model/ball/odometri, {mode}: true}}\n")
        assert code == 1
        assert "nobody publishes /model/ball/odometri (did you mean '/model/ball/odometry'?)" in out


def test_a_world_with_an_error_is_told_with_its_place(tmp_path):
    write(tmp_path, "bad.sdf", "<sdf version='1.9'><world name='w'>\n<model name='m'><link/></model></world></sdf>")
    write(tmp_path, "s.yaml", LANDS.replace("w.sdf", "bad.sdf"))
    code, out, _ = command(tmp_path, "s.yaml")
    assert code == 1
    assert "the world can't be loaded: bad.sdf:2:" in out


@pytest.mark.parametrize("arguments, words", [
    ([], "which scenarios?"), (["--jobs", "0", "s.yaml"], "invalid number value"), (["--bla"], "there is no option --bla ("), (["--junti", "x"], "there is no option --junti (did you mean '--junit'?)"),
    (["nowhere.yaml"], "nowhere.yaml: No such file or directory"),
])
def test_of_the_command_line(tmp_path, arguments, words):
    code, out, err = command(tmp_path, *arguments)
    assert (code, out) == (2, "")
    assert words in err
