"""What a world consists of, and what of it can be changed without loading it again."""

import numpy as np
import pytest
from conftest import BALL, LIDAR

import pongsim

SLOPE = """<sdf version="1.9"><world name="w"><gravity>5 0 -10</gravity>
  <model name="ground"><static>true</static><link name="link"><collision name="c"><geometry><plane/></geometry><surface>
    <friction><ode><mu>1</mu><mu2>1</mu2></ode></friction></surface></collision></link></model>
  <model name="box"><pose>0 0 0.5 0 0 0</pose><link name="link"><inertial><mass>2</mass></inertial>
    <collision name="c"><geometry><box><size>1 1 1</size></box></geometry></collision></link></model>
  <model name="arm"><pose>0 5 3 0 0 0</pose>
    <link name="base"/><link name="rod"><inertial><pose>0.5 0 0 0 0 0</pose><mass>1</mass>
      <inertia><ixx>0.1</ixx><iyy>0.2</iyy><izz>0.3</izz></inertia></inertial></link>
    <joint name="fix" type="fixed"><parent>world</parent><child>base</child></joint>
    <joint name="hinge" type="revolute"><pose>0.1 0 0 0 0 0</pose><parent>base</parent><child>rod</child>
      <axis><xyz>0 0 1</xyz><limit><lower>-1</lower><upper>2</upper><effort>7</effort><velocity>3</velocity></limit>
      <dynamics><damping>0.25</damping><friction>0.5</friction></dynamics></axis></joint></model>
</world></sdf>"""


@pytest.fixture
def slope():
    with pongsim.Simulation(SLOPE) as simulation:
        yield simulation


def test_metadata(slope):
    hinge = slope.model("arm").joint("hinge")
    axis = hinge.axis()
    assert axis == pongsim.JointAxis((0, 0, 1), -1, 2, 7, 3, 0.25, 0.5)
    assert hinge.parent == slope.model("arm").link("base") and hinge.child == slope.model("arm").link("rod")
    assert slope.model("arm").joint("fix").parent is None
    assert hinge.pose_in_child.position == (0.1, 0, 0) and hinge.pose_in_parent.position == pytest.approx((0.1, 0, 0))
    with pytest.raises(IndexError, match="axis 1"):
        hinge.axis(1)
    rod = slope.model("arm").link("rod")
    assert rod.center_of_mass == (0.5, 0, 0) and np.array(rod.inertia) == pytest.approx(np.diag([0.1, 0.2, 0.3]))
    box, = slope.model("box").link("link").collisions
    assert (box.name, box.scoped_name, box.shape, box.size) == ("c", "box::link::c", "box", (1, 1, 1))
    assert box.pose_in_link == pongsim.Pose() and box.friction == (1, 1) and box.restitution == 0
    assert box == slope.model("box").link("link").collision("c")
    with pytest.raises(KeyError):
        slope.model("box").link("link").collision("d")


def test_metadata_of_sensors():
    with pongsim.Simulation(LIDAR) as sim:
        lidar = sim.sensor("lidar")
        link = sim.model("pong_bot").link(lidar.link_name.rpartition("::")[2])
        assert lidar.scoped_name in link.sensor_names
        assert set(lidar.topics) == set(lidar.kinds) and lidar.topics["ranges"] in sim.topics
        assert lidar.frame_name and lidar.pose_in_link.position and lidar.has_noise in (True, False)


def slides(sim):
    sim.step(1000)
    return sim.model("box").pose.position[0]


def test_friction(slope):
    # mu is 1 and the slope 1 : 2: it stays
    assert abs(slides(slope)) < 1e-3
    slope.reset()
    box = slope.model("box").link("link").collision("c")
    box.set_friction(0.25)
    assert box.friction == (0.25, 0.25)
    # a = 5 - 0.25 * 10
    assert slides(slope) == pytest.approx(0.5 * 2.5, rel=0.01)
    slope.reset()
    assert box.friction == (1, 1) and abs(slides(slope)) < 1e-3


def test_a_change_acts_on_what_touches_already(slope):
    slope.step(100)
    slope.model("box").link("link").collision("c").set_friction(0)
    x = slope.model("box").pose.position[0]
    slope.step(100)
    assert slope.model("box").pose.position[0] - x == pytest.approx(0.5 * 5 * 0.01, rel=0.05)


def test_mass_and_inertia(slope):
    slope.gravity = (0, 0, 0)
    link = slope.model("box").link("link")
    inertia = np.array(link.inertia)
    link.set_mass(8)
    assert link.mass == 8 and link.inertia_factor == 4 and np.array(link.inertia) == pytest.approx(4 * inertia)
    link.add_wrench((8, 0, 0), (0, 0, 2))
    slope.step()
    assert link.linear_velocity[0] == pytest.approx(0.001)
    assert link.angular_velocity[2] == pytest.approx(0.001 * 2 / (4 * inertia[2, 2]))
    link.set_mass(8, 1)
    assert np.array(link.inertia) == pytest.approx(inertia) and link.mass == 8
    # gravity accelerates it as before
    slope.reset()
    link.set_mass(100)
    slope.model("box").move((0, 0, 50))
    slope.step(100)
    assert link.linear_velocity == pytest.approx((0.5, 0, -1))
    slope.reset()
    assert link.mass == 2 and link.inertia_factor == 1


def test_restitution():
    with pongsim.Simulation(BALL) as sim:
        for model in ("ground", "ball"):
            sim.model(model).link("link").collision("c").set_restitution(1)
        heights = []
        for _ in range(1500):
            sim.step()
            heights.append(sim.model("ball").pose.position[2])
        assert max(heights[700:]) == pytest.approx(2, rel=0.02)


def test_damping_and_friction_of_joints(slope):
    hinge = slope.model("arm").joint("hinge")
    slope.gravity = (0, 0, 0)
    hinge.set_friction(0)
    hinge.set_damping(0)
    hinge.reset(velocity=0.5)
    slope.step(100)
    assert hinge.velocity() == pytest.approx(0.5, rel=1e-6)
    hinge.set_damping(2)
    assert hinge.axis().damping == 2 and hinge.axis().friction == 0
    slope.step(200)
    assert hinge.velocity() < 0.3
    slope.reset()
    assert hinge.axis().damping == 0.25 and hinge.axis().friction == 0.5


def change(sim):
    sim.model("box").link("link").set_mass(3, 2)
    sim.model("box").link("link").collision("c").set_friction(0.2, 0.1)
    sim.model("ground").link("link").collision("c").set_restitution(0.5)
    sim.model("arm").joint("hinge").set_damping(0.125)
    sim.model("arm").joint("hinge").set_friction(0.0625)


def test_changes_are_saved_and_restored(slope):
    start = slope.save()
    slope.step(200)
    plain = slope.state_hash()
    slope.reset()
    change(slope)
    slope.step(100)
    state = slope.save()
    slope.step(100)
    expected = slope.state_hash()
    assert expected != plain
    # into another simulation, too
    with pongsim.Simulation(SLOPE) as other:
        for sim in (slope, other):
            sim.restore(state)
            assert sim.model("box").link("link").mass == 3
            assert sim.model("box").link("link").collision("c").friction == (0.2, 0.1)
            assert sim.model("arm").joint("hinge").axis()[-2:] == (0.125, 0.0625)
            assert sim.save() == state
            sim.step(100)
            assert sim.state_hash() == expected
            sim.restore(start)
            assert sim.model("box").link("link").mass == 2
            sim.step(200)
            assert sim.state_hash() == plain


def test_impossible_properties_are_refused_and_change_nothing(slope):
    before = slope.save()
    link, collision, hinge = (slope.model("box").link("link"), slope.model("box").link("link").collision("c"),
                              slope.model("arm").joint("hinge"))
    for bad in (0, -1, np.nan, np.inf, 1e300):
        for call in (lambda: link.set_mass(bad), lambda: link.set_mass(1, bad)):
            with pytest.raises(pongsim.Refused, match="box::link"):
                call()
    for bad in (-1, np.nan, np.inf):
        for call in (lambda: collision.set_friction(bad), lambda: collision.set_friction(1, bad),
                     lambda: collision.set_restitution(bad), lambda: hinge.set_damping(bad), lambda: hinge.set_friction(bad)):
            with pytest.raises(pongsim.Refused):
                call()
    with pytest.raises(pongsim.Refused, match="does not move"):
        slope.model("ground").link("link").set_mass(1)
    with pytest.raises(IndexError):
        hinge.set_damping(1, 1)
    assert slope.save() == before


def test_not_within_a_step():
    class Changes(pongsim.System):
        def update(self, info):
            self.sim.model("ball").link("link").set_mass(1)

    with pongsim.Simulation(BALL, systems=[Changes()], strict=True) as sim:
        with pytest.raises(pongsim.SystemFailed, match="Busy"):
            sim.step()
