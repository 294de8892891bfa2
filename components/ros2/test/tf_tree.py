"""Transforms as a node keeps them: those of /tf and /tf_static, looked up at a time."""

import bisect

import numpy as np
import peers
import ros_messages

TFMessage = ros_messages.message("tf2_msgs/msg/TFMessage")
DEEP = peers.Qos(peers.Policy.Reliability.Reliable(peers.duration(seconds=1)), peers.Policy.History.KeepLast(1000))


def nanoseconds(stamp):
    return stamp.sec * 10**9 + stamp.nanosec


def matrix(position, q):
    """The 4 x 4 matrix of a pose, which converts the child's coordinates to the parent's."""
    x, y, z, w = np.array([q.x, q.y, q.z, q.w]) / np.linalg.norm([q.x, q.y, q.z, q.w])
    result = np.eye(4)
    result[:3, :3] = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                      [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                      [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    result[:3, 3] = [position.x, position.y, position.z]
    return result


def between(a, b, part):
    """The interpolated transform between a and b, as in tf2: linear, with a rotation at constant speed."""
    def vector(message, names):
        return np.array([getattr(message, name) for name in names])

    p = (1 - part) * vector(a.translation, "xyz") + part * vector(b.translation, "xyz")
    q, r = vector(a.rotation, "xyzw"), vector(b.rotation, "xyzw")
    r = r if q @ r >= 0 else -r
    angle = np.arccos(np.clip(q @ r, -1, 1))
    q = q + part * (r - q) if angle < 1e-6 else (np.sin((1 - part) * angle) * q + np.sin(part * angle) * r) / np.sin(angle)
    return matrix(type(a.translation)(*map(float, p)), type(a.rotation)(*map(float, q)))


class TfTree:
    def __init__(self, peer, prefix=""):
        self._moving = peer.reader(f"{prefix}/tf", TFMessage, DEEP)
        self._static = peer.reader(f"{prefix}/tf_static", TFMessage, peers.LATCHED)
        # keyed by child: its parent, and (time, transform) in order; a static one has no time
        self.parents = {}
        self.static = {}
        self.moving = {}

    def update(self):
        for message in peers.take(self._static):
            for each in message.transforms:
                self._adopt(each)
                self.static[each.child_frame_id] = matrix(each.transform.translation, each.transform.rotation)
        for message in peers.take(self._moving):
            for each in message.transforms:
                self._adopt(each)
                track = self.moving.setdefault(each.child_frame_id, ([], []))
                time = nanoseconds(each.header.stamp)
                assert not track[0] or time > track[0][-1], f"{each.child_frame_id} has two transforms at {time}"
                track[0].append(time)
                track[1].append(each.transform)

    def _adopt(self, each):
        parent = self.parents.setdefault(each.child_frame_id, each.header.frame_id)
        assert parent == each.header.frame_id, f"{each.child_frame_id} has two parents, {parent} and {each.header.frame_id}"

    def chain(self, frame):
        """The frames from that one up to its root."""
        frames = [frame]
        while frames[-1] in self.parents:
            frames.append(self.parents[frames[-1]])
            assert len(frames) < 100, f"{frame} is its own ancestor"
        return frames

    def known_until(self, frame):
        """The last time [ns] at which the pose of the frame in its root is known."""
        return min((self.moving[each][0][-1] for each in self.chain(frame)[:-1] if each in self.moving), default=None)

    def lookup(self, frame, root, time):
        """The matrix that converts coordinates in `frame` to those in `root`, at that time [ns]."""
        result = np.eye(4)
        for each in self.chain(frame)[:self.chain(frame).index(root)]:
            result = self._at(each, time) @ result
        return result

    def gap(self, frame, root, time):
        """The longest time [ns] between the transforms on either side of `time`, which lie farther apart where some of
        them were lost."""
        gaps = [0]
        for each in self.chain(frame)[:self.chain(frame).index(root)]:
            if each in self.moving:
                times, _ = self.moving[each]
                after = bisect.bisect_left(times, time)
                gaps.append(times[after] - times[after - 1] if 0 < after < len(times) else 0)
        return max(gaps)

    def _at(self, frame, time):
        if frame in self.static:
            return self.static[frame]
        times, transforms = self.moving[frame]
        after = bisect.bisect_left(times, time)
        assert after < len(times), f"{frame} is known until {times[-1]}, not at {time}"
        if times[after] == time:
            return matrix(transforms[after].translation, transforms[after].rotation)
        assert after > 0, f"{frame} is not known before {times[0]}"
        part = (time - times[after - 1]) / (times[after] - times[after - 1])
        return between(transforms[after - 1], transforms[after], part)
