"""A node of the real rclpy that publishes images of 640 x 480 at 30 Hz."""

import time

import rclpy
from rclpy.executors import ExternalShutdownException
from sensor_msgs.msg import Image

rclpy.init()
node = rclpy.create_node("image_publisher")
publisher = node.create_publisher(Image, "/real", 10)
image = Image(width=640, height=480, step=1920, encoding="rgb8", data=bytes(640 * 480 * 3))


def publish():
    image.header.stamp.sec, image.header.stamp.nanosec = divmod(time.time_ns(), 10**9)
    publisher.publish(image)


node.create_timer(1 / 30, publish)
try:
    rclpy.spin(node)
except (KeyboardInterrupt, ExternalShutdownException):
    pass
