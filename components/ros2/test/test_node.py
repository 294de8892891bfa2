"""The node as its tools see it: /rosout, parameters and their events, the action, and models that `pongsim ros2 create`
inserts."""

import subprocess
import time
from dataclasses import dataclass, field

import peers
from client import Client, Result
from cyclonedds.core import Policy, Qos
from cyclonedds.idl import IdlStruct
from cyclonedds.idl.types import array, float64, int8, int64, sequence, uint8, uint32, uint64
from cyclonedds.util import duration

RCL = "rcl_interfaces::msg::dds_::"
SRV = "rcl_interfaces::srv::dds_::"
STEPS = "simulation_interfaces::action::dds_::SimulateSteps_"
WORLD = peers.ROOT / "components/ros2/test/drive.sdf"
ROSOUT = Qos(Policy.Reliability.Reliable(duration(seconds=1)), Policy.Durability.TransientLocal,
             Policy.History.KeepLast(1000))
EVENTS = Qos(Policy.Reliability.Reliable(duration(seconds=1)), Policy.History.KeepLast(1000))
BOOL, INTEGER, DOUBLE = 1, 2, 3
EXECUTING, SUCCEEDED, CANCELED, ABORTED = 2, 4, 5, 6


@dataclass
class Log(IdlStruct, typename=RCL + "Log_"):
    stamp: peers.Time = field(default_factory=peers.Time)
    level: uint8 = 0
    name: str = ""
    msg: str = ""
    file: str = ""
    function: str = ""
    line: uint32 = 0


@dataclass
class Value(IdlStruct, typename=RCL + "ParameterValue_"):
    type: uint8 = 0
    bool_value: bool = False
    integer_value: int64 = 0
    double_value: float64 = 0.0
    string_value: str = ""
    byte_array_value: sequence[uint8] = field(default_factory=list)
    bool_array_value: sequence[bool] = field(default_factory=list)
    integer_array_value: sequence[int64] = field(default_factory=list)
    double_array_value: sequence[float64] = field(default_factory=list)
    string_array_value: sequence[str] = field(default_factory=list)


@dataclass
class Parameter(IdlStruct, typename=RCL + "Parameter_"):
    name: str = ""
    value: Value = field(default_factory=Value)


@dataclass
class ParameterEvent(IdlStruct, typename=RCL + "ParameterEvent_"):
    stamp: peers.Time = field(default_factory=peers.Time)
    node: str = ""
    new_parameters: sequence[Parameter] = field(default_factory=list)
    changed_parameters: sequence[Parameter] = field(default_factory=list)
    deleted_parameters: sequence[Parameter] = field(default_factory=list)


@dataclass
class GetParametersRequest(IdlStruct, typename=SRV + "GetParameters_Request_"):
    names: sequence[str] = field(default_factory=list)


@dataclass
class GetParametersResponse(IdlStruct, typename=SRV + "GetParameters_Response_"):
    values: sequence[Value] = field(default_factory=list)


@dataclass
class SetParametersRequest(IdlStruct, typename=SRV + "SetParameters_Request_"):
    parameters: sequence[Parameter] = field(default_factory=list)


@dataclass
class SetParametersResult(IdlStruct, typename=RCL + "SetParametersResult_"):
    successful: bool = False
    reason: str = ""


@dataclass
class SetParametersResponse(IdlStruct, typename=SRV + "SetParameters_Response_"):
    results: sequence[SetParametersResult] = field(default_factory=list)


@dataclass
class UUID(IdlStruct, typename="unique_identifier_msgs::msg::dds_::UUID_"):
    uuid: array[uint8, 16] = field(default_factory=lambda: [0] * 16)


@dataclass
class StepsGoal(IdlStruct, typename=STEPS + "Goal_"):
    steps: uint64 = 0


@dataclass
class SendGoalRequest(IdlStruct, typename=STEPS + "SendGoal_Request_"):
    goal_id: UUID = field(default_factory=UUID)
    goal: StepsGoal = field(default_factory=StepsGoal)


@dataclass
class SendGoalResponse(IdlStruct, typename=STEPS + "SendGoal_Response_"):
    accepted: bool = False
    stamp: peers.Time = field(default_factory=peers.Time)


@dataclass
class StepsResult(IdlStruct, typename=STEPS + "Result_"):
    result: Result = field(default_factory=Result)


@dataclass
class GetResultRequest(IdlStruct, typename=STEPS + "GetResult_Request_"):
    goal_id: UUID = field(default_factory=UUID)


@dataclass
class GetResultResponse(IdlStruct, typename=STEPS + "GetResult_Response_"):
    status: int8 = 0
    result: StepsResult = field(default_factory=StepsResult)


@dataclass
class StepsFeedback(IdlStruct, typename=STEPS + "Feedback_"):
    completed_steps: uint64 = 0
    remaining_steps: uint64 = 0


@dataclass
class FeedbackMessage(IdlStruct, typename=STEPS + "FeedbackMessage_"):
    goal_id: UUID = field(default_factory=UUID)
    feedback: StepsFeedback = field(default_factory=StepsFeedback)


@dataclass
class GoalInfo(IdlStruct, typename="action_msgs::msg::dds_::GoalInfo_"):
    goal_id: UUID = field(default_factory=UUID)
    stamp: peers.Time = field(default_factory=peers.Time)


@dataclass
class GoalStatus(IdlStruct, typename="action_msgs::msg::dds_::GoalStatus_"):
    goal_info: GoalInfo = field(default_factory=GoalInfo)
    status: int8 = 0


@dataclass
class GoalStatusArray(IdlStruct, typename="action_msgs::msg::dds_::GoalStatusArray_"):
    status_list: sequence[GoalStatus] = field(default_factory=list)


@dataclass
class CancelGoalRequest(IdlStruct, typename="action_msgs::srv::dds_::CancelGoal_Request_"):
    goal_info: GoalInfo = field(default_factory=GoalInfo)


@dataclass
class CancelGoalResponse(IdlStruct, typename="action_msgs::srv::dds_::CancelGoal_Response_"):
    return_code: int8 = 0
    goals_canceling: sequence[GoalInfo] = field(default_factory=list)


def value(kind, **values):
    return Value(type=kind, **values)


def test_a_late_reader_of_rosout_gets_what_was_warned_of():
    with peers.running(WORLD):
        peer = peers.Peer()
        # a value that is not a number causes a warning, once per second at most
        command = peer.writer("/cmd_vel", peers.Twist)
        bad = peers.Twist(linear=peers.Vector3(x=float("nan")))
        first = peer.reader("/rosout", Log, ROSOUT)

        def complained():
            command.write(bad)
            return peers.take(first)

        def heard_late():
            peers.until(complained, "a complaint")
            came = time.time()
            # messages older than ten seconds are not resent, and this machine may be slow
            log = peers.take_one(peers.Peer().reader("/rosout", Log, ROSOUT))
            return [log] if log.stamp.sec + log.stamp.nanosec / 1e9 < came else None

        log = peers.until(heard_late, "a complaint from before")[0]
        assert log.level == 30 and log.name.startswith("pongsim.") and log.msg


def test_rosout_tells_what_is_wrong_with_the_world(tmp_path):
    world = tmp_path / "world.sdf"
    world.write_text(WORLD.read_text().replace('<world name="drive">', '<world name="drive"><nonsense/>'))
    logs = peers.Peer().reader("/rosout", Log, ROSOUT)
    with peers.running(world):
        log = peers.take_one(logs, where=lambda each: "nonsense" in each.msg)
        assert log.level == 30 and "world.sdf:" in log.msg


def test_parameters_are_read_and_set_and_events_tell_of_it():
    with peers.running(WORLD):
        peer = peers.Peer()
        events = peer.reader("/parameter_events", ParameterEvent, EVENTS)
        get = Client(peer, "/pongsim/get_parameters", GetParametersRequest, GetParametersResponse)
        put = Client(peer, "/pongsim/set_parameters", SetParametersRequest, SetParametersResponse)
        peers.until(events.get_matched_publications, "the events")

        values = get(GetParametersRequest(["use_sim_time", "real_time_factor", "bridge_all"])).values
        assert [each.type for each in values] == [BOOL, DOUBLE, BOOL]
        assert values[0].bool_value and values[1].double_value == 1
        assert get(GetParametersRequest(["nobody"])).values == []

        results = put(SetParametersRequest([
            Parameter("real_time_factor", value(DOUBLE, double_value=0.25)),
            Parameter("real_time_factor", value(INTEGER, integer_value=1)),
            Parameter("real_time_factor", value(DOUBLE, double_value=-1.0)),
            Parameter("use_sim_time", value(BOOL)),
            Parameter("nobody", value(BOOL))])).results
        assert [(each.successful, each.reason) for each in results] == [
            (True, ""),
            (False, "Wrong parameter type, parameter {real_time_factor} is of type {double}, setting it to {integer} "
                    "is not allowed."),
            (False, "Parameter {real_time_factor} doesn't comply with floating point range."),
            (False, "parameter 'use_sim_time' cannot be set because it is read-only"),
            (False, "parameter 'nobody' cannot be set because it was not declared")]
        event = peers.take_one(events)
        assert event.node == "/pongsim"
        assert [(each.name, each.value.double_value) for each in event.changed_parameters] == [
            ("real_time_factor", 0.25)]

        # the simulation's own service changes it, too
        subprocess.run([peers.PONGSIM, "service", "-s", "/world/drive/set_physics", "--reqtype", "ignition.msgs.Physics",
                        "--reptype", "ignition.msgs.Boolean", "--timeout", "60000", "--req", "real_time_factor: 0.5"],
                       check=True, capture_output=True, timeout=90)
        event = peers.take_one(events)
        assert event.changed_parameters[0].value.double_value == 0.5


def test_topics_go_and_come_back_with_bridge_all():
    with peers.running(WORLD):
        peer = peers.Peer()
        scans = peer.reader("/lidar", peers.LaserScan)
        put = Client(peer, "/pongsim/set_parameters", SetParametersRequest, SetParametersResponse)
        peers.until(scans.get_matched_publications, "the lidar")
        for wanted in (False, True):
            assert put(SetParametersRequest([Parameter("bridge_all", value(BOOL, bool_value=wanted))])).results[0].successful
            peers.until(lambda: bool(scans.get_matched_publications()) == wanted, "that the lidar is there or not")


class Steps:
    """A client of the action."""

    def __init__(self, peer):
        action = "/pongsim/simulate_steps/_action/"
        self.feedback = peer.reader(action + "feedback", FeedbackMessage,
                                    Qos(Policy.Reliability.Reliable(duration(seconds=1)), Policy.History.KeepAll))
        self.status = peer.reader(action + "status", GoalStatusArray, peers.LATCHED)
        self.send = Client(peer, action + "send_goal", SendGoalRequest, SendGoalResponse)
        self.cancel = Client(peer, action + "cancel_goal", CancelGoalRequest, CancelGoalResponse)
        self.result = Client(peer, action + "get_result", GetResultRequest, GetResultResponse)
        peers.until(self.feedback.get_matched_publications, "the feedback")

    def start(self, number, steps):
        goal = UUID([number] * 16)
        assert self.send(SendGoalRequest(goal, StepsGoal(steps))).accepted
        self.result.ask(GetResultRequest(goal))
        return goal


def test_so_many_steps_are_made_of_a_paused_simulation():
    with peers.running(WORLD, "--paused"):
        peer = peers.Peer()
        clock = peer.reader("/clock", peers.Clock)
        steps = Steps(peer)
        before = peers.take_one(clock).clock
        steps.start(1, 250)
        answer = steps.result.answer()
        assert (answer.status, answer.result.result.result) == (SUCCEEDED, 1), answer
        last = peers.take_one(steps.feedback, where=lambda each: each.feedback.remaining_steps == 0)
        assert last.feedback.completed_steps == 250
        after = peers.take_one(clock, where=lambda each: each.clock.nanosec >= before.nanosec + 250_000_000)
        assert (after.clock.sec, after.clock.nanosec) == (before.sec, before.nanosec + 250_000_000)
        # and no further: a paused simulation repeats its time
        for _ in range(3):
            assert peers.take_one(clock).clock == after.clock


def test_steps_are_cancelled_and_their_status_is_told():
    with peers.running(WORLD, "--paused"):
        peer = peers.Peer()
        steps = Steps(peer)
        goal = steps.start(1, 10**9)
        peers.take_one(steps.feedback)
        status = peers.take_one(peers.Peer().reader("/pongsim/simulate_steps/_action/status", GoalStatusArray,
                                                    peers.LATCHED))
        told = [(bytes(each.goal_info.goal_id.uuid), each.status) for each in status.status_list]
        assert told == [(bytes(goal.uuid), EXECUTING)]
        answer = steps.cancel(CancelGoalRequest())
        assert answer.return_code == 0 and [bytes(each.goal_id.uuid) for each in answer.goals_canceling] == [
            bytes(goal.uuid)]
        answer = steps.result.answer()
        assert answer.status == CANCELED
        assert answer.result.result.error_message.startswith("cancelled after ")
        assert peers.take_one(steps.status, where=lambda each: each.status_list[0].status == CANCELED)


def test_steps_are_refused_of_a_simulation_that_runs():
    with peers.running(WORLD):
        steps = Steps(peers.Peer())
        steps.start(1, 5)
        answer = steps.result.answer()
        assert (answer.status, answer.result.result.result) == (ABORTED, 4)
        assert answer.result.result.error_message == "the simulation is not paused"


def create(*arguments):
    return subprocess.run([peers.PONGSIM, "ros2", "create", *arguments], capture_output=True, text=True, timeout=100)


def models():
    listed = subprocess.run([peers.PONGSIM, "model", "--list", "--timeout", "60000"], capture_output=True, text=True,
                            timeout=90)
    return set(listed.stdout.split())


SDF = "<sdf version='1.9'><model name='crate'><pose>9 9 9 0 0 0</pose><static>true</static><link name='l'/></model></sdf>"


def test_create_inserts_as_ros_gz_sim_does(tmp_path):
    file = tmp_path / "crate.sdf"
    file.write_text(SDF)
    # which publishes the poses of models
    world = tmp_path / "world.sdf"
    world.write_text(WORLD.read_text().replace(
        '<world name="drive">', '<world name="drive"><plugin filename="ignition-gazebo-scene-broadcaster-system" '
                                'name="ignition::gazebo::systems::SceneBroadcaster"/>'))
    with peers.running(world):
        done = create("-string", SDF, "-x", "-1.5", "-Y", "1.57")
        assert done.returncode == 0, done.stderr
        pose = subprocess.run([peers.PONGSIM, "model", "-m", "crate", "--pose", "--timeout", "60000"],
                              capture_output=True, text=True, timeout=90).stdout
        assert "-1.5" in pose and "9" not in pose
        again = create("-world", "drive", "-file", str(file))
        assert again.returncode == 1 and "crate" in again.stderr
        assert create("-file", str(file), "-allow_renaming", "true").returncode == 0
        assert create("--file=" + str(file), "-name=box").returncode == 0
        assert {"crate", "crate_0", "box"} <= models()

        # a node that keeps its description
        writer = peers.Peer().writer("/robot_description", peers.String, peers.LATCHED)
        writer.write(peers.String(SDF))
        described = create("-topic", "robot_description", "-name", "robot")
        assert described.returncode == 0, described.stderr
        assert "robot" in models()

        late = create("-topic", "nothing", "-timeout", "1500")
        assert late.returncode == 1
        assert "waiting for a message on '/nothing'" in late.stderr and "no messages on '/nothing'" in late.stderr
        other = create("-world", "driv", "-string", SDF, "-timeout", "100")
        assert other.returncode == 1 and "did you mean 'drive'" in other.stderr
        assert create("-string", "<sdf").returncode == 1


def test_a_wrong_command_line_of_create_says_why():
    for arguments, why in [((), "nothing to create"),
                           (("-file", "a", "-string", "b"), "use only one of"),
                           (("-string", "b", "-x", "one"), "option '-x' takes a number, not 'one'"),
                           (("-string", "b", "-x", "nan"), "takes a number"),
                           (("-string", "b", "-node", "n"), "needs '-param'"),
                           (("-strin", "b"), "unknown option '-strin'")]:
        done = create(*arguments)
        assert done.returncode == 2, arguments
        assert why in done.stderr, done.stderr
