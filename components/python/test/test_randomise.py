"""Properties that each episode draws."""

import numpy as np
import pytest
from conftest import COURT
from test_gym import NOISY, rail

import pongsim
import pongsim.gym as gym

MASS = gym.Randomise("mass", "cart::body", 0.5, 2.0)


def mass(env):
    return env.simulation.model("cart").link("body").mass


def test_each_episode_has_its_own_from_the_seed():
    env = gym.Env(rail(randomise=[MASS]))
    drawn = []
    for seed in (1, None, None, 1, None, None):
        env.reset(seed=seed)
        drawn.append(mass(env))
        env.step([4.0])
    assert drawn[:3] == drawn[3:] and len(set(drawn)) == 3
    assert all(1.0 <= each <= 4.0 for each in drawn)
    # the file's value is the base each time
    expected = np.random.Generator(np.random.PCG64(np.random.SeedSequence(1))).uniform(0.5, 2.0) * 2
    assert drawn[0] == pytest.approx(expected)
    env.simulation.reset()
    assert mass(env) == 2.0
    env.close()


def test_it_acts():
    light, heavy = (gym.Env(rail(randomise=[gym.Randomise("mass", "cart::body", each, each, relative=False)])) for each in (1, 4))
    speeds = []
    for env in (light, heavy):
        env.reset(seed=1)
        env.step([4.0])
        speeds.append(env.simulation.model("cart").joint("rail").velocity())
        env.close()
    assert speeds[0] == pytest.approx(4 * speeds[1], rel=1e-6) and speeds[1] == pytest.approx(0.1, rel=1e-6)


@pytest.mark.parametrize("world", [rail().world, NOISY])
def test_the_same_seed_gives_the_same_episode(world):
    task = rail(world, randomise=[MASS, gym.Randomise("damping", "cart::rail", 0.1, 0.5, relative=False)])

    def episode(env, seed):
        hashes = []
        env.reset(seed=seed)
        for _ in range(2):
            for _ in range(5):
                env.step([1.0])
            hashes.append(env.simulation.state_hash())
            env.reset()
        return hashes

    one, other = gym.Env(task), gym.Env(task)
    other.reset(seed=9)
    first = episode(one, 3)
    assert first == episode(other, 3) and first[0] != first[1]
    assert episode(one, 4) != first


def test_each_world_of_a_vector_has_its_own_as_an_env_would():
    task = rail(randomise=[MASS])
    envs = gym.VectorEnv(task, 3, threads=2)
    envs.reset(seed=5)
    masses = [each.model("cart").link("body").mass for each in envs.simulations]
    for i, expected in enumerate(masses):
        env = gym.Env(task)
        env.reset(seed=5 + i)
        assert mass(env) == expected
        env.close()
    envs.reset(options={"reset_mask": np.array([False, True, False])})
    now = [each.model("cart").link("body").mass for each in envs.simulations]
    assert [a == b for a, b in zip(masses, now)] == [True, False, True]
    envs.close()


def test_everything_of_a_robot():
    randomise = [
        gym.Randomise("mass", "pong_bot::*", 0.8, 1.2),
        gym.Randomise("inertia", "pong_bot::*", 2.0, 3.0, together=True),
        gym.Randomise("friction", "*", 0.5, 0.9, together=True),
        gym.Randomise("restitution", "pong_bot::*", 0.1, 0.2, relative=False),
        gym.Randomise("damping", "pong_bot::*", 0.1, 0.2, relative=False),
        gym.Randomise("joint_friction", "pong_bot::*", 0.1, 0.2, relative=False),
    ]
    env = gym.Env(gym.Task(world=COURT, action=[gym.Command("/cmd_vel", {"linear.x": (0, 1)})],
                           observation={"pose": gym.Pose("pong_bot")}, reward=lambda now: 0.0, randomise=randomise))
    env.reset(seed=1)
    robot = env.simulation.model("pong_bot")
    factors = {link.inertia_factor for link in robot.links}
    assert len(factors) == 1 and 2 <= factors.pop() <= 3
    assert len({round(joint.axis().damping, 12) for joint in robot.joints if joint.axis_count}) == sum(
        joint.axis_count > 0 for joint in robot.joints)
    env.step([0.5])
    env.close()


def test_mistakes_are_told_of():
    with pytest.raises(ValueError, match="'mas' can't be drawn; did you mean 'mass'"):
        gym.Randomise("mas", "a", 0, 1)
    for low, high in ((2, 1), (-1, 1), (0, np.inf), (np.nan, 1)):
        with pytest.raises(ValueError, match="lesser first"):
            gym.Randomise("mass", "a", low, high)
    with pytest.raises(KeyError, match="did you mean 'cart::body'"):
        gym.Env(rail(randomise=[gym.Randomise("mass", "cart::boddy", 1, 2)]))
    with pytest.raises(TypeError, match="list of Randomise"):
        rail(randomise=["mass"])
    env = gym.Env(rail(randomise=[gym.Randomise("mass", "cart::body", 0, 0)]))
    with pytest.raises(pongsim.Refused, match="cart::body"):
        env.reset()
