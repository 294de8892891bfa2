"""Many worlds as a vector of stable-baselines3. It needs PyTorch, which is large, so it is no requirement of the tests."""

import subprocess
import sys

import numpy as np
import pytest
from test_observations import eyed
from test_gym import rail

import pongsim.gym as gym

try:
    import stable_baselines3
except ImportError:
    stable_baselines3 = None
needed = pytest.mark.skipif(
    stable_baselines3 is None, reason="stable-baselines3 is not installed: with PyTorch it has 3 GB, too many for these tests")


def task(**changes):
    return rail(start=lambda sim, random: sim.model("cart").joint("rail").reset(random.uniform(-1, 1)), time_limit=1.0, **changes)


def test_without_it_it_says_what_to_install():
    code = "import sys; sys.modules['stable_baselines3'] = None; import pongsim.gym.sb3"
    result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert "ImportError: pongsim.gym.sb3 needs stable-baselines3" in result.stderr


@needed
def test_an_env_passes_its_own_check():
    from stable_baselines3.common.env_checker import check_env

    for each in (task(), eyed()):
        env = gym.Env(each, render_mode="rgb_array")
        check_env(env)
        env.close()


@needed
def test_it_gives_what_its_own_vector_gives():
    from stable_baselines3.common.vec_env import DummyVecEnv

    from pongsim.gym.sb3 import VecEnv

    ours = VecEnv(task(), 3, threads=2)
    theirs = DummyVecEnv([lambda: gym.Env(task()) for _ in range(3)])
    random = np.random.default_rng(1)
    for envs in (ours, theirs):
        envs.seed(7)
    assert np.array_equal(ours.reset(), theirs.reset())
    ended = 0
    for _ in range(25):
        actions = random.uniform(-4, 4, (3, 1)).astype(np.float32)
        for mine, other in zip(ours.step(actions)[:3], theirs.step(actions)[:3]):
            assert np.array_equal(mine, other) and mine.dtype == other.dtype
        for mine, other in zip(ours.step(actions)[3], theirs.step(actions)[3]):
            assert mine.get("TimeLimit.truncated", False) == other.get("TimeLimit.truncated", False)
            assert ("terminal_observation" in mine) == ("terminal_observation" in other)
            if "terminal_observation" in mine:
                ended += 1
                assert np.array_equal(mine["terminal_observation"], other["terminal_observation"])
    assert ended >= 6
    assert ours.env_is_wrapped(object) == [False] * 3
    assert ours.get_attr("simulation")[1] is ours.simulations[1]
    ours.set_attr("note", 5, indices=[0, 2])
    assert ours.get_attr("note", indices=2) == [5] and not ours.has_attr("note")
    assert ours.env_method("state_hash", indices=0) == [ours.simulations[0].state_hash()]
    ours.close()
    theirs.close()


@needed
def test_its_algorithms_take_it():
    from stable_baselines3 import PPO
    from stable_baselines3.common.evaluation import evaluate_policy
    from stable_baselines3.common.vec_env import VecMonitor, VecTransposeImage

    from pongsim.gym.sb3 import VecEnv

    envs = VecMonitor(VecEnv(task(), 4))
    model = PPO("MlpPolicy", envs, n_steps=16, batch_size=32, seed=1, device="cpu")
    model.learn(128)
    mean, _ = evaluate_policy(model, envs, 4)
    assert model.num_timesteps == 128 and -10 < mean < 0
    envs.close()
    seen = VecTransposeImage(VecEnv(eyed(), 2, render_mode="rgb_array"))
    PPO("MultiInputPolicy", seen, n_steps=8, batch_size=8, device="cpu").learn(16)
    assert seen.render().shape == (480, 320, 3)
    seen.close()
