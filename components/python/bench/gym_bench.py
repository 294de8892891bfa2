"""What environments cost: run by tools/bench python, in a Python that has MuJoCo and PyBullet."""

import os
import statistics
import time

import gymnasium
import numpy as np
import peers

from pongsim.gym import VectorEnv, wall_avoid
from pongsim.gym.wall_avoid import WallAvoidEnv

ROUNDS, STEPS = 11, 1000
WORLDS, BATCHES = 16, 60
MANY, FEW_BATCHES = 48, 30


def show(name, values, unit=""):
    print(f"{name:<58} {statistics.median(values):9.2f}{unit}  ({min(values):.2f} to {max(values):.2f})", flush=True)


def actions():
    """The same for all: ahead in bends."""
    return [np.float32([0.6, 0.8 * np.sin(i / 40)]) for i in range(STEPS)]


def steps_a_second(env, told):
    """Of processor time."""
    env.reset(seed=1)
    begin = time.process_time()
    for action in told:
        *_, terminated, truncated, _ = env.step(action)
        if terminated or truncated:
            env.reset()
    return len(told) / (time.process_time() - begin)


def against_peers():
    envs = {
        "pongsim": WallAvoidEnv(),
        "MuJoCo, friction as it comes (pyramidal)": peers.InMuJoCo("pyramidal"),
        "MuJoCo, friction without directions (elliptic)": peers.InMuJoCo("elliptic"),
        "PyBullet": peers.InPyBullet(),
    }
    told = actions()
    found = {name: [] for name in envs}
    for _ in range(ROUNDS):
        for name, env in envs.items():
            found[name].append(steps_a_second(env, told))
    print(f"\nenvironment steps a second of processor time, medians of {ROUNDS} rounds by turns")
    for name, values in found.items():
        show(name, values)
    for name, values in found.items():
        if name != "pongsim":
            show(f"pongsim : {name}", [ours / theirs for ours, theirs in zip(found["pongsim"], values)])
    for env in envs.values():
        env.close()


def batch_time(envs, told):
    begin = time.perf_counter()
    for _ in range(FEW_BATCHES):
        envs.step(told)
    return (time.perf_counter() - begin) / FEW_BATCHES


def on_threads():
    told = np.tile(np.float32([0.3, 0.5]), (MANY, 1))
    vectors = {n: VectorEnv(wall_avoid(), MANY, threads=n) for n in (1, 2)}
    for envs in vectors.values():
        envs.reset(seed=1)
    pairs = []
    for _ in range(2 * ROUNDS):
        pairs.append([batch_time(vectors[n], told) for n in (1, 2)])
    print(f"\n{MANY} wall avoiders at once, by the clock; {os.getloadavg()[0]:.1f} tasks want the "
          f"{len(os.sched_getaffinity(0))} processors")
    show("steps a second on one thread", [MANY / one for one, _ in pairs])
    show("on two", [MANY / two for _, two in pairs])
    show("two threads : one, of pairs", [one / two for one, two in pairs])
    for envs in vectors.values():
        envs.close()


def in_batches():
    """A step of an environment of many beside one of Gymnasium's own vectors of as many in MuJoCo."""
    told = np.tile(np.float32([0.3, 0.5]), (WORLDS, 1))
    ours = VectorEnv(wall_avoid(), WORLDS, threads=1)
    theirs = gymnasium.vector.SyncVectorEnv([lambda: peers.InMuJoCo("pyramidal")] * WORLDS)
    found = {"pongsim, VectorEnv on one thread": [], "MuJoCo, pyramidal, Gymnasium's SyncVectorEnv": []}
    for envs in (ours, theirs):
        envs.reset(seed=1)
    for _ in range(ROUNDS):
        for values, envs in zip(found.values(), (ours, theirs)):
            begin = time.process_time()
            for _ in range(BATCHES):
                envs.step(told)
            values.append(WORLDS * BATCHES / (time.process_time() - begin))
    print(f"\n{WORLDS} at once, environment steps a second of processor time")
    for name, values in found.items():
        show(name, values)
    show("pongsim : MuJoCo", [a / b for a, b in zip(*found.values())])
    ours.close()
    theirs.close()


def begin_anew():
    env = WallAvoidEnv()
    env.reset(seed=1)
    state = env.simulation.save()
    restores, resets = [], []
    for _ in range(ROUNDS):
        for values, work in ((restores, lambda: env.simulation.restore(state)), (resets, env.reset)):
            begin = time.process_time_ns()
            for _ in range(200):
                work()
            values.append((time.process_time_ns() - begin) / 200 / 1000)
    print("\nmicroseconds of processor time")
    show("restore the wall avoider's world", restores)
    show("Env.reset: restore, put the robot somewhere, five steps, scan", resets)
    env.close()


against_peers()
in_batches()
on_threads()
begin_anew()
