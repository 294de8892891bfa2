"""Nothing of the time before a reset, or before a state was restored, acts or is read afterwards."""

import pytest
from conftest import BALL, COURT, LIDAR

import pongsim

FORWARD = {"linear": {"x": 1.0}}


def to_the_start(sim, how, start):
    if how == "reset":
        sim.reset()
    else:
        sim.restore(start)


both = pytest.mark.parametrize("how", ["reset", "restore"])


@both
def test_a_command_that_waits_does_not_act(how):
    with pongsim.Simulation(COURT, seed=7) as sim:
        start = sim.save()
        sim.step(1000)
        expected = sim.state_hash()
        to_the_start(sim, how, start)
        sim.publish("/cmd_vel", FORWARD)
        to_the_start(sim, how, start)
        sim.step(1000)
        assert sim.state_hash() == expected
        # one that comes afterwards does
        to_the_start(sim, how, start)
        sim.publish("/cmd_vel", FORWARD)
        sim.step(1000)
        assert sim.model("pong_bot").pose.position[0] > 0.5


@both
def test_a_message_of_the_last_step_is_not_heard(how):
    with pongsim.Simulation(COURT, seed=7) as sim:
        start = sim.save()
        heard = []
        sim.subscribe("/a", heard)
        sim.step()
        sim.publish("/a", {"data": 1}, type="Int32")
        to_the_start(sim, how, start)
        sim.publish("/a", {"data": 2}, type="Int32")
        sim.step()
        assert [each["data"] for each in heard] == [2]


def test_a_refused_state_drops_nothing():
    with pongsim.Simulation(COURT, seed=7) as sim:
        heard = []
        sim.subscribe("/a", heard)
        sim.publish("/a", {"data": 1}, type="Int32")
        with pytest.raises(pongsim.Refused):
            sim.restore(b"rubbish")
        sim.step()
        assert [each["data"] for each in heard] == [1]


@both
def test_a_sensor_has_no_reading_again(how):
    with pongsim.Simulation(LIDAR) as sim:
        start = sim.save()
        lidar = sim.sensor("lidar", "ranges", "points")
        sim.run_until(0.5)
        old = lidar.ranges.copy()
        assert lidar.count() > 0
        to_the_start(sim, how, start)
        assert lidar.count() == 0
        for read in (lambda: lidar.ranges, lambda: lidar.intensities, lambda: lidar.points, lambda: lidar.time(),
                     lambda: sim.sensor("lidar").ranges):
            with pytest.raises(pongsim.NoReading):
                read()
        sim.run_until(0.5)
        assert (lidar.ranges == old).all() and lidar.time() <= 0.5


def test_a_strict_simulation_goes_on():
    class Fails(pongsim.System):
        fails = True

        def update(self, info):
            if self.fails:
                raise RuntimeError("boom")

    system = Fails()
    with pongsim.Simulation(BALL, strict=True, systems=[system]) as sim:
        start = sim.save()
        for how in ("reset", "restore"):
            system.fails = True
            with pytest.raises(pongsim.SystemFailed, match="boom"):
                sim.step()
            with pytest.raises(pongsim.SystemFailed, match="boom"):
                sim.step()
            to_the_start(sim, how, start)
            assert system.error is None
            system.fails = False
            sim.step(5)
            assert sim.iterations == 5


def test_forces_of_the_next_step_are_dropped():
    with pongsim.Simulation(BALL) as sim:
        start = sim.save()
        sim.step(10)
        expected = sim.state_hash()
        for how in ("reset", "restore"):
            sim.model("arm").joint("hinge").add_force(1e3)
            sim.model("ball").link("link").add_wrench((1e3, 0, 0))
            to_the_start(sim, how, start)
            sim.step(10)
            assert sim.state_hash() == expected


def test_the_error_of_a_system_is_that_of_the_restored_time():
    class Fails(pongsim.System):
        def update(self, info):
            if info.iteration == 3:
                raise RuntimeError("boom")

    system = Fails()
    with pongsim.Simulation(BALL, systems=[system]) as sim:
        start = sim.save()
        sim.step(5)
        assert "boom" in str(system.error)
        off = sim.save()
        sim.restore(start)
        assert system.error is None
        sim.step(5)
        error = system.error
        sim.restore(off)
        assert system.error is error
