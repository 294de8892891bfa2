"""Properties that each episode draws."""

import numpy as np
import pytest
from conftest import COURT
from test_gym import NOISY, rail
from test_observations import EYED
from test_seeing import SCENE

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


def look(env):
    return env.simulation.render("eye").reshape(-1, 3).astype(float)


def test_colours_and_lights_are_seen():
    task = rail(world=EYED, observation={"rail": gym.Joint("cart::rail")}, randomise=[
        gym.Randomise("color", "floor::*", 0.0, 1.0, relative=False)])
    env = gym.Env(task)
    seen = []
    for seed in (1, 2, 1):
        env.reset(seed=seed)
        seen.append(look(env))
    assert np.array_equal(seen[0], seen[2]) and not np.array_equal(seen[0], seen[1])
    # as if the file had these colours
    drawn = np.random.Generator(np.random.PCG64(np.random.SeedSequence(1))).uniform(0, 1, 3)
    color = " ".join(repr(each) for each in drawn.tolist())
    same = gym.Env(rail(world=EYED.replace(
        "<ambient>0 1 0 1</ambient>", f"<ambient>{color} 1</ambient><diffuse>{color} 1</diffuse>"),
        observation={"rail": gym.Joint("cart::rail")}))
    same.reset(seed=1)
    assert np.array_equal(look(same), seen[0])
    same.close()
    # a reset of the world brings the file's colours back
    env.simulation.reset()
    assert look(env)[0].argmax() == 1
    env.close()
    lit = SCENE.replace("<ambient>1 1 1 1</ambient>", "<ambient>0 0 0 1</ambient>").replace(
        "<model", "<light name='sun' type='directional'><direction>0 0 -1</direction><diffuse>1 1 1 1</diffuse></light><model", 1
    ).replace("<ambient>0 1 0 1</ambient>", "<diffuse>0 1 0 1</diffuse>")
    with pongsim.Simulation(lit) as sim:
        bright = sim.render("eye").sum()
        (name, sun), = sim.lights().items()
        assert name == "sun" and sun["intensity"] == 1
        sim.change_light({**sun, "intensity": 0.2})
        dark = sim.render("eye").sum()
        assert dark < 0.8 * bright and sim.lights()["sun"]["intensity"] == pytest.approx(0.2)
        with pytest.raises(pongsim.Refused, match="moon"):
            sim.change_light({**sun, "name": "moon", "id": 0})
        sim.reset()
        assert sim.render("eye").sum() == bright
        draw = gym.Randomise("light_intensity", "s*", 0.2, 0.2).attach(sim)
        draw(np.random.default_rng(1))
        assert sim.render("eye").sum() == dark


def test_a_colour_is_checked():
    with pongsim.Simulation(SCENE) as sim:
        link = sim.model("floor").links[0]
        assert link.visual_names == ["v"]
        before = sim.render("eye")
        with pytest.raises(KeyError, match="no visual 'w'"):
            link.set_color("w", (0, 0, 0))
        for wrong in ((0, 0, 2), (-1, 0, 0)):
            with pytest.raises(pongsim.Refused, match="a colour must be 0 to 1"):
                link.set_color("v", wrong)
        assert np.array_equal(sim.render("eye"), before)


def test_mistakes_are_told_of():
    with pytest.raises(ValueError, match="relative=False"):
        gym.Randomise("color", "a", 0, 1)
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
