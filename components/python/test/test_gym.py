"""A world as a Gymnasium environment."""

import re
import subprocess
import sys
import warnings

import gymnasium
import numpy as np
import pytest
from conftest import COURT
from gymnasium import spaces
from gymnasium.error import ResetNeeded
from gymnasium.utils.env_checker import check_env

import pongsim
import pongsim.gym as gym

# a ball on a rail, with an IMU
RAIL = """<sdf version="1.9"><world name="w">
  <plugin filename="ignition-gazebo-physics-system" name="ignition::gazebo::systems::Physics"/>
  <plugin filename="ignition-gazebo-imu-system" name="ignition::gazebo::systems::Imu"/>
  <model name="cart"><link name="base"/><link name="body"><inertial><mass>2</mass></inertial>
      <sensor name="imu" type="imu"><topic>imu</topic><update_rate>100</update_rate>NOISE</sensor></link>
    <joint name="fix" type="fixed"><parent>world</parent><child>base</child></joint>
    <joint name="rail" type="prismatic"><parent>base</parent><child>body</child><axis><xyz>1 0 0</xyz></axis></joint>
  </model></world></sdf>"""
QUIET = RAIL.replace("NOISE", "")
NOISY = RAIL.replace(
    "NOISE",
    "<imu><linear_acceleration><x><noise type='gaussian'><mean>0</mean><stddev>0.1</stddev></noise></x>"
    "</linear_acceleration></imu>",
)


def rail(world=QUIET, **changes):
    what = {
        "world": world,
        "action": [gym.JointForce("cart::rail", -4.0, 4.0)],
        "observation": {"rail": gym.Joint("cart::rail"), "felt": gym.Fields("/imu", "linear_acceleration.x")},
        "reward": lambda now: -np.abs(now["rail"][:, 0]),
        **changes,
    }
    return gym.Task(**what)


@pytest.fixture
def avoider():
    env = gymnasium.make("pongsim/WallAvoid-v0")
    yield env
    env.close()


def test_the_wall_avoider_passes_gymnasiums_own_check():
    env = gymnasium.make("pongsim/WallAvoid-v0", render_mode="rgb_array").unwrapped
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_env(env)
    env.close()


@pytest.mark.filterwarnings("ignore:.*WARN.*Box")  # that the limits are not those of learners
def test_an_environment_of_ones_own_passes_it():
    env = gym.Env(rail(time_limit=1.0))
    check_env(env, skip_render_check=True)
    env.close()


def test_the_name_brings_its_module_along():
    code = "import gymnasium; gymnasium.make('pongsim.gym:pongsim/WallAvoid-v0').reset(seed=1)"
    subprocess.run([sys.executable, "-c", code], check=True)


def test_spaces_say_what_numbers_lie_between(avoider):
    assert avoider.observation_space == spaces.Box(0.0, 10.0, (64,), np.float32)
    assert avoider.action_space == spaces.Box(np.float32([0, -1]), np.float32([1, 1]), dtype=np.float32)


def test_a_force_moves_the_cart_as_newton_says():
    env = gym.Env(rail(step_time=0.5))
    env.reset(seed=1)
    observation, reward, terminated, truncated, info = env.step([4.0])
    # 4 N on 2 kg for half a second; the world counts in steps of a millisecond
    assert observation == pytest.approx([0.25, 1.0, 2.0], abs=2e-3)
    assert reward == pytest.approx(-0.25, abs=2e-3) and not terminated and not truncated and info == {}
    assert env.moment.before["rail"][0] == pytest.approx([0, 0])
    # values beyond the limits are clamped
    env.reset()
    assert np.array_equal(env.step([400.0])[0], observation)
    env.close()


def test_a_joint_is_driven_and_poses_and_velocities_are_read():
    env = gym.Env(
        rail(
            action=[gym.JointVelocity("cart::rail", -1, 1)],
            observation={"pose": gym.Pose("cart"), "velocity": gym.Velocity("cart")},
            extra={"rail": gym.Joint("cart::rail")},
            reward=lambda now: now["velocity"][:, 0],
        )
    )
    env.reset(seed=1)
    for _ in range(10):
        _, reward, *_ = env.step([0.5])
    assert env.moment["rail"][0] == pytest.approx([0.5, 0.5], abs=2e-3)
    assert env.observation_space.shape == (13,)
    env.close()


@pytest.mark.filterwarnings("ignore:.*WARN.*Box")
def test_functions_stand_for_readings_and_steerings():
    env = gym.Env(
        rail(
            action=lambda sim, action: sim.model("cart").joint("rail").drive([-1.0, 0.0, 1.0][action]),
            action_space=spaces.Discrete(3),
            observation=lambda sim: sim.joint_states()[0],
            observation_space=spaces.Box(-10, 10, (2,), np.float64),
            extra={"rail": gym.Joint("cart::rail")},
        )
    )
    check_env(env, skip_render_check=True)
    env.reset()
    observation, *_ = env.step(2)
    assert observation == pytest.approx([0.1, 1.0], abs=2e-3)
    assert np.array_equal(env.moment["rail"][0], observation)
    env.close()


def episode(env, seed=None, steps=40):
    seen = [env.reset(seed=seed)[0]]
    for i in range(steps):
        observation, reward, *_ = env.step(np.float32([0.6, np.sin(i / 5)]))
        seen.append(np.append(observation, reward))
    return np.concatenate(seen)


TWO = RAIL.replace("NOISE", "").replace("</link>", """</link><link name="tip"><inertial><mass>1</mass></inertial></link>
  <joint name="lift" type="prismatic"><parent>body</parent><child>tip</child><axis><xyz>0 0 1</xyz></axis></joint>""", 1)


def test_an_action_by_names():
    def task(action):
        return rail(TWO, action=action, observation={"rail": gym.Joint("cart::rail"), "lift": gym.Joint("cart::lift")})

    push, hold = gym.JointForce("cart::rail", -4, 4), gym.JointForce("cart::lift", 0, 20)
    named = task({"push": push, "hold": [hold]})
    env, plain = gym.Env(named), gym.Env(task([push, hold]))
    assert env.action_space == spaces.Dict(push=spaces.Box(-4, 4, (1,)), hold=spaces.Box(0, 20, (1,)))
    env.reset(seed=1), plain.reset(seed=1)
    assert np.array_equal(env.step({"hold": [9.8], "push": [3.0]})[0], plain.step([3.0, 9.8])[0])
    assert env.simulation.state_hash() == plain.simulation.state_hash()
    assert env.moment.action.tolist() == [[3.0, 9.8]]
    for wrong, said in (
        ([1, 2], "an action must be a dict with 'push', 'hold', not list"),
        ({"push": [1]}, "not 'push'"),
        ({"push": [1], "hold": [1, 2]}, r"an action has at 'hold' the shape \(1,\), not \(2,\)"),
    ):
        with pytest.raises(ValueError, match=said):
            env.step(wrong)
    check_env(env)
    envs = gym.VectorEnv(named, 2)
    envs.reset(seed=1)
    actions = envs.action_space.sample()
    assert actions["hold"].shape == (2, 1)
    envs.step(actions)
    with pytest.raises(ValueError, match="the actions have at 'push' the shape"):
        envs.step({"push": [1, 2], "hold": [[1], [2]]})
    envs.close(), env.close(), plain.close()


def test_a_seed_repeats_to_the_bit_in_a_world_of_its_own_too(avoider):
    first = episode(avoider, seed=3)
    assert not np.array_equal(episode(avoider), first)
    assert np.array_equal(episode(avoider, seed=3), first)
    other = gymnasium.make("pongsim/WallAvoid-v0")
    assert np.array_equal(episode(other, seed=3), first)
    other.close()


def test_an_episode_after_a_restore_has_the_bits_of_one_after_a_start():
    task = rail(reward=lambda now: 0.0)
    env = gym.Env(task)
    runs = []
    for _ in range(3):
        # the first one is a start, the others are restored
        runs.append([env.reset()[0], *(env.step([float(i)])[0] for i in range(5))])
    assert np.array_equal(runs[0], runs[1]) and np.array_equal(runs[0], runs[2])
    env.close()


def test_an_episode_begins_where_models_have_come_and_gone():
    mark = "<sdf version='1.9'><model name='mark'><static>true</static><pose>5 0 0 0 0 0</pose><link name='l'/></model></sdf>"
    env = gym.Env(rail(start=lambda sim, random: sim.insert(mark)))
    runs = [[env.reset()[0], *(env.step([float(i)])[0] for i in range(5))] for _ in range(3)]
    assert np.array_equal(runs[0], runs[1]) and np.array_equal(runs[0], runs[2])
    env.simulation.remove(env.simulation.model("cart"))
    env.reset()
    env.step([1.0])
    env.close()


def felt(env, seed=None):
    env.reset(seed=seed)
    return [env.step([0.0])[0][2] for _ in range(3)]


def test_noise_differs_from_episode_to_episode_and_repeats_with_the_seed():
    env = gym.Env(rail(NOISY))
    runs = [felt(env, seed=5), felt(env), felt(env), felt(env, seed=5), felt(env)]
    assert runs[0] == runs[3] and runs[1] == runs[4]
    assert len({tuple(run) for run in runs}) == 3
    # the seed is the world's
    with pongsim.Simulation(NOISY, seed=5) as sim:
        imu = sim.sensor("imu")
        sim.run_until(0.2)
        assert np.float32(imu.message()["linear_acceleration"]["x"]) == np.float32(runs[0][0])
    env.close()
    # and where it is not wanted
    same = gym.Env(rail(NOISY, noise=False))
    assert felt(same, seed=5) == felt(same)
    same.close()


def test_an_episode_ends_and_is_broken_off():
    env = gym.Env(rail(terminated=lambda now: now["rail"][:, 0] > 0.3, time_limit=1.0))
    for force, end, steps in ((4.0, (True, False), 6), (0.0, (False, True), 10), (1.4, (True, True), 10)):
        env.reset()
        for _ in range(steps - 1):
            assert env.step([force])[2:4] == (False, False)
        assert env.step([force])[2:4] == end, force
        assert env.moment.time == pytest.approx([steps / 10])
    env.close()


def test_pictures_from_a_camera_of_the_world_and_from_a_place_of_its_own(avoider):
    env = gymnasium.make("pongsim/WallAvoid-v0", render_mode="rgb_array")
    env.reset(seed=1)
    first = env.render()
    assert first.shape == (240, 320, 3) and first.dtype == np.uint8 and first.std() > 5
    for _ in range(10):
        env.step(np.float32([1, 0]))
    assert not np.array_equal(env.render(), first)
    hash_before = env.unwrapped.simulation.state_hash()
    env.render()
    assert env.unwrapped.simulation.state_hash() == hash_before
    env.close()

    world = COURT.with_name("pong_lidar.sdf")
    task = gym.Task(world=world, action=[gym.Command("/cmd_vel", {"linear.x": (0, 1)}, "Twist")], camera="camera",
                    observation={"pose": gym.Pose("pong_bot")}, reward=lambda now: 0.0)
    env = gym.Env(task, render_mode="rgb_array")
    env.reset()
    seen = env.render()
    sensor = env.simulation.sensor("camera")
    env.simulation.step(200)
    # what the camera itself sees then; the robot is at rest
    assert np.abs(seen.astype(int) - sensor.image).mean() < 1
    env.close()


def test_a_task_without_a_place_for_the_eye_is_seen_from_above():
    task = gym.Task(world=COURT, action=[gym.Command("/cmd_vel", {"linear.x": (0, 1)})],
                    observation={"pose": gym.Pose("pong_bot")}, reward=lambda now: 0.0,
                    camera=gym.Camera(width=64, height=48))
    env = gym.Env(task, render_mode="rgb_array")
    env.reset()
    picture = env.render()
    assert picture.shape == (48, 64, 3)
    # the red wheels and the blue chassis are in it
    red, green, blue = (picture[..., i].astype(int) for i in range(3))
    assert (red > green + 60).any() and (blue > green + 60).any()
    env.close()


def test_without_a_render_mode_there_is_no_picture():
    env = gym.Env(rail())
    env.reset()
    with pytest.warns(UserWarning, match="rgb_array"):
        assert env.render() is None
    env.close()
    with pytest.raises(ValueError, match="there is no render_mode 'human'"):
        gym.Env(rail(), render_mode="human")


def test_functions_that_fail_are_named_and_the_environment_goes_on():
    def hopeless(now):
        raise ZeroDivisionError("by nothing")

    for what, named in (("reward", "the reward"), ("terminated", "terminated"), ("truncated", "truncated")):
        env = gym.Env(rail(**{what: hopeless}))
        env.reset()
        with pytest.raises(gym.TaskError, match=rf"{named} '.*hopeless' raised ZeroDivisionError: by nothing") as caught:
            env.step([0.0])
        assert isinstance(caught.value.__cause__, ZeroDivisionError)
        with pytest.raises(ResetNeeded):
            env.step([0.0])
        env.reset()
        env.close()
        assert env.simulation.is_closed


@pytest.mark.parametrize(
    "changes, text",
    [
        ({"reward": lambda now: np.zeros(3)}, r"returned an array of shape \(3,\); it must be \(1,\)"),
        ({"reward": lambda now: np.nan}, "all must be finite"),
        ({"reward": lambda now: "much"}, "which are not numbers"),
        ({"reward": lambda now: now["speed"]}, "the task has no reading 'speed'; it has rail, felt"),
        ({"start": lambda sim, random: sim.model("kart")}, "the start '.*' raised KeyError.*cart"),
        ({"action": lambda sim, action: 1 / 0, "action_space": spaces.Discrete(2)}, "the action '.*' raised ZeroDivision"),
        (
            {"observation": lambda sim: np.zeros(3), "observation_space": spaces.Box(-1, 1, (2,)), "reward": lambda now: 0},
            "outside its space",
        ),
        (
            {"observation": lambda sim: [0, 1.5], "observation_space": spaces.Box(-1, 1, (2,)), "reward": lambda now: 0},
            r"outside its space, .*: number \[1\] is 1.5",
        ),
        (
            {"observation": lambda sim: [np.nan, 0], "observation_space": spaces.Box(-1, 1, (2,)), "reward": lambda now: 0},
            r"outside its space, .*: number \[0\] is nan",
        ),
    ],
)
def test_what_functions_give_is_checked(changes, text):
    env = gym.Env(rail(**changes))
    with pytest.raises(gym.TaskError, match=text):
        env.reset()
        env.step(0 if "action" in changes else [0.0])
    env.close()


@pytest.mark.parametrize(
    "changes, kind, text",
    [
        ({"world": COURT.with_name("nowhere.sdf")}, pongsim.LoadError, "nowhere.sdf"),
        ({"world": "<sdf version='1.9'><world name='w'><model/></world></sdf>"}, pongsim.LoadError, "name"),
        ({"action": [gym.JointForce("cart::rial", -1, 1)]}, KeyError, "rail"),
        ({"action": [gym.JointForce("rail", -1, 1)]}, ValueError, "name a joint with its model"),
        ({"action": [gym.JointForce("cart::rail", 1, -1)]}, ValueError, "lesser first"),
        ({"action": [gym.JointForce("cart::fix", -1, 1)]}, ValueError, "no axis that can be driven"),
        ({"action": [gym.Command("/x", {"linear.w": (0, 1)}, "Twist")]}, ValueError, "field 'linear.w'"),
        ({"action": [gym.Command("/x", {"linear": (0, 1)}, "Twist")]}, ValueError, "not a single number"),
        ({"action": [gym.Command("/x", {"linear.x": (0, np.inf)}, "Twist")]}, ValueError, "two finite numbers"),
        ({"action": [gym.Command("/x", {"linear.x": (0, 1)})]}, ValueError, "give it as type"),
        ({"action": ["forward"]}, TypeError, "be a list of actuators"),
        ({"observation": {"r": gym.Ranges("imu")}}, ValueError, "is not a lidar"),
        ({"observation": {"r": gym.Ranges("eye")}}, KeyError, "no sensor 'eye'"),
        ({"observation": {"r": 7}}, TypeError, "must be a Reading"),
        ({"observation": {"r": gym.Fields("/imu", "frame_id")}}, ValueError, "frame_id"),
        ({"extra": {"rail": gym.Pose("cart")}}, ValueError, "both observed and extra"),
        ({"step_time": 0.0015}, ValueError, "not a multiple of the world's step of 0.001 s"),
        ({"step_time": -1.0}, ValueError, "step_time must be above 0"),
        ({"time_limit": np.nan}, ValueError, "time_limit must be above 0"),
        ({"reward": 3}, TypeError, "reward must be a function"),
        ({"action": lambda sim, action: None}, ValueError, "if, and only if, action is a function"),
    ],
)
def test_what_is_wrong_with_a_task_is_said(changes, kind, text):
    with pytest.raises(kind, match=text):
        gym.Env(rail(**changes))


def test_a_sensor_that_is_never_heard_is_told_of():
    env = gym.Env(rail(extra={"silence": gym.Fields("/silence", "data", "Double")}))
    with pytest.raises(pongsim.NoReading, match="no reading of topic /silence"):
        env.reset()
    env.close()


def test_wrong_actions_are_refused_and_change_nothing():
    env = gym.Env(rail())
    env.reset()
    before = env.simulation.state_hash()
    for action, text in (([0.0, 1.0], r"shape \(1,\), not \(2,\)"), (3.0, r"not \(\)"), ([np.nan], "number 0 .* is -?nan"),
                         ([np.inf], "must be finite"), (["a"], "could not convert")):
        with pytest.raises(ValueError, match=text):
            env.step(action)
        assert env.simulation.state_hash() == before
        env.reset()
    env.close()


def test_steps_come_after_a_reset_and_before_the_close():
    env = gym.Env(rail())
    with pytest.raises(ResetNeeded):
        env.step([0.0])
    with pytest.raises(ValueError, match="no option 'where'"):
        env.reset(options={"where": 1})
    env.close()
    env.close()
    for call in (lambda: env.step([0.0]), env.reset, lambda: env.simulation.time):
        with pytest.raises(pongsim.Gone):
            call()


def test_no_step_follows_the_end_of_an_episode():
    for changes in ({"terminated": lambda now: True}, {"truncated": lambda now: True}, {"time_limit": 0.1}):
        env = gym.Env(rail(**changes))
        env.reset()
        assert True in env.step([0.0])[2:4]
        with pytest.raises(ResetNeeded, match="end of an episode"):
            env.step([0.0])
        env.reset()
        env.step([0.0])
        env.close()


def test_a_world_that_somebody_else_resets_has_no_reading():
    env = gym.Env(rail())
    env.reset()
    env.step([4.0])
    # of the environment's own resets, the readings are those of the new episode
    observation, _ = env.reset()
    assert observation[2] == 0
    env.simulation.reset()
    # a reading comes with the next step, because the sensor is faster
    env.step([0.0])
    told = gym.Env(rail(extra={"told": gym.Fields("/told", "data", type="Double")},
                        start=lambda sim, random: sim.publish("/told", {"data": 1.0}, type="Double")))
    for end in (told.simulation.reset, lambda: told.simulation.restore(told.simulation.save())):
        told.reset()
        told.step([0.0])
        end()
        with pytest.raises(pongsim.NoReading, match="/told.*call reset"):
            told.step([0.0])
    told.reset()
    told.step([0.0])


def test_a_model_that_is_removed_is_told_of():
    env = gym.Env(rail())
    env.reset()
    env.simulation.remove(env.simulation.model("cart"))
    with pytest.raises(pongsim.Gone, match="environment 0"):
        env.step([0.0])
    env.close()


def test_a_system_in_python_that_fails_does_not_end_the_episode():
    class Judge(pongsim.System):
        def post_update(self, info):
            raise ValueError("no")

    env = gym.Env(rail())
    judge = Judge()
    env.simulation.add(judge)
    env.reset()
    env.step([0.0])
    assert isinstance(judge.error, ValueError)
    env.close()


def test_what_a_callback_raises_comes_out_of_the_step():
    env = gym.Env(rail())
    env.reset()

    def hear(message):
        raise LookupError("not this")

    env.simulation.subscribe("/imu", hear)
    with pytest.raises(LookupError, match="not this"):
        env.step([0.0])
    env.close()


def test_without_gymnasium_it_says_what_to_install():
    code = "import sys; sys.modules['gymnasium'] = None; import pongsim; import pongsim.gym"
    result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert re.search(r"ImportError: pongsim.gym needs Gymnasium .*pip install", result.stderr)


def test_everything_has_a_docstring():
    missing = []
    for name in gym.__all__:
        thing = getattr(gym, name)
        if not (thing.__doc__ or "").strip():
            missing.append(name)
        if isinstance(thing, type) and thing.__module__.startswith("pongsim"):
            for part, value in vars(thing).items():
                if not part.startswith("_") and (callable(value) or isinstance(value, property)):
                    if not (value.__doc__ or "").strip():
                        missing.append(f"{name}.{part}")
    assert [each for each in missing if not each.startswith("Task.")] == []
