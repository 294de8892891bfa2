"""A run in lockstep with a real node: the same bits, however slow it is."""

import random
import re
import subprocess
import time

import ros
import simulation
from geometry_msgs.msg import Twist
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import LaserScan

STEPS = 2000


def state_hash(delay, *options):
    """The hash of a run with a node that thinks up to `delay` seconds before each answer to a scan."""
    with ros.node("driver") as driver:
        rng = random.Random(delay)
        publisher = driver.create_publisher(Twist, "/cmd_vel", 10)
        answers = []

        def answer(scan):
            time.sleep(rng.uniform(0, delay))
            twist = Twist()
            twist.linear.x = 0.1 * min(scan.ranges)
            twist.angular.z = 0.3 if len(answers) % 3 else -0.2
            publisher.publish(twist)
            answers.append(scan.header.stamp)

        driver.create_subscription(LaserScan, "/lidar", answer, qos_profile_sensor_data)
        result = subprocess.run([simulation.PONGSIM, "run", ros.WORLD, "-z", "0", "--iterations", str(STEPS), "--hash",
                                 *options], capture_output=True, text=True, timeout=simulation.PATIENCE)
        assert result.returncode == 0, result.stderr
        return re.search("state hash: (.*)", result.stdout).group(1), len(answers)


def test_a_slow_node_does_not_change_a_bit():
    # 20 scans a second
    options = ("--lockstep", "/cmd_vel:50", "--lockstep-start", "/lidar", "--lockstep-timeout", "30")
    runs = [state_hash(delay, *options) for delay in (0, 0.02, 0.05)]
    assert len({each for each, _ in runs}) == 1, runs
    alone = subprocess.run([simulation.PONGSIM, "run", ros.WORLD, "-z", "0", "--iterations", str(STEPS), "--hash"],
                           capture_output=True, text=True, timeout=simulation.PATIENCE)
    assert runs[0][0] not in alone.stdout


def test_a_node_that_does_not_answer_is_named():
    result = subprocess.run([simulation.PONGSIM, "run", ros.WORLD, "-z", "0", "--iterations", "100",
                             "--lockstep", "/cmd_vel", "--lockstep-timeout", "0.5"],
                            capture_output=True, text=True, timeout=simulation.PATIENCE)
    assert result.returncode == 1
    assert "error: lockstep: nobody subscribes to the world's topics within 0.5 s" in result.stderr
