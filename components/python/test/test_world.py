"""Models, links and joints: reading, commanding, inserting and removing."""

import numpy as np
import pytest

import pongsim

BOX = """<sdf version='1.9'><model name='box'><link name='link'><collision name='c'><geometry><box><size>1 1 1</size></box>
</geometry></collision></link></model></sdf>"""


def test_what_is_there(ball):
    assert [each.name for each in ball.models] == ["ground", "ball", "arm"]
    assert ball.model_names == ["ground", "ball", "arm"]
    assert ball.joint_names == ["arm::hinge"]
    arm = ball.model("arm")
    assert [each.name for each in arm.links] == ["base", "rod"]
    assert [(each.name, each.type, each.axis_count) for each in arm.joints] == [("fix", "fixed", 0), ("hinge", "revolute", 1)]
    assert arm.link("rod").scoped_name == "arm::rod"
    assert arm.link("rod").model == arm
    assert ball.model("ground").is_static
    assert ball.model("ball").link("link").mass == 2
    assert ball.model("ball") == ball.model("ball") != arm
    assert len({ball.model("ball"), ball.model("ball"), arm}) == 2
    assert repr(arm) == "<pongsim.Model 'arm'>"


def test_a_wrong_name_is_told(ball):
    with pytest.raises(KeyError, match="did you mean 'ball'"):
        ball.model("bal")
    with pytest.raises(KeyError, match="hinge"):
        ball.model("arm").joint("hing")
    with pytest.raises(KeyError):
        ball.model("arm").link("nothing")
    with pytest.raises(IndexError, match="no axis 1"):
        ball.model("arm").joint("hinge").position(1)


def test_a_wrench_pushes(ball):
    link = ball.model("ball").link("link")
    ball.gravity = (0, 0, 0)
    link.add_wrench((4, 0, 0))
    ball.step()
    # dv = F t / m
    assert link.linear_velocity[0] == pytest.approx(4 * ball.step_size / 2)
    link.add_wrench(np.array([-4.0, 0, 0]), torque=[0, 0, 0])
    ball.step()
    assert link.linear_velocity[0] == pytest.approx(0, abs=1e-12)
    for wrong in ((1, 2), (1, 2, float("nan"))):
        with pytest.raises(ValueError):
            link.add_wrench(wrong)
    for wrong in (3, "abc", (1, 2, "x"), None):
        with pytest.raises(TypeError):
            link.add_wrench(wrong)


def test_a_joint_is_driven_and_let_go(ball):
    hinge = ball.model("arm").joint("hinge")
    hinge.drive(2.0)
    ball.step(100)
    assert hinge.velocity() == pytest.approx(2.0, rel=1e-3)
    hinge.drive(None)
    hinge.reset(position=0.5, velocity=0.0)
    assert hinge.position() == pytest.approx(0.5)
    hinge.add_force(3.0)
    ball.step()
    assert hinge.velocity() > 0
    with pytest.raises(ValueError):
        hinge.drive(float("inf"))


def test_moves(ball):
    model = ball.model("ball")
    model.move((1, 2, 3))
    assert model.pose.position == (1, 2, 3)
    model.move((0, 0, 5, 0, 0, 0.5), stop=True)
    assert model.pose.yaw == pytest.approx(0.5)
    assert model.pose.roll_pitch_yaw[2] == pytest.approx(0.5)
    model.move(pongsim.Pose((0, 0, 1)))
    assert model.pose == pongsim.Pose((0, 0, 1))
    for wrong in ((1, 2), (0, 0, 0, 0), (0, 0, float("inf"))):
        with pytest.raises(ValueError):
            model.move(wrong)
    with pytest.raises(ValueError, match="length 1"):
        model.move(pongsim.Pose((0, 0, 1), (0, 0, 0, 2)))
    with pytest.raises(pongsim.Refused):
        ball.model("arm").move((0, 0, 0))


def test_models_come_and_go(ball, tmp_path):
    box = ball.insert(BOX, name="crate", pose=(5, 0, 0.5))
    assert ball.model("crate") == box
    assert box.pose.position == (5, 0, 0.5)
    file = tmp_path / "box.sdf"
    file.write_text(BOX)
    assert ball.insert(file).name == "box"
    assert ball.insert(file, allow_renaming=True).name == "box_0"
    with pytest.raises(pongsim.LoadError):
        ball.insert(file)
    with pytest.raises(pongsim.LoadError) as raised:
        ball.insert("<sdf version='1.9'><model/></sdf>")
    assert raised.value.line == 1
    link = box.link("link")
    ball.remove(box)
    assert not box.exists
    for call in (lambda: box.pose, lambda: link.pose, lambda: box.move((0, 0, 0)), lambda: ball.remove(box)):
        with pytest.raises((pongsim.Gone, pongsim.Refused)):
            call()
    ball.reset()
    assert ball.model_names == ["ground", "ball", "arm"]


def test_several_models_go_at_once_or_none(ball):
    ball.remove(ball.model("arm"), ball.model("ball"), ball.model("arm"))
    assert ball.model_names == ["ground"]
    crates = [ball.insert(BOX, name=f"crate{i}") for i in range(3)]
    ball.remove(crates[1])
    with pytest.raises(pongsim.Refused):
        ball.remove(*crates)
    with pytest.raises(TypeError, match="only models"):
        ball.remove(crates[0], "crate2")
    assert ball.model_names == ["ground", "crate0", "crate2"]
    ball.step()


def test_a_model_of_another_simulation_is_refused(ball):
    with pongsim.Simulation("<sdf version='1.9'><world name='x'/></sdf>") as other:
        with pytest.raises(ValueError, match="another simulation"):
            other.remove(ball.model("ball"))


def test_all_poses_and_joints_at_once(ball):
    ball.model("arm").joint("hinge").drive(1.0)
    ball.step(100)
    poses, joints = ball.poses(), ball.joint_states()
    assert poses.shape == (3, 7) and joints.shape == (1, 2)
    for row, model in zip(poses, ball.models):
        assert tuple(row[:3]) == model.pose.position
        assert tuple(row[3:]) == model.pose.orientation
    hinge = ball.model("arm").joint("hinge")
    assert tuple(joints[0]) == (hinge.position(), hinge.velocity())
    before = poses.copy()
    ball.step(100)
    assert np.array_equal(poses, before) and not np.array_equal(ball.poses(), before)
