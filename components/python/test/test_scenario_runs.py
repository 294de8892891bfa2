"""Runs of scenarios: what is published when, programs beside them, matrices, limits, reports, and what is kept."""

import json
import os
import re
import signal
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

import pytest
from scenarios import HEAD, LANDS, WORLD, command, run, start, write
from waiting import until

SAYS = "world: w.sdf\nduration: 2\nexpect:\n"


def test_it_passes_and_says_so(tmp_path):
    code, out, err = run(tmp_path, LANDS)
    assert (code, err) == (0, "")
    assert re.fullmatch(r"ok   s.yaml  \(0\.55\d s in \d+\.\d\d s\)\n1 passed; 0\.55\d s simulated in \S+ s\n", out), out


def test_a_failure_is_told_with_what_was_expected_and_seen_and_when(tmp_path):
    code, out, _ = run(tmp_path, SAYS + "  - name: it stays up\n    pose: ball\n    always: {z: {above: 1}}\nkeep: []\n")
    assert code == 1
    assert "FAIL s.yaml" in out
    assert "     s.yaml:4:5: it stays up\n" in out
    assert "expected  always pose of ball: z > 1\n" in out
    assert re.search(r"seen      z = (1|0\.99\d+) at 0\.45\d s\n", out), out
    # a plot, and when it failed
    assert re.search(r"\n +z\n +2 \|\*", out), out
    assert re.search(r"\+-+\^\n", out), out


def test_messages_are_published_at_a_time_after_an_event_and_again_and_again(tmp_path):
    publish = """publish:
  - {topic: /a, type: Int32, message: {data: 1}, at: 0.3}
  - {topic: /b, type: Int32, message: 'data: 2', after: {contact: [ball, ground]}, at: 0.1}
  - {topic: /c, type: Int32, message: {data: 3}, every: 0.5}
"""
    expect = """expect:
  - {topic: /a, never: true, during: [0, 0.299]}
  - {topic: /a, eventually: {data: 1}, within: 0.301}
  - {topic: /b, never: true, during: [0, 0.652]}
  - {topic: /b, eventually: {data: 2}, within: 0.66}
  - in_order: [{topic: /c}, {topic: /a}, {topic: /b}, {topic: /c}]
"""
    code, out, _ = run(tmp_path, HEAD + publish + expect)
    assert code == 0, out


def test_parameters_and_seeds_make_a_matrix(tmp_path):
    text = HEAD + """parameters:
  height: {values: [1, 3], xpath: "//model[@name='ball']/pose", text: 0 0 $height 0 0 0}
seeds: 2
expect:
  - {pose: ball, always: {z: $height}, at: 0}
  - {contact: ball, eventually: true, within: 0.5}
"""
    code, out, _ = run(tmp_path, text, "--list")
    assert (code, out.splitlines()) == (0, [f"s.yaml height={h} seed={s}" for h in (1, 3) for s in (0, 1)])
    code, out, _ = run(tmp_path, text, "--quiet", "--output", "kept")
    assert code == 1
    assert out.splitlines()[-1].startswith("2 passed, 2 failed; ")
    assert "ok" not in out and out.count("FAIL s.yaml height=3 seed=") == 2
    assert sorted(os.listdir(tmp_path / "kept")) == ["s.height=3_seed=0", "s.height=3_seed=1"]


def test_a_failure_leaves_a_recording_and_a_log_of_the_same_run(tmp_path, program):
    code, out, _ = run(tmp_path, SAYS + "  - {pose: ball, always: {z: {above: 1}}}\n")
    assert code == 1
    kept = tmp_path / "test-failures/s.seed=0"
    assert "test-failures/s.seed=0/recording\n" in out
    info = subprocess.run([program, "log", "info", kept / "recording/state.tlog"], capture_output=True, text=True, check=True)
    # from the start to half a second after the failure
    assert "/world/w/changed_state" in info.stdout
    assert "expected: always pose of ball: z > 1" in (kept / "log.txt").read_text()


def test_what_passes_leaves_nothing(tmp_path):
    run(tmp_path, LANDS)
    run(tmp_path, LANDS + "programs: [{command: [sleep, 60]}]\nspeed: 0\n")
    assert not (tmp_path / "test-failures").exists() or not os.listdir(tmp_path / "test-failures")


def test_a_camera_gives_a_picture(tmp_path):
    camera = ("<model name='eye'><static>true</static><pose>-4 0 1 0 0 0</pose><link name='l'><sensor name='cam' type='camera'>"
              "<camera><image><width>32</width><height>24</height></image></camera></sensor></link></model></world>")
    write(tmp_path, "camera.sdf", WORLD.replace("</world>", camera))
    write(tmp_path, "s.yaml", LANDS.replace("w.sdf", "camera.sdf").replace("eventually", "never"))
    code, out, _ = command(tmp_path, "s.yaml")
    assert code == 1
    if "no picture" in out:
        pytest.skip("nothing here renders")
    [picture] = (tmp_path / "test-failures/s.seed=0").glob("*.png")
    data = picture.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n" and data[16:24] == (32).to_bytes(4, "big") + (24).to_bytes(4, "big")
    # a graphics card or else the same as before
    assert command(tmp_path, "s.yaml", "--renderer", "auto", "-o", "again")[0] == 1
    [again] = (tmp_path / "again/s.seed=0").glob("*.png")
    assert again.read_bytes()[16:24] == data[16:24]
    code, _, err = command(tmp_path, "s.yaml", "--renderer", "gpu")
    assert code == 2 and "--renderer" in err


def test_a_run_is_compared_with_a_recorded_one(tmp_path, program):
    write(tmp_path, "w.sdf", WORLD)
    subprocess.run([program, "run", "w.sdf", "-z", "0", "--iterations", "1000", "--record-path", "good", "--record-topic",
                    "/model/ball/odometry"], cwd=tmp_path, check=True, capture_output=True)
    compare = SAYS + "  - topic: /model/ball/odometry\n    always: {pose.position.z: {recorded: good, tolerance: 1e-6}}\n"
    code, out, err = run(tmp_path, compare)
    assert code == 0, out + err
    write(tmp_path, "w.sdf", WORLD.replace("0 0 2 0", "0 0 2.2 0"))
    code, out, _ = command(tmp_path, "s.yaml")
    assert code == 1
    assert "expected  always /model/ball/odometry: pose.position.z as recorded ± 1e-06, from 0." in out
    assert re.search(r"seen +pose\.position\.z = \S+ instead of \S+ at ", out), out
    write(tmp_path, "t.csv", "time_s,z\n0,2\n0.1,1.951\n")
    write(tmp_path, "s.yaml", SAYS + "  - {pose: ball, always: {z: {recorded: t.csv, tolerance: 0.02}}}\n")
    code, out, _ = command(tmp_path, "s.yaml")
    assert code == 1 and "z = 2.2 instead of 2" in out


def test_systems_are_added_to_the_world(tmp_path):
    text = HEAD + """parameters: {rate: {values: [10, 50]}}
systems:
  - filename: ignition-gazebo-scene-broadcaster-system
    name: ignition::gazebo::systems::SceneBroadcaster
    xml: <dynamic_pose_hertz>$rate</dynamic_pose_hertz>
expect:
  - {topic: /world/w/dynamic_pose/info, eventually: true, during: [0.01, 0.05]}
"""
    code, out, _ = run(tmp_path, text)
    assert code == 1
    assert "ok   s.yaml rate=50 seed=0" in out and "FAIL s.yaml rate=10 seed=0" in out


def test_services_are_called(tmp_path):
    text = HEAD + """request:
  - {service: /world/w/set_pose, type: Pose, message: {name: ball, position: {x: 3, z: 5}}, at: 0.1}
  - {service: /world/w/remove, type: Entity, message: 'name: "ball", type: MODEL', after: {velocity: ball, is: {z: {below: -5}}}}
expect:
  - {pose: ball, eventually: {x: 3, z: {above: 4.9}}, within: 0.11}
  - {pose: ball, never: {z: {below: 1}}}
"""
    code, out, _ = run(tmp_path, text)
    assert code == 0, out
    code, out, _ = run(tmp_path, text.replace("name: ball, position", "name: bell, position"))
    assert code == 1 and "s.yaml:4:5: service '/world/w/set_pose' refused: there is no model 'bell'; did you mean 'ball'?" in out, out
    code, out, _ = run(tmp_path, text.replace("/world/w/set_pose", "/world/w/set_pos"))
    assert code == 1 and "s.yaml:4:5: this simulation has no service '/world/w/set_pos'" in out, out
    code, out, _ = run(tmp_path, text.replace("type: Pose,", "type: Pos,"))
    assert code == 2 and "s.yaml:4:5: error: " in out, out


def test_a_robot_without_a_world_is_tested_too(tmp_path):
    write(tmp_path, "r.urdf", "<robot name='r'><link name='l'><inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1' ixy='0'"
          " ixz='0' iyz='0'/></inertial></link></robot>")
    write(tmp_path, "s.yaml", "world: r.urdf\nduration: 0.1\nexpect: [{pose: r, never: {z: {below: 10}}}]\n"
          "programs: [{command: [sleep, 60]}]\n")
    code, out, _ = command(tmp_path, "s.yaml")
    assert code == 1 and "expected  never pose of r: z < 10" in out, out
    assert "test-failures/s.seed=0/log.txt" in out


def test_a_report_that_cannot_be_written_is_told_before_anything_runs(tmp_path):
    code, out, err = run(tmp_path, LANDS, "--junit", "no/such/out.xml")
    assert (code, out) == (1, "") and "pongsim test: error: no/such/out.xml: No such file" in err


def test_reports_for_ci(tmp_path):
    text = SAYS + "  - {pose: ball, always: {z: {above: 1}}}\nseeds: 2\nkeep: []\n"
    code, out, _ = run(tmp_path, text, "--junit", "out.xml", "--github", "--tap")
    assert code == 1
    root = ElementTree.parse(tmp_path / "out.xml").getroot()
    assert (root.get("tests"), root.get("failures"), root.get("errors")) == ("2", "2", "0")
    [first, second] = root.iter("testcase")
    assert (first.get("name"), second.get("name")) == ("s.yaml seed=0", "s.yaml seed=1")
    assert first.find("failure").get("message").startswith("expected always pose of ball: z > 1; seen: z = ")
    lines = out.splitlines()
    assert lines.count("TAP version 13") == 1 and "1..2" in lines and "not ok 1 - s.yaml seed=0" in lines
    [note, _] = [line for line in lines if line.startswith("::error ")]
    assert note.startswith("::error file=s.yaml,line=4,col=5,title=s.yaml seed=")
    assert "%0Aseen: z = " in note


def test_a_mistake_is_an_error_in_junit(tmp_path):
    code, _, _ = run(tmp_path, SAYS + "  - {pose: bal, always: {z: 1}}\n", "--junit", "out.xml")
    assert code == 2
    root = ElementTree.parse(tmp_path / "out.xml").getroot()
    assert root.get("errors") == "1" and root.find(".//error").get("message").startswith("s.yaml:4:5: error: there is no model 'bal'")


def test_it_takes_as_long_as_it_is_told_to(tmp_path):
    code, out, _ = run(tmp_path, LANDS + "speed: 1\n")
    assert code == 0
    assert 0.5 < float(re.search(r"s in (\S+) s\)", out).group(1)) < 30


def test_a_run_that_takes_too_long_is_a_failure(tmp_path):
    code, out, _ = run(tmp_path, LANDS + "speed: 0.001\nlimits: {wall: 0.5}\nkeep: []\n")
    assert code == 1
    assert re.search(r"it took longer than 0.5 s of wall time, at 0\.0\S* s of simulated time", out), out


def test_a_world_that_hangs_in_a_step_is_a_failure(tmp_path, monkeypatch):
    # its wall time is up while it is in a function that does not come back
    code = """
import sys, time
from pongsim.testing import pool, scenario
from pongsim.testing.command import main
pool._GRACE = 0.2
def hang(case, place, noted, again):
    import signal
    signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGTERM])
    while True:
        time.sleep(1)
pool.execute_and_keep = hang
sys.exit(main(["s.yaml"]))
"""
    write(tmp_path, "w.sdf", WORLD)
    write(tmp_path, "s.yaml", LANDS + "limits: {wall: 0.2}\n")
    done = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 1
    assert "the world hangs: it took longer than 0.2 s of wall time, and was killed" in done.stdout


def test_a_process_that_is_killed_is_a_failure_and_the_others_go_on(tmp_path):
    text = LANDS + "seeds: 3\nprograms: [{command: [sh, -c, 'kill -9 $$PPID']}]\n"
    code, out, _ = run(tmp_path, text, "--jobs", "1")
    assert code == 1
    assert out.count("its process was killed by SIGKILL") == 3


PROGRAM = "programs:\n  - command: [sh, -c, '{}']\n{}"


@pytest.mark.parametrize("script, more, words", [
    ("echo hello; echo last words; exit 3", "", r"program 'sh' ended with code 3 before the run was over\n +\| hello\n +\| last words"),
    ("kill -9 $$$$", "", "program 'sh' was killed by SIGKILL before the run was over"),
    ("exit 0", "", "program 'sh' ended with code 0 before the run was over\n +it printed nothing"),
    ("echo not yet; exec sleep 60", "    ready: {prints: now}\n    wait: 0.3\n",
     r"program 'sh' was not ready within 0.3 s: it did not print now\n +\| not yet"),
    ("echo no; exit 1", "    ready: {prints: now}\n", r"program 'sh' ended with code 1 before it was ready\n +\| no"),
    ("exec sleep 60", "    ready: {subscribes: /x}\n    wait: 0.3\n", "it did not subscribe to /x"),
])
def test_programs_that_fail(tmp_path, script, more, words):
    text = LANDS.replace("eventually", "never") + PROGRAM.format(script, more) + "keep: [log]\n"
    code, out, _ = run(tmp_path, text.replace("duration: 2", "duration: 20").replace("contact: [ball, ground]", "contact: [ball, ball]"))
    assert code == 1
    assert re.search(words, out), out


def test_a_program_that_is_not_there(tmp_path):
    code, out, _ = run(tmp_path, LANDS + "programs: [{command: no-such-program --x}]\n")
    assert code == 1
    assert "program 'no-such-program' does not start: no-such-program: No such file or directory" in out


def test_a_program_may_end_if_it_says_so(tmp_path):
    code, out, _ = run(tmp_path, LANDS + PROGRAM.format("echo done", "    ends: true\n    ready: {prints: done}\n"))
    assert code == 0, out


def test_programs_get_their_environment_and_a_domain_of_their_own(tmp_path):
    text = LANDS + PROGRAM.format("echo $$PONGSIM_DOMAIN $$MINE; pwd; echo $$ROS_DOMAIN_ID $$IGN_PARTITION $$GZ_PARTITION; exec sleep 60",
                                  "    environment: {MINE: 7}\n    folder: sub\n    ready: {prints: pongsim-test-}\n")
    (tmp_path / "sub").mkdir()
    code, out, _ = run(tmp_path, text.replace("eventually", "never") + "seeds: 2\n")
    assert code == 1
    said = [(tmp_path / f"test-failures/s.seed={seed}/log.txt").read_text() for seed in (0, 1)]
    pattern = r"sh printed:\n(\d+) 7\n\S+/sub\n\1 (pongsim-test-\d+) \2\n"
    domains = [re.search(pattern, text).group(1) for text in said]
    assert len(set(domains)) == 2


def test_a_program_drives_the_world(tmp_path, program):
    text = HEAD.replace("2", "30") + f"""speed: 2
programs:
  - command: [{program}, topic, -t, /told, -m, Int32, -p, 'data: 7']
    ends: true
expect:
  - topic: /told
    eventually: {{data: 7}}
"""
    code, out, _ = run(tmp_path, text)
    assert code == 0, out


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGKILL])
def test_ctrl_c_ends_all_that_was_started_and_nothing_else(tmp_path, number):
    script = "sleep 1000 & echo $$! >inner; echo $$$$ >outer; wait"
    text = LANDS.replace("eventually", "never") + PROGRAM.format(script, "    ready: {prints: never}\n")
    write(tmp_path, "w.sdf", WORLD)
    write(tmp_path, "s.yaml", text)
    other = subprocess.Popen(["sleep", "1000"])
    try:
        process = start(tmp_path, "s.yaml")
        until(lambda: (tmp_path / "outer").exists() and (tmp_path / "outer").read_text().endswith("\n"))
        pids = [int((tmp_path / name).read_text()) for name in ("inner", "outer")]
        process.send_signal(number)
        out, err = process.communicate(timeout=60)
        if number == signal.SIGKILL:
            assert process.returncode == -signal.SIGKILL
        else:
            assert process.returncode == 1
            assert "0 passed, 1 not run; " in out and "pongsim test: stopped" in err
        until(lambda: not any(os.path.exists(f"/proc/{pid}") and "Z" not in open(f"/proc/{pid}/stat").read().split()[2] for pid in pids))
        assert other.poll() is None
    finally:
        other.kill()
        other.wait()


def test_the_same_run_has_the_same_bits(tmp_path):
    text = SAYS + "  - {pose: ball, always: {z: {above: 1}}}\nseeds: [3, 3]\n"
    assert run(tmp_path, text)[0] == 2  # a seed is given twice
    hashes = set()
    for jobs in ("1", "2"):
        assert run(tmp_path, text.replace("[3, 3]", "[3, 4]"), "--jobs", jobs)[0] == 1
        log = (tmp_path / "test-failures/s.seed=3/log.txt").read_text()
        hashes.add(re.search(r"state hash ([0-9a-f]{16})", log).group(1))
    assert len(hashes) == 1


def test_a_first_scenario_passes(tmp_path):
    for world in ("pong_world.sdf", "pong_lidar.sdf"):
        code, out, err = command(tmp_path, "--init", world)
        assert (code, err) == (0, "")
        name = world.replace(".sdf", ".yaml")
        assert re.fullmatch(rf"{name}: \d+ expectations; run it with: pongsim test {name}\n", out)
        code, out, _ = command(tmp_path, name)
        assert code == 0, out
    assert "/cmd_vel" in (tmp_path / "pong_world.yaml").read_text()
    code, out, err = command(tmp_path, "--init", "pong_world.sdf")
    assert (code, out) == (2, "") and "pong_world.yaml is there already" in err


def test_a_first_scenario_of_a_file_of_ones_own(tmp_path):
    write(tmp_path, "w.sdf", WORLD)
    assert command(tmp_path, "--init", "w.sdf", "-o", "mine.yaml")[0] == 0
    assert "pose: ball" in (tmp_path / "mine.yaml").read_text()
    assert command(tmp_path, "mine.yaml")[0] == 0
    code, _, err = command(tmp_path, "--init", "nowhere.sdf")
    assert code == 2 and "there is no file nowhere.sdf" in err


def test_the_schema_is_there(tmp_path):
    code, out, _ = command(tmp_path, "--schema")
    assert code == 0
    assert json.loads(open(out.strip()).read())["title"] == "A scenario of pongsim test"
