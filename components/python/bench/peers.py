"""The wall avoider in MuJoCo and in PyBullet: the same robot among the same walls, told and rewarded in the same way as
pongsim/WallAvoid-v0, with the same step of time and as many of them. For `tools/bench python`."""

import pathlib
import tempfile

import gymnasium
import mujoco
import numpy as np
import pybullet
from gymnasium import spaces

STEP, STEPS = 0.01, 5  # [s], of physics in a step of the environment
FAR, EPISODE = 10.0, 600
ANGLES = np.arange(64) * (2 * np.pi / 64) - np.pi
BEAMS = np.stack([np.cos(ANGLES), np.sin(ANGLES), np.zeros(64)], 1)
OUTLINE = np.minimum(1.0 / np.maximum(np.abs(np.cos(ANGLES)), 1e-9), 0.7 / np.maximum(np.abs(np.sin(ANGLES)), 1e-9))
TOO_NEAR = OUTLINE + 0.1
WHEEL, TRACK = 0.4, 1.2  # radius, distance [m]
# middle, half sizes [m]
WALLS = [((0, 6.1), (10.2, 0.1)), ((0, -6.1), (10.2, 0.1)), ((10.1, 0), (0.1, 6)), ((-10.1, 0), (0.1, 6)), ((0, 0), (2, 0.5))]


class Avoider(gymnasium.Env):
    """What both have in common."""

    observation_space = spaces.Box(0.0, FAR, (64,), np.float32)
    action_space = spaces.Box(np.float32([0, -1]), np.float32([1, 1]), dtype=np.float32)

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        random = self.np_random
        x = random.uniform(-7.0, 7.0)
        y = random.uniform(2.5, 4.0) * (1.0 if random.random() < 0.5 else -1.0)
        self.place(x, y, random.uniform(-np.pi, np.pi))
        self.count = 0
        self.advance(0.0, 0.0)
        return self.ranges().astype(np.float32), {}

    def step(self, action):
        ahead, turn = float(action[0]), float(action[1])
        side = turn * TRACK / 2
        self.advance((ahead - side) / WHEEL, (ahead + side) / WHEEL)
        ranges = self.ranges()
        hit = bool(np.logical_or.reduce(ranges < TOO_NEAR))
        reward = self.speed() * STEP * STEPS * (1 - abs(turn)) - 5.0 * hit
        self.count += 1
        return ranges.astype(np.float32), reward, hit, self.count >= EPISODE, {}


MJCF = """<mujoco><option timestep="{step}" integrator="implicitfast" cone="{cone}"/><worldbody>
 <geom type="plane" size="20 20 1"/>{walls}
 <body name="chassis" pos="0.5 0 0.4"><freejoint/>
  <inertial pos="0 0 0" mass="4" diaginertia="0.416667 1.41667 1.66667"/><geom type="box" size="1 0.5 0.25"/>
  <site name="lidar" pos="0 0 0.5"/>
  <body pos="-0.5 0.6 0" euler="-90 0 0"><joint name="left" axis="0 0 1"/>
   <inertial pos="0 0 0" mass="1.5" diaginertia="0.065 0.065 0.12"/><geom type="cylinder" size="0.4 0.1"/></body>
  <body pos="-0.5 -0.6 0" euler="-90 0 0"><joint name="right" axis="0 0 1"/>
   <inertial pos="0 0 0" mass="1.5" diaginertia="0.065 0.065 0.12"/><geom type="cylinder" size="0.4 0.1"/></body>
  <body pos="0.8 0 -0.2"><joint type="ball"/>
   <inertial pos="0 0 0" mass="0.5" diaginertia="0.008 0.008 0.008"/><geom type="sphere" size="0.2"/></body>
 </body></worldbody>
 <actuator><velocity joint="left" kv="50"/><velocity joint="right" kv="50"/></actuator></mujoco>"""


class InMuJoCo(Avoider):
    """Rays are cast once a step, all at once: rangefinders of the model would cast them in each step of physics. Its
    integrator is the one that its documentation advises; with the explicit one the wheels' motors are unstable. `cone`
    is that of friction: "pyramidal", as it comes, or "elliptic", which is dearer and does not favour directions."""

    def __init__(self, cone):
        walls = "".join(f'<geom type="box" pos="{x} {y} 0.5" size="{a} {b} 0.5"/>' for (x, y), (a, b) in WALLS)
        self.model = mujoco.MjModel.from_xml_string(MJCF.format(step=STEP, cone=cone, walls=walls))
        self.data = mujoco.MjData(self.model)
        self.hits, self.distances = np.zeros(64, np.int32), np.zeros(64)
        self.beams = BEAMS.copy()

    def place(self, x, y, yaw):
        mujoco.mj_resetData(self.model, self.data)
        # of the chassis, which is half a metre ahead of the axle
        self.data.qpos[:7] = x + 0.5 * np.cos(yaw), y + 0.5 * np.sin(yaw), 0.4, np.cos(yaw / 2), 0, 0, np.sin(yaw / 2)

    def advance(self, left, right):
        self.data.ctrl[0] = left
        self.data.ctrl[1] = right
        mujoco.mj_step(self.model, self.data, STEPS)

    def ranges(self):
        # those of the body itself are not met: the lidar looks over them
        mujoco.mj_kinematics(self.model, self.data)
        turned = self.beams @ self.data.site_xmat[0].reshape(3, 3).T
        mujoco.mj_multiRay(self.model, self.data, self.data.site_xpos[0], turned.ravel(), None, 1, 1, self.hits,
                           self.distances, None, 64, FAR)
        return np.where(self.distances < 0, FAR, np.minimum(self.distances, FAR))

    def speed(self):
        return float(self.data.qvel[:3] @ self.data.xmat[1].reshape(3, 3)[:, 0])


URDF = """<robot name="bot"><link name="chassis"><inertial><mass value="4"/>
  <inertia ixx="0.416667" iyy="1.41667" izz="1.66667" ixy="0" ixz="0" iyz="0"/></inertial>
  <collision><geometry><box size="2 1 0.5"/></geometry></collision></link>
 {wheels}
 <link name="caster"><inertial><mass value="0.5"/><inertia ixx="0.008" iyy="0.008" izz="0.008" ixy="0" ixz="0" iyz="0"/>
  </inertial><collision><geometry><sphere radius="0.2"/></geometry></collision></link>
 <joint name="ball" type="spherical"><parent link="chassis"/><child link="caster"/><origin xyz="0.8 0 -0.2"/></joint>
</robot>"""
WHEEL_URDF = """<link name="{name}"><inertial><mass value="1.5"/>
  <inertia ixx="0.065" iyy="0.065" izz="0.12" ixy="0" ixz="0" iyz="0"/></inertial>
  <collision><geometry><cylinder radius="0.4" length="0.2"/></geometry></collision></link>
 <joint name="j{name}" type="continuous"><parent link="chassis"/><child link="{name}"/>
  <origin xyz="-0.5 {y} 0" rpy="-1.5708 0 0"/><axis xyz="0 0 1"/></joint>"""


class InPyBullet(Avoider):
    """Without its window; its solver's settings are those that it comes with."""

    def __init__(self):
        self.client = pybullet.connect(pybullet.DIRECT)
        pybullet.setTimeStep(STEP)
        pybullet.setGravity(0, 0, -9.8)
        plane = pybullet.createCollisionShape(pybullet.GEOM_PLANE)
        pybullet.changeDynamics(pybullet.createMultiBody(0, plane), -1, lateralFriction=1.0)
        for (x, y), (a, b) in WALLS:
            shape = pybullet.createCollisionShape(pybullet.GEOM_BOX, halfExtents=(a, b, 0.5))
            pybullet.createMultiBody(0, shape, basePosition=(x, y, 0.5))
        wheels = WHEEL_URDF.format(name="left", y=0.6) + WHEEL_URDF.format(name="right", y=-0.6)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "bot.urdf")
            file.write_text(URDF.format(wheels=wheels))
            self.bot = pybullet.loadURDF(str(file), (0.5, 0, 0.4), flags=pybullet.URDF_USE_INERTIA_FROM_FILE)
        for link in range(3):
            pybullet.changeDynamics(self.bot, link, lateralFriction=1.0)
        pybullet.setJointMotorControlMultiDof(self.bot, 2, pybullet.POSITION_CONTROL, targetPosition=(0, 0, 0, 1),
                                              positionGain=0, velocityGain=0, force=(0, 0, 0))
        self.start = pybullet.saveState()

    def place(self, x, y, yaw):
        pybullet.restoreState(self.start)
        turn = (0, 0, np.sin(yaw / 2), np.cos(yaw / 2))
        pybullet.resetBasePositionAndOrientation(self.bot, (x + 0.5 * np.cos(yaw), y + 0.5 * np.sin(yaw), 0.4), turn)

    def advance(self, left, right):
        pybullet.setJointMotorControlArray(self.bot, (0, 1), pybullet.VELOCITY_CONTROL, targetVelocities=(left, right),
                                           forces=(1000, 1000))
        for _ in range(STEPS):
            pybullet.stepSimulation()

    def ranges(self):
        place, turn = pybullet.getBasePositionAndOrientation(self.bot)
        self.rotation = np.array(pybullet.getMatrixFromQuaternion(turn)).reshape(3, 3)
        eye = np.array(place) + self.rotation @ (0, 0, 0.5)
        ends = eye + FAR * (BEAMS @ self.rotation.T)
        found = pybullet.rayTestBatch(np.broadcast_to(eye, (64, 3)), ends, numThreads=1)
        return np.array([each[2] for each in found]) * FAR

    def speed(self):
        return float(np.array(pybullet.getBaseVelocity(self.bot)[0]) @ self.rotation[:, 0])

    def close(self):
        pybullet.disconnect(self.client)
