"""A node that drives a robot with a lidar, and keeps it off the walls."""

from geometry_msgs.msg import Twist
import rclpy
from rclpy.duration import Duration
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from ros2_wall_avoider.steering import Steering
from sensor_msgs.msg import LaserScan


class WallAvoider(Node):
    """Answers each scan with a command, and stops the robot when no scan comes any more."""

    def __init__(self):
        super().__init__('wall_avoider')
        self.steering = Steering(
            near=self.declare_parameter('near', 1.0).value,
            width=self.declare_parameter('width', 2.4).value,
            speed=self.declare_parameter('speed', 0.5).value,
            turn=self.declare_parameter('turn', 0.5).value)
        self.patience = Duration(seconds=self.declare_parameter('patience', 1.0).value)
        self.commands = self.create_publisher(Twist, '/cmd_vel', 10)
        self.scans = self.create_subscription(
            LaserScan, '/lidar', self.drive, qos_profile_sensor_data)
        self.watch = self.create_timer(0.5, self.stop_if_blind)
        self.last_scan = None

    def drive(self, scan):
        self.last_scan = self.get_clock().now()
        was_turning = self.steering.turning != 0
        command = Twist()
        command.linear.x, command.angular.z = self.steering.command(
            scan.ranges, scan.angle_min, scan.angle_increment)
        self.commands.publish(command)
        if self.steering.turning != 0 and not was_turning:
            side = 'left' if self.steering.turning > 0 else 'right'
            self.get_logger().info(f'A wall is near: turning {side}')

    def stop_if_blind(self):
        if self.last_scan is None:
            self.get_logger().info('Waiting for the first scan', throttle_duration_sec=5.0)
        elif self.get_clock().now() - self.last_scan > self.patience:
            self.get_logger().warning('No scan comes: stopping', throttle_duration_sec=5.0)
            self.commands.publish(Twist())


def main(args=None):
    rclpy.init(args=args)
    node = WallAvoider()
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        node.destroy_node()
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
