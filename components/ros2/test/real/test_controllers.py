"""Controllers inside the simulation, as spawners, `ros2 control` and their users' nodes see them."""

import contextlib
import math
import pathlib

import ros
import simulation
from builtin_interfaces.msg import Duration
from control_msgs.action import FollowJointTrajectory, GripperCommand
from controller_manager_msgs.srv import (ConfigureController, ListControllers, ListControllerTypes,
                                         ListHardwareComponents, ListHardwareInterfaces, LoadController,
                                         SetHardwareComponentState, SwitchController, UnloadController)
from geometry_msgs.msg import TwistStamped
from lifecycle_msgs.msg import State
from nav_msgs.msg import Odometry
from rcl_interfaces.msg import Parameter, ParameterType, ParameterValue
from rcl_interfaces.srv import GetParameters, SetParameters
from rclpy.action import ActionClient
from rclpy.qos import QoSProfile, DurabilityPolicy
from sensor_msgs.msg import Imu, JointState
from tf2_msgs.msg import TFMessage
from trajectory_msgs.msg import JointTrajectoryPoint

WORLD = pathlib.Path(__file__).with_name("controllers.sdf")
MANAGER = "/controller_manager"


def ask(tester, kind, service, **request):
    return ros.call(tester, kind, f"{MANAGER}/{service}", kind.Request(**request))


def spawn(tester, name):
    """What the spawner of Jazzy's controller_manager does."""
    assert name not in [each.name for each in ask(tester, ListControllers, "list_controllers").controller]
    assert ask(tester, LoadController, "load_controller", name=name).ok
    assert ask(tester, ConfigureController, "configure_controller", name=name).ok
    answer = ask(tester, SwitchController, "switch_controller", activate_controllers=[name],
                 strictness=SwitchController.Request.STRICT, activate_asap=True, timeout=Duration(sec=5))
    assert answer.ok, answer.message


@contextlib.contextmanager
def rover():
    with simulation.running(WORLD, "--ros2") as process, ros.node() as tester:
        yield tester, process


def hear(tester, kind, topic, qos=10):
    heard = []
    tester.create_subscription(kind, topic, heard.append, qos)
    return heard


def test_the_manager_lists_what_there_is():
    with rover() as (tester, _):
        spawn(tester, "drive")
        [state] = ask(tester, ListControllers, "list_controllers").controller
        assert (state.name, state.state, state.type) == ("drive", "active", "diff_drive_controller/DiffDriveController")
        assert state.claimed_interfaces == ["left_wheel_joint/velocity", "right_wheel_joint/velocity"]
        types = ask(tester, ListControllerTypes, "list_controller_types").types
        assert "joint_trajectory_controller/JointTrajectoryController" in types
        interfaces = ask(tester, ListHardwareInterfaces, "list_hardware_interfaces")
        claimed = {each.name: each.is_claimed for each in interfaces.command_interfaces}
        assert claimed == {"left_wheel_joint/velocity": True, "right_wheel_joint/velocity": True,
                           "finger_joint/position": False}
        assert "rover_imu/orientation.w" in [each.name for each in interfaces.state_interfaces]
        [component] = ask(tester, ListHardwareComponents, "list_hardware_components").component
        assert (component.name, component.type) == ("rover_hardware", "system")
        assert component.plugin_name == "gz_ros2_control/GazeboSimSystem" and component.state.label == "active"
        assert "finger_joint/position" in [each.name for each in component.command_interfaces]
        answer = ask(tester, SetHardwareComponentState, "set_hardware_component_state", name="rover_hardware",
                     target_state=State(label="active"))
        assert answer.ok and answer.state.id == State.PRIMARY_STATE_ACTIVE
        # its own nodes, with their parameters
        simulation.until(lambda: {("controller_manager", "/"), ("drive", "/")}
                         <= set(tester.get_node_names_and_namespaces()), "the nodes")
        answer = ros.call(tester, GetParameters, "/drive/get_parameters", GetParameters.Request(names=["wheel_radius"]))
        assert answer.values[0].double_value == 0.1
        # and what can't be done
        assert not ask(tester, LoadController, "load_controller", name="nobody").ok
        assert not ask(tester, UnloadController, "unload_controller", name="drive").ok
        answer = ask(tester, SwitchController, "switch_controller", deactivate_controllers=["drive"],
                     strictness=SwitchController.Request.STRICT)
        assert answer.ok and ask(tester, UnloadController, "unload_controller", name="drive").ok


def test_driving_by_a_controller():
    with rover() as (tester, _):
        states, frames = hear(tester, JointState, "/joint_states"), hear(tester, TFMessage, "/tf", 100)
        static = hear(tester, TFMessage, "/tf_static", QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL))
        odometry = hear(tester, Odometry, "/drive/odom")
        spawn(tester, "joint_state_broadcaster")
        spawn(tester, "drive")
        # one publisher: the broadcaster
        simulation.until(lambda: [each.node_name for each in tester.get_publishers_info_by_topic("/joint_states")]
                         == ["joint_state_broadcaster"], "the broadcaster's topic")
        states.clear()
        simulation.until(lambda: len(states) > 5, "joint states")
        assert states[-1].name == ["finger_joint", "left_wheel_joint", "right_wheel_joint"]
        assert all(math.isnan(each) for each in states[-1].effort)
        publisher = tester.create_publisher(TwistStamped, "/drive/cmd_vel", 10)
        simulation.until(lambda: publisher.get_subscription_count() > 0, "the controller's subscription")
        command = TwistStamped()
        command.twist.linear.x, command.twist.angular.z = 0.5, 0.2

        def has_moved():
            # the controller may find the publisher later than the publisher it
            publisher.publish(command)
            return odometry and odometry[-1].pose.pose.position.x > 0.5

        simulation.until(has_moved, "motion")
        assert abs(odometry[-1].twist.twist.linear.x - 0.5) < 0.02 and abs(odometry[-1].twist.twist.angular.z - 0.2) < 0.02
        # one parent each: odom, and below it the links
        frames.clear()
        simulation.until(lambda: len(frames) > 20, "frames")
        parents = {each.child_frame_id: each.header.frame_id for message in frames for each in message.transforms}
        assert parents == {"base_link": "odom", "left_wheel": "base_link", "right_wheel": "base_link",
                           "finger": "base_link"}
        simulation.until(lambda: static, "static frames")
        assert {each.child_frame_id for message in static for each in message.transforms} >= {"caster"}


def test_the_odometrys_frame_alone():
    """Where the other frames are left to robot_state_publisher."""
    with simulation.running(WORLD, "--ros2", "--ros2-no-tf"), ros.node() as tester:
        frames = hear(tester, TFMessage, "/tf", 100)
        spawn(tester, "drive")
        simulation.until(lambda: len(frames) > 5, "frames")
        parents = {each.child_frame_id: each.header.frame_id for message in frames for each in message.transforms}
        assert parents == {"base_link": "odom"}
        assert [each.node_name for each in tester.get_publishers_info_by_topic("/tf")] == ["drive"]


def send(tester, kind, name, goal):
    client = ActionClient(tester, kind, name)
    assert client.wait_for_server(simulation.PATIENCE)
    feedback = []
    sent = ros.on_its_thread(tester, client.send_goal_async, goal, feedback.append)
    simulation.until(sent.done, "an answer to the goal")
    assert sent.result().accepted
    result = ros.on_its_thread(tester, sent.result().get_result_async)
    simulation.until(result.done, "the result")
    return result.result(), feedback


def test_a_trajectory_and_a_gripper():
    with rover() as (tester, _):
        spawn(tester, "finger")
        goal = FollowJointTrajectory.Goal()
        goal.trajectory.joint_names = ["finger_joint"]
        goal.trajectory.points = [JointTrajectoryPoint(positions=[0.1], velocities=[0.0], time_from_start=Duration(sec=1)),
                                  JointTrajectoryPoint(positions=[-0.1], velocities=[0.0],
                                                       time_from_start=Duration(sec=2))]
        result, feedback = send(tester, FollowJointTrajectory, "/finger/follow_joint_trajectory", goal)
        assert result.result.error_code == FollowJointTrajectory.Result.SUCCESSFUL, result
        assert feedback and feedback[-1].feedback.joint_names == ["finger_joint"]
        if ros.DISTRO == "kilted":
            # the next point
            assert {each.feedback.index for each in feedback} == {0, 1}
        # another controller of the joint
        assert ask(tester, LoadController, "load_controller", name="gripper").ok
        assert ask(tester, ConfigureController, "configure_controller", name="gripper").ok
        switch = {"activate_controllers": ["gripper"], "strictness": SwitchController.Request.STRICT}
        answer = ask(tester, SwitchController, "switch_controller", **switch)
        assert not answer.ok and "which controller 'finger' holds" in answer.message
        assert ask(tester, SwitchController, "switch_controller", deactivate_controllers=["finger"], **switch).ok
        goal = GripperCommand.Goal()
        goal.command.position = 0.15
        result, _ = send(tester, GripperCommand, "/gripper/gripper_cmd", goal)
        assert result.result.reached_goal and abs(result.result.position - 0.15) < 0.01


def test_an_imu():
    with rover() as (tester, _):
        spawn(tester, "imu_broadcaster")
        heard = hear(tester, Imu, "/imu_broadcaster/imu")
        # at rest, after it has settled
        simulation.until(lambda: heard and abs(heard[-1].linear_acceleration.z - 9.8) < 0.05, "gravity")
        assert heard[-1].header.frame_id == "base_link" and abs(heard[-1].orientation.w) > 0.99


def test_parameters_that_a_spawner_gives(tmp_path):
    (tmp_path / "late.yaml").write_text("late:\n  ros__parameters:\n    joints: [finger_joint]\n"
                                        "    type: position_controllers/JointGroupPositionController\n")
    with rover() as (tester, _):
        files = ParameterValue(type=ParameterType.PARAMETER_STRING_ARRAY, string_array_value=[str(tmp_path / "late.yaml")])
        kind = ParameterValue(type=ParameterType.PARAMETER_STRING,
                              string_value="position_controllers/JointGroupPositionController")
        remap = ParameterValue(type=ParameterType.PARAMETER_STRING_ARRAY,
                               string_array_value=["-r", "~/commands:=/finger_position"])
        parameters = [Parameter(name="late.params_file", value=files), Parameter(name="late.type", value=kind),
                      Parameter(name="late.node_options_args", value=remap)]
        answer = ask(tester, SetParameters, "set_parameters", parameters=parameters)
        assert all(each.successful for each in answer.results)
        spawn(tester, "late")
        simulation.until(lambda: tester.get_subscriptions_info_by_topic("/finger_position"), "the remapped topic")
