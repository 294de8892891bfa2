"""Mistakes that would do nothing are errors."""

import inspect
import math
import pydoc

import pytest
from conftest import BALL

import pongsim


def test_a_message_of_another_type_than_the_topics(court):
    with pytest.raises(ValueError, match="'/cmd_vel' has the type ignition.msgs.Twist, not ignition.msgs.Pose"):
        court.publish("/cmd_vel", {"name": "x"}, type="Pose")
    court.publish("/a", {"data": 1}, type="Int32")
    with pytest.raises(ValueError, match="Int32"):
        court.publish("/a", {"data": "1"}, type="StringMsg")
    # who hears any type hears several
    heard = []
    court.subscribe("/b", heard)
    court.publish("/b", {"data": 1}, type="Int32")
    court.publish("/b", {"data": "1"}, type="StringMsg")
    court.step()
    assert heard == [{"data": 1}, {"data": "1"}]


def test_a_subscription_with_the_wrong_class(court):
    with pytest.raises(ValueError, match="Odometry, not ignition.msgs.Twist"):
        court.subscribe("/model/pong_bot/odometry", print, type=pongsim.messages.Twist)
    for wrong in ("Twist", int, pongsim.messages.Twist()):
        with pytest.raises(TypeError, match="message class"):
            court.subscribe("/a", print, type=wrong)
    court.subscribe("/model/pong_bot/odometry", [].append, type=pongsim.messages.Odometry)
    # a class for a topic that comes later
    court.subscribe("/later", [].append, type=pongsim.messages.Twist)
    court.publish("/later", {"data": 1}, type="Int32")
    with pytest.raises(TypeError, match="Int32"):
        court.step()


def test_numbers_that_a_command_refuses_every_time(court):
    for _ in range(3):
        for bad in (math.nan, math.inf, 1e300):
            with pytest.raises(ValueError, match=r"/cmd_vel.*linear"):
                court.publish("/cmd_vel", {"linear": {"x": bad}})
    # nobody refuses them here
    heard = []
    court.subscribe("/a", heard)
    court.publish("/a", {"data": math.nan}, type="Double")
    court.step()
    assert math.isnan(heard[0]["data"])


@pytest.mark.parametrize("name, meant", [("preUpdate", "pre_update"), ("preupdate", "pre_update"),
                                         ("postUpdate", "post_update"), ("worldChanged", "world_changed"),
                                         ("Configure", "configure")])
def test_a_method_that_is_never_called(name, meant):
    with pytest.raises(TypeError, match=f"Judge.{name} would never be called; did you mean '{meant}'"):
        type("Judge", (pongsim.System,), {name: lambda self: None})
    # other names are free
    type("Judge", (pongsim.System,), {"updated": lambda self: None, "preupdate_": 3, "_preUpdate": lambda self: None})


def test_an_attribute_that_is_not_there(ball):
    with pytest.raises(AttributeError, match="step_sise.*did you mean 'step_size'"):
        ball.step_sise = 3
    with pytest.raises(AttributeError, match="gravity"):
        ball.gravitiy = (0, 0, 0)
    # other names are the user's own
    ball.score, ball.steps, ball._hidden = 3, 4, 5
    ball.step_size = 0.002
    ball.gravity = (0, 0, 0)
    for part in (ball.model("ball"), ball.model("ball").link("link"), ball.model("arm").joint("hinge")):
        with pytest.raises(AttributeError):
            part.mas = 3


def test_seeds():
    for bad in (-1, 2**64):
        with pytest.raises(ValueError, match=f"a seed must be 0 to .*not {bad}"):
            pongsim.Simulation(BALL, seed=bad)
    with pytest.raises(TypeError):
        pongsim.Simulation(BALL, seed=1.5)
    with pongsim.Simulation(BALL, seed=2**64 - 1) as sim:
        with pytest.raises(ValueError, match="not -5"):
            sim.reset(seed=-5)
        sim.reset(seed=7)


def public(kind):
    return [name for name in dir(kind) if not name.startswith("_")]


def test_everything_has_a_signature():
    for name in pongsim.__all__:
        kind = getattr(pongsim, name)
        if not isinstance(kind, type) or issubclass(kind, (Exception, tuple)):
            continue
        for part in public(kind):
            function = inspect.getattr_static(kind, part)
            if callable(function):
                signature = inspect.signature(getattr(kind, part))
                assert all(not parameter.startswith("arg") for parameter in signature.parameters), (name, part)
    assert str(inspect.signature(pongsim.Simulation.step)) == "(self, count=1)"
    assert str(inspect.signature(pongsim.Link.add_wrench)) == "(self, force, torque=(0.0, 0.0, 0.0))"
    assert str(inspect.signature(pongsim.Model.move)) == "(self, pose, *, stop=False)"


@pytest.mark.parametrize("kind", [pongsim.Simulation, pongsim.Model, pongsim.Link, pongsim.Joint, pongsim.Sensor,
                                  pongsim.System, pongsim.Subscription, pongsim.Collision])
def test_help_is_for_readers(kind):
    text = pydoc.plain(pydoc.render_doc(kind))
    for internal in ("::python", "std::", "Owner", "_memory", "find_sensor", "open_subscription", "ask(", "arg0", "handle"):
        assert internal not in text, text[max(0, text.find(internal) - 200):text.find(internal) + 100]


def test_a_command_to_what_is_static(ball):
    ground = ball.model("ground")
    for call in (lambda: ground.set_velocity((1, 0, 0)), lambda: ground.link("link").set_velocity((1, 0, 0)),
                 lambda: ground.link("link").add_wrench((1, 0, 0))):
        with pytest.raises(pongsim.Refused, match="'ground.* is static"):
            call()


@pytest.mark.parametrize("call, kind, said", [
    ("pongsim.Simulation(b'<sdf/>')", TypeError, "a world must be a file or a text, not bytes"),
    ("pongsim.Simulation(5)", TypeError, "a world must be a file or a text, not int"),
    ("pongsim.Simulation('pong_word.sdf')", pongsim.LoadError, "no such file; did you mean 'pong_world.sdf'"),
    ("pongsim.Simulation(BALL, threads='2')", TypeError, "threads must be an integer, not str"),
    ("pongsim.Simulation(BALL, seed=1.5)", TypeError, "a seed must be an integer, not float"),
    ("pongsim.Simulation(BALL, systems=[pongsim.System])", TypeError, r"an object, such as System\(\), not the class"),
    ("ball.step(-1)", ValueError, "a number of steps must be 0 or more, not -1"),
    ("ball.remove('ball')", TypeError, r"only models can be removed, such as sim.model\('robot'\), not 'ball'"),
    ("ball.model('ball').link('lnk')", KeyError, "model 'ball' has no link 'lnk'; did you mean 'link'"),
    ("ball.model('arm').joint('hing')", KeyError, "model 'arm' has no joint 'hing'; did you mean 'hinge'"),
    ("ball.link('link')", KeyError, "names no model: a link is"),
    ("ball.joint('arm::hing')", KeyError, "model 'arm' has no joint 'hing'; did you mean 'hinge'"),
    ("ball.joint('arm::hinge').position(4)", IndexError, "has 1 axis with a position; there is no axis 4"),
    ("ball.joint('arm::hinge').drive(1e99)", ValueError, r"a velocity must be at most 1e\+08, not 1e\+99"),
    ("ball.joint('arm::hinge').add_force(-1e11)", ValueError, r"a force must be at most 1e\+10, not -1e\+11"),
    ("ball.link('ball::link').set_velocity((1e9, 0, 0))", ValueError, "a velocity must be at most"),
    ("ball.model('ball').set_velocity((0, 0, 0), (0, 1e9, 0))", ValueError, "an angular velocity must be at most"),
    ("ball.link('ball::link').add_wrench((0, 1e11, 0))", ValueError, "a force must be at most"),
    ("setattr(ball, 'qpos', None)", TypeError, "qpos must be an array of numbers, not None"),
    ("setattr(ball, 'qvel', None)", TypeError, "qvel must be an array of numbers, not None"),
    ("ball.set_joint_states([[1, 2]], ['hinge'])", KeyError, "no joint axis 'hinge'; did you mean 'arm::hinge'"),
    ("ball.view(port=-1)", ValueError, "a port must be 1 to 65535, or 0 for a free one, not -1"),
])
def test_a_mistake_in_a_shell(ball, call, kind, said, capfd):
    before = ball.save()
    with pytest.raises(kind, match=said):
        eval(call, {"pongsim": pongsim, "ball": ball, "BALL": BALL})
    assert ball.save() == before and capfd.readouterr().err == ""


@pytest.mark.parametrize("call, said", [
    ("ball.model(3)", "name must be a text, not int"),
    ("ball.model(nam='ball')", r"model\(\) has no argument 'nam'; did you mean 'name'"),
    ("ball.model()", r"model\(\) needs an argument 'name'"),
    ("ball.model('ball', 3)", r"model\(\) takes 1 argument, not 2"),
    ("ball.link(3)", "a link must be named by a text, not int"),
    ("ball.model('ball').link(None)", "name must be a text, not None"),
    ("ball.joint('arm::hinge').position('first')", "axis must be an integer, not str"),
    ("ball.joint('arm::hinge').position(0.5)", "axis must be an integer, not float"),
    ("ball.joint('arm::hinge').drive('fast')", "velocity must be a number or None, not str"),
    ("ball.joint('arm::hinge').drive(1, axis='x')", "axis must be an integer, not str"),
    ("ball.link('ball::link').set_mass('heavy')", "mass must be a number, not str"),
    ("ball.link('ball::link').set_color(3, (1, 1, 1))", "visual must be a text, not int"),
    ("ball.step('all')", "count must be an integer, not str"),
    ("ball.step(2**70)", "count is too large a number"),
    ("ball.save(3)", r"save\(\) takes 0 arguments, not 1"),
    ("ball.restore('x')", "state must be bytes, not str"),
    ("ball.insert(BALL, name=3)", "name must be a text, not int"),
    ("ball.insert(3)", "a model must be a file or a text, not int"),
    ("ball.sensor(4)", "name must be a text, not int"),
    ("ball.publish(3, {})", "topic must be a text, not int"),
    ("ball.subscribe(3, print)", "topic must be a text, not int"),
    ("ball.request('/s', {}, timeout='long')", "timeout must be a number, not str"),
    ("setattr(ball, 'step_size', 'short')", "step_size must be a number, not str"),
    ("pongsim.set_log_level('all')", "level must be an integer, not str"),
])
def test_an_argument_of_a_wrong_type_is_named(ball, call, said):
    before = ball.save()
    with pytest.raises(TypeError, match=f"^{said}"):
        eval(call, {"pongsim": pongsim, "ball": ball, "BALL": BALL})
    assert ball.save() == before


def test_links_and_joints_by_their_scoped_names(ball):
    assert ball.link("ball::link") == ball.model("ball").link("link")
    assert ball.joint("arm::hinge") == ball.model("arm").joint("hinge")
