"""The house of worlds/ros2_nav2.sdf."""

import math
import xml.etree.ElementTree as xml

import numpy as np
import peers

WORLD = peers.ROOT / "worlds/ros2_nav2.sdf"


def numbers(text):
    return [float(word) for word in text.split()]


class House:
    """The walls and the robot's start, read from the world's file."""

    def __init__(self):
        world = xml.parse(WORLD).getroot().find("world")
        self.shapes = []
        for link in world.find("model[@name='house']").findall("link"):
            x, y, _, _, _, yaw = numbers(link.findtext("pose"))
            geometry = link.find("visual/geometry")
            size = geometry.findtext("box/size")
            self.shapes.append((x, y, yaw, numbers(size)[:2] if size else None, geometry.findtext("cylinder/radius")))
        x, y, _, _, _, yaw = numbers(world.findtext("include/pose"))
        self.start = np.eye(4)
        self.start[:2, :2] = [[math.cos(yaw), -math.sin(yaw)], [math.sin(yaw), math.cos(yaw)]]
        self.start[:2, 3] = x, y

    def distance(self, points):
        """Distance from points [n x 2] in the world to the nearest surface, seen from above [m]."""
        nearest = np.full(len(points), np.inf)
        for x, y, yaw, size, radius in self.shapes:
            turned = (points - [x, y]) @ np.array([[math.cos(yaw), -math.sin(yaw)], [math.sin(yaw), math.cos(yaw)]])
            if size is None:
                distance = np.abs(np.linalg.norm(turned, axis=1) - float(radius))
            else:
                beyond = np.abs(turned) - np.array(size) / 2
                outside = np.linalg.norm(np.maximum(beyond, 0), axis=1)
                distance = np.where(outside > 0, outside, -beyond.max(axis=1))
            nearest = np.minimum(nearest, distance)
        return nearest
