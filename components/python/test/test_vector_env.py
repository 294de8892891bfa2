"""Many worlds as a Gymnasium vector environment."""

import os
import subprocess
import sys
from pathlib import Path

import gymnasium
import numpy as np
import pytest
from gymnasium.error import ResetNeeded
from gymnasium.vector import AutoresetMode, SyncVectorEnv
from gymnasium.vector.utils import batch_space
from test_gym import NOISY, rail

import pongsim
import pongsim.gym as gym

MODES = [AutoresetMode.NEXT_STEP, AutoresetMode.SAME_STEP]
ID = "pongsim/WallAvoid-v0"


def short(now):
    """Ends episodes now and then."""
    return np.abs(now["rail"][:, 0]) > 0.2


def same(one, other):
    """Whether two results of a reset or a step are bit-for-bit the same."""
    assert len(one) == len(other)
    for a, b in zip(one, other):
        if isinstance(a, dict):
            assert a.keys() == b.keys()
            same([a[key] for key in a], [b[key] for key in a])
        elif getattr(a, "dtype", None) == object:
            assert [x is None for x in a] == [x is None for x in b]
            same([x for x in a if x is not None], [x for x in b if x is not None])
        else:
            assert a.dtype == b.dtype
            assert np.array_equal(a, b)


def actions_for(envs, steps):
    random = np.random.default_rng(4)
    low, high = envs.action_space.low, envs.action_space.high
    return [random.uniform(low, high).astype(np.float32) for _ in range(steps)]


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("world", ["still", "noise", "start"])
def test_it_gives_what_gymnasiums_own_vector_of_single_ones_gives(mode, world):
    changes = {"terminated": short, "time_limit": 1.5}
    if world == "noise":
        changes["world"] = NOISY
    if world == "start":
        changes["start"] = lambda sim, random: sim.model("cart").joint("rail").reset(random.uniform(-0.1, 0.1))
    task = rail(**changes)
    ours = gym.VectorEnv(task, 3, autoreset_mode=mode)
    theirs = SyncVectorEnv([lambda: gym.Env(task)] * 3, autoreset_mode=mode)
    assert ours.action_space == theirs.action_space and ours.observation_space == theirs.observation_space
    same(ours.reset(seed=11), theirs.reset(seed=11))
    ended = 0
    for action in actions_for(ours, 60):
        one = ours.step(action)
        same(one, theirs.step(action))
        ended += one[2].sum() + one[3].sum()
    assert ended > 5
    same(ours.reset(seed=[1, None, 3]), theirs.reset(seed=[1, None, 3]))
    assert ours.np_random_seed == tuple(theirs.np_random_seed)
    ours.close()
    theirs.close()


def test_the_wall_avoider_likewise():
    ours = gymnasium.make_vec(ID, num_envs=2)
    theirs = gymnasium.make_vec(ID, num_envs=2, vectorization_mode="sync")
    assert isinstance(ours, gym.VectorEnv)
    same(ours.reset(seed=2), theirs.reset(seed=2))
    for _ in range(120):
        # into a wall
        action = np.tile(np.float32([1.0, 0.0]), (2, 1))
        one = ours.step(action)
        same(one, theirs.step(action))
    ours.close()
    theirs.close()


def test_the_bits_do_not_depend_on_the_threads():
    results = []
    for threads in (1, 2, 5):
        envs = gymnasium.make_vec(ID, num_envs=5, threads=threads)
        seen = [envs.reset(seed=9)[0]]
        for action in actions_for(envs, 150):
            observations, rewards, terminated, truncated, _ = envs.step(action)
            seen += [observations, rewards, terminated, truncated]
        results.append((seen, [sim.state_hash() for sim in envs.simulations]))
        envs.close()
    for seen, hashes in results[1:]:
        same(seen, results[0][0])
        assert hashes == results[0][1]


def test_it_has_what_a_vector_of_gymnasium_has():
    envs = gymnasium.make_vec(ID, num_envs=3, render_mode="rgb_array", autoreset_mode="SameStep")
    assert envs.num_envs == 3 and envs.render_mode == "rgb_array" and not envs.closed
    assert envs.metadata["autoreset_mode"] is AutoresetMode.SAME_STEP and envs.spec.id == ID
    assert envs.observation_space == batch_space(envs.single_observation_space, 3)
    assert envs.action_space == batch_space(envs.single_action_space, 3)
    observations, infos = envs.reset(seed=1)
    assert observations in envs.observation_space and infos == {}
    kept = observations.copy()
    observations_then, rewards, terminated, truncated, _ = envs.step(envs.action_space.sample())
    assert np.array_equal(observations, kept) and observations_then in envs.observation_space
    assert rewards.shape == terminated.shape == truncated.shape == (3,)
    assert (rewards.dtype, terminated.dtype, truncated.dtype) == (np.float64, np.bool_, np.bool_)
    pictures = envs.render()
    assert len(pictures) == 3 and not np.array_equal(pictures[0], pictures[1])
    wrapped = gymnasium.wrappers.vector.RecordEpisodeStatistics(envs)
    wrapped.reset(seed=1)
    wrapped.close()
    assert envs.closed


@pytest.mark.parametrize("mode", MODES)
def test_what_a_step_gives_is_not_changed_by_what_comes_then(mode):
    # a reward that is a part of what was read, as it lies there
    task = rail(reward=lambda now: now["rail"][:, 0], terminated=short)
    ours = gym.VectorEnv(task, 2, autoreset_mode=mode)
    theirs = SyncVectorEnv([lambda: gym.Env(task)] * 2, autoreset_mode=mode)
    push = np.float32([[4.0], [1.0]])
    for envs in (ours, theirs):
        envs.reset(seed=1)
    results = [(ours.step(push), theirs.step(push)) for _ in range(20)]
    assert any(one[2][0] for one, _ in results)
    for one, other in results:
        same(one, other)
        assert all(each.flags.writeable for each in one[1:4])
    ours.close()
    theirs.close()


def test_a_reward_that_an_episode_which_just_begins_does_not_have_is_not_asked_for():
    def speed(now):
        with np.errstate(invalid="ignore", divide="ignore"):
            return now["rail"][:, 0] / now.time

    envs = gym.VectorEnv(rail(reward=speed, terminated=short), 2)
    envs.reset(seed=1)
    push = np.float32([[4.0], [0.0]])
    while not envs.step(push)[2][0]:
        pass
    rewards = envs.step(push)[1]
    assert rewards[0] == 0 and np.isfinite(rewards).all()
    envs.close()


def test_without_autoreset_a_mask_says_who_begins_anew():
    task = rail(terminated=short)
    envs = gym.VectorEnv(task, 2, autoreset_mode=AutoresetMode.DISABLED)
    envs.reset(seed=1)
    push = np.float32([[4.0], [0.0]])
    while not envs.step(push)[2][0]:
        pass
    with pytest.raises(ResetNeeded, match=r"environments \[0\] have ended"):
        envs.step(push)
    other = envs.simulations[1].state_hash()
    envs.reset(options={"reset_mask": np.array([True, False])})
    assert envs.simulations[1].state_hash() == other
    assert envs.moment.elapsed[0] == 0 and envs.moment.elapsed[1] > 0
    envs.step(push)
    for mask in (np.array([True]), np.array([1, 0]), np.array([False, False])):
        with pytest.raises(ValueError, match="2 booleans"):
            envs.reset(options={"reset_mask": mask})
    envs.close()


def test_bad_calls_are_refused():
    with pytest.raises(ValueError, match="num_envs"):
        gym.VectorEnv(rail(), 0)
    with pytest.raises(ValueError, match="threads"):
        gym.VectorEnv(rail(), 1, threads=0)
    envs = gym.VectorEnv(rail(), 2)
    with pytest.raises(ResetNeeded):
        envs.step(np.zeros((2, 1)))
    with pytest.raises(ResetNeeded):
        envs.reset(options={"reset_mask": np.array([True, False])})
    with pytest.raises(ValueError, match="3 seeds for 2 environments"):
        envs.reset(seed=[1, 2, 3])
    envs.reset()
    with pytest.raises(ValueError, match=r"shape \(2, 1\), not \(3, 1\)"):
        envs.step(np.zeros((3, 1)))
    with pytest.raises(ValueError, match="number 0 of the action of environment 1"):
        envs.step(np.array([[0.0], [np.nan]]))
    envs.close()
    for call in (lambda: envs.step(np.zeros((2, 1))), envs.reset):
        with pytest.raises(pongsim.Gone):
            call()


def test_a_fault_names_the_environment_and_the_others_are_left_whole():
    class Judge(pongsim.System):
        def post_update(self, info):
            raise ValueError("no")

    envs = gym.VectorEnv(rail(), 3, threads=2)
    envs.reset(seed=1)
    envs.simulations[1].remove(envs.simulations[1].model("cart"))
    with pytest.raises(pongsim.Gone, match="environment 1"):
        envs.step(np.zeros((3, 1)))
    assert envs.simulations[2].time == pytest.approx(0.2)
    envs.close()

    envs = gym.VectorEnv(rail(), 3, threads=2)
    envs.reset(seed=1)
    envs.simulations[2].close()
    with pytest.raises(pongsim.Gone):
        envs.step(np.zeros((3, 1)))
    envs.close()


def test_systems_and_callbacks_in_python_run_on_the_threads():
    class Counts(pongsim.System):
        count = 0

        def post_update(self, info):
            self.count += 1
            assert self.sim.model("cart").joint("rail").position() == 0

    envs = gym.VectorEnv(rail(), 4, threads=3)
    systems = [Counts() for _ in range(4)]
    heard = [[] for _ in range(4)]
    for simulation, system, to in zip(envs.simulations, systems, heard):
        simulation.add(system)
        simulation.subscribe("/imu", to)
    envs.reset(seed=1)
    for _ in range(10):
        envs.step(np.zeros((4, 1)))
    assert [system.count for system in systems] == [1100] * 4
    assert len({len(to) for to in heard}) == 1 and len(heard[0]) > 100
    assert [system.error for system in systems] == [None] * 4
    envs.close()


def test_what_callbacks_raise_on_threads_comes_out_of_the_step():
    envs = gym.VectorEnv(rail(), 4, threads=2)
    envs.reset(seed=1)

    def hear(message):
        raise LookupError("not this")

    for simulation in envs.simulations[1:]:
        simulation.subscribe("/imu", hear)
    with pytest.raises(LookupError, match="not this"):
        envs.step(np.zeros((4, 1)))
    assert envs.simulations[0].time == pytest.approx(0.2)
    envs.close()


def test_a_thousand_episodes_leave_nothing_behind():
    from test_leaks import grown

    envs = gym.VectorEnv(rail(terminated=lambda now: True, step_time=0.01, settle_time=0.01), 4, threads=2)
    envs.reset(seed=1)

    def episodes():
        for _ in range(20):
            envs.step(np.zeros((4, 1)))

    assert grown(episodes, 200, 20) < 2_000
    envs.close()


def test_too_many_threads_are_an_error():
    if "san.so" in os.environ.get("LD_PRELOAD", ""):
        pytest.skip("a sanitizer ends the process where a thread has no memory")
    program = """
import resource
import numpy as np
from test_gym import rail
import pongsim.gym as gym

envs = gym.VectorEnv(rail(), 8, threads=8)
size = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
# room for the stacks of a few threads
resource.setrlimit(resource.RLIMIT_AS, (size + 30_000_000, resource.RLIM_INFINITY))
try:
    envs.reset(seed=1)
except RuntimeError as error:
    print(error)
resource.setrlimit(resource.RLIMIT_AS, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
envs.reset(seed=1)
envs.step(np.zeros((8, 1)))
"""
    done = subprocess.run([sys.executable, "-c", program], cwd=Path(__file__).parent, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert "can't start 8 threads: Resource temporarily unavailable" in done.stdout
