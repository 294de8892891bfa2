"""Services, parameters and actions for real nodes."""

import ros
import simulation
from rcl_interfaces.msg import Parameter, ParameterType, ParameterValue
from rcl_interfaces.srv import GetParameters, SetParameters
from simulation_interfaces.msg import Result
from simulation_interfaces.srv import GetEntityState, GetSpawnables, SetEntityState, SpawnEntity

BOX = """<sdf version="1.9"><model name="box"><link name="link"><inertial><mass>1</mass></inertial>
<collision name="c"><geometry><box><size>1 1 1</size></box></geometry></collision></link></model></sdf>"""


def test_simulation_interfaces_as_the_distribution_ships_them(tmp_path):
    (tmp_path / "crate").mkdir()
    (tmp_path / "crate/model.config").touch()
    with simulation.running(ros.WORLD), ros.node() as tester:
        request = SpawnEntity.Request(name="crate", resource_string=BOX)
        request.initial_pose.pose.position.z = 5.0
        answer = ros.call(tester, SpawnEntity, "/pongsim/spawn_entity", request)
        assert answer.result.result == Result.RESULT_OK, answer

        request = SetEntityState.Request(entity="crate")
        request.state.pose.position.x = 7.0
        answer = ros.call(tester, SetEntityState, "/pongsim/set_entity_state", request)
        assert answer.result.result == Result.RESULT_OK, answer
        answer = ros.call(tester, GetEntityState, "/pongsim/get_entity_state", GetEntityState.Request(entity="crate"))
        assert abs(answer.state.pose.position.x - 7.0) < 1e-3

        sources = GetSpawnables.Request(sources=[str(tmp_path)])
        answer = ros.call(tester, GetSpawnables, "/pongsim/get_spawnables", sources)
        assert str(tmp_path / "crate") in [each.uri for each in answer.spawnables]


def test_parameters():
    with simulation.running(ros.WORLD), ros.node() as tester:
        value = ParameterValue(type=ParameterType.PARAMETER_DOUBLE, double_value=0.5)
        answer = ros.call(tester, SetParameters, "/pongsim/set_parameters",
                          SetParameters.Request(parameters=[Parameter(name="real_time_factor", value=value)]))
        assert answer.results[0].successful
        answer = ros.call(tester, GetParameters, "/pongsim/get_parameters",
                          GetParameters.Request(names=["real_time_factor", "use_sim_time"]))
        assert answer.values[0].double_value == 0.5 and answer.values[1].bool_value


def test_each_client_gets_its_own_answers():
    with simulation.running(ros.WORLD), ros.node() as tester:
        clients = [tester.create_client(GetEntityState, "/pongsim/get_entity_state") for _ in range(3)]
        futures = []
        for client in clients:
            assert client.wait_for_service(simulation.PATIENCE)
            futures += [(name, client.call_async(GetEntityState.Request(entity=name))) for name in ("rover", "nobody")]
        simulation.until(lambda: all(future.done() for _, future in futures), "the answers")
        for name, future in futures:
            expected = Result.RESULT_OK if name == "rover" else Result.RESULT_NOT_FOUND
            assert future.result().result.result == expected
