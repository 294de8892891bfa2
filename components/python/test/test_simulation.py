"""A simulation, its time and state, and messages for bad files."""

import gc
import os
import signal
import subprocess
import sys

import pytest
from conftest import BALL, COURT

import pongsim


def test_hash_is_that_of_the_command_line(program):
    for seed in (0, 7):
        said = subprocess.run(
            [program, "run", str(COURT), "-z", "0", "--iterations", "2000", "--seed", str(seed), "--hash"],
            capture_output=True, text=True, check=True,
        ).stdout
        with pongsim.Simulation(COURT, seed=seed) as sim:
            sim.step(2000)
            assert f"state hash: {sim.state_hash():016x}" in said


def test_steps_and_time(court):
    assert (court.time, court.iterations, court.name) == (0.0, 0, "pong_world")
    court.step()
    court.step(9)
    assert court.iterations == 10
    assert court.time_ns == 10 * round(court.step_size * 1e9)
    court.run_until(0.5)
    assert court.time == pytest.approx(0.5)
    before = court.iterations
    court.run_until(0.2)
    assert court.iterations == before
    for wrong in (float("nan"), float("inf"), 1e300):
        with pytest.raises(ValueError):
            court.run_until(wrong)
    with pytest.raises(ValueError):
        court.step(-1)


def test_step_size_and_gravity(ball):
    ball.step_size = 0.01
    ball.step()
    assert ball.time == pytest.approx(0.01)
    with pytest.raises(pongsim.Refused):
        ball.step_size = 2
    ball.gravity = (0, 0, 0)
    assert ball.gravity == (0, 0, 0)
    height = ball.model("ball").pose.position[2]
    ball.model("ball").set_velocity((0, 0, 0))
    ball.step(10)
    assert ball.model("ball").pose.position[2] == pytest.approx(height)


def drive(sim):
    sim.publish("/cmd_vel", {"linear": {"x": 0.5}, "angular": {"z": 0.2}})
    sim.step(1000)
    return sim.state_hash()


def test_reset_and_restore_give_the_same_bits(court):
    court.step(100)
    state = court.save()
    first = drive(court)
    court.restore(state)
    assert court.iterations == 100
    assert drive(court) == first
    court.reset()
    assert court.time == 0
    court.step(100)
    assert drive(court) == first


def test_a_state_of_another_world_is_refused(court, ball):
    before = ball.state_hash()
    with pytest.raises(pongsim.Refused, match="another world"):
        ball.restore(court.save())
    with pytest.raises(pongsim.Refused, match="not a saved state"):
        ball.restore(b"")
    with pytest.raises(pongsim.Refused):
        ball.restore(ball.save()[:-1])
    assert ball.state_hash() == before


def test_an_error_has_file_line_and_column(tmp_path):
    file = tmp_path / "bad.sdf"
    file.write_text(
        "<sdf version='1.9'>\n <world name='w'>\n  <model name='m'>\n   <link name='l'/>\n"
        "   <joint name='j' type='revolute'><parent>l</parent><child>nobody</child></joint>\n  </model>\n </world>\n</sdf>\n"
    )
    with pytest.raises(pongsim.LoadError) as raised:
        pongsim.Simulation(file)
    error = raised.value
    assert (error.file, error.line) == (str(file), 5)
    assert error.column > 0
    assert f"{file}:5:{error.column}: error: " in str(error)
    assert any(each.is_error for each in error.diagnostics)
    with pytest.raises(pongsim.LoadError, match="no_such"):
        pongsim.Simulation("no_such.sdf")
    with pytest.raises(pongsim.LoadError):
        pongsim.Simulation("<sdf>")


def test_a_text_may_stand_for_a_file(tmp_path):
    (tmp_path / "box.sdf").write_text("<sdf version='1.9'><model name='box'><link name='l'/></model></sdf>")
    text = "<sdf version='1.9'><world name='w'><include><uri>%s</uri></include></world></sdf>"
    with pongsim.Simulation(text % "box.sdf", file=tmp_path / "world.sdf") as sim:
        assert sim.model_names == ["box"]
    with pytest.raises(pongsim.LoadError, match="world.sdf:1:"):
        pongsim.Simulation(text % "no.sdf", file=tmp_path / "world.sdf")


def test_a_warning_is_a_warning():
    text = BALL.replace("<world name=\"w\">", "<world name=\"w\"><plugin filename='ignition-gazebo-physics-system' name='x'/>"
                        "<plugin filename='libgazebo_ros_init.so' name='y'/>")
    with pytest.warns(pongsim.WorldWarning, match="left out"):
        sim = pongsim.Simulation(text)
    assert any("left out" in each.message and not each.is_error and each.line == 2 for each in sim.diagnostics)


def test_wrong_arguments():
    with pytest.raises(TypeError):
        pongsim.Simulation(3)
    with pytest.raises(TypeError):
        pongsim.Simulation(COURT, sead=7)
    with pytest.raises(ValueError, match="threads"):
        pongsim.Simulation(COURT, threads=0)
    with pytest.raises(ValueError, match="network=True"):
        pongsim.Simulation(COURT, domain=3)


def test_nothing_is_left_of_a_closed_simulation():
    sim = pongsim.Simulation(BALL)
    model, link, joint = sim.model("ball"), sim.model("ball").link("link"), sim.model("arm").joint("hinge")
    sim.close()
    assert sim.is_closed
    sim.close()
    calls = [sim.step, sim.reset, sim.save, sim.state_hash, sim.poses, lambda: sim.time, lambda: sim.model("ball"),
             lambda: sim.run_until(1), lambda: sim.publish("/a", {}, type="Empty"), lambda: model.pose,
             lambda: model.name, lambda: model.move((0, 0, 0)), lambda: model.links, lambda: link.pose,
             lambda: link.add_wrench((0, 0, 0)), lambda: joint.position(), lambda: joint.drive(1.0)]
    for call in calls:
        with pytest.raises(pongsim.Gone):
            call()
    assert not model.exists
    assert "gone" in repr(model)
    assert "closed" in repr(sim)


def test_handles_do_not_hold_the_simulation():
    model = pongsim.Simulation(BALL).model("ball")
    gc.collect()
    with pytest.raises(pongsim.Gone):
        model.pose


def test_control_c_ends_a_long_run():
    code = (
        "import pongsim, sys\n"
        "sim = pongsim.Simulation(sys.argv[1])\n"
        "class Ready(pongsim.System):\n"
        "    def post_update(self, info):\n"
        "        if info.iteration == 5: print('ready', flush=True)\n"
        "sim.add(Ready())\n"
        "try:\n"
        "    {call}\n"
        "except KeyboardInterrupt:\n"
        "    sim.step()\n"
        "    print('interrupted', sim.iterations > 1)\n"
    )
    for call in ("sim.run_until(1e9)", "sim.step(10**15)"):
        process = subprocess.Popen([sys.executable, "-c", code.format(call=call), str(COURT)], stdout=subprocess.PIPE,
                                   text=True)
        try:
            assert process.stdout.readline() == "ready\n"
            process.send_signal(signal.SIGINT)
            assert process.communicate(timeout=60)[0] == "interrupted True\n"
        finally:
            process.kill()
            process.wait()
