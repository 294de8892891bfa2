"""Scenarios whose world waits for programs."""

import os
import pathlib
import signal
import time

import pytest
from conftest import PROJECT
from scenarios import command, start, write

from pongsim.testing import read
from pongsim.testing.execute import execute

#: Stops the controller at random and lets it go on.
STUTTER = ("wall_avoider & while kill -STOP $!; do sleep 0.0$((RANDOM % 5)); kill -CONT $!; sleep 0.0$((RANDOM % 3)); done")
SCENARIO = f"""world: {PROJECT / "worlds/pong_lidar.sdf"}
duration: 4
programs:
  - command: COMMAND
lockstep: {{topics: ["/cmd_vel:100"], start: [/lidar]OPTIONS}}
expect:
  - topic: /cmd_vel
    always: {{linear.x: {{at_most: 10}}}}
"""


def scenario(folder, words, options=""):
    return write(folder, "s.yaml", SCENARIO.replace("COMMAND", words.replace("$", "$$")).replace("OPTIONS", options))


@pytest.fixture(autouse=True)
def path(monkeypatch):
    monkeypatch.setenv("PATH", f"{pathlib.Path(os.environ['PONGSIM']).parents[1] / 'test'}:{os.environ['PATH']}")


def test_a_controller_that_stutters_gives_the_same_bits(tmp_path):
    hashes = set()
    for words in ("[wall_avoider]", f"[bash, -c, '{STUTTER}']", f"[bash, -c, '{STUTTER}']"):
        result = execute(read(scenario(tmp_path, words)).cases[0])
        assert result.status.name == "PASSED", result.reason
        assert result.sim_time == 4
        hashes.add(result.state_hash)
    assert len(hashes) == 1


def test_it_goes_as_fast_as_the_controller(tmp_path):
    assert read(scenario(tmp_path, "[wall_avoider]")).cases[0].speed == 0


def test_who_is_late_is_named(tmp_path):
    scenario(tmp_path, "[sleep, 60]", ", timeout: 0.5")
    code, out, err = command(tmp_path, "s.yaml")
    assert (code, err) == (1, "")
    assert "lockstep: nobody publishes on '/cmd_vel'; nobody subscribes to '/lidar' within 0.5 s" in out


def test_an_unknown_topic_is_named_with_the_nearest(tmp_path):
    file = scenario(tmp_path, "[sleep, 60]", ", timeout: 0.5")
    file.write_text(file.read_text().replace("/cmd_vel:100", "/cmd_vell:100"))
    code, out, _ = command(tmp_path, "s.yaml")
    assert code == 1
    assert "no system of the world subscribes to '/cmd_vell': did you mean '/cmd_vel'?" in out


def test_a_run_goes_on_if_it_is_told(tmp_path):
    scenario(tmp_path, "[wall_avoider]", ", timeout: 0.2, late: continue")
    file = tmp_path / "s.yaml"
    file.write_text(file.read_text().replace("/cmd_vel:100", "/cmd_vel:1000:11"))
    code, out, _ = command(tmp_path, "s.yaml")
    assert code == 0, out


def test_a_program_that_dies_ends_the_wait(tmp_path):
    scenario(tmp_path, "[bash, -c, 'echo no more; exit 3']", ", timeout: 60")
    begin = time.monotonic()
    code, out, _ = command(tmp_path, "s.yaml")
    assert code == 1
    assert "program 'bash' ended with code 3 before the run was over\n       | no more" in out
    assert time.monotonic() - begin < 30


def test_ctrl_c_ends_the_wait(tmp_path):
    scenario(tmp_path, "[bash, -c, 'touch there; exec sleep 60']", ", timeout: 60")
    process = start(tmp_path, "s.yaml")
    while not (tmp_path / "there").exists():
        assert process.poll() is None
        time.sleep(0.01)
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=30)
    assert process.returncode == 1
    assert "1 not run" in out and "pongsim test: stopped" in err
