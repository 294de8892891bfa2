"""A node of the real rclpy that ends when it has heard the simulation's clock."""

import rclpy
from rosgraph_msgs.msg import Clock

rclpy.init()
node = rclpy.create_node("clock_listener")
heard = []
node.create_subscription(Clock, "/clock", heard.append, 10)
print("listens", flush=True)
while not heard:
    rclpy.spin_once(node)
