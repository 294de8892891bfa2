"""Where to drive with what a lidar sees."""

import math


class Steering:
    """Ahead while the way is free, slower before a wall, and round in place where it is near."""

    def __init__(self, near, width, speed, turn):
        """
        Keep what to drive by.

        :param near: distance ahead of the lidar at which to turn [m]
        :param width: width of the way that must be free [m]
        :param speed: speed where the way is free [m/s]
        :param turn: angular speed while turning [rad/s]
        """
        self.near = near
        self.width = width
        self.speed = speed
        self.turn = turn
        # 0 ahead, 1 to the left, -1 to the right
        self.turning = 0

    def command(self, ranges, angle_min, angle_increment):
        """
        Say how to drive with that in view.

        :param ranges: distances along the beams [m]; infinite or NaN where nothing was met
        :param angle_min: direction of the first beam, counterclockwise from ahead [rad]
        :param angle_increment: from one beam to the next [rad]
        :return: linear speed [m/s] and angular speed [rad/s]
        """
        ahead = math.inf
        left = right = 0.0
        far = 4.0 * self.near
        for i, distance in enumerate(ranges):
            angle = angle_min + i * angle_increment
            if math.isfinite(distance):
                x, y = distance * math.cos(angle), distance * math.sin(angle)
                if x > 0.0 and abs(y) < self.width / 2.0:
                    ahead = min(ahead, x)

            # how much room each side has; what is far away does not matter
            room = far if math.isnan(distance) else min(distance, far)
            if angle > 0.0:
                left += room
            elif angle < 0.0:
                right += room

        # who has begun to turn goes on until there is room, and to the same side
        if self.turning != 0 and ahead > 2.0 * self.near:
            self.turning = 0
        if self.turning == 0 and ahead < self.near:
            self.turning = 1 if left >= right else -1
        if self.turning != 0:
            return 0.0, self.turning * self.turn
        return self.speed * min(1.0, ahead / (2.0 * self.near)), 0.0
