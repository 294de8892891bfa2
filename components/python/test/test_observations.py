"""Images and dicts as observations, and actions that are positions of joints."""

import numpy as np
import pytest
from gymnasium import spaces
from gymnasium.utils.env_checker import check_env
from test_gym import rail
from test_seeing import SCENE, colours

import pongsim
import pongsim.gym as gym

EYED = SCENE.replace("</world>", """<model name="cart"><pose>3 0 1 0 0 0</pose><link name="base"/><link name="body">
  <inertial><mass>2</mass></inertial></link>
  <joint name="fix" type="fixed"><parent>world</parent><child>base</child></joint>
  <joint name="rail" type="prismatic"><parent>base</parent><child>body</child><axis><xyz>1 0 0</xyz>
    <limit><lower>-2</lower><upper>1.5</upper></limit></axis></joint></model></world>""")


def eyed(**changes):
    return rail(**{
        "world": EYED,
        "observation": {"rail": gym.Joint("cart::rail"), "eye": gym.Image("eye")},
        "step_time": 0.1,
        **changes,
    })


@pytest.mark.filterwarnings("ignore:.*WARN.*Box")
def test_images_beside_numbers_make_a_dict():
    env = gym.Env(eyed(time_limit=1.0))
    check_env(env, skip_render_check=True)
    assert env.observation_space == spaces.Dict({
        "rail": spaces.Box(-np.inf, np.inf, (2,), np.float32), "eye": spaces.Box(0, 255, (48, 64, 3), np.uint8)})
    first, _ = env.reset(seed=1)
    assert colours(first["eye"]) == {"r", "g"}
    second, *_ = env.step([4.0])
    assert second["rail"] == pytest.approx([0.01, 0.2], abs=1e-3)
    # the ball has fallen
    assert not np.array_equal(first["eye"], second["eye"])
    assert np.array_equal(env.reset()[0]["eye"], first["eye"])
    env.close()


def test_one_image_alone_is_an_array_unless_a_dict_is_asked_for():
    env = gym.Env(eyed(observation={"eye": gym.Image("eye", size=(20, 10))}))
    assert env.observation_space == spaces.Box(0, 255, (10, 20, 3), np.uint8)
    assert env.reset()[0].shape == (10, 20, 3)
    env.close()
    env = gym.Env(eyed(observation={"eye": gym.Image(gym.Camera(width=12, height=8))}, dictionary=True))
    assert env.reset()[0]["eye"].shape == (8, 12, 3)
    env.close()


def test_readings_as_a_dict():
    env = gym.Env(rail(dictionary=True))
    observation, _ = env.reset()
    assert {name: array.shape for name, array in observation.items()} == {"rail": (2,), "felt": (1,)}
    after, *_ = env.step([4.0])
    assert after["rail"][1] == pytest.approx(0.2, abs=1e-3) and after["felt"][0] == pytest.approx(2, abs=1e-3)
    # earlier ones are not written to
    assert observation["rail"][1] == 0
    env.close()


def test_a_vector_has_what_each_env_has():
    task = eyed(start=lambda sim, random: sim.model("cart").joint("rail").reset(random.uniform(-1, 1)), time_limit=0.2)
    envs = gym.VectorEnv(task, 3, threads=2, autoreset_mode="SameStep")
    both, _ = envs.reset(seed=5)
    assert both["eye"].shape == (3, 48, 64, 3)
    envs.step(np.ones((3, 1)))
    after, _, _, truncated, infos = envs.step(np.ones((3, 1)))
    assert truncated.all()
    for i in range(3):
        env = gym.Env(task)
        alone, _ = env.reset(seed=5 + i)
        assert all(np.array_equal(alone[name], both[name][i]) for name in alone)
        env.step([1.0])
        last = env.step([1.0])[0]
        assert all(np.array_equal(last[name], infos["final_obs"][i][name]) for name in last)
        alone, _ = env.reset()
        assert all(np.array_equal(alone[name], after[name][i]) for name in alone)
        env.close()
    envs.close()


def test_a_function_returns_a_dict():
    space = spaces.Dict({"x": spaces.Box(-1, 1, (1,)), "time": spaces.Box(0, 10, (), np.float64)})
    task = rail(observation=lambda sim: {"x": sim.joint_states()[0, :1], "time": sim.time}, observation_space=space)
    env = gym.Env(task)
    observation, _ = env.reset()
    assert space.contains(observation) and observation["time"] == pytest.approx(0.1)
    env.close()
    for wrong, text in (({"x": [0.0]}, "must return a dict with"), ([0.0], "must return a dict"),
                        ({"x": [2.0], "time": 0.0}, r"of 'x' outside its space.*number \[0\] is 2"),
                        ({"x": ["a"], "time": 0.0}, "of 'x' outside its space")):
        env = gym.Env(rail(observation=lambda sim, wrong=wrong: wrong, observation_space=space))
        with pytest.raises(gym.TaskError, match=text):
            env.reset()
        env.close()


@pytest.mark.parametrize(
    "changes, kind, text",
    [
        ({"dictionary": False}, ValueError, "don't fit into one array"),
        ({"observation": {"eye": gym.Image("eya")}}, KeyError, "no sensor 'eya'"),
        ({"observation": {"eye": gym.Image("eye", (0, 5))}}, ValueError, "pixel"),
        ({"extra": {"seen": gym.Image("eye")}}, TypeError, "must be a Reading"),
        ({"observation": lambda sim: 0, "observation_space": spaces.Discrete(2)}, TypeError, "a Box or a Dict of Boxes"),
        ({"observation": lambda sim: 0, "observation_space": spaces.Box(0, 1), "dictionary": True}, ValueError, "leave out"),
    ],
)
def test_mistakes_are_told_of(changes, kind, text):
    with pytest.raises(kind, match=text):
        gym.Env(eyed(**changes))


def position(stiffness=200.0, damping=40.0, *limits, **changes):
    return eyed(action=[gym.JointPosition("cart::rail", *limits, stiffness=stiffness, damping=damping)],
                observation={"rail": gym.Joint("cart::rail")}, **changes)


def test_a_joint_moves_to_a_position():
    env = gym.Env(position())
    # the joint's own limits
    assert env.action_space == spaces.Box(-2, 1.5, (1,), np.float32)
    env.reset()
    for _ in range(20):
        (x, speed), *_ = env.step([0.8])
    # critically damped: 2 kg, 200 N/m, 40 N s/m
    assert x == pytest.approx(0.8, abs=1e-4) and abs(speed) < 1e-3
    env.reset()
    (x, speed), *_ = env.step([0.1])
    # x = 0.1 (1 - (1 + w t) exp(-w t)) with w = 10 1/s
    assert x == pytest.approx(0.1 * (1 - 2 * np.exp(-1)), rel=0.02)
    env.close()
    env = gym.Env(position(200.0, 40.0, -0.5, 0.5))
    env.reset()
    for _ in range(20):
        (x, _), *_ = env.step([3.0])
    assert x == pytest.approx(0.5, abs=1e-4)
    env.close()


def test_what_cant_be_a_position_controller_is_said():
    with pytest.raises(ValueError, match="stiffness and damping"):
        gym.Env(position(-1.0))
    with pytest.raises(ValueError, match="two finite numbers"):
        gym.Env(rail(action=[gym.JointPosition("cart::rail", stiffness=1.0, damping=1.0)]))
    with pytest.raises(KeyError, match="rail"):
        gym.Env(rail(action=[gym.JointPosition("cart::rial", 0, 1, stiffness=1.0, damping=1.0)]))


def test_its_gains_are_drawn_for_each_episode():
    randomise = [gym.Randomise("servo_stiffness", "cart::rail", 0.5, 2.0), gym.Randomise("servo_damping", "cart::*", 1.0, 1.0)]
    env = gym.Env(position(randomise=randomise))
    ends = []
    for seed in (1, 2, 1):
        env.reset(seed=seed)
        ends.append(float(env.step([0.5])[0][0]))
    assert ends[0] == ends[2] and abs(ends[0] - ends[1]) > 1e-3
    factor = np.random.Generator(np.random.PCG64(np.random.SeedSequence(1))).uniform(0.5, 2.0)
    plain = gym.Env(position(stiffness=200 * factor))
    plain.reset(seed=1)
    assert float(plain.step([0.5])[0][0]) == pytest.approx(ends[0], rel=1e-6)
    with pytest.raises(KeyError, match="cart::rail"):
        gym.Env(position(randomise=[gym.Randomise("servo_stiffness", "cart::ral", 1, 2)]))
    # of simulations alone there are none
    assert pongsim.Simulation(EYED)._gains == {}
    env.close()
    plain.close()
