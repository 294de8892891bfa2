"""Services, called by a peer that is not ours.

cyclonedds can't say which reader a reply is for, as rmw_fastrtps does; the server then answers by the writer's name and
all readers hear it, so that a lone client can be one over it. How replies find their callers ros2/node/service_test.cc
shows."""

import subprocess
from dataclasses import dataclass, field

import peers
from client import MSG, SRV, Client, Result, StepSimulationRequest, StepSimulationResponse
from cyclonedds.idl import IdlStruct
from cyclonedds.idl.types import float64, sequence, uint8, uint16, uint32

GZ = "ros_gz_interfaces::"
GEOMETRY = "geometry_msgs::msg::dds_::"


@dataclass
class Point(IdlStruct, typename=GEOMETRY + "Point_"):
    x: float64 = 0.0
    y: float64 = 0.0
    z: float64 = 0.0


@dataclass
class Quaternion(IdlStruct, typename=GEOMETRY + "Quaternion_"):
    x: float64 = 0.0
    y: float64 = 0.0
    z: float64 = 0.0
    w: float64 = 1.0


@dataclass
class Pose(IdlStruct, typename=GEOMETRY + "Pose_"):
    position: Point = field(default_factory=Point)
    orientation: Quaternion = field(default_factory=Quaternion)


@dataclass
class PoseStamped(IdlStruct, typename=GEOMETRY + "PoseStamped_"):
    header: peers.Header = field(default_factory=peers.Header)
    pose: Pose = field(default_factory=Pose)


@dataclass
class Accel(IdlStruct, typename=GEOMETRY + "Accel_"):
    linear: peers.Vector3 = field(default_factory=peers.Vector3)
    angular: peers.Vector3 = field(default_factory=peers.Vector3)


@dataclass
class Features(IdlStruct, typename=MSG + "SimulatorFeatures_"):
    features: sequence[uint16] = field(default_factory=list)
    spawn_formats: sequence[str] = field(default_factory=list)
    custom_info: str = ""


@dataclass
class GetSimulatorFeaturesRequest(IdlStruct, typename=SRV + "GetSimulatorFeatures_Request_"):
    structure_needs_at_least_one_member: uint8 = 0


@dataclass
class GetSimulatorFeaturesResponse(IdlStruct, typename=SRV + "GetSimulatorFeatures_Response_"):
    features: Features = field(default_factory=Features)


@dataclass
class Resource(IdlStruct, typename=MSG + "Resource_"):
    uri: str = ""
    resource_string: str = ""


@dataclass
class SpawnEntityRequest(IdlStruct, typename=SRV + "SpawnEntity_Request_"):
    name: str = ""
    allow_renaming: bool = False
    entity_resource: Resource = field(default_factory=Resource)
    entity_namespace: str = ""
    initial_pose: PoseStamped = field(default_factory=PoseStamped)


@dataclass
class SpawnEntityResponse(IdlStruct, typename=SRV + "SpawnEntity_Response_"):
    result: Result = field(default_factory=Result)
    entity_name: str = ""


@dataclass
class EntityState(IdlStruct, typename=MSG + "EntityState_"):
    header: peers.Header = field(default_factory=peers.Header)
    pose: Pose = field(default_factory=Pose)
    twist: peers.Twist = field(default_factory=peers.Twist)
    acceleration: Accel = field(default_factory=Accel)


@dataclass
class GetEntityStateRequest(IdlStruct, typename=SRV + "GetEntityState_Request_"):
    entity: str = ""


@dataclass
class GetEntityStateResponse(IdlStruct, typename=SRV + "GetEntityState_Response_"):
    result: Result = field(default_factory=Result)
    state: EntityState = field(default_factory=EntityState)


@dataclass
class SetEntityStateRequest(IdlStruct, typename=SRV + "SetEntityState_Request_"):
    entity: str = ""
    state: EntityState = field(default_factory=EntityState)


@dataclass
class SetEntityStateResponse(IdlStruct, typename=SRV + "SetEntityState_Response_"):
    result: Result = field(default_factory=Result)


@dataclass
class DeleteEntityRequest(IdlStruct, typename=SRV + "DeleteEntity_Request_"):
    entity: str = ""


@dataclass
class DeleteEntityResponse(IdlStruct, typename=SRV + "DeleteEntity_Response_"):
    result: Result = field(default_factory=Result)


@dataclass
class WorldReset(IdlStruct, typename=GZ + "msg::dds_::WorldReset_"):
    all: bool = False
    time_only: bool = False
    model_only: bool = False


@dataclass
class WorldControl(IdlStruct, typename=GZ + "msg::dds_::WorldControl_"):
    pause: bool = False
    step: bool = False
    multi_step: uint32 = 0
    reset: WorldReset = field(default_factory=WorldReset)
    seed: uint32 = 0
    run_to_sim_time: peers.Time = field(default_factory=peers.Time)


@dataclass
class ControlWorldRequest(IdlStruct, typename=GZ + "srv::dds_::ControlWorld_Request_"):
    world_control: WorldControl = field(default_factory=WorldControl)


@dataclass
class ControlWorldResponse(IdlStruct, typename=GZ + "srv::dds_::ControlWorld_Response_"):
    success: bool = False


BOX = "<sdf version='1.9'><model name='box'><static>true</static><link name='l'/></model></sdf>"


FALLING = BOX.replace("<static>true</static>", "").replace(
    "<link name='l'/>", "<link name='l'><collision name='c'><geometry><sphere><radius>0.2</radius></sphere></geometry>"
                        "</collision></link>")


def test_another_middleware_spawns_steps_and_deletes():
    world = peers.ROOT / "components/ros2/test/drive.sdf"
    with peers.running(world, "--paused"):
        peer = peers.Peer()
        features = Client(peer, "/pongsim/get_simulator_features", GetSimulatorFeaturesRequest,
                          GetSimulatorFeaturesResponse)
        answer = features(GetSimulatorFeaturesRequest()).features
        assert {0, 1, 9, 10, 31, 32} <= set(answer.features)
        assert answer.spawn_formats == ["sdf", "urdf"]

        spawn = Client(peer, "/pongsim/spawn_entity", SpawnEntityRequest, SpawnEntityResponse)
        request = SpawnEntityRequest(entity_resource=Resource(resource_string=BOX))
        request.initial_pose.pose.position = Point(1.0, 2.0, 3.0)
        spawned = spawn(request)
        assert (spawned.result.result, spawned.entity_name) == (1, "box")
        again = spawn(request)
        assert again.result.result == 101
        assert "there is a 'box' in the world already" in again.result.error_message

        state = Client(peer, "/pongsim/get_entity_state", GetEntityStateRequest, GetEntityStateResponse)
        found = state(GetEntityStateRequest("box")).state
        assert (found.pose.position.x, found.pose.position.y, found.pose.position.z) == (1, 2, 3)

        step = Client(peer, "/pongsim/step_simulation", StepSimulationRequest, StepSimulationResponse)
        assert step(StepSimulationRequest(25)).result.result == 1
        assert state(GetEntityStateRequest("rover")).state.header.stamp.nanosec == 25_000_000

        delete = Client(peer, "/pongsim/delete_entity", DeleteEntityRequest, DeleteEntityResponse)
        assert delete(DeleteEntityRequest("box")).result.result == 1
        assert delete(DeleteEntityRequest("box")).result.result == 2

        control = Client(peer, "/world/drive/control", ControlWorldRequest, ControlWorldResponse)
        assert control(ControlWorldRequest(WorldControl(pause=True, reset=WorldReset(all=True)))).success
        assert state(GetEntityStateRequest("rover")).state.header.stamp.nanosec == 0
        assert not control(ControlWorldRequest(WorldControl(reset=WorldReset(time_only=True)))).success


def test_a_repeated_run_with_the_same_steps_has_the_same_bits():
    """Requests come at no simulated time of their own while paused, so that what is asked in between two steps repeats."""
    def drive():
        with peers.running(peers.ROOT / "components/ros2/test/drive.sdf", "--paused"):
            peer = peers.Peer()
            spawn = Client(peer, "/pongsim/spawn_entity", SpawnEntityRequest, SpawnEntityResponse)
            step = Client(peer, "/pongsim/step_simulation", StepSimulationRequest, StepSimulationResponse)
            state = Client(peer, "/pongsim/get_entity_state", GetEntityStateRequest, GetEntityStateResponse)
            assert step(StepSimulationRequest(100)).result.result == 1
            request = SpawnEntityRequest(entity_resource=Resource(resource_string=FALLING))
            request.initial_pose.pose.position = Point(0.1, 0.05, 1.0)
            assert spawn(request).result.result == 1
            assert step(StepSimulationRequest(700)).result.result == 1
            return [state(GetEntityStateRequest(name)).state.pose for name in ("rover", "box")]

    assert drive() == drive()


def test_what_services_change_while_the_world_runs_is_recorded_and_replayed(tmp_path):
    recording = tmp_path / "run.inputs"
    with peers.running(peers.ROOT / "components/ros2/test/drive.sdf", "--record-inputs", recording):
        peer = peers.Peer()
        spawn = Client(peer, "/pongsim/spawn_entity", SpawnEntityRequest, SpawnEntityResponse)
        move = Client(peer, "/pongsim/set_entity_state", SetEntityStateRequest, SetEntityStateResponse)
        delete = Client(peer, "/pongsim/delete_entity", DeleteEntityRequest, DeleteEntityResponse)
        for name in ("a", "b", "c"):
            request = SpawnEntityRequest(name=name, entity_resource=Resource(resource_string=FALLING))
            request.initial_pose.pose.position = Point(0.1, 0.05, 1.0)
            assert spawn(request).result.result == 1
        state = EntityState()
        state.pose.position = Point(0.5, 0.5, 2.0)
        state.twist.linear.z = 1.0
        assert move(SetEntityStateRequest("b", state)).result.result == 1
        assert delete(DeleteEntityRequest("a")).result.result == 1
    for threads in ("1", "3"):
        replay = subprocess.run([peers.PONGSIM, "replay", recording, "--threads", threads], capture_output=True, text=True)
        assert replay.returncode == 0 and "is as recorded" in replay.stdout, replay.stdout + replay.stderr
