"""Memory does not grow."""

import gc
import weakref

import pytest
from conftest import BALL, COURT

import pongsim


def resident():
    """Memory of this process [kB]."""
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * 4


def grown(work, times, warm):
    """Memory that so many times take for good [kB]: a leak grows in each part of them, what the system and the allocator
    take in large pieces in one or the other."""
    parts = 4
    for _ in range(warm):
        work()
    sizes = []
    for _ in range(parts + 1):
        gc.collect()
        sizes.append(resident())
        for _ in range(times // parts if len(sizes) <= parts else 0):
            work()
    return parts * min(after - before for before, after in zip(sizes, sizes[1:]))


def test_ten_thousand_resets(court):
    def episode():
        court.reset(seed=3)
        court.publish("/cmd_vel", {"linear": {"x": 0.5}})
        court.step(2)
        court.poses()

    assert grown(episode, 10_000, 500) < 4_000


def test_ten_thousand_restores(court):
    state = court.save()

    def episode():
        court.restore(state)
        court.step()
        court.save()

    assert grown(episode, 10_000, 500) < 4_000


class Judge(pongsim.System):
    def post_update(self, info):
        self.sim.model("ball").pose


def test_simulations_that_know_themselves_are_collected():
    sims = []

    def work():
        sim = pongsim.Simulation(BALL, systems=[Judge()])
        sim.subscribe("/a", lambda message: sim.step_size)
        sim.publish("/a", {}, type="Empty")
        sim.step()
        sims.append(weakref.ref(sim))

    def collected():
        # the collector doesn't know how large they are, and would come for a hundred of them at once
        work()
        gc.collect()

    collected()
    assert sims[0]() is None
    assert grown(collected, 300, 50) < 8_000
    assert all(each() is None for each in sims)


def test_errors_leave_nothing():
    sim = pongsim.Simulation(BALL)

    def work():
        with pytest.raises(ValueError):
            sim.publish("/a", {"x": {"y": 1}}, type="Twist")
        with pytest.raises(pongsim.LoadError):
            sim.insert("<sdf version='1.9'><model/></sdf>")

    assert grown(work, 2000, 200) < 4_000
