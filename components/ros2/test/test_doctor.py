"""`pongsim ros2 doctor` finds nothing wrong with the robot for Nav2, and the faults of others, with what mends them."""

import json
import subprocess

import peers
import ros_messages
from house import WORLD

ros_messages.install()

from geometry_msgs.msg import Transform, TransformStamped, TwistStamped  # noqa: E402
from sensor_msgs.msg import JointState  # noqa: E402
from std_msgs.msg import String  # noqa: E402
from tf2_msgs.msg import TFMessage  # noqa: E402

DRIVE = peers.ROOT / "components/ros2/test/drive.sdf"


def doctor(*arguments):
    return subprocess.run([peers.PONGSIM, "ros2", "doctor", *arguments], capture_output=True, text=True)


def faults(*arguments):
    """What is wrong, by what mends it; and the exit code."""
    result = doctor("--json", *arguments)
    assert result.stderr == ""
    findings = json.loads(result.stdout)
    assert len(findings) > 5 and all(each["for"] for each in findings)
    wrong = {each["text"]: each["mend"] for each in findings if each["verdict"] == "fault"}
    assert all(wrong.values())
    return wrong, result.returncode


def test_a_robot_that_has_all():
    with peers.running(WORLD, "--ros2"):
        peer = peers.Peer()
        # the world's services are there before the run begins
        peers.take_one(peer.reader("/clock", peers.Clock), where=lambda each: each.clock.nanosec > 0)
        assert faults() == ({}, 0)
        said = doctor()
        assert said.returncode == 0
        assert "ok     /clock moves\n" in said.stdout and "ok     tf knows the frames of all messages\n" in said.stdout
        # the part of others
        assert "hint   there is no frame 'map'\n" in said.stdout
        assert "to mend: start slam_toolbox" in said.stdout
        assert said.stdout.splitlines()[-1].startswith("0 faults, ")


def test_a_robot_with_other_names():
    with peers.running(DRIVE):
        peers.take_one(peers.Peer().reader("/clock", peers.Clock), where=lambda each: each.clock.nanosec > 0)
        wrong, code = faults()
        assert code == 1
        assert wrong == {
            "there is no frame 'base_link'": "name the robot's main link base_link, and in an SDF one of its links in the "
                                             "drive, <child_frame_id>base_link</child_frame_id>",
            "there is no frame 'odom'": "in the drive's <plugin>: <frame_id>odom</frame_id>",
            "nobody publishes '/scan' [sensor_msgs/msg/LaserScan]; there is '/lidar'":
                "in the lidar's <sensor>: <topic>scan</topic>, or remap the topic in the node",
            "nobody publishes '/odom' [nav_msgs/msg/Odometry]; there is '/model/rover/odometry'":
                "in the drive's <plugin>: <odom_topic>odom</odom_topic>, or remap the topic in the node"}


def test_a_second_source_of_everything():
    with peers.running(WORLD, "--ros2"):
        peer = peers.Peer()
        writers = [peer.writer("/joint_states", JointState), peer.writer("/robot_description", String, peers.LATCHED),
                   peer.writer("/cmd_vel", TwistStamped)]
        frames = peer.writer("/tf_static", TFMessage, peers.LATCHED)
        transform = TransformStamped(child_frame_id="base_scan", transform=Transform())
        transform.header.frame_id = "elsewhere"
        frames.write(TFMessage(transforms=[transform]))
        late = peer.reader("/scan", String)
        wrong, code = faults()
        assert code == 1
        assert "--ros2-no-tf" in wrong["frame 'base_scan' has 2 parents: 'base_link', 'elsewhere'"]
        assert any(each.startswith("'/joint_states' has 2 publishers: ") for each in wrong)
        assert any(each.startswith("2 publishers of '/robot_description'") for each in wrong)
        assert "TwistStamped@ignition.msgs.Twist" in wrong[
            "commands on '/cmd_vel' are stamped, but the robot hears those without stamp"]
        assert any(each.startswith("a subscriber wants '/scan' as std_msgs/msg/String, but it is published as "
                                   "sensor_msgs/msg/LaserScan") for each in wrong)
        del writers, late


def test_a_simulation_that_stands_still_and_one_that_is_not_there():
    with peers.running(WORLD, "--ros2", "--paused"):
        wrong, code = faults()
        assert code == 1 and "/clock stands still: the simulation is paused" in wrong
    nobody = doctor("--domain", str(peers.take_domain()))
    assert nobody.returncode == 1 and "no nodes in domain" in nobody.stderr


def test_wrong_command_lines():
    for arguments in (["--time", "0"], ["--namespace", "a-b"], ["--frames"]):
        result = doctor(*arguments)
        assert result.returncode == 2 and result.stdout == "", arguments
