"""gz.math's vectors, rotations and poses."""

import math


class Missing:
    """Says what Gazebo has and pongsim has not."""

    def __getattr__(self, name):
        raise AttributeError(f"pongsim has no {type(self).__module__}.{type(self).__name__}.{name} for systems in Python")


def vector_of(value):
    return [float(value.x()), float(value.y()), float(value.z())]


class Vector3d(Missing):
    __module__ = "gz.math"

    def __init__(self, x=0.0, y=0.0, z=0.0):
        self._v = vector_of(x) if hasattr(x, "x") else [float(x), float(y), float(z)]

    def x(self, *value):
        return self._part(0, value)

    def y(self, *value):
        return self._part(1, value)

    def z(self, *value):
        return self._part(2, value)

    def _part(self, place, value):
        if value:
            self._v[place] = float(value[0])
        return self._v[place]

    set_x, set_y, set_z = x, y, z

    def set(self, x=0, y=0, z=0):
        self._v = [float(x), float(y), float(z)]

    def _with(self, other, work):
        others = vector_of(other) if hasattr(other, "x") else [other] * 3
        return Vector3d(*(work(a, b) for a, b in zip(self._v, others)))

    def __add__(self, other):
        return self._with(other, lambda a, b: a + b)

    def __sub__(self, other):
        return self._with(other, lambda a, b: a - b)

    def __mul__(self, other):
        return self._with(other, lambda a, b: a * b)

    def __truediv__(self, other):
        return self._with(other, lambda a, b: a / b)

    __radd__, __rmul__ = __add__, __mul__

    def __neg__(self):
        return self * -1.0

    def __getitem__(self, place):
        return self._v[place]

    def __setitem__(self, place, value):
        self._v[place] = float(value)

    def __eq__(self, other):
        return hasattr(other, "x") and all(abs(a - b) <= 1e-3 for a, b in zip(self._v, vector_of(other)))

    __hash__ = None

    def dot(self, other):
        return sum(a * b for a, b in zip(self._v, vector_of(other)))

    def cross(self, other):
        (a, b, c), (x, y, z) = self._v, vector_of(other)
        return Vector3d(b * z - c * y, c * x - a * z, a * y - b * x)

    def squared_length(self):
        return self.dot(self)

    def length(self):
        return math.sqrt(self.dot(self))

    def sum(self):
        return sum(self._v)

    def distance(self, other):
        return (self - other).length()

    def normalized(self):
        length = self.length()
        return self / length if length > 0 else Vector3d(self)

    def normalize(self):
        self._v = self.normalized()._v
        return self

    def __repr__(self):
        return " ".join(f"{value:g}" for value in self._v)


Vector3d.ZERO, Vector3d.ONE = Vector3d(), Vector3d(1, 1, 1)
Vector3d.UNIT_X, Vector3d.UNIT_Y, Vector3d.UNIT_Z = Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, 0, 1)


class Quaterniond(Missing):
    """Made of w, x, y, z, of roll, pitch, yaw, or of a vector of these."""

    __module__ = "gz.math"

    def __init__(self, *values):
        if len(values) == 1:
            values = [values[0].w(), *vector_of(values[0])] if hasattr(values[0], "w") else vector_of(values[0])
        if len(values) == 3:
            (r, p, y) = (float(angle) / 2 for angle in values)
            cr, cp, cy, sr, sp, sy = math.cos(r), math.cos(p), math.cos(y), math.sin(r), math.sin(p), math.sin(y)
            values = (
                cr * cp * cy + sr * sp * sy,
                sr * cp * cy - cr * sp * sy,
                cr * sp * cy + sr * cp * sy,
                cr * cp * sy - sr * sp * cy,
            )
        self._q = [float(value) for value in values] or [1.0, 0.0, 0.0, 0.0]

    def w(self):
        return self._q[0]

    def x(self):
        return self._q[1]

    def y(self):
        return self._q[2]

    def z(self):
        return self._q[3]

    def inverse(self):
        w, x, y, z = self._q
        square = w * w + x * x + y * y + z * z
        return Quaterniond(w / square, -x / square, -y / square, -z / square)

    def normalized(self):
        length = math.sqrt(sum(value * value for value in self._q))
        return Quaterniond(*(value / length for value in self._q))

    def __mul__(self, other):
        if not hasattr(other, "w"):
            return self.rotate_vector(other)
        (w, x, y, z), (a, b, c, d) = self._q, (other.w(), other.x(), other.y(), other.z())
        return Quaterniond(
            w * a - x * b - y * c - z * d,
            w * b + x * a + y * d - z * c,
            w * c - x * d + y * a + z * b,
            w * d + x * c - y * b + z * a,
        )

    def rotate_vector(self, vector):
        turned = self * Quaterniond(0, *vector_of(vector)) * self.inverse()
        return Vector3d(turned.x(), turned.y(), turned.z())

    def rotate_vector_reverse(self, vector):
        return self.inverse().rotate_vector(vector)

    def euler(self):
        w, x, y, z = self.normalized()._q
        pitch = math.asin(max(-1.0, min(1.0, 2 * (w * y - z * x))))
        roll = math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y))
        return Vector3d(roll, pitch, math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)))

    def roll(self):
        return self.euler().x()

    def pitch(self):
        return self.euler().y()

    def yaw(self):
        return self.euler().z()

    def __repr__(self):
        return repr(self.euler())


Quaterniond.IDENTITY = Quaterniond()


class Pose3d(Missing):
    """Made of x, y, z, roll, pitch, yaw; of x, y, z and a quaternion's four numbers; or of a position and a rotation."""

    __module__ = "gz.math"

    def __init__(self, *values):
        if len(values) == 1:
            values = values[0].pos(), values[0].rot()
        if len(values) == 2:
            self._pos, self._rot = Vector3d(values[0]), Quaterniond(values[1])
        else:
            self._pos, self._rot = Vector3d(*values[:3]), Quaterniond(*values[3:])

    def pos(self):
        return self._pos

    def rot(self):
        return self._rot

    def x(self):
        return self._pos.x()

    def y(self):
        return self._pos.y()

    def z(self):
        return self._pos.z()

    def roll(self):
        return self._rot.roll()

    def pitch(self):
        return self._rot.pitch()

    def yaw(self):
        return self._rot.yaw()

    def set_x(self, value):
        self._pos.x(value)

    def set_y(self, value):
        self._pos.y(value)

    def set_z(self, value):
        self._pos.z(value)

    def inverse(self):
        turn = self._rot.inverse()
        return Pose3d(-turn.rotate_vector(self._pos), turn)

    def __mul__(self, other):
        return Pose3d(self._pos + self._rot.rotate_vector(other.pos()), self._rot * other.rot())

    def __repr__(self):
        return f"{self._pos} {self._rot}"


Pose3d.ZERO = Pose3d()


def pose_from(words):
    return Pose3d(*numbers(words)) if words else None


def words_of_pose(pose):
    rotation = pose.rot()
    return (*vector_of(pose.pos()), rotation.w(), rotation.x(), rotation.y(), rotation.z())
