"""DART, the engine of Fortress, by its own package for Python; with ODE's collisions, as Fortress has it."""

import dartpy as dart
import numpy

from scene import matrix

NAME = f"DART {dart.__version__}"

#: Limit of contact points. Fortress raises it, but DART's Python package has no way to.
MOST_CONTACTS = 1000


def placed(position, rotation=None):
    transform = numpy.eye(4)
    transform[:3, 3] = position
    if rotation is not None:
        transform[:3, :3] = rotation
    return transform


class Engine:
    def __init__(self, scene, step):
        if any(body.shape and body.shape[0] == "ellipsoid" for body in scene.bodies):
            raise NotImplementedError("no ellipsoids")
        self.world = dart.simulation.World()
        self.world.setTimeStep(step)
        self.world.setGravity(list(scene.gravity))
        # without sleeping bodies, which Fortress's DART lacks
        rest = self.world.getDeactivationOptions()
        rest.mEnabled = False
        self.world.setDeactivationOptions(rest)
        self.world.getConstraintSolver().setCollisionDetector(dart.collision.OdeCollisionDetector())
        self.scene = scene
        self.bodies, self.motors = {}, []
        joints = [joint for joint in scene.joints if not joint.closes]
        holder = {joint.child: joint for joint in joints}
        skeletons = {}
        for body in scene.bodies:
            self.add(body, holder, skeletons)
        for skeleton in skeletons.values():
            self.world.addSkeleton(skeleton)
        if scene.ground:
            self.add_ground()
        for joint in scene.joints:
            if joint.closes:
                self.close_loop(joint)

    def add(self, body, holder, skeletons):
        if body.name in self.bodies:
            return
        joint = holder.get(body.name)
        if joint is not None and joint.parent:
            self.add(self.scene.body(joint.parent), holder, skeletons)
        name = self.scene.model_of(body)
        skeleton = skeletons.get(name)
        if skeleton is None:
            skeleton = skeletons[name] = dart.dynamics.Skeleton(name)
            skeleton.disableSelfCollisionCheck()
        parent = self.bodies[joint.parent] if joint is not None and joint.parent else None
        made, node = self.make(skeleton, joint, parent)
        self.bodies[body.name] = node
        node.setInertia(dart.dynamics.Inertia(body.mass, numpy.zeros(3), numpy.diag(body.moments)))
        if body.shape:
            self.clothe(node, body.shape)
        turned = matrix(body.rotation)
        if joint is None:
            made.setPositions(
                dart.dynamics.FreeJoint.convertToPositions(dart.math.Isometry3(placed(body.position, turned)))
            )
            # the velocities of a free joint are those of the body, in its own axes
            spatial = numpy.concatenate(
                [turned.T @ numpy.asarray(body.turning, float), turned.T @ numpy.asarray(body.velocity, float)]
            )
            made.setVelocities(spatial)
            return
        holds = self.scene.body(joint.parent) if joint.parent else None
        place = numpy.asarray(joint.anchor, float)
        frame = placed(holds.position, matrix(holds.rotation)) if holds else numpy.eye(4)
        # initially, the joint's frame is parallel to the world's
        made.setTransformFromParentBodyNode(dart.math.Isometry3(numpy.linalg.inv(frame) @ placed(place)))
        made.setTransformFromChildBodyNode(
            dart.math.Isometry3(numpy.linalg.inv(placed(body.position, turned)) @ placed(place))
        )
        if joint.kind != "ball":
            made.setAxis(joint.axis)
        if joint.drive is not None:
            made.setActuatorType(dart.dynamics.SERVO)
            self.motors.append((made, joint.drive))

    @staticmethod
    def make(skeleton, joint, parent):
        kind = {None: "Free", "hinge": "Revolute", "ball": "Ball", "slide": "Prismatic"}[joint and joint.kind]
        create = getattr(skeleton, f"create{kind}JointAndBodyNodePair")
        return create(parent) if parent is not None else create()

    def clothe(self, node, shape):
        kind, *size = shape
        made = {
            "box": lambda: dart.dynamics.BoxShape(size),
            "sphere": lambda: dart.dynamics.SphereShape(*size),
            "cylinder": lambda: dart.dynamics.CylinderShape(*size),
        }[kind]()
        self.surface(node.createShapeNode(made))

    def surface(self, shape):
        shape.createCollisionAspect()
        dynamics = shape.createDynamicsAspect()
        dynamics.setFrictionCoeff(self.scene.friction)
        dynamics.setRestitutionCoeff(self.scene.restitution)

    def add_ground(self):
        skeleton = dart.dynamics.Skeleton("ground")
        skeleton.setMobile(False)
        _, node = skeleton.createWeldJointAndBodyNodePair()
        self.surface(node.createShapeNode(dart.dynamics.PlaneShape([0, 0, 1], 0)))
        self.world.addSkeleton(skeleton)

    def close_loop(self, joint):
        constraint = dart.constraint.BallJointConstraint(
            self.bodies[joint.parent], self.bodies[joint.child], list(joint.anchor)
        )
        self.world.getConstraintSolver().addConstraint(constraint)

    def step(self, count):
        for _ in range(count):
            for joint, velocity in self.motors:
                joint.setCommand(0, velocity)
            self.world.step()

    def body(self, name):
        node = self.bodies[name]
        transform = node.getWorldTransform()
        return (
            transform.translation(),
            transform.quaternion().wxyz(),
            node.getLinearVelocity(),
            node.getAngularVelocity(),
        )

    def close(self):
        pass
