"""Runs a system that is written for Gazebo's Python modules, for pongsim's PythonSystemLoader.

pongsim and this program take turns on a socket, whose number is the second argument: a call is answered when the system
has returned, and meanwhile the system's questions and commands go the other way. A line is one of them: words between
tabs. The other arguments are the module's name and the folders in which it is looked for.
"""

import sys

# the present folder is no place for modules
sys.path[:] = [folder for folder in sys.path if folder]

import datetime
import importlib.abc
import importlib.machinery
import importlib.util
import math
import os
import re
import signal
import socket
import time
import traceback
import types
import xml.etree.ElementTree as ElementTree

HELP = (
    "pongsim has Model, Link, Joint, World and world_entity of gz.sim, Vector3d, Quaterniond and Pose3d of gz.math, and "
    "sdformat's Element"
)


class Line:
    """Words to and from pongsim."""

    def __init__(self, number):
        self.stream = socket.socket(fileno=number).makefile("rwb")

    def write(self, *words):
        escaped = (str(w).replace("\\", "\\\\").replace("\t", "\\t").replace("\n", "\\n") for w in words)
        self.stream.write("\t".join(escaped).encode(errors="replace") + b"\n")
        self.stream.flush()

    def read(self):
        """None at the end."""
        line = self.stream.readline().decode(errors="replace")
        if not line.endswith("\n"):
            return None
        plain = {"t": "\t", "n": "\n"}
        return [re.sub(r"\\(.)", lambda m: plain.get(m[1], m[1]), word) for word in line[:-1].split("\t")]

    def ask(self, *words):
        self.write("ask", *words)
        answer = self.read()
        if answer is None:
            sys.exit(0)
        if answer[0] != "ok":
            raise RuntimeError(answer[1])
        return answer[1:]


line = None


def numbers(words):
    return [float(word) for word in words]


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


class Entity(Missing):
    """What Gazebo's classes of entities have in common. The functions take the component manager, as Gazebo's do."""

    __module__ = "gz.sim"
    KIND = ""

    def __init__(self, entity=0):
        self._entity = entity.entity() if isinstance(entity, Entity) else int(entity)

    def entity(self):
        return self._entity

    def reset_entity(self, entity):
        self._entity = int(entity)

    def _ask(self, what, *words):
        return line.ask(self.KIND + "." + what, self._entity, *words)

    def _id(self, what, *words):
        return int(self._ask(what, *words)[0])

    def _ids(self, what):
        return [int(word) for word in self._ask(what)]

    def valid(self, ecm):
        return self._ask("valid")[0] == "1"

    def name(self, ecm):
        return self._ask("name")[0]

    def __copy__(self):
        return type(self)(self._entity)

    def __deepcopy__(self, memo):
        return type(self)(self._entity)


class World(Entity):
    __module__, KIND = "gz.sim", "world"

    def gravity(self, ecm):
        return Vector3d(*numbers(self._ask("gravity")))

    def magnetic_field(self, ecm):
        return Vector3d(*numbers(self._ask("magnetic_field")))

    def model_by_name(self, ecm, name):
        return self._id("model_by_name", name)

    def models(self, ecm):
        return self._ids("models")

    def model_count(self, ecm):
        return len(self.models(ecm))


class Model(Entity):
    __module__, KIND = "gz.sim", "model"

    def static(self, ecm):
        return self._ask("static")[0] == "1"

    def link_by_name(self, ecm, name):
        return self._id("link_by_name", name)

    def joint_by_name(self, ecm, name):
        return self._id("joint_by_name", name)

    def links(self, ecm):
        return self._ids("links")

    def joints(self, ecm):
        return self._ids("joints")

    def models(self, ecm):
        return self._ids("models")

    def link_count(self, ecm):
        return len(self.links(ecm))

    def joint_count(self, ecm):
        return len(self.joints(ecm))

    def canonical_link(self, ecm):
        return self._id("canonical_link")

    def set_world_pose_cmd(self, ecm, pose):
        self._ask("set_world_pose", *words_of_pose(pose))


class Link(Entity):
    __module__, KIND = "gz.sim", "link"

    def parent_model(self, ecm):
        return Model(self._id("parent_model"))

    def is_canonical(self, ecm):
        return self.parent_model(ecm).canonical_link(ecm) == self._entity

    def wind_mode(self, ecm):
        return self._ask("wind_mode")[0] == "1"

    def world_pose(self, ecm):
        return pose_from(self._ask("world_pose"))

    def _inertial(self):
        return pose_from(self._ask("inertial_pose"))

    def world_inertial_pose(self, ecm):
        return self.world_pose(ecm) * self._inertial()

    def world_linear_velocity(self, ecm, offset=None):
        parts = numbers(self._ask("velocity"))
        linear, angular = Vector3d(*parts[:3]), Vector3d(*parts[3:])
        if offset is None:
            return linear
        return linear + angular.cross(self.world_pose(ecm).rot().rotate_vector(offset))

    def world_angular_velocity(self, ecm):
        return Vector3d(*numbers(self._ask("velocity"))[3:])

    def set_linear_velocity(self, ecm, velocity):
        """In the link's own axes, as in Gazebo."""
        turned = self.world_pose(ecm).rot().rotate_vector(velocity)
        self._ask("set_velocity", *vector_of(turned), *vector_of(self.world_angular_velocity(ecm)))

    def set_angular_velocity(self, ecm, velocity):
        turned = self.world_pose(ecm).rot().rotate_vector(velocity)
        self._ask("set_velocity", *vector_of(self.world_linear_velocity(ecm)), *vector_of(turned))

    def enable_velocity_checks(self, ecm, enable=True):
        """Nothing to do: velocities are always known."""

    def add_world_wrench(self, ecm, force, torque, offset=None):
        if offset is not None:
            torque = Vector3d(torque) + self.world_pose(ecm).rot().rotate_vector(offset).cross(force)
        self._ask("add_wrench", *vector_of(force), *vector_of(torque))

    def add_world_force(self, ecm, force, position=None):
        """At a position from the centre of mass, in the link's axes."""
        offset = self._inertial().pos()
        self.add_world_wrench(ecm, force, Vector3d(), offset if position is None else offset + position)

    def add_force_in_inertial_frame(self, ecm, force, position=None):
        axes = self._inertial().rot()
        world_force = self.world_pose(ecm).rot().rotate_vector(axes.rotate_vector(force))
        self.add_world_force(ecm, world_force, None if position is None else axes.rotate_vector(position))


class Joint(Entity):
    __module__, KIND = "gz.sim", "joint"

    def parent_link_name(self, ecm):
        return self._ask("parent_link_name")[0]

    def child_link_name(self, ecm):
        return self._ask("child_link_name")[0]

    def parent_model(self, ecm):
        return Model(self._id("parent_model"))

    def position(self, ecm):
        return numbers(self._ask("position"))

    def velocity(self, ecm):
        return numbers(self._ask("velocity"))

    def set_force(self, ecm, forces):
        self._ask("set_force", *map(float, forces))

    def set_velocity(self, ecm, velocities):
        self._ask("set_velocity", *map(float, velocities))

    def reset_position(self, ecm, positions):
        self._ask("reset_position", *map(float, positions))

    def reset_velocity(self, ecm, velocities):
        self._ask("reset_velocity", *map(float, velocities))

    def enable_position_check(self, ecm, enable=True):
        """Nothing to do: positions are always known."""

    def enable_velocity_check(self, ecm, enable=True):
        """Nothing to do: velocities are always known."""


class EntityComponentManager(Missing):
    __module__ = "gz.sim"


class EventManager(Missing):
    __module__ = "gz.sim"


class UpdateInfo(Missing):
    __module__ = "gz.sim"

    def __init__(self, words=("0", "0", "0", "0")):
        self.iterations = int(words[0])
        self.sim_time = datetime.timedelta(microseconds=int(words[1]) / 1000)
        self.dt = datetime.timedelta(microseconds=int(words[2]) / 1000)
        self.paused = words[3] == "1"
        self.real_time = datetime.timedelta(seconds=time.monotonic() - START)


START = time.monotonic()


class Param:
    """An attribute of an element."""

    def __init__(self, text):
        self._text = text

    def get_as_string(self, *config):
        return self._text


class Element(Missing):
    """sdformat's Element, for reading."""

    __module__ = "sdformat"

    def __init__(self, tree, parent=None):
        self._tree, self._parent = tree, parent

    def get_name(self):
        return self._tree.tag

    def get_parent(self):
        return self._parent

    def has_element(self, name):
        return self._tree.find(name) is not None

    def find_element(self, name):
        found = self._tree.find(name)
        return None if found is None else Element(found, self)

    def get_element(self, name):
        found = self.find_element(name)
        if found is None:
            raise RuntimeError(f"<{self.get_name()}> has no <{name}>")
        return found

    def get_first_element(self):
        return Element(self._tree[0], self) if len(self._tree) else None

    def get_next_element(self, name=""):
        if self._parent is None:
            return None
        siblings = list(self._parent._tree)
        for each in siblings[siblings.index(self._tree) + 1 :]:
            if name in ("", each.tag):
                return Element(each, self._parent)
        return None

    def has_attribute(self, name):
        return name in self._tree.attrib

    def get_attribute(self, name):
        return Param(self._tree.attrib[name]) if self.has_attribute(name) else None

    def get_attribute_count(self):
        return len(self._tree.attrib)

    def to_string(self, prefix="", *more):
        return prefix + ElementTree.tostring(self._tree, encoding="unicode")

    def _text(self, key):
        if not key:
            return self._tree.text or ""
        found = self._tree.find(key)
        return self._tree.attrib.get(key) if found is None else found.text or ""

    def _get(self, key, fallback, convert, default):
        """With a default, the value and whether it was given, as in sdformat."""
        text = self._text(key)
        value = (fallback[0] if fallback else default) if text is None else convert(text.strip())
        return (value, text is not None) if fallback else value

    def get_string(self, key="", *fallback):
        return self._get(key, fallback, str, "")

    def get_bool(self, key="", *fallback):
        return self._get(key, fallback, lambda text: text.lower() in ("1", "true"), False)

    def get_int(self, key="", *fallback):
        return self._get(key, fallback, int, 0)

    def get_double(self, key="", *fallback):
        return self._get(key, fallback, float, 0.0)

    def get_vector3d(self, key="", *fallback):
        return self._get(key, fallback, lambda text: Vector3d(*numbers(text.split())), Vector3d())

    def get_pose(self, key="", *fallback):
        return self._get(key, fallback, lambda text: Pose3d(*numbers(text.split())), Pose3d())

    get_float, get_unsigned_int, get_uint64 = get_double, get_int, get_int


HOOKS = ("configure", "pre_update", "update", "post_update", "reset")

MODULES = {
    "gz.math": (Vector3d, Quaterniond, Pose3d),
    "gz.sim": (World, Model, Link, Joint, EntityComponentManager, EventManager, UpdateInfo),
    "sdformat": (Element,),
}


class GazeboModules(importlib.abc.MetaPathFinder, importlib.abc.Loader):
    """Gazebo's modules, by any release's name: gz.sim, gz.sim8."""

    def find_spec(self, name, path=None, target=None):
        if name == "gz" or name.startswith("gz.") or re.fullmatch(r"sdformat\d*", name):
            return importlib.machinery.ModuleSpec(name, self, is_package=name == "gz")
        return None

    def create_module(self, spec):
        return None

    def exec_module(self, module):
        name = module.__name__
        if name == "gz":
            return
        known = re.sub(r"\d+$", "", name)
        if known not in MODULES:
            raise ImportError(f"{name} is not here: {HELP}")
        for each in MODULES[known]:
            setattr(module, each.__name__, each)
        if known == "gz.sim":
            module.K_NULL_ENTITY = 0
            module.world_entity = lambda *ecm: int(line.ask("world.entity", 0)[0])

        def missing(what):
            if what.startswith("__"):
                raise AttributeError(what)
            raise AttributeError(f"{name}.{what} is not here: {HELP}")

        module.__getattr__ = missing


def load(name, folders):
    """Only from these folders, so that no world runs what else is installed."""
    spec = importlib.machinery.PathFinder.find_spec(name, folders)
    if spec is None or spec.loader is None:
        places = ", ".join(folders) or "none"
        raise ImportError(f"there is no module '{name}' in the folders of systems and in PYTHONPATH: {places}")
    sys.path[:0] = folders
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    spec.loader.exec_module(module)
    return module


def place_of(error):
    """Where the module raised it; this program's own lines tell nobody anything."""
    places = [each for each in traceback.extract_tb(error.__traceback__) if os.path.isfile(each.filename)]
    return f" ({places[-1].filename}:{places[-1].lineno})" if places else ""


def call(system, word, words, ecm):
    if word == "configure":
        system.configure(int(words[0]), Element(ElementTree.fromstring(words[1])), ecm, EventManager())
    else:
        getattr(system, word)(UpdateInfo(words), ecm)


def main():
    global line
    line = Line(int(sys.argv[1]))
    # pongsim ends the run, and then this
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    sys.meta_path.insert(0, GazeboModules())
    ecm = EntityComponentManager()
    system = None
    while (words := line.read()) is not None:
        try:
            if words[0] == "load":
                system = load(words[1], words[2:]).get_system()
                line.write("done", *(hook for hook in HOOKS if hasattr(system, hook)))
            else:
                call(system, words[0], words[1:], ecm)
                line.write("done")
        except SystemExit:
            raise
        except BaseException as error:
            sys.stderr.write("".join(traceback.format_exception(type(error), error, error.__traceback__)))
            line.write("failed", f"{type(error).__name__}: {error}{place_of(error)}")
        sys.stdout.flush()
        sys.stderr.flush()
    if hasattr(system, "shutdown"):
        system.shutdown()


main()
