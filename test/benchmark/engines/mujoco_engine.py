"""MuJoCo with its own defaults, but for `implicitfast`, which its makers recommend."""

import mujoco
import numpy

from scene import inverse, matrix, product

NAME = f"MuJoCo {mujoco.__version__}"

# By default, warnings are written to a file in the current folder. They are not needed: divergence shows in the error.
mujoco.set_mju_user_warning(lambda text: None)

#: Contact as an undamped spring, because MuJoCo has no restitution; stiffness per mass [1/s^2].
BOUNCE = 'solref="-100000 0"'


class Engine:
    integrator = "implicitfast"

    def __init__(self, scene, step):
        self.model = mujoco.MjModel.from_xml_string(mjcf_of(scene, step, self.integrator))
        self.data = mujoco.MjData(self.model)
        held = {joint.child for joint in scene.joints if not joint.closes}
        for body in scene.bodies:
            if body.name not in held and (any(body.velocity) or any(body.turning)):
                start = self.model.jnt_dofadr[self.model.body(body.name).jntadr[0]]
                self.data.qvel[start : start + 3] = body.velocity
                self.data.qvel[start + 3 : start + 6] = matrix(body.rotation).T @ numpy.asarray(body.turning, float)
        for joint in scene.joints:
            if joint.drive is not None:
                self.data.actuator(joint.name).ctrl = joint.drive
        mujoco.mj_forward(self.model, self.data)

    def step(self, count):
        mujoco.mj_step(self.model, self.data, count)

    def body(self, name):
        number = self.model.body(name).id
        velocity = numpy.zeros(6)
        mujoco.mj_objectVelocity(self.model, self.data, mujoco.mjtObj.mjOBJ_BODY, number, velocity, 0)
        return self.data.xipos[number].copy(), self.data.xquat[number].copy(), velocity[3:], velocity[:3]

    def close(self):
        pass


class RungeKutta(Engine):
    integrator = "RK4"


def numbers(values):
    return " ".join(repr(float(value)) for value in values)


def geom_of(scene, body):
    if not body.shape:
        return ""
    kind, *size = body.shape
    if kind == "box":
        size = [side / 2 for side in size]
    elif kind == "cylinder":
        size = [size[0], size[1] / 2]
    return f'<geom type="{kind}" size="{numbers(size)}" {material_of(scene)}/>'


def material_of(scene):
    bounce = BOUNCE if scene.restitution > 0 else ""
    return f'friction="{scene.friction} 0.005 0.0001" {bounce}'


def mjcf_of(scene, step, integrator="implicitfast"):
    tree = [joint for joint in scene.joints if not joint.closes]
    holder = {joint.child: joint for joint in tree}
    children = {}
    for joint in tree:
        children.setdefault(joint.parent, []).append(joint)

    def text_of(body, parent):
        at, rotation = numpy.asarray(body.position, float), body.rotation
        if parent:
            at = matrix(parent.rotation).T @ (at - numpy.asarray(parent.position, float))
            rotation = product(inverse(parent.rotation), rotation)
        joint = holder.get(body.name)
        if joint is None:
            own = "<freejoint/>"
        else:
            turned = matrix(body.rotation).T
            place = turned @ (numpy.asarray(joint.anchor, float) - numpy.asarray(body.position, float))
            axis = "" if joint.kind == "ball" else f'axis="{numbers(turned @ numpy.asarray(joint.axis, float))}"'
            own = f'<joint name="{joint.name}" type="{joint.kind}" pos="{numbers(place)}" {axis}/>'
        inner = "".join(text_of(scene.body(each.child), body) for each in children.get(body.name, []))
        return (
            f'<body name="{body.name}" pos="{numbers(at)}" quat="{numbers(rotation)}">{own}<inertial pos="0 0 0" '
            f'mass="{body.mass!r}" diaginertia="{numbers(body.moments)}"/>{geom_of(scene, body)}{inner}</body>'
        )

    world = "".join(
        text_of(body, None) for body in scene.bodies if body.name not in holder or holder[body.name].parent == ""
    )
    if scene.ground:
        world = f'<geom type="plane" size="0 0 1" {material_of(scene)}/>' + world
    motors = "".join(
        f'<velocity name="{joint.name}" joint="{joint.name}" kv="100"/>'
        for joint in scene.joints
        if joint.drive is not None
    )
    return (
        f'<mujoco><compiler angle="radian" autolimits="true"/><size memory="1G"/><option timestep="{step!r}" '
        f'integrator="{integrator}" gravity="{numbers(scene.gravity)}"><flag autoreset="disable"/></option>'
        f"<worldbody>{world}</worldbody>"
        f"<actuator>{motors}</actuator><contact>{apart_of(scene)}</contact><equality>{loops_of(scene)}</equality>"
        "</mujoco>"
    )


def apart_of(scene):
    """Bodies of one model that do not touch each other; those that a joint holds do not anyway."""
    held = {frozenset((joint.parent, joint.child)) for joint in scene.joints}
    models = {}
    for body in scene.bodies:
        if body.shape:
            models.setdefault(scene.model_of(body), []).append(body.name)
    return "".join(
        f'<exclude body1="{one}" body2="{other}"/>'
        for names in models.values()
        for i, one in enumerate(names)
        for other in names[i + 1 :]
        if frozenset((one, other)) not in held
    )


def loops_of(scene):
    text = ""
    for joint in scene.joints:
        if joint.closes:
            parent = scene.body(joint.parent)
            place = matrix(parent.rotation).T @ (numpy.asarray(joint.anchor, float) - parent.position)
            text += f'<connect body1="{joint.parent}" body2="{joint.child}" anchor="{numbers(place)}"/>'
    return text
