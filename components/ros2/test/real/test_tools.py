"""ROS's own command line, `ros2`, and the spawner of ros2_control."""

import os
import pathlib
import re
import signal
import subprocess
import sys
import threading

import pytest
import ros
import simulation

HERE = pathlib.Path(__file__).parent
BIN = pathlib.Path(sys.executable).parent
pytestmark = ros.needs_tools

# asks the network itself
DIRECT = ("--no-daemon", "--spin-time", "1")
CONTROL_WORLD = HERE / "controllers.sdf"
GOAL = """{trajectory: {joint_names: [finger_joint], points: [
  {positions: [0.05], time_from_start: {sec: 1}}, {positions: [0.1], time_from_start: {sec: 2}}]}}"""


def run(*command, environment=None):
    """What a command says."""
    done = subprocess.run([str(each) for each in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          timeout=simulation.PATIENCE, env={**os.environ, **(environment or {})})
    return done.returncode, done.stdout


def ros2(*words):
    return run(BIN / "ros2", *words)


def says(expected, *words):
    """Asks again until the answer has all that is expected: a command waits for nodes for a second only."""
    answers = []

    def has_all():
        code, text = ros2(*words)
        answers[:] = [text]
        return code == 0 and all(each in text for each in expected) and text

    try:
        return simulation.until(has_all, f"{expected} of ros2 {' '.join(words)}")
    except AssertionError as error:
        raise AssertionError(f"{error}: {answers}") from None


def first_line(pattern, *words):
    """The first line with that pattern of a command that goes on until it is interrupted."""
    process = subprocess.Popen([BIN / "ros2", *words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                               env={**os.environ, "PYTHONUNBUFFERED": "1"})
    limit = threading.Timer(simulation.PATIENCE, process.kill)
    limit.start()
    said = []
    try:
        for line in process.stdout:
            said.append(line)
            if re.search(pattern, line):
                return line
    finally:
        limit.cancel()
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=simulation.PATIENCE)
    raise AssertionError(f"ros2 {' '.join(words)}: {said}")


@pytest.fixture(autouse=True, scope="module")
def daemon():
    """Some commands start ROS's daemon of this domain, which would stay."""
    yield
    ros2("daemon", "stop")


def test_nodes_and_topics():
    with simulation.running(ros.WORLD):
        says(["/pongsim\n"], "node", "list", *DIRECT)
        says(["/lidar: sensor_msgs/msg/LaserScan", "/cmd_vel: geometry_msgs/msg/Twist",
              "/pongsim/spawn_entity: simulation_interfaces/srv/SpawnEntity",
              "/pongsim/simulate_steps: simulation_interfaces/action/SimulateSteps"],
             "node", "info", "/pongsim", *DIRECT)
        says(["/clock [rosgraph_msgs/msg/Clock]", "/lidar [sensor_msgs/msg/LaserScan]"], "topic", "list", "-t", *DIRECT)
        says(["Node name: pongsim", "Publisher count: 1", "Topic type hash: RIHS01_"],
             "topic", "info", "-v", "/lidar", *DIRECT)
        says(["/lidar\n"], "topic", "find", "sensor_msgs/msg/LaserScan", *DIRECT)
        says(["frame_id: rover/chassis/lidar", "range_max: 20.0"], "topic", "echo", "--once", *DIRECT, "/lidar")
        # the rate of the file, by the time of the simulation
        rate = first_line("average rate", "topic", "hz", "--use-sim-time", "/lidar")
        assert 15 < float(rate.split(":")[1]) < 25, rate
        code, text = ros2("topic", "pub", "--times", "3", "--rate", "10", "-w", "1", "/cmd_vel",
                          "geometry_msgs/msg/Twist", "{linear: {x: 1.0}}")
        assert code == 0, text
        # and the robot has moved
        answer = says(["result=1"], "service", "call", "/pongsim/get_entity_state",
                      "simulation_interfaces/srv/GetEntityState", "{entity: rover}")
        assert float(re.search(r"position=\S*Point\(x=([-.\de]+)", answer)[1]) > 0.05, answer


def test_services_and_parameters():
    with simulation.running(ros.WORLD):
        says(["/pongsim/get_entity_state [simulation_interfaces/srv/GetEntityState]"], "service", "list", "-t", *DIRECT)
        answer = says(["result=1"], "service", "call", "/pongsim/get_entity_state",
                      "simulation_interfaces/srv/GetEntityState", "{entity: rover}")
        assert "frame_id='world'" in answer, answer
        says(["  bridge_all\n", "  real_time_factor\n"], "param", "list", "/pongsim", *DIRECT)
        says(["Double value is: 1.0"], "param", "get", "/pongsim", "real_time_factor", *DIRECT)
        says(["Set parameter successful"], "param", "set", "/pongsim", "real_time_factor", "0.5", *DIRECT)
        says(["Double value is: 0.5"], "param", "get", "/pongsim", "real_time_factor", *DIRECT)
        code, text = ros2("param", "set", "/pongsim", "use_sim_time", "false", *DIRECT)
        assert "Setting parameter failed" in text, (code, text)
        says(["real_time_factor: 0.5", "use_sim_time: true"], "param", "dump", "/pongsim", *DIRECT)


def spawner(name, *arguments, program="spawner", home):
    return run(sys.executable, "-m", f"controller_manager.{program}", name, *arguments, environment={"ROS_HOME": str(home)})


def test_spawners_and_actions(tmp_path):
    with simulation.running(CONTROL_WORLD, "--ros2"):
        code, text = spawner("finger", home=tmp_path)
        assert code == 0 and "Configured and activated finger" in text, text
        (tmp_path / "late.yaml").write_text("late:\n  ros__parameters:\n    joints: [left_wheel_joint]\n"
                                            "    interface_name: velocity\n"
                                            "    type: forward_command_controller/ForwardCommandController\n")
        code, text = spawner("late", "--inactive", "--param-file", tmp_path / "late.yaml", home=tmp_path)
        assert code == 0 and "Loaded late" in text, text
        code, text = spawner("nobody", home=tmp_path)
        assert code == 1, text
        listed = says(["finger", "late"], "control", "list_controllers")
        assert re.search(r"finger\s+joint_trajectory_controller/JointTrajectoryController\s+active", listed), listed
        assert re.search(r"late\s+forward_command_controller/ForwardCommandController\s+inactive", listed), listed
        says(["name: rover_hardware", "plugin name: gz_ros2_control/GazeboSimSystem", "state: id=3 label=active",
              "finger_joint/position"], "control", "list_hardware_components")
        says(["finger_joint/position [available] [claimed]", "left_wheel_joint/velocity [available] [unclaimed]"],
             "control", "list_hardware_interfaces")

        says(["/finger/follow_joint_trajectory [control_msgs/action/FollowJointTrajectory]"], "action", "list", "-t")
        says(["Action servers: 1\n"], "action", "info", "/finger/follow_joint_trajectory")
        code, text = ros2("action", "send_goal", "--feedback", "/finger/follow_joint_trajectory",
                          "control_msgs/action/FollowJointTrajectory", GOAL)
        assert code == 0 and "Goal finished with status: SUCCEEDED" in text, text
        assert "Feedback:" in text and "- finger_joint" in text, text

        code, text = spawner("finger", program="unspawner", home=tmp_path)
        assert code == 0 and "Unloaded controller" in text, text
        listed = says(["late"], "control", "list_controllers")
        assert "finger" not in listed
