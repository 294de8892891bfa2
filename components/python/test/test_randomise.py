"""Properties that each episode draws."""

import numpy as np
import pytest
from conftest import COURT
from gymnasium import spaces
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


ROLLER = """<sdf version="1.9"><world name="w">
  <plugin filename="ignition-gazebo-physics-system" name="ignition::gazebo::systems::Physics"/>
  <model name="ground"><static>true</static><link name="l"><collision name="c"><geometry><plane/></geometry></collision></link>
  </model>
  <model name="ball"><pose>0 0 1 0 0 0</pose><link name="l"><inertial><mass>2</mass></inertial>
    <collision name="c"><geometry><sphere><radius>0.5</radius></sphere></geometry></collision>
    <visual name="v"><geometry><sphere><radius>0.5</radius></sphere></geometry></visual></link></model>
  <model name="crate"><pose>5 0 1 0 0 0</pose><link name="l"><collision name="c"><geometry><box><size>1 2 3</size></box>
    </geometry></collision></link></model></world></sdf>"""


def rolling(*randomise):
    return gym.Task(world=ROLLER, action=lambda sim, action: None, action_space=spaces.Box(-1, 1, (1,)),
                    observation={"ball": gym.Pose("ball")}, reward=lambda now: 0.0, randomise=randomise)


def radius(sim):
    return sim.model("ball").link("l").collision("c").size[0]


def test_sizes():
    task = rolling(gym.Randomise("size", "*", 0.5, 2.0), gym.Randomise("size", "ball::*", 1.0, 1.5, with_mass=True))
    env = gym.Env(task)
    drawn, hashes = [], []
    for seed in (1, None, 1, None):
        env.reset(seed=seed)
        drawn.append(radius(env.simulation))
        hashes.append(env.simulation.state_hash())
    assert drawn[:2] == drawn[2:] and hashes[:2] == hashes[2:] and drawn[0] != drawn[1]
    sim = env.simulation
    # the box keeps its proportions
    numbers = np.random.Generator(np.random.PCG64(np.random.SeedSequence(1))).uniform(0.5, 2.0, 2)
    env.reset(seed=1)
    assert sim.model("crate").link("l").collision("c").size == pytest.approx(np.array([1, 2, 3]) * numbers[1])
    assert sim.model("ball").link("l").visual_size("v") == (radius(sim),)
    sim.reset()
    assert radius(sim) == 0.5 and sim.model("ball").link("l").mass == 2
    envs = gym.VectorEnv(task, 3, threads=2)
    envs.reset(seed=0)
    assert radius(envs.simulations[1]) == drawn[0] and len({radius(each) for each in envs.simulations}) == 3
    envs.close()
    env.close()


def test_a_mass_follows_a_size():
    env = gym.Env(rolling(gym.Randomise("size", "ball::*", 1.0, 1.0, relative=False, with_mass=True)))
    env.reset(seed=1)
    assert radius(env.simulation) == 1 and env.simulation.model("ball").link("l").mass == pytest.approx(16)
    env.close()


def test_a_thousand_sizes_are_those_of_the_file_again():
    env = gym.Env(rolling(gym.Randomise("size", "*", 0.5, 2.0)))
    for _ in range(1000):
        env.reset()
    env.simulation.reset()
    with pongsim.Simulation(ROLLER) as fresh:
        for each in (fresh, env.simulation):
            each.step(200)
        assert fresh.state_hash() == env.simulation.state_hash()
    env.close()


def test_noise():
    task = rail(world=NOISY, randomise=[gym.Randomise("noise", "*::imu::acceleration x", 0.5, 2.0),
                                        gym.Randomise("noise", "*::imu::turn *", 0.1, 0.2, relative=False)])
    env = gym.Env(task)
    drawn = []
    for seed in (1, None, 1):
        env.reset(seed=seed)
        noise = env.simulation._find_sensor("imu").noise
        drawn.append(noise["acceleration x"].stddev)
        assert 0.05 <= drawn[-1] <= 0.2 and all(0.1 <= noise[f"turn {axis}"].stddev <= 0.2 for axis in "xyz")
        assert noise["acceleration y"].stddev == 0
    assert drawn[0] == drawn[2] != drawn[1]
    env.close()
    # of a sensor that has none in the file, too: each episode has its own
    env = gym.Env(rail(randomise=[gym.Randomise("noise", "*acceleration x", 0.1, 0.1, relative=False)]))
    felt = [env.reset(seed=1)[0][2], env.reset()[0][2], env.reset(seed=1)[0][2]]
    assert felt[0] == felt[2] != felt[1]
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
    for wrong, said in (({"low": 0, "high": 1}, "above 0"), ({"what": "mass", "low": 1, "high": 1, "with_mass": True}, "goes with")):
        with pytest.raises(ValueError, match=said):
            gym.Randomise(**{"what": "size", "name": "*", **wrong})
    with pytest.raises(ValueError, match="only radii of spheres"):
        gym.Env(rolling(gym.Randomise("size", "*", 1, 2, relative=False)))
    with pytest.raises(KeyError, match="did you mean 'cart::body::imu::turn [xyz]'"):
        gym.Env(rail(randomise=[gym.Randomise("noise", "cart::body::imu::turn", 1, 2)]))
    with pytest.raises(KeyError, match="did you mean 'cart::body'"):
        gym.Env(rail(randomise=[gym.Randomise("mass", "cart::boddy", 1, 2)]))
    with pytest.raises(TypeError, match="list of Randomise"):
        rail(randomise=["mass"])
    env = gym.Env(rail(randomise=[gym.Randomise("mass", "cart::body", 0, 0)]))
    with pytest.raises(pongsim.Refused, match="cart::body"):
        env.reset()
