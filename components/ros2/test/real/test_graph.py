"""The graph of nodes, without telling the simulation which distribution they are of."""

import subprocess

import ros
import simulation
from sensor_msgs.msg import LaserScan
from std_msgs.msg import String
from type_description_interfaces.srv import GetTypeDescription


def nodes_that_pongsim_lists(domain=simulation.DOMAIN):
    listed = subprocess.run([simulation.PONGSIM, "ros2", "nodes", "-v", "--domain", str(domain)], capture_output=True,
                            text=True, check=True)
    return listed.stdout


def test_real_nodes_see_the_name_of_the_simulations_node():
    with simulation.running(ros.WORLD), ros.node() as tester:
        simulation.until(lambda: ("pongsim", "/") in tester.get_node_names_and_namespaces(), "the node's name")
        simulation.until(lambda: [each.node_name for each in tester.get_publishers_info_by_topic("/lidar")] == ["pongsim"],
                         "the lidar's publisher")
        [publisher] = tester.get_publishers_info_by_topic("/lidar")
        assert publisher.topic_type == "sensor_msgs/msg/LaserScan"
        # that of the real type
        publisher_of_ours = tester.create_publisher(LaserScan, "/other", 1)
        simulation.until(lambda: tester.get_publishers_info_by_topic("/other"), "our own")
        [ours] = tester.get_publishers_info_by_topic("/other")
        assert str(publisher.topic_type_hash) == str(ours.topic_type_hash)
        tester.destroy_publisher(publisher_of_ours)


def test_pongsim_sees_the_names_of_real_nodes():
    with ros.node("talker") as talker:
        talker.create_publisher(String, "/chatter", 1)
        listed = simulation.until(lambda: "/chatter" in (text := nodes_that_pongsim_lists()) and text, "the talker")
        assert "/talker\n" in listed and "/chatter [std_msgs/msg/String]" in listed


def test_the_node_describes_its_types():
    with simulation.running(ros.WORLD), ros.node() as tester:
        simulation.until(lambda: tester.get_publishers_info_by_topic("/lidar"), "the lidar")
        request = GetTypeDescription.Request(type_name="sensor_msgs/msg/LaserScan", include_type_sources=False)
        answer = ros.call(tester, GetTypeDescription, "/pongsim/get_type_description", request)
        assert answer.successful, answer.failure_reason
        described = {each.type_name for each in answer.type_description.referenced_type_descriptions}
        assert described == {"std_msgs/msg/Header", "builtin_interfaces/msg/Time"}
        names = [each.name for each in answer.type_description.type_description.fields]
        assert names == list(LaserScan.get_fields_and_field_types())
        request.type_name = "no_msgs/msg/None"
        answer = ros.call(tester, GetTypeDescription, "/pongsim/get_type_description", request)
        assert not answer.successful and "no_msgs/msg/None" in answer.failure_reason
