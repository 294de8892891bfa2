"""Bullet as it comes, by PyBullet: reduced coordinates for what has joints, 50 iterations. No damping."""

import math

import numpy
import pybullet

from scene import inverse, matrix, product

NAME = "Bullet"


def xyzw(rotation):
    w, x, y, z = rotation
    return (x, y, z, w)


class Engine:
    def __init__(self, scene, step):
        if any(body.shape and body.shape[0] == "ellipsoid" for body in scene.bodies):
            raise NotImplementedError("no ellipsoids")
        self.scene = scene
        self.client = pybullet.connect(pybullet.DIRECT)
        pybullet.setPhysicsEngineParameter(fixedTimeStep=step, physicsClientId=self.client)
        pybullet.setGravity(*scene.gravity, physicsClientId=self.client)
        #: For each body: the number of its tree, and of its link there (-1: the base).
        self.places = {}
        tree = [joint for joint in scene.joints if not joint.closes]
        self.holder = {joint.child: joint for joint in tree}
        self.children = {}
        for joint in tree:
            self.children.setdefault(joint.parent, []).append(joint)
        for body in scene.bodies:
            joint = self.holder.get(body.name)
            if joint is None or not joint.parent:
                self.add_tree(body, joint)
        if scene.ground:
            plane = pybullet.createCollisionShape(pybullet.GEOM_PLANE, physicsClientId=self.client)
            self.material(pybullet.createMultiBody(0, plane, physicsClientId=self.client), -1)
        for joint in scene.joints:
            if joint.closes:
                self.close_loop(joint)

    def shape_of(self, body, offset):
        if not body.shape:
            return -1
        kind, *size = body.shape
        common = {"collisionFramePosition": list(offset), "physicsClientId": self.client}
        if kind == "box":
            return pybullet.createCollisionShape(pybullet.GEOM_BOX, halfExtents=[side / 2 for side in size], **common)
        if kind == "sphere":
            return pybullet.createCollisionShape(pybullet.GEOM_SPHERE, radius=size[0], **common)
        return pybullet.createCollisionShape(pybullet.GEOM_CYLINDER, radius=size[0], height=size[1], **common)

    def add_tree(self, root, held):
        """Makes a tree; one that is held by the world hangs on a base without mass at the world's origin."""
        links, order = [], {}
        pending = [held] if held else [*self.children.get(root.name, [])]
        while pending:
            joint = pending.pop(0)
            order[joint.child] = len(links)
            links.append(joint)
            pending += self.children.get(joint.child, [])
        lists = {
            key: []
            for key in (
                "linkMasses",
                "linkCollisionShapeIndices",
                "linkVisualShapeIndices",
                "linkPositions",
                "linkOrientations",
                "linkInertialFramePositions",
                "linkInertialFrameOrientations",
                "linkParentIndices",
                "linkJointTypes",
                "linkJointAxis",
            )
        }
        kinds = {"hinge": pybullet.JOINT_REVOLUTE, "ball": pybullet.JOINT_SPHERICAL, "slide": pybullet.JOINT_PRISMATIC}
        for joint in links:
            body = self.scene.body(joint.child)
            parent = self.scene.body(joint.parent) if joint.parent else None
            anchor, turned = numpy.asarray(joint.anchor, float), matrix(body.rotation)
            if parent is None:
                place, rotation, number = anchor, body.rotation, 0
            else:
                # in Bullet, the origin of a link is at its joint, with the axes of the body
                own = self.holder.get(joint.parent)
                origin = numpy.asarray(own.anchor if own else parent.position, float)
                place = matrix(parent.rotation).T @ (anchor - origin)
                rotation = product(inverse(parent.rotation), body.rotation)
                number = order[joint.parent] + 1 if joint.parent in order else 0
            centre = turned.T @ (numpy.asarray(body.position, float) - anchor)
            values = (
                body.mass,
                self.shape_of(body, centre),
                -1,
                list(place),
                xyzw(rotation),
                list(centre),
                (0, 0, 0, 1),
                number,
                kinds[joint.kind],
                list(turned.T @ numpy.asarray(joint.axis, float)),
            )
            for key, value in zip(lists, values):
                lists[key].append(value)
        base = (
            {"baseMass": 0}
            if held
            else {
                "baseMass": root.mass,
                "baseCollisionShapeIndex": self.shape_of(root, (0, 0, 0)),
                "basePosition": list(root.position),
                "baseOrientation": xyzw(root.rotation),
            }
        )
        tree = pybullet.createMultiBody(**base, **lists, useMaximalCoordinates=0, physicsClientId=self.client)
        self.finish(tree, None if held else root, links)

    def finish(self, tree, root, links):
        common = {"physicsClientId": self.client}
        # Bullet renumbers the links; their names have the numbers from before
        names = [pybullet.getJointInfo(tree, i, **common)[12].decode() for i in range(len(links))]
        links = [links[int(name.removeprefix("link")) - 1] for name in names]
        bodies = ([(root, -1)] if root else []) + [(self.scene.body(joint.child), i) for i, joint in enumerate(links)]
        for body, place in bodies:
            self.places[body.name] = (tree, place)
            self.material(tree, place)
            pybullet.changeDynamics(tree, place, localInertiaDiagonal=list(body.moments), **common)
        if root and (any(root.velocity) or any(root.turning)):
            pybullet.resetBaseVelocity(tree, list(root.velocity), list(root.turning), **common)
        for place, joint in enumerate(links):
            if joint.kind == "ball":
                pybullet.setJointMotorControlMultiDof(
                    tree,
                    place,
                    pybullet.POSITION_CONTROL,
                    targetPosition=[0, 0, 0, 1],
                    positionGain=0,
                    velocityGain=0,
                    force=[0, 0, 0],
                    **common,
                )
            else:
                pybullet.setJointMotorControl2(
                    tree,
                    place,
                    pybullet.VELOCITY_CONTROL,
                    targetVelocity=joint.drive or 0,
                    force=0 if joint.drive is None else 1e6,
                    **common,
                )
        # links of one model do not collide
        for i in range(-1, len(links)):
            for j in range(i + 1, len(links)):
                pybullet.setCollisionFilterPair(tree, tree, i, j, 0, **common)

    def material(self, tree, place):
        # Bullet multiplies the values of both bodies
        pybullet.changeDynamics(
            tree,
            place,
            lateralFriction=math.sqrt(self.scene.friction),
            restitution=math.sqrt(self.scene.restitution),
            linearDamping=0,
            angularDamping=0,
            jointDamping=0,
            physicsClientId=self.client,
        )

    def close_loop(self, joint):
        ends = []
        for name in (joint.parent, joint.child):
            body = self.scene.body(name)
            ends.append(matrix(body.rotation).T @ (numpy.asarray(joint.anchor, float) - body.position))
        (one, first), (other, second) = self.places[joint.parent], self.places[joint.child]
        made = pybullet.createConstraint(
            one,
            first,
            other,
            second,
            pybullet.JOINT_POINT2POINT,
            [0, 0, 0],
            list(ends[0]),
            list(ends[1]),
            physicsClientId=self.client,
        )
        pybullet.changeConstraint(made, maxForce=1e6, physicsClientId=self.client)

    def step(self, count):
        for _ in range(count):
            pybullet.stepSimulation(physicsClientId=self.client)

    def body(self, name):
        tree, place = self.places[name]
        common = {"physicsClientId": self.client}
        if place < 0:
            position, rotation = pybullet.getBasePositionAndOrientation(tree, **common)
            velocity, turning = pybullet.getBaseVelocity(tree, **common)
        else:
            found = pybullet.getLinkState(tree, place, computeLinkVelocity=1, computeForwardKinematics=1, **common)
            position, rotation, velocity, turning = found[0], found[1], found[6], found[7]
        x, y, z, w = rotation
        return position, (w, x, y, z), velocity, turning

    def close(self):
        pybullet.disconnect(self.client)
