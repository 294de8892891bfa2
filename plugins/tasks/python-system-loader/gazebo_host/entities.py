"""gz.sim's entities, which ask pongsim."""

import datetime
import time


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
