"""Several agents in one world, checked by PettingZoo itself."""

import numpy as np
import pettingzoo
import pytest
from gymnasium import spaces
from gymnasium.error import ResetNeeded
from pettingzoo.test import parallel_api_test, parallel_seed_test
from test_observations import EYED

import pongsim
import pongsim.gym as gym
from pongsim.gym.pettingzoo import Agent, ParallelEnv

# two carts on rails
CART = EYED[EYED.index('<model name="cart">') : EYED.index("</world>")]
TWO = EYED.replace("</world>", CART.replace('name="cart"><pose>3 0', 'name="tail"><pose>3 1') + "</world>")


def cart(name, **changes):
    return Agent(**{
        "action": [gym.JointForce(f"{name}::rail", -4.0, 4.0)],
        "observation": {"rail": gym.Joint(f"{name}::rail")},
        "reward": lambda now: -np.abs(now[f"{name}.rail"][:, 0]),
        **changes,
    })


def env_of(first={}, second={}, **task):
    return ParallelEnv(TWO, {"cart": cart("cart", **first), "tail": cart("tail", **second)}, **task)


@pytest.mark.filterwarnings("error")
def test_it_passes_pettingzoos_own_checks():
    env = env_of(first={"terminated": lambda now: now["cart.rail"][:, 0] > 0.2}, time_limit=2.0)
    assert isinstance(env, pettingzoo.ParallelEnv)
    parallel_api_test(env, num_cycles=100)
    env.close()
    parallel_seed_test(lambda: env_of(time_limit=1.0, start=lambda sim, random: sim.model("tail").joint("rail").reset(
        random.uniform(-1, 1))), num_cycles=50)


def test_each_acts_observes_and_is_rewarded():
    env = env_of(second={"observation": {"rail": gym.Joint("tail::rail"), "eye": gym.Image("eye")}})
    assert env.observation_space("tail") == spaces.Dict({
        "rail": spaces.Box(-np.inf, np.inf, (2,), np.float32), "eye": spaces.Box(0, 255, (48, 64, 3), np.uint8)})
    first, infos = env.reset(seed=1)
    assert set(first) == {"cart", "tail"} == set(infos)
    seen, rewards, terminated, truncated, _ = env.step({"cart": [4.0], "tail": [-2.0]})
    assert seen["cart"] == pytest.approx([0.01, 0.2], abs=1e-3)
    assert seen["tail"]["rail"] == pytest.approx([-0.005, -0.1], abs=1e-3)
    assert seen["tail"]["eye"].shape == (48, 64, 3)
    assert rewards == pytest.approx({"cart": -0.01, "tail": -0.005}, abs=1e-3)
    assert not any(terminated.values()) and not any(truncated.values())
    env.close()


def test_who_is_done_leaves_and_acts_no_more():
    env = env_of(first={"terminated": lambda now: now["cart.rail"][:, 0] > 0.05}, time_limit=1.0)
    env.reset(seed=1)
    everybody = {"cart": [4.0], "tail": [0.0]}
    while "cart" in env.agents:
        _, _, terminated, _, _ = env.step(everybody)
    assert terminated == {"cart": True, "tail": False}
    speed = env.simulation.model("cart").joint("rail").velocity()
    seen, rewards, _, truncated, _ = env.step({"tail": [1.0]})
    assert set(seen) == {"tail"} == set(rewards)
    assert env.simulation.model("cart").joint("rail").velocity() == pytest.approx(speed, rel=1e-9)
    while env.agents:
        _, _, _, truncated, _ = env.step({"tail": [1.0]})
    assert truncated == {"tail": True}
    with pytest.raises(ResetNeeded):
        env.step({"tail": [1.0]})
    env.reset()
    assert env.agents == ["cart", "tail"]
    env.close()


def test_mistakes_are_told_of():
    with pytest.raises(ValueError, match="needs an agent"):
        ParallelEnv(TWO, {})
    with pytest.raises(KeyError, match="tale"):
        env_of(second={"action": [gym.JointForce("tale::rail", -1, 1)]})
    env = env_of(first={"reward": lambda now: np.nan})
    with pytest.raises(ResetNeeded):
        env.step({})
    for actions, text in (({"cart": [1.0]}, "no action of agent 'tail'"), ({"cart": [1.0, 2.0], "tail": [0.0]}, "has the shape"),
                          ({"cart": [np.inf], "tail": [0.0]}, "finite")):
        env.reset()
        with pytest.raises(ValueError, match=text):
            env.step(actions)
    env.reset()
    with pytest.raises(gym.TaskError, match="reward of 'cart'"):
        env.step({"cart": [0.0], "tail": [0.0]})
    assert env.render() is None
    env.close()
    with pytest.raises(pongsim.Gone):
        env.step({})
