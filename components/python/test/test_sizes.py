"""Sizes of simple shapes that are changed without loading the world again."""

import pickle

import numpy as np
import pytest

import pongsim

# a ball on a ground, seen from above by a camera and a lidar, and all other shapes
WORLD = """<sdf version="1.9"><world name="w">
  <plugin filename="ignition-gazebo-physics-system" name="ignition::gazebo::systems::Physics"/>
  <plugin filename="ignition-gazebo-sensors-system" name="ignition::gazebo::systems::Sensors"/>
  <scene><ambient>1 1 1 1</ambient><background>0 0 1 1</background></scene>
  <model name="ground"><static>true</static><link name="l"><collision name="c"><geometry><plane/></geometry></collision></link>
  </model>
  <model name="ball"><pose>0 0 0.5 0 0 0</pose><link name="l">
    <inertial><mass>2</mass><inertia><ixx>0.2</ixx><iyy>0.2</iyy><izz>0.2</izz></inertia></inertial>
    <collision name="c"><geometry><sphere><radius>0.5</radius></sphere></geometry></collision>
    <visual name="v"><geometry><sphere><radius>0.5</radius></sphere></geometry>
      <material><ambient>1 0 0 1</ambient></material></visual></link></model>
  <model name="shelf"><static>true</static><pose>20 0 0 0 0 0</pose><link name="l">
    <collision name="box"><geometry><box><size>1 2 3</size></box></geometry></collision>
    <collision name="cylinder"><geometry><cylinder><radius>1</radius><length>2</length></cylinder></geometry></collision>
    <collision name="capsule"><geometry><capsule><radius>1</radius><length>2</length></capsule></geometry></collision>
    <collision name="ellipsoid"><geometry><ellipsoid><radii>1 2 3</radii></ellipsoid></geometry></collision></link></model>
  <model name="mast"><static>true</static><pose>0 0 6 0 1.5707963 0</pose><link name="l">
    <sensor name="eye" type="camera"><camera><horizontal_fov>1.0</horizontal_fov><image><width>64</width><height>48</height>
      </image></camera></sensor>
    <sensor name="beam" type="gpu_lidar"><update_rate>100</update_rate><lidar><scan><horizontal><samples>1</samples>
      <min_angle>0</min_angle><max_angle>0</max_angle></horizontal></scan><range><min>0.1</min><max>20</max></range></lidar>
      </sensor></link></model></world></sdf>"""


@pytest.fixture
def sim():
    with pongsim.Simulation(WORLD) as simulation:
        yield simulation


def skin(sim):
    return sim.model("ball").link("l").collision("c")


def redness(sim):
    picture = sim.render("eye").astype(int)
    return int((picture[:, :, 0] > picture[:, :, 2]).sum())


def test_a_ball_that_grows_rests_higher_and_is_seen(sim):
    sim.step(100)
    small = redness(sim)
    beam = sim.sensor("beam")
    skin(sim).set_size(1.0)
    assert skin(sim).size == (1.0,) and sim.model("ball").link("l").visual_size("v") == (1.0,)
    sim.model("ball").move((0, 0, 1.01))
    sim.step(1000)
    assert sim.model("ball").pose.position[2] == pytest.approx(1, abs=1e-3)
    assert redness(sim) > 3 * small
    assert beam.ranges[0] == pytest.approx(4, abs=0.01)
    assert sim.raycast((0, 0, 6), (0, 0, -1)).distance == pytest.approx(4, abs=0.01)
    assert sim.model("ball").link("l").mass == 2
    sim.reset()
    assert skin(sim).size == (0.5,) and redness(sim) == small
    sim.step(100)
    assert sim.raycast((0, 0, 6), (0, 0, -1)).distance == pytest.approx(5, abs=0.01)


def test_the_visual_alone(sim):
    link = sim.model("ball").link("l")
    link.set_visual_size("v", 0.75)
    skin(sim).set_size((0.4,), visuals=False)
    assert link.visual_size("v") == (0.75,) and skin(sim).size == (0.4,)
    # not of the same size any more: it does not follow
    skin(sim).set_size(0.6)
    assert link.visual_size("v") == (0.75,)


def test_the_mass_follows_on_request(sim):
    link = sim.model("ball").link("l")
    skin(sim).set_size(1.0, mass=True)
    assert link.mass == pytest.approx(16) and np.array(link.inertia) == pytest.approx(np.diag([6.4] * 3))
    link.set_mass(8)
    assert np.array(link.inertia) == pytest.approx(np.diag([3.2] * 3))


@pytest.mark.parametrize("shape, size", [
    ("box", (4, 3, 4)), ("cylinder", (2, 3)), ("capsule", (2, 3)), ("ellipsoid", (2, 3, 4)),
])
def test_each_shape(sim, shape, size):
    collision = sim.model("shelf").link("l").collision(shape)
    before = sim.save()
    collision.set_size(size)
    assert collision.size == size and collision.shape == shape
    # touches where the shapes of the file do not
    def touches():
        sim.model("ball").move((21.9, 0, 0.5))
        sim.step()
        return any("shelf" in each for pair in sim.contacts().names for each in pair)

    assert touches()
    sim.restore(before)
    assert collision.size != size and not touches()


def test_saved_states_and_copies_have_it(sim):
    start = sim.save()
    sim.step(50)
    plain = sim.state_hash()
    sim.reset()
    skin(sim).set_size(0.8, mass=True)
    sim.step(50)
    state, seen = sim.save(), redness(sim)
    sim.step(50)
    expected = sim.state_hash()
    copy = pickle.loads(pickle.dumps(sim))
    assert skin(copy).size == (0.8,) and copy.state_hash() == expected
    with pongsim.Simulation(WORLD) as other:
        for each in (sim, other):
            each.restore(state)
            assert each.save() == state and redness(each) == seen
            each.step(50)
            assert each.state_hash() == expected
            each.restore(start)
            assert skin(each).size == (0.5,) and each.model("ball").link("l").mass == 2
            each.step(50)
            assert each.state_hash() == plain


def test_of_models_that_come_and_go(sim):
    text = WORLD[WORLD.index('<model name="ball">'):WORLD.index('<model name="shelf">')].replace('"ball"', '"new"')
    for _ in range(3):
        new = sim.insert(f"<sdf version='1.9'>{text}</sdf>", pose=(5, 0, 0.5))
        collision = new.link("l").collision("c")
        collision.set_size(0.7)
        new.move((5, 0, 0.71))
        sim.step(1000)
        assert new.pose.position[2] == pytest.approx(0.7, abs=1e-3)
        sim.remove(new)
        sim.step(10)
        with pytest.raises(pongsim.Gone):
            collision.set_size(1)
    assert skin(sim).size == (0.5,)


def test_a_system_knows_of_it(sim):
    class Watches(pongsim.System):
        changes = 0

        def world_changed(self):
            self.changes += 1

    watches = Watches()
    sim.add(watches)
    sim.step()
    before = watches.changes
    skin(sim).set_size(0.5)
    sim.step()
    assert watches.changes == before
    skin(sim).set_size(0.6)
    sim.step()
    assert watches.changes == before + 1


def test_what_is_wrong_is_told_and_changes_nothing(sim):
    before = sim.save()
    for bad in (0, -1, np.nan, np.inf, 1e300):
        with pytest.raises(pongsim.Refused, match="the size of collision 'ball::l::c' must be 1e-06 m to 1e.09 m, not"):
            skin(sim).set_size(bad)
    with pytest.raises(pongsim.Refused, match="has 1 number, not 3"):
        skin(sim).set_size((1, 1, 1))
    with pytest.raises(TypeError, match="a size must be a number, or several in a tuple, not str"):
        skin(sim).set_size("big")
    with pytest.raises(pongsim.Refused, match="it is no box, sphere, cylinder, capsule or ellipsoid"):
        sim.model("ground").link("l").collision("c").set_size(1)
    with pytest.raises(pongsim.Refused, match="the link does not move"):
        sim.model("shelf").link("l").collision("box").set_size((1, 1, 1), mass=True)
    with pytest.raises(KeyError, match="link 'ball::l' has no visual 'w'"):
        sim.model("ball").link("l").set_visual_size("w", 1)
    with pytest.raises(KeyError, match="link 'shelf::l' has no collision 'boxx'; did you mean 'box'"):
        sim.model("shelf").link("l").collision("boxx")
    assert sim.save() == before
