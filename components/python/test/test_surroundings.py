"""Contacts and rays."""

import numpy as np
import pytest
from conftest import BALL

import pongsim

# a ball of 2 kg rests on the ground; boxes stand on x and y; a wall is visible to few
SCENE = """<sdf version="1.9"><world name="w"><gravity>0 0 -10</gravity>
  <model name="ground"><static>true</static><link name="link"><collision name="c"><geometry><plane/></geometry></collision>
  </link></model>
  <model name="ball"><pose>0 0 0.5 0 0 0</pose><link name="link"><inertial><mass>2</mass></inertial>
    <collision name="c"><geometry><sphere><radius>0.5</radius></sphere></geometry></collision></link></model>
  <model name="east"><pose>4 0 1 0 0 0</pose><static>true</static><link name="link"><visual name="v"><geometry>
    <box><size>1 1 1</size></box></geometry></visual></link></model>
  <model name="north"><pose>0 6 1 0 0 0</pose><link name="link"><gravity>false</gravity><visual name="v"><geometry>
    <box><size>2 2 2</size></box></geometry></visual></link></model>
  <model name="veil"><pose>2 0 1 0 0 0</pose><static>true</static><link name="link"><visual name="v">
    <visibility_flags>2</visibility_flags><geometry><box><size>0.1 9 9</size></box></geometry></visual></link></model>
</world></sdf>"""


@pytest.fixture
def scene():
    with pongsim.Simulation(SCENE) as simulation:
        yield simulation


def test_contacts_are_arrays(scene):
    assert scene.contacts().names == [] and scene.contacts().points.shape == (0, 3)
    scene.step(500)
    contacts = scene.contacts()
    assert contacts.names == [("ground::link::c", "ball::link::c")] or contacts.names == [("ball::link::c", "ground::link::c")]
    assert contacts.ids.shape == (1, 2) and contacts.ids.dtype == np.uint64
    assert contacts.points[0] == pytest.approx([0, 0, 0], abs=1e-3)
    # on the first collision, out of the second into the first
    up = 1 if contacts.names[0][0].startswith("ball") else -1
    assert contacts.normals[0] == pytest.approx([0, 0, up])
    assert contacts.forces[0] == pytest.approx([0, 0, up * 20], abs=1e-3)
    assert 0 <= contacts.depths[0] < 1e-3
    by_handle = scene.model("ball").link("link").collision("c")
    assert by_handle.id in contacts.ids[0]
    # they are saved with the state
    state = scene.save()
    scene.model("ball").move((0, 0, 3))
    scene.step()
    assert len(scene.contacts().names) == 0
    scene.restore(state)
    assert scene.contacts().forces.tolist() == contacts.forces.tolist()


def test_a_ray(scene):
    hit = scene.raycast((0, 0, 1), (1, 0, 0), visibility_mask=1)
    assert hit.distance == pytest.approx(3.5) and hit.link == "east::link"
    assert hit.point == pytest.approx([3.5, 0, 1])
    # of any length
    assert scene.raycast((0, 0, 1), (10, 0, 0)).link == "veil::link"
    assert scene.raycast((0, 0, 1), (1, 0, 0), 3, visibility_mask=1) .link is None
    nothing = scene.raycast((0, 0, 1), (-1, 0, 0))
    assert nothing.distance == np.inf and nothing.link is None
    for origin, direction in (((0, 0, np.nan), (1, 0, 0)), ((0, 0, 0), (0, 0, 0)), ((0, 0, 0), (np.inf, 0, 0))):
        with pytest.raises(ValueError, match="finite"):
            scene.raycast(origin, direction)
    with pytest.raises(ValueError, match="shape"):
        scene.raycast((0, 0), (1, 0, 0))


def test_many_rays(scene):
    angles = np.linspace(0, 2 * np.pi, 360, endpoint=False)
    directions = np.stack([np.cos(angles), np.sin(angles), np.zeros(360)], axis=1)
    hits = scene.raycasts((0, 0, 1), directions, visibility_mask=1)
    assert hits.distances.shape == (360,) and hits.points.shape == (360, 3) and len(hits.links) == 360
    assert hits.links[0] == "east::link" and hits.links[90] == "north::link" and hits.links[180] is None
    assert hits.distances[[0, 90]] == pytest.approx([3.5, 5])
    one_by_one = [scene.raycast((0, 0, 1), each, visibility_mask=1) for each in directions]
    assert [each.distance for each in one_by_one] == hits.distances.tolist()
    assert [each.link for each in one_by_one] == hits.links
    # other origins
    assert scene.raycasts([(0, 0, 1), (0, 0, 1.2)], (0, 1, 0)).links == ["north::link"] * 2


def test_rays_see_what_has_moved_and_what_is_new(scene):
    scene.model("north").move((0, 10, 1))
    assert scene.raycast((0, 0, 1), (0, 1, 0)).distance == pytest.approx(9)
    box = scene.insert("<sdf version='1.9'><model name='box'><static>true</static><link name='l'><visual name='v'>"
                       "<geometry><box><size>1 1 1</size></box></geometry></visual></link></model></sdf>", pose=(0, 3, 1))
    assert scene.raycast((0, 0, 1), (0, 1, 0)).link == "box::l"
    scene.remove(box)
    assert scene.raycast((0, 0, 1), (0, 1, 0)).link == "north::link"
    scene.reset()
    assert scene.raycast((0, 0, 1), (0, 1, 0)).distance == pytest.approx(5)


def test_rays_change_nothing():
    with pongsim.Simulation(BALL) as sim:
        sim.step(100)
        expected = sim.state_hash()
        sim.reset()
        for _ in range(100):
            sim.raycast((0, 0, 5), (0, 0, -1))
            sim.contacts()
            sim.step()
        assert sim.state_hash() == expected
