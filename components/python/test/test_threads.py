"""Several simulations on threads, one on several."""

import concurrent.futures
import os
import subprocess
import sys
import threading

import pytest
from conftest import BALL, COURT

import pongsim


def run(seed):
    with pongsim.Simulation(COURT, seed=seed) as sim:
        heard = []
        sim.subscribe("/model/pong_bot/odometry", heard)
        sim.publish("/cmd_vel", {"linear": {"x": 0.1 * seed}})
        sim.step(500)
        return sim.state_hash(), len(heard)


def test_worlds_on_threads_give_the_bits_of_one_after_the_other():
    one_by_one = [run(seed) for seed in range(4)]
    with concurrent.futures.ThreadPoolExecutor(4) as pool:
        assert list(pool.map(run, range(4))) == one_by_one


def test_other_threads_run_while_one_steps():
    """The step continues until another Python thread ends it, for which it would wait if it held the GIL."""
    sim = pongsim.Simulation(BALL)
    stop = threading.Event()
    told = threading.Event()

    class Waits(pongsim.System):
        def update(self, info):
            told.set()
            if stop.is_set():
                raise KeyboardInterrupt

    sim.add(Waits())

    def other():
        told.wait(60)
        stop.set()

    thread = threading.Thread(target=other)
    thread.start()
    with pytest.raises(KeyboardInterrupt):
        sim.step(10**12)
    thread.join()


def test_one_simulation_on_two_threads_is_refused():
    sim = pongsim.Simulation(BALL)
    model = sim.model("ball")
    inside, leave = threading.Event(), threading.Event()

    class Waits(pongsim.System):
        def update(self, info):
            inside.set()
            leave.wait(60)

    sim.add(Waits())
    thread = threading.Thread(target=sim.step)
    thread.start()
    assert inside.wait(60)
    for call in (sim.step, sim.state_hash, sim.reset, sim.close, lambda: model.pose, lambda: sim.time,
                 lambda: sim.subscribe("/a", print)):
        with pytest.raises(pongsim.Busy, match="thread|while it steps"):
            call()
    leave.set()
    thread.join()
    assert sim.iterations == 1


def test_dropping_what_listens_while_another_thread_steps():
    sim = pongsim.Simulation(BALL)
    count = 0

    def hear(message):
        nonlocal count
        count += 1
        if count < 2000:
            sim.publish("/a", {}, type="Empty")

    sim.subscribe("/a", hear)
    sim.publish("/a", {}, type="Empty")
    spare = [sim.subscribe(f"/spare{i}", print) for i in range(100)]
    thread = threading.Thread(target=sim.step, args=(2000,))
    thread.start()
    while spare:
        try:
            spare[-1].close()
        except pongsim.Busy:
            pass
        spare.pop()
    thread.join()
    assert count == 2000


@pytest.mark.skipif("san.so" in os.environ.get("LD_PRELOAD", ""), reason="a sanitizer needs all address space")
def test_threads_that_cannot_start_are_an_exception():
    """The memory for their stacks is not there."""
    code = f"""
import resource, pongsim
pongsim.Simulation({BALL!r}).step()
size = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (size + (64 << 20),) * 2)
try:
    pongsim.Simulation({BALL!r}, threads=200)
except RuntimeError as error:
    assert "can't start 200 threads" in str(error), error
    with pongsim.Simulation({BALL!r}) as sim:
        sim.step()
        print("goes on")
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120)
    assert (done.returncode, done.stdout) == (0, "goes on\n"), done.stderr
