"""The program ends while other threads step, load or call back: quietly, and at once."""

import subprocess
import sys
import time

import pytest
from conftest import BALL, COURT

BEGIN = f"""
import os, sys, threading, time, pongsim
BALL = {BALL!r}
COURT = {str(COURT)!r}
started = threading.Event()

def forever(work):
    def run():
        while True:
            work()
            started.set()
    threading.Thread(target=run, daemon=True).start()

class Counts(pongsim.System):
    count = 0
    def update(self, info):
        self.count += 1
        started.set()
"""

PROGRAMS = {
    "steps": "sim = pongsim.Simulation(BALL); forever(sim.step)",
    "many steps": "sim = pongsim.Simulation(BALL); forever(lambda: sim.step(100))",
    "endless steps": "sim = pongsim.Simulation(BALL, systems=[Counts()]); forever(lambda: sim.step(10**12))",
    "a system": "sim = pongsim.Simulation(BALL, systems=[Counts()]); forever(sim.step)",
    "several threads": "sims = [pongsim.Simulation(BALL, systems=[Counts()]) for i in range(4)]\n"
                       "for sim in sims: forever(sim.step)",
    "a callback": "sim = pongsim.Simulation(COURT); heard = []\n"
                  "sim.subscribe('/model/pong_bot/odometry', lambda m: heard.append(m)); forever(lambda: sim.step(200))",
    "loading": "forever(lambda: pongsim.Simulation(COURT))",
    "resets": "sim = pongsim.Simulation(BALL, systems=[Counts()]); forever(sim.reset); time.sleep(0.01); started.set()",
    "saving": "class Saves(Counts):\n    def save(self): return sum(range(1000))\n    def restore(self, state): pass\n"
              "sim = pongsim.Simulation(BALL, systems=[Saves()]); forever(sim.save)",
    "environments": "import pongsim.gym as gym\nenvs = gym.VectorEnv(gym.wall_avoid(), 4, threads=2)\n"
                    "for sim in envs.simulations: sim.add(Counts())\n"
                    "envs.reset(seed=1); forever(lambda: envs.step(envs.action_space.sample()))",
    "an error in the end": "sim = pongsim.Simulation(BALL, systems=[Counts()]); forever(sim.step); started.wait(60); sys.exit(3)",
}


@pytest.mark.parametrize("program", PROGRAMS)
def test_a_program_ends_while_a_thread_works(program):
    for _ in range(3):
        begin = time.monotonic()
        done = subprocess.run([sys.executable, "-c", BEGIN + PROGRAMS[program] + "\nassert started.wait(60)\n"],
                              capture_output=True, text=True, timeout=120)
        assert (done.returncode, done.stderr) == (3 if "error" in program else 0, "")
        assert time.monotonic() - begin < 60


def test_nobody_takes_a_step_that_has_stopped_early_for_complete():
    program = """
sim = pongsim.Simulation(BALL, systems=[Counts()])
def run():
    sim.run_until(8e9)
    os.write(1, b"complete")
threading.Thread(target=run, daemon=True).start()
started.wait(60)
"""
    for _ in range(5):
        done = subprocess.run([sys.executable, "-c", BEGIN + program], capture_output=True, text=True, timeout=120)
        assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


def test_what_runs_at_the_end_can_step():
    done = subprocess.run([sys.executable, "-c", f"""
import atexit
def last():
    sim.step(10)
    print(sim.iterations, judge.count)
atexit.register(last)
{BEGIN}
judge = Counts()
sim = pongsim.Simulation(BALL, systems=[judge])
"""], capture_output=True, text=True, timeout=120)
    assert (done.returncode, done.stdout, done.stderr) == (0, "10 10\n", "")


def test_an_end_waits_only_briefly_for_a_system_that_hangs():
    begin = time.monotonic()
    done = subprocess.run([sys.executable, "-c", BEGIN + """
class Hangs(pongsim.System):
    def update(self, info):
        started.set()
        threading.Event().wait()
sim = pongsim.Simulation(BALL, systems=[Hangs()])
forever(sim.step)
started.wait(60)
"""], capture_output=True, text=True, timeout=120)
    assert done.stderr == "" and time.monotonic() - begin < 60
