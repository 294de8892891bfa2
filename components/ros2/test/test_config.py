"""Rules: files of ros_gz_bridge, its arguments, and settings of each topic, as a node with Cyclone DDS sees them."""

import json
import os
import re
import subprocess
import time

from cyclonedds.core import Policy, Qos
from cyclonedds.util import duration

import peers

WORLD = peers.ROOT / "components/ros2/test/drive.sdf"
CHATTER = "/chatter@std_msgs/msg/String@ignition.msgs.StringMsg"
TRANSIENT = Qos(Policy.Reliability.Reliable(duration(seconds=1)), Policy.Durability.TransientLocal,
                Policy.History.KeepLast(10))


def pongsim(*arguments, check=True):
    return subprocess.run([peers.PONGSIM, *map(str, arguments)], capture_output=True, text=True, check=check)


def say(topic, text):
    """Publishes a text in the simulation, once there is a subscriber."""
    pongsim("topic", "-t", topic, "-m", "StringMsg", "-p", f'data: "{text}"', "--timeout", "60")


def subscribers(topic):
    """The number of subscribers to a topic of the simulation; -1 if there is no such topic."""
    topics = {each["name"]: each["subscribers"] for each in json.loads(pongsim("topic", "-l", "--json").stdout)}
    return topics.get(topic, -1)


def node(name="/pongsim"):
    """The topics that a node publishes and subscribes to; nothing while it does not exist."""
    for each in json.loads(pongsim("ros2", "nodes", "--json").stdout):
        if each["name"] == name:
            # without those that each node has
            return {key: [way["name"] for way in each[key] if way["name"] not in ("/rosout", "/parameter_events")]
                    for key in ("publishers", "subscribers")}
    return None


def node_with(publishers=(), subscribers=(), name="/pongsim"):
    """Waits until a node has these topics, and returns all that it has then."""
    def there():
        known = node(name)
        return known and set(publishers) <= set(known["publishers"]) and set(subscribers) <= set(known["subscribers"]) and known

    return peers.until(there, f"{name} with {publishers} and {subscribers}")


def configuration(folder, text, name="bridge.yaml"):
    file = folder / name
    file.write_text(text)
    return file


def lidar_as(name, more=""):
    return (f"- ros_topic_name: {name}\n  gz_topic_name: /lidar\n  ros_type_name: sensor_msgs/msg/LaserScan\n"
            f"  gz_type_name: gz.msgs.LaserScan\n  direction: GZ_TO_ROS\n{more}")


def test_a_file_gives_a_topic_another_name(tmp_path):
    file = configuration(tmp_path, lidar_as("scan", "  frame_id: laser\n"))
    with peers.running(WORLD, "--ros2-config", file):
        assert peers.take_one(peers.Peer().reader("/scan", peers.LaserScan)).header.frame_id == "laser"
        # a topic without a rule is bridged as usual
        known = node_with(publishers=("/scan", "/clock"), subscribers=("/cmd_vel",))
        assert "/lidar" not in known["publishers"]


def test_a_world_names_its_file_from_its_own_folder(tmp_path):
    configuration(tmp_path, lidar_as("/front/scan"))
    world = tmp_path / "world.sdf"
    world.write_text(WORLD.read_text().replace(
        'name="pongsim::systems::Ros2"/>',
        'name="pongsim::systems::Ros2"><config_file>bridge.yaml</config_file><bridge_all>false</bridge_all></plugin>'))
    with peers.running(world):
        peers.take_one(peers.Peer().reader("/front/scan", peers.LaserScan))
        assert node_with(publishers=("/front/scan",)) == {"publishers": ["/front/scan"], "subscribers": []}


def test_an_argument_carries_both_ways():
    with peers.running(WORLD, "--ros2-only", "--ros2-topic", CHATTER):
        peer = peers.Peer()
        reader = peer.reader("/chatter", peers.String)
        peers.until(lambda: subscribers("/chatter") > 0, "a listener in the simulation")
        say("/chatter", "from inside")
        assert peers.take_one(reader).data == "from inside"
        writer = peer.writer("/chatter", peers.String)
        echo = subprocess.Popen([peers.PONGSIM, "topic", "-e", "-t", "/chatter", "-n", "1"], stdout=subprocess.PIPE,
                                text=True)

        def heard():
            writer.write(peers.String("from ROS"))
            return echo.poll() is not None

        peers.until(heard, "the end of the echo")
        assert "from ROS" in echo.stdout.read()


def test_an_argument_with_a_bracket_carries_one_way():
    one_way = ["--ros2-only", "--ros2-topic", "/lidar@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan",
               "--ros2-topic", "/cmd_vel@geometry_msgs/msg/Twist]gz.msgs.Twist"]
    with peers.running(WORLD, *one_way):
        scans = peers.Peer().reader("/lidar", peers.LaserScan)
        ahead = peers.take_one(scans).ranges[30]
        assert node_with(publishers=("/lidar",), subscribers=("/cmd_vel",)) == {
            "publishers": ["/lidar"], "subscribers": ["/cmd_vel"]}
        command = peers.Peer().writer("/cmd_vel", peers.Twist)

        def nearer():
            command.write(peers.Twist(linear=peers.Vector3(x=1.0)))
            return any(scan.ranges[30] < ahead - 0.2 for scan in peers.take(scans))

        peers.until(nearer, "a wall that is nearer")


def test_a_topic_is_listened_to_only_when_a_node_listens_unless_a_rule_says_otherwise(tmp_path):
    with peers.running(WORLD, "--ros2-config", configuration(tmp_path, lidar_as("scan"))):
        peers.until(lambda: subscribers("/lidar") == 0, "the simulation's topic, without a listener")
        reader = peers.Peer().reader("/scan", peers.LaserScan)
        peers.until(lambda: subscribers("/lidar") == 1, "a listener")
        # with its participant
        del reader
        peers.until(lambda: subscribers("/lidar") == 0, "its end")
    with peers.running(WORLD, "--ros2-config", configuration(tmp_path, lidar_as("scan", "  lazy: false\n"))):
        peers.until(lambda: subscribers("/lidar") == 1, "a listener from the start")


def test_a_late_node_gets_what_was_said_where_a_rule_keeps_it(tmp_path):
    file = configuration(tmp_path, "- topic_name: /chatter\n  ros_type_name: std_msgs/msg/String\n"
                                   "  gz_type_name: gz.msgs.StringMsg\n  direction: GZ_TO_ROS\n"
                                   "  qos: {durability: transient_local, depth: 2}\n")
    with peers.running(WORLD, "--ros2-config", file):
        for text in ("one", "two", "three"):
            say("/chatter", text)
        peers.until(lambda: any(each["ros"] == "/chatter" and each["sent"] == 3
                                for each in json.loads(pongsim("ros2", "topics", "-d", "0", "--json").stdout)),
                    "three messages on their way")
        reader = peers.Peer().reader("/chatter", peers.String, TRANSIENT)
        heard = []

        def all_there():
            heard.extend(sample.data for sample in peers.take(reader))
            return len(heard) >= 2

        peers.until(all_there, "what was said before")
        assert heard == ["two", "three"]


def test_a_profile_is_what_readers_see(tmp_path):
    file = configuration(tmp_path, lidar_as("scan", "  qos_profile: SENSOR_DATA\n"))
    with peers.running(WORLD, "--ros2-config", file):
        peer = peers.Peer()
        reliable = peer.reader("/scan", peers.LaserScan, peers.RELIABLE)
        peers.take_one(peer.reader("/scan", peers.LaserScan, peers.BEST_EFFORT))
        # a best-effort writer does not match a reader that requests more
        assert reliable.get_subscription_matched_status().current_count == 0


def test_messages_are_stamped_with_the_time_of_the_wall():
    with peers.running(WORLD, "--ros2-override-timestamps"):
        begin = time.time()
        scan = peers.take_one(peers.Peer().reader("/lidar", peers.LaserScan),
                              where=lambda sample: sample.header.stamp.sec >= int(begin))
        assert scan.header.stamp.sec <= time.time()


def test_two_namespaces_stand_side_by_side(tmp_path):
    file = configuration(tmp_path, lidar_as("scan"))
    options = lambda name: ["--ros2-config", file, "--ros2-only", "--ros2-namespace", name, "--ros2-frame-prefix",
                            name + "/", "--ros2-node-name", "simulator"]
    # their own topics have the same names
    other = {"PONGSIM_DOMAIN": str(peers.take_domain())}
    with peers.running(WORLD, *options("red")), peers.running(WORLD, *options("blue"), environment=other):
        peer = peers.Peer()
        for name in ("red", "blue"):
            scan = peers.take_one(peer.reader(f"/{name}/scan", peers.LaserScan))
            assert scan.header.frame_id == f"{name}/rover/chassis/lidar"
            known = node_with(publishers=(f"/{name}/scan",), name=f"/{name}/simulator")
            assert known["publishers"] == [f"/{name}/scan"]


def test_names_of_the_simulation_are_expanded_too():
    with peers.running(WORLD, "--ros2-only", "--ros2-namespace", "/demo", "--ros2-expand-gz-topic-names",
                       "--ros2-topic", "chatter@std_msgs/msg/String@ignition.msgs.StringMsg"):
        reader = peers.Peer().reader("/demo/chatter", peers.String)
        peers.until(lambda: subscribers("/demo/chatter") > 0, "a listener in the simulation")
        say("/demo/chatter", "hello")
        assert peers.take_one(reader).data == "hello"


def refused(*arguments, environment=None, code=1):
    """The output of a run that does not start."""
    result = subprocess.run([peers.PONGSIM, "run", WORLD, "--iterations", "1", *map(str, arguments)],
                            capture_output=True, text=True, env={**os.environ, **(environment or {})}, timeout=60)
    assert result.returncode == code, result.stderr
    return result.stderr


def test_a_run_with_a_wrong_configuration_does_not_begin(tmp_path):
    file = configuration(tmp_path, lidar_as("scan") + lidar_as("scan").replace("LaserScan", "PointCloud2", 1)
                         + "- topic_name: a\n  ros_type_name: std_msgs/msg/Strin\n  gz_type_name: gz.msgs.StringMsg\n"
                         + "  direction: GZ_TO_RO\n")
    said = refused("--ros2-config", file)
    assert f"{file}:9:17: error: sensor_msgs/msg/PointCloud2 does not match ignition.msgs.LaserScan" in said
    assert f"{file}:14:14: error: 'direction' can't be 'GZ_TO_RO'" in said
    assert "hint: did you mean 'GZ_TO_ROS'?" in said
    said = refused("--ros2-topic", "/a@geometry_msgs/msg/Twist@gz.msgs.Twist",
                   "--ros2-topic", "/a@geometry_msgs/msg/TwistStamped@gz.msgs.Twist")
    assert "error: ROS topic '/a' can't be geometry_msgs/msg/TwistStamped here and geometry_msgs/msg/Twist" in said
    assert "option '--ros2-domain' takes a whole number from 0 to 232, not '233'" in refused("--ros2-domain", "233", code=2)
    assert "ROS_DOMAIN_ID is '233', not an integer between 0 and 232" in refused(
        "--ros2", environment={"ROS_DOMAIN_ID": "233"})
    assert "the file can't be read" in refused("--ros2-config", tmp_path / "none.yaml")


def test_what_is_bridged_can_be_asked_for():
    with peers.running(WORLD, "--ros2"):
        reader = peers.Peer().reader("/clock", peers.Clock)
        peers.take_one(reader)

        def goes_on():
            topics = {each["ros"]: each for each in json.loads(pongsim("ros2", "topics", "--json").stdout)}
            known = {"/clock", "/cmd_vel", "/lidar"} <= topics.keys()
            return known and topics["/clock"]["hz_to_ros"] > 0 and topics

        topics = peers.until(goes_on, "a clock that is bridged")
        clock = topics["/clock"]
        assert clock["ros_type"] == "rosgraph_msgs/msg/Clock" and clock["ignition_type"] == "ignition.msgs.Clock"
        assert clock["to_ros"] and not clock["from_ros"]
        assert clock["readers"] == 1 and clock["sent"] > 0
        assert topics["/cmd_vel"]["from_ros"] and topics["/lidar"]["sent"] == 0
        table = pongsim("ros2", "topics", "-d", "0.1").stdout
        assert re.search(r"^/clock \[rosgraph_msgs/msg/Clock\] +<-  /clock \[ignition.msgs.Clock\] +to ROS: 1 reader, ",
                         table, re.MULTILINE)
        assert re.search(r"^/cmd_vel \[geometry_msgs/msg/Twist\] +->  /cmd_vel", table, re.MULTILINE)


def test_who_asks_hears_why_nothing_is_bridged():
    nobody = pongsim("ros2", "topics", "--timeout", "0", check=False)
    assert nobody.returncode == 1 and "no world is running" in nobody.stderr
    with peers.running(peers.ROOT / "worlds/pong_world.sdf"):
        def said_why():
            unbridged = pongsim("ros2", "topics", "--timeout", "0", check=False)
            assert unbridged.returncode == 1
            return "world 'pong_world' is not bridged to ROS 2\n  hint: start it with pongsim run WORLD --ros2" \
                in unbridged.stderr

        peers.until(said_why, "the world")


def test_the_example_of_the_documentation_does_what_it_says(tmp_path):
    page = (peers.ROOT / "docs/ros2.md").read_text()
    example = re.search(r"<!-- test_config.py runs it -->\n\n((?:    .*\n|\n)+)", page).group(1)
    file = configuration(tmp_path, "\n".join(line[4:] for line in example.splitlines()) + "\n")
    checked = pongsim("ros2", "check", file)
    assert checked.stderr == "" and "/scan [sensor_msgs/msg/LaserScan]" in checked.stdout
    with peers.running(WORLD, "--ros2-config", file):
        peer = peers.Peer()
        assert peers.take_one(peer.reader("/scan", peers.LaserScan, peers.BEST_EFFORT)).header.frame_id == "laser"
        known = node_with(publishers=("/scan",), subscribers=("/cmd",))
        assert "/lidar" not in known["publishers"] and "/cmd_vel" not in known["subscribers"]
