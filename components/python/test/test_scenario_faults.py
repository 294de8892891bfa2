"""Scenarios with faults on purpose."""

import re
import subprocess

from scenarios import HEAD, LANDS, WORLD, run, write

from pongsim.testing import read
from pongsim.testing.execute import execute

ODOMETRY = "/model/ball/odometry"
HEARD = HEAD + "expect:\n  - {topic: " + ODOMETRY + ", eventually: {pose.position.z: {below: 3}}, within: 0.5}\n"


def test_a_fault_acts(tmp_path):
    assert run(tmp_path, HEARD)[0] == 0
    code, out, _ = run(tmp_path, HEARD + f"faults: [{{type: drop, topic: {ODOMETRY}, to: 1}}]\n")
    assert code == 1
    assert "no message came" in out
    assert run(tmp_path, HEARD + f"faults: [{{type: drop, topic: {ODOMETRY}, from: 1}}]\n")[0] == 0


def test_a_parameter_goes_into_a_fault(tmp_path):
    text = HEARD + f"faults: [{{type: drop, topic: {ODOMETRY}, probability: $p}}]\nparameters: {{p: {{values: [0, 1]}}}}\n"
    code, out, _ = run(tmp_path, text)
    assert code == 1
    assert re.search("^ok .* p=0 ", out, re.MULTILINE) and re.search("^FAIL .* p=1 ", out, re.MULTILINE)


def test_chance_comes_from_the_seed(tmp_path):
    text = LANDS.replace("2", "0.5", 1).replace("eventually", "never") + (
        f"  - {{topic: {ODOMETRY}, always: {{pose.position.z: {{above: 3}}}}}}\n"
        f"faults: [{{type: drop, topic: {ODOMETRY}, probability: 0.9}}]\nseeds: 6\n")
    write(tmp_path, "w.sdf", WORLD)
    cases = read(write(tmp_path, "s.yaml", text)).cases
    # the first message that is not dropped
    first = [[execute(case).judged[1].time for case in cases] for _ in range(2)]
    assert first[0] == first[1]
    assert len(set(first[0])) > 2


def test_a_fault_that_never_acts_is_a_mistake(tmp_path):
    code, out, _ = run(tmp_path, LANDS + "faults: [{type: drop, topic: model/ball/odometri}]\n")
    assert code == 2
    assert ("s.yaml:6:30: error: nobody in the world uses the topic /model/ball/odometri, which has a fault "
            "(did you mean '/model/ball/odometry'?)") in out


PENDULUM = """<sdf version="1.9"><world name="w"><model name="arm">
  <link name="base"/><link name="rod"><inertial><pose>0.5 0 0 0 0 0</pose></inertial></link>
  <joint name="fix" type="fixed"><parent>world</parent><child>base</child></joint>
  <joint name="hinge" type="revolute"><parent>base</parent><child>rod</child><axis><xyz>0 1 0</xyz></axis></joint>
</model></world></sdf>"""


def test_it_is_as_with_the_option(tmp_path, program):
    """The same bits as of `pongsim run --fault`."""
    world = write(tmp_path, "pendulum.sdf", PENDULUM)
    text = f"world: {world}\nduration: 1\nexpect: [{{pose: arm, always: {{z: {{above: -1}}}}}}]\n"
    hashes = set()
    for faults, options in (("", []), ("faults: [{type: stick, joint: 'arm::hinge', from: 0.3}]\n",
                                       ["--fault", "stick joint=arm::hinge from=0.3"])):
        result = execute(read(write(tmp_path, "s.yaml", text + faults)).cases[0])
        done = subprocess.run([program, "run", world, "-z", "0", "--iterations", "1000", "--hash", *options],
                              capture_output=True, text=True)
        assert done.stdout == f"state hash: {result.state_hash}\n", done.stderr
        hashes.add(result.state_hash)
    assert len(hashes) == 2
