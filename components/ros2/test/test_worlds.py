"""Several worlds of a file with --ros2: each is a node with the topics of its world."""

import json
import subprocess

import peers

WORLD = peers.ROOT / "worlds/three_worlds.sdf"
WORLDS = ("fine", "coarse", "fast")


def pongsim(*arguments):
    result = subprocess.run([peers.PONGSIM, *map(str, arguments)], capture_output=True, text=True, timeout=90)
    assert result.returncode == 0, result.stderr
    return result.stdout


def x_of(world):
    """The distance that a world's cart has driven [m]."""
    return float(pongsim("topic", "-e", "-t", f"/model/cart_{world}/odometry", "-n", "1", "--field", "pose.position.x"))


def names_of_nodes():
    return sorted(node["name"] for node in json.loads(pongsim("ros2", "nodes", "--json")))


def test_each_world_is_a_node():
    with peers.running(WORLD, "--ros2"):
        names = [f"/pongsim_{world}" for world in sorted(WORLDS)]
        peers.until(lambda: names_of_nodes() == names, "a node for each world")
        for world in WORLDS:
            def own_topics(world=world):
                topics = json.loads(pongsim("ros2", "topics", "--world", world, "--timeout", "60000", "-d", "0", "--json"))
                own = [each["ros"] for each in topics]
                return f"/model/cart_{world}/odometry" in own and ("/clock" in own or world != "fine") and own

            own = peers.until(own_topics, f"the topics of {world}")
            assert ("/clock" in own) == (world == "fine")
            assert not [name for name in own if name.startswith("/model/cart_") and f"cart_{world}" not in name]


def test_a_command_drives_the_robot_of_its_world():
    with peers.running(WORLD, "--ros2", "--ros2-node-name", "sim"):
        peers.until(lambda: "/sim_coarse" in names_of_nodes(), "the node")
        clock = peers.Peer().reader("/clock", peers.Clock)
        peers.take_one(clock)
        writer = peers.Peer().writer("/model/cart_coarse/cmd_vel", peers.Twist)

        def moved():
            writer.write(peers.Twist(linear=peers.Vector3(x=0.5)))
            return x_of("coarse") > 0.1

        peers.until(moved, "the cart to move")
        assert abs(x_of("fine")) < 1e-3 and abs(x_of("fast")) < 1e-3


def test_a_world_that_names_its_node_keeps_the_name(tmp_path):
    plugin = ("<plugin filename='pongsim-ros2-system' name='pongsim::systems::Ros2'>"
              "<node_name>mine</node_name></plugin>")
    file = tmp_path / "two.sdf"
    file.write_text(f"<sdf version='1.9'><world name='a'>{plugin}</world><world name='b'/></sdf>")
    with peers.running(file, "--ros2"):
        peers.until(lambda: names_of_nodes() == ["/mine", "/pongsim_b"], "both nodes")
