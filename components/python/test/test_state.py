"""The state as vectors, and what sets it all at once."""

import numpy as np
import pytest
from conftest import BALL, COURT

import pongsim

# a cart that slides, with an arm of two joints on it; a double hinge; two loose links in a model
MANY = """<sdf version="1.9"><world name="w"><gravity>0 0 0</gravity>
  <model name="cart"><pose>0 1 1 0 0 0.5</pose>
    <link name="body"/>
    <link name="upper"><pose>0 0 0.5 0 0 0</pose></link>
    <link name="lower"><pose>0 0 1.5 0 0 0</pose></link>
    <joint name="shoulder" type="revolute"><parent>body</parent><child>upper</child><axis><xyz>0 1 0</xyz></axis></joint>
    <joint name="slide" type="prismatic"><parent>upper</parent><child>lower</child><axis><xyz>0 0 1</xyz></axis></joint>
  </model>
  <model name="cross"><pose>4 0 1 0 0 0</pose>
    <link name="a"/><link name="b"/>
    <joint name="fix" type="fixed"><parent>world</parent><child>a</child></joint>
    <joint name="fork" type="universal"><parent>a</parent><child>b</child>
      <axis><xyz>1 0 0</xyz></axis><axis2><xyz>0 1 0</xyz></axis2></joint></model>
  <model name="pair"><pose>-4 0 1 0 0 0</pose><link name="one"/><link name="two"><pose>0 2 0 0 0 0</pose></link></model>
  <model name="wall"><static>true</static><pose>9 0 0 0 0 0</pose><link name="l"/></model>
</world></sdf>"""


@pytest.fixture
def many():
    with pongsim.Simulation(MANY) as simulation:
        yield simulation


def test_the_numbers_have_names_and_places(many):
    layout = many.layout
    assert list(layout.qpos) == ["cart", "cart::shoulder", "cart::slide", "cross::fork", "pair::one", "pair::two"]
    assert layout.qpos["cart"] == slice(0, 7) and layout.qvel["cart"] == slice(0, 6)
    assert layout.qpos["cross::fork"] == slice(9, 11) and layout.qvel["cross::fork"] == slice(8, 10)
    assert layout.qpos_names[6:11] == ["cart.qw", "cart::shoulder", "cart::slide", "cross::fork", "cross::fork#1"]
    assert layout.qvel_names[4:8] == ["cart.wy", "cart.wz", "cart::shoulder", "cart::slide"]
    assert len(layout.qpos_names) == many.qpos.size == 7 + 4 + 14
    assert len(layout.qvel_names) == many.qvel.size == 6 + 4 + 12
    assert many.qpos[layout.qpos["cart"]] == pytest.approx([0, 1, 1, 0, 0, np.sin(0.25), np.cos(0.25)])


def random_state(simulation, seed):
    random = np.random.default_rng(seed)
    qpos, qvel = random.uniform(-1, 1, simulation.qpos.size), random.uniform(-1, 1, simulation.qvel.size)
    for name, place in simulation.layout.qpos.items():
        if place.stop - place.start == 7:
            qpos[place][3:] /= np.linalg.norm(qpos[place][3:])
    return qpos, qvel


def test_what_is_set_is_read(many):
    for seed in range(5):
        qpos, qvel = random_state(many, seed)
        many.set_state(qpos, qvel)
        assert many.qpos == pytest.approx(qpos, abs=1e-12)
        assert many.qvel == pytest.approx(qvel, abs=1e-12)
        # the handles say the same
        cart = many.model("cart")
        assert cart.pose.position == pytest.approx(qpos[:3])
        assert cart.joint("slide").position() == pytest.approx(qpos[8])
        assert cart.joint("shoulder").velocity() == pytest.approx(qvel[6])
        many.step(3)


def test_positions_and_velocities_are_set_apart(many):
    qpos, qvel = random_state(many, 1)
    many.qvel = qvel
    many.qpos = qpos
    assert many.qvel == pytest.approx(qvel, abs=1e-12)
    many.qvel = 2 * qvel
    assert many.qpos == pytest.approx(qpos, abs=1e-12)
    assert many.qvel == pytest.approx(2 * qvel, abs=1e-12)


TUMBLING = """<sdf version="1.9"><model name="m"><pose>0 0 5 0 0 0</pose><link name="a"/>
  <link name="b"><pose>1 0 0 0 0 0</pose></link><link name="c"><pose>2 0 0 0 0 0</pose></link>
  <joint name="ab" type="revolute"><parent>a</parent><child>b</child><axis><xyz>0 1 0</xyz></axis></joint>
  <joint name="bc" type="prismatic"><parent>b</parent><child>c</child><axis><xyz>0 0 1</xyz></axis></joint></model></sdf>"""


def test_positions_of_what_moves_keep_its_joints_together():
    with pongsim.Simulation(TUMBLING) as sim:
        qvel = np.arange(1.0, 9.0)
        sim.qvel = qvel
        qpos = sim.qpos.copy()
        qpos[7:] += 0.3, 0.4
        sim.qpos = qpos
        assert sim.qvel == pytest.approx(qvel, abs=1e-12)
        # the links' velocities are those that the numbers say, so a step has nothing to correct
        for link in sim.model("m").links:
            J = link.jacobian()
            assert J[:3] @ qvel == pytest.approx(link.linear_velocity, abs=1e-9)
            assert J[3:] @ qvel == pytest.approx(link.angular_velocity, abs=1e-9)


def test_what_is_there_already_changes_no_bit(many):
    many.set_state(*random_state(many, 2))
    many.step(10)
    before = many.save()
    many.qpos = many.qpos
    many.qvel = many.qvel
    many.set_poses(many.poses()[:0], [])
    assert many.save() == before


def test_a_set_state_is_saved_and_restored(many):
    start = many.save()
    many.set_state(*random_state(many, 3))
    state = many.save()
    many.step(50)
    expected = many.state_hash()
    many.reset()
    many.restore(state)
    many.step(50)
    assert many.state_hash() == expected
    many.restore(start)
    many.set_state(*random_state(many, 3))
    many.step(50)
    assert many.state_hash() == expected


def test_a_part_can_be_changed_by_its_place(many):
    qpos = many.qpos.copy()
    qpos[many.layout.qpos["cart::slide"]] = 0.25
    many.qpos = qpos
    assert many.model("cart").joint("slide").position() == pytest.approx(0.25)


def test_the_arrays_cannot_be_written_to(many):
    with pytest.raises(ValueError, match="read-only"):
        many.qpos[0] = 1
    with pytest.raises(ValueError, match="read-only"):
        many.qvel[0] = 1


def test_wrong_numbers_are_refused_and_change_nothing(many):
    before = many.save()
    qpos, qvel = many.qpos, many.qvel
    for wrong, text in ((qpos[:-1], "25 positions, not 24"), (np.full_like(qpos, np.nan), "finite"),
                        (np.zeros_like(qpos), "length 1")):
        with pytest.raises(ValueError, match=text):
            many.qpos = wrong
    with pytest.raises(ValueError, match="22 velocities"):
        many.qvel = qvel[:3]
    with pytest.raises(ValueError, match="finite"):
        many.qvel = np.full_like(qvel, np.inf)
    assert many.save() == before
    with pytest.raises(pongsim.Gone):
        many.close()
        many.qpos


def test_what_is_inserted_is_added(many):
    size = many.qpos.size
    ball = many.insert("<sdf version='1.9'><model name='ball'><link name='l'/></model></sdf>", pose=(0, 0, 5))
    assert many.qpos.size == size + 7 and many.qpos[-7:-4].tolist() == [0, 0, 5]
    many.remove(ball)
    assert many.qpos.size == size


def test_a_state_within_a_step_is_read_only():
    class Looks(pongsim.System):
        def post_update(self, info):
            self.seen = self.sim.qpos
            self.sim.qpos = self.seen

    system = Looks()
    with pongsim.Simulation(BALL, systems=[system], strict=True) as sim:
        with pytest.raises(pongsim.SystemFailed, match="Busy"):
            sim.step()
        assert system.seen.size == 8


def test_joint_states(many):
    names = many.joint_names
    states = np.arange(2.0 * len(names)).reshape(-1, 2) / 10
    many.set_joint_states(states)
    assert many.joint_states() == pytest.approx(states, abs=1e-12)
    many.set_joint_states([[0.5, -1]], ["cart::slide"])
    assert many.joint_states()[names.index("cart::slide")] == pytest.approx([0.5, -1])
    assert many.joint_states()[0] == pytest.approx(states[0])
    with pytest.raises(KeyError, match="cart::slide"):
        many.set_joint_states([[0, 0]], ["cart::slid"])
    with pytest.raises(ValueError, match=r"\(4, 2\)"):
        many.set_joint_states([[0, 0]])


def test_poses_and_velocities_of_models(many):
    poses = many.poses().copy()
    assert many.model_names == ["cart", "cross", "pair", "wall"]
    poses[0, :3] = 1, 2, 3
    poses[3, :3] = 5, 5, 5
    many.set_poses(poses[[0, 3]], ["cart", "wall"])
    assert many.poses() == pytest.approx(poses)
    many.set_velocities([[1, 2, 3, 0.1, 0.2, 0.3]], ["cart"])
    assert many.velocities()[0] == pytest.approx([1, 2, 3, 0.1, 0.2, 0.3])
    assert many.qvel[:6] == pytest.approx([1, 2, 3, 0.1, 0.2, 0.3])
    many.set_poses(poses[:1], ["cart"], stop=True)
    assert not many.velocities()[0].any()
    # one that is held by the world is refused, and the one before it is put back
    before = many.poses().copy()
    poses[:, 2] += 1
    with pytest.raises(pongsim.Refused, match="cross"):
        many.set_poses(poses)
    assert many.poses() == pytest.approx(before, abs=1e-12)
    with pytest.raises(ValueError, match="finite"):
        many.set_velocities([[np.nan] * 6], ["cart"])
    many.set_velocities(many.velocities())
    speeds = many.velocities().copy()
    speeds[[0, 3], 0] = 1
    with pytest.raises(pongsim.Refused, match="'wall' is static"):
        many.set_velocities(speeds)
    assert not many.velocities()[0].any()
    with pytest.raises(KeyError):
        many.set_poses(poses[:1], ["card"])


def test_a_robot_with_a_wheel_as_its_first_link_is_set():
    """Joints first, then the model: the link that the model's pose is that of may be a joint's child."""
    with pongsim.Simulation(COURT, seed=7) as sim:
        sim.publish("/cmd_vel", {"linear": {"x": 0.5}, "angular": {"z": 0.3}})
        sim.step(300)
        qpos, qvel = sim.qpos, sim.qvel
        sim.reset()
        sim.set_state(qpos, qvel)
        assert sim.qpos == pytest.approx(qpos, abs=1e-9)
        assert sim.qvel == pytest.approx(qvel, abs=1e-9)
