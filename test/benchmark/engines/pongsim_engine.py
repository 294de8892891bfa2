"""pongsim as a whole, systems included, in this process."""

import pongsim

NAME = "pongsim"


class Engine:
    def __init__(self, scene, step):
        text = sdf_of(scene, step)
        pongsim.set_log_level(0)
        self.world = pongsim.Simulation(text)
        self.links = {}
        for model in self.world.models:
            for link in model.links:
                self.links.setdefault(link.name, link)
        for body in scene.bodies:
            if any(body.velocity) or any(body.turning):
                self.links[body.name].set_velocity(body.velocity, body.turning)
        for joint in scene.joints:
            if joint.drive is not None and not scene.message:
                self.world.model(scene.model_of(scene.body(joint.child))).joint(joint.name).drive(joint.drive)
        if scene.message:
            self.world.publish(*scene.message)

    def step(self, count):
        self.world.step(count)

    def body(self, name):
        """Position, orientation w x y z, velocity and angular velocity."""
        link = self.links[name]
        x, y, z, w = link.pose.orientation
        return link.pose.position, (w, x, y, z), link.linear_velocity, link.angular_velocity

    def close(self):
        self.world.close()


def numbers(values):
    return " ".join(repr(float(value)) for value in values)


def geometry_of(shape):
    kind, *size = shape
    if kind == "box":
        inner = f"<size>{numbers(size)}</size>"
    elif kind == "sphere":
        inner = f"<radius>{size[0]!r}</radius>"
    elif kind == "cylinder":
        inner = f"<radius>{size[0]!r}</radius><length>{size[1]!r}</length>"
    else:
        inner = f"<radii>{numbers(size)}</radii>"
    return f"<geometry><{kind}>{inner}</{kind}></geometry>"


def link_of(body, surface):
    w, x, y, z = body.rotation
    collision = ""
    if body.shape:
        collision = f"<collision name='collision'>{geometry_of(body.shape)}{surface}</collision>"
    ixx, iyy, izz = body.moments
    return (
        f"<link name='{body.name}'><pose rotation_format='quat_xyzw'>{numbers((*body.position, x, y, z, w))}</pose>"
        f"<inertial><mass>{body.mass!r}</mass><inertia><ixx>{ixx!r}</ixx><iyy>{iyy!r}</iyy><izz>{izz!r}</izz>"
        f"</inertia></inertial>{collision}</link>"
    )


def joint_of(joint):
    kind = {"hinge": "revolute", "ball": "ball", "slide": "prismatic"}[joint.kind]
    axis = ""
    if joint.kind != "ball":
        axis = f"<axis><xyz expressed_in='__model__'>{numbers(joint.axis)}</xyz></axis>"
    return (
        f"<joint name='{joint.name}' type='{kind}'><pose relative_to='__model__'>{numbers(joint.anchor)} 0 0 0</pose>"
        f"<parent>{joint.parent or 'world'}</parent><child>{joint.child}</child>{axis}</joint>"
    )


def sdf_of(scene, step):
    mu = f"<mu>{scene.friction}</mu><mu2>{scene.friction}</mu2>"
    surface = (
        f"<surface><friction><ode>{mu}</ode></friction><bounce><restitution_coefficient>{scene.restitution}"
        "</restitution_coefficient></bounce></surface>"
    )
    models = {}
    for body in scene.bodies:
        models.setdefault(scene.model_of(body), []).append(link_of(body, surface))
    for joint in scene.joints:
        models[scene.model_of(scene.body(joint.child))].append(joint_of(joint))
    text = "".join(
        f"<model name='{name}'>{''.join(parts)}{scene.model_systems.get(name, '')}</model>"
        for name, parts in models.items()
    )
    if scene.ground:
        text += (
            "<model name='ground'><static>true</static><link name='ground'><collision name='collision'><geometry>"
            f"<plane><normal>0 0 1</normal></plane></geometry>{surface}</collision></link></model>"
        )
    return (
        f"<sdf version='1.9'><world name='scene'><gravity>{numbers(scene.gravity)}</gravity><physics name='p' type='p'>"
        f"<max_step_size>{step!r}</max_step_size></physics><plugin filename='ignition-gazebo-physics-system' "
        f"name='ignition::gazebo::systems::Physics'/>{scene.systems}{text}</world></sdf>"
    )
