"""Jacobians, mass matrices, bias forces and inverse dynamics, beside MuJoCo's and the simulation's own steps."""

import mujoco
import numpy as np
import pytest

import pongsim

# name, parent, joint, axis, x y z and roll pitch yaw of the link frame in the parent's, mass, centre, moments and products
LINKS = [
    ("trunk", None, None, None, None, 4.0, (0.05, -0.02, 0.1), (0.2, 0.3, 0.25, 0.01, -0.02, 0.03)),
    ("thigh", "trunk", "revolute", (0, 1, 0), (0.1, 0.2, -0.1, 0.1, -0.2, 0.3), 1.5, (0.0, 0.01, -0.2), (0.03, 0.03, 0.01, 0, 0, 0)),
    ("shin", "thigh", "continuous", (0.6, 0, 0.8), (0, 0.02, -0.4, 0, 0.4, 0), 0.8, (0.01, 0, -0.2), (0.02, 0.02, 0.005, 0.001, 0, 0)),
    ("rod", "trunk", "prismatic", (0, 0.8, 0.6), (0.3, 0, 0.1, 0.2, 0, 0), 0.5, (0, 0, 0.1), (0.004, 0.004, 0.001, 0, 0, 0)),
    ("hand", "rod", "revolute", (1, 0, 0), (0, 0.1, 0.2, 0, 0, 1.0), 0.3, (0.03, 0, 0), (0.001, 0.002, 0.002, 0, 0, 0)),
]


def urdf(is_free):
    """The robot, on the world or free."""
    text = '<robot name="robot"><mujoco><compiler fusestatic="false"/></mujoco>'
    if not is_free:
        text += '<link name="world"/><joint name="foot" type="revolute"><parent link="world"/><child link="trunk"/>' \
                '<origin xyz="0.1 0 1" rpy="0 0.3 0"/><axis xyz="0 0 1"/><limit lower="-9" upper="9" effort="1" velocity="1"/></joint>'
    for name, parent, kind, axis, place, mass, centre, inertia in LINKS:
        xx, yy, zz, xy, xz, yz = inertia
        text += f'<link name="{name}"><inertial><origin xyz="{" ".join(map(str, centre))}"/><mass value="{mass}"/>' \
                f'<inertia ixx="{xx}" iyy="{yy}" izz="{zz}" ixy="{xy}" ixz="{xz}" iyz="{yz}"/></inertial></link>'
        if parent is None:
            continue
        x, y, z, roll, pitch, yaw = place
        text += f'<joint name="{name}_joint" type="{kind}"><parent link="{parent}"/><child link="{name}"/>' \
                f'<origin xyz="{x} {y} {z}" rpy="{roll} {pitch} {yaw}"/><axis xyz="{" ".join(map(str, axis))}"/>' \
                '<limit lower="-9" upper="9" effort="100" velocity="100"/></joint>'
    return text + "</robot>"


class Peer:
    """The robot in MuJoCo, with velocities in the order and form of pongsim's."""

    def __init__(self, text, is_free, sim):
        spec = mujoco.MjSpec.from_string(text)
        if is_free:
            next(body for body in spec.bodies if body.name == "trunk").add_freejoint()
        self.model = spec.compile()
        self.model.opt.gravity[:] = sim.gravity
        self.model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONTACT
        self.data = mujoco.MjData(self.model)
        layout, size = sim.layout, sim.qvel.size
        #: From pongsim's velocities to MuJoCo's.
        self.turn = np.zeros((self.model.nv, size))
        for i in range(self.model.njnt):
            joint = self.model.joint(i)
            if joint.type[0] != mujoco.mjtJoint.mjJNT_FREE:
                self.data.qpos[joint.qposadr[0]] = sim.qpos[layout.qpos[f"robot::{joint.name}"]][0]
                self.turn[joint.dofadr[0], layout.qvel[f"robot::{joint.name}"].start] = 1
                continue
            x, y, z, qx, qy, qz, qw = sim.qpos[layout.qpos["robot"]]
            self.data.qpos[joint.qposadr[0] : joint.qposadr[0] + 7] = x, y, z, qw, qx, qy, qz
            rotation = np.zeros(9)
            mujoco.mju_quat2Mat(rotation, np.array([qw, qx, qy, qz]))
            self.turn[0:3, 0:3] = np.eye(3)
            self.turn[3:6, 3:6] = rotation.reshape(3, 3).T
        self.data.qvel[:] = self.turn @ sim.qvel
        mujoco.mj_forward(self.model, self.data)

    def mass_matrix(self):
        full = np.zeros((self.model.nv, self.model.nv))
        mujoco.mj_fullM(self.model, self.data, full)
        return self.turn.T @ full @ self.turn

    def bias_forces(self):
        return self.turn.T @ self.data.qfrc_bias

    def jacobian(self, link, point):
        body = self.data.body(link)
        where = body.xpos + body.xmat.reshape(3, 3) @ point
        linear, angular = np.zeros((3, self.model.nv)), np.zeros((3, self.model.nv))
        mujoco.mj_jac(self.model, self.data, linear, angular, where, self.model.body(link).id)
        return np.vstack([linear, angular]) @ self.turn


def moving(text, seed=3):
    """A simulation of the model in a random state."""
    sim = pongsim.Simulation(text)
    random = np.random.default_rng(seed)
    qpos = sim.qpos + random.uniform(-1, 1, sim.qpos.size)
    qvel = random.uniform(-2, 2, sim.qvel.size)
    free = [name for name, place in sim.layout.qpos.items() if place.stop - place.start == 7]
    if len(free) > 1:
        # one of several in a model can't be set by the vectors
        for what in ("position", "velocity"):
            for joint in sim.models[-1].joints:
                for axis in range(joint.axis_count):
                    joint.reset(**{what: random.uniform(-1, 1)}, axis=axis)
        sim.models[-1].set_velocity((1, 2, -1), (0.5, 2, 1))
        sim.models[-1].link("lone").set_velocity((0, 1, 2), (-1, 3, 0.5))
        return sim
    for name in free:
        quaternion = qpos[sim.layout.qpos[name]][3:]
        quaternion /= np.linalg.norm(quaternion)
    sim.set_state(qpos, qvel)
    return sim


@pytest.mark.parametrize("is_free", [True, False])
@pytest.mark.parametrize("seed", [1, 2])
def test_it_is_as_in_mujoco(is_free, seed):
    text = urdf(is_free)
    with moving(text, seed) as sim:
        peer = Peer(text, is_free, sim)
        robot = sim.model("robot")
        assert robot.mass_matrix() == pytest.approx(peer.mass_matrix(), abs=1e-9)
        assert robot.bias_forces() == pytest.approx(peer.bias_forces(), abs=1e-8)
        accelerations = np.random.default_rng(seed).uniform(-5, 5, sim.qvel.size)
        expected = peer.mass_matrix() @ accelerations + peer.bias_forces()
        assert robot.inverse_dynamics(accelerations) == pytest.approx(expected, abs=1e-8)
        for link, point in (("hand", (0.1, -0.2, 0.3)), ("trunk", (0.0, 0.0, 0.0)), ("shin", (0.0, 0.0, -0.4))):
            assert robot.link(link).jacobian(point) == pytest.approx(peer.jacobian(link, np.array(point)), abs=1e-9)


# joints of two axes, a tree that leads from children to parents, parts that nothing connects, a nested model
ODD = """<sdf version="1.9"><model name="odd"><pose>1 2 3 0.1 0.2 0.3</pose>
  <link name="a"><pose>0.1 0 0 0 0 0.4</pose>INERTIA</link>
  <link name="b"><pose>0.5 0.1 0 0.2 0 0</pose>INERTIA</link>
  <link name="c"><pose>0 0.7 0 0 0.3 0</pose>INERTIA</link>
  <link name="lone"><pose>0 0 5 0 0 0</pose>INERTIA</link>
  <model name="inner"><pose>0 0 1 0 0 0</pose><link name="d">INERTIA</link></model>
  <joint name="cardan" type="universal"><parent>b</parent><child>a</child>
    <axis><xyz>1 0 0</xyz></axis><axis2><xyz>0 0.6 0.8</xyz></axis2></joint>
  <joint name="hinge" type="revolute"><parent>c</parent><child>b</child><axis><xyz>0 0 1</xyz></axis></joint>
  <joint name="weld" type="fixed"><parent>c</parent><child>inner::d</child></joint></model></sdf>""".replace(
    "INERTIA", "<inertial><pose>0.05 0.02 -0.1 0 0 0.5</pose><mass>1.3</mass><inertia><ixx>0.02</ixx><iyy>0.03</iyy>"
    "<izz>0.035</izz><ixy>0.001</ixy></inertia></inertial>")


def test_it_is_as_the_simulation_moves():
    for text in (ODD, urdf(True), urdf(False)):
        with moving(text) as sim:
            model = sim.models[-1]
            velocities = sim.qvel.copy()
            links = [link for each in (model, *model.models) for link in each.links]
            energy = 0.0
            for link in links:
                J = link.jacobian()
                assert J[:3] @ velocities == pytest.approx(link.linear_velocity, abs=1e-9)
                assert J[3:] @ velocities == pytest.approx(link.angular_velocity, abs=1e-9)
                centre = link.jacobian(link.center_of_mass) @ velocities
                x, y, z, w = link.pose.orientation
                R = np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                              [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                              [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])
                energy += link.mass * centre[:3] @ centre[:3] / 2 + centre[3:] @ (R @ link.inertia @ R.T) @ centre[3:] / 2
            M = model.mass_matrix()
            assert velocities @ M @ velocities / 2 == pytest.approx(energy)
            accelerations = -np.linalg.solve(M, model.bias_forces())
            assert np.abs(model.inverse_dynamics(accelerations)).max() < 1e-9
            # velocities are means over steps, so between the one before and the one after are two; what is left is of the
            # order of a step's length
            sim.step(3)
            before = sim.qvel.copy()
            sim.step()
            accelerations = -np.linalg.solve(model.mass_matrix(), model.bias_forces())
            sim.step()
            moved = (sim.qvel - before) / (2 * sim.step_size)
            assert moved == pytest.approx(accelerations, abs=2e-3 * np.abs(accelerations).max())


def test_changed_masses_count():
    with moving(urdf(True)) as sim:
        robot = sim.model("robot")
        before = robot.mass_matrix()
        robot.link("hand").set_mass(0.6)
        J = robot.link("hand").jacobian(robot.link("hand").center_of_mass)
        after = robot.mass_matrix()
        assert np.trace(after[:3, :3] - before[:3, :3]) == pytest.approx(3 * 0.3)
        assert (J.T @ (0.6 / 2 * np.r_[0, 0, 9.8, 0, 0, 0]))[2] == pytest.approx(0.3 * 9.8)


@pytest.mark.parametrize("kind, text", [("ball", "is a ball"), ("screw", "is a screw")])
def test_what_it_is_not_written_for_is_refused(kind, text):
    world = ODD.replace('type="revolute"', f'type="{kind}"')
    with pongsim.Simulation(world) as sim, pytest.raises(pongsim.Refused, match=f"odd::hinge.*{text}"):
        sim.model("odd").mass_matrix()


def test_loops_and_mistakes_are_told_of():
    loop = ODD.replace("</model></sdf>", '<joint name="again" type="fixed"><parent>a</parent><child>c</child></joint></model></sdf>')
    with pongsim.Simulation(loop) as sim, pytest.raises(pongsim.Refused, match="closes a loop"):
        sim.model("odd").bias_forces()
    with pongsim.Simulation(urdf(True)) as sim:
        robot = sim.model("robot")
        for wrong in ([0.0], np.zeros(11), [np.nan] * 10):
            with pytest.raises(ValueError):
                robot.inverse_dynamics(wrong)
        ground = sim.model("ground_plane")
        assert ground.mass_matrix().shape == (0, 0) and ground.links[0].jacobian().shape == (6, 0)
    with pongsim.Simulation(ODD) as sim, pytest.raises(ValueError, match="nested"):
        sim.model("odd::inner").mass_matrix()
