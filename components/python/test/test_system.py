"""Systems in Python beside those of the file."""

import pytest
from conftest import BALL, COURT

import pongsim


class Judge(pongsim.System):
    """Records its calls."""

    def __init__(self):
        self.calls = []
        self.resets = 0
        self.changes = 0
        self.high = 0.0

    def configure(self):
        self.ball = self.sim.model("ball")

    def pre_update(self, info):
        self.calls.append(("pre", info.iteration, info.time_ns))

    def update(self, info):
        self.calls.append(("update", info.iteration, info.time_ns))

    def post_update(self, info):
        self.calls.append(("post", info.iteration, info.time_ns))
        self.high = max(self.high, self.ball.pose.position[2])

    def reset(self):
        self.resets += 1

    def world_changed(self):
        self.changes += 1


def test_phases_in_their_order(ball):
    judge = Judge()
    ball.add(judge)
    ball.step(2)
    assert judge.calls == [(phase, i, 1_000_000 * i) for i in (1, 2) for phase in ("pre", "update", "post")]
    assert judge.sim is ball
    ball.remove(ball.model("arm"))
    ball.step()
    assert judge.changes == 1
    ball.reset()
    assert judge.resets == 1
    with pytest.raises(RuntimeError, match="not in a simulation"):
        Judge().sim


def test_it_is_given_with_the_world_and_can_command():
    class Push(pongsim.System):
        def pre_update(self, info):
            self.sim.model("ball").link("link").add_wrench((0, 0, 30))

    with pongsim.Simulation(BALL, systems=[Push(), Judge()]) as sim:
        sim.step(100)
        assert sim.model("ball").pose.position[2] > 2


def test_that_it_is_there_changes_no_bits():
    hashes = []
    for systems in ([], [Judge2()]):
        with pongsim.Simulation(COURT, seed=7, systems=systems) as sim:
            sim.publish("/cmd_vel", {"linear": {"x": 0.5}})
            sim.step(500)
            hashes.append(sim.state_hash())
    assert hashes[0] == hashes[1]


class Judge2(pongsim.System):
    def post_update(self, info):
        self.sim.poses()


class Fails(pongsim.System):
    name = "weak"

    def __init__(self):
        self.count = 0

    def post_update(self, info):
        self.count += 1
        if info.iteration == 3:
            raise ValueError("too far")


def test_one_that_raises_is_named_and_switched_off(ball, capfd):
    system = Fails()
    ball.add(system)
    ball.step(10)
    assert system.count == 3
    said = capfd.readouterr().err
    assert "weak" in said and "failed in postUpdate: ValueError: too far (test_system.py:" in said
    assert "it is switched off" in said
    assert isinstance(system.error, ValueError)
    ball.reset()
    assert system.error is None
    ball.step(2)
    assert system.count == 5


def test_a_strict_simulation_raises_it():
    with pongsim.Simulation(BALL, strict=True, systems=[Fails()]) as sim:
        with pytest.raises(pongsim.SystemFailed, match="weak failed in postUpdate: ValueError: too far") as raised:
            sim.step(10)
        assert isinstance(raised.value.__cause__, ValueError)
        assert sim.iterations == 3


def test_one_that_can_not_begin_is_not_there(ball):
    class Wants(pongsim.System):
        def configure(self):
            self.sim.model("nobody")

    with pytest.raises(pongsim.SystemFailed, match="Wants is left out: KeyError") as raised:
        ball.add(Wants())
    assert isinstance(raised.value.__cause__, KeyError)
    ball.step()


def test_what_can_not_be_added(ball):
    with pytest.raises(TypeError, match="must derive from pongsim.System"):
        ball.add(3)
    judge = Judge()
    ball.add(judge)
    with pytest.raises(ValueError, match="already"):
        ball.add(judge)
    with pytest.raises(pongsim.SystemFailed, match="there is an added system 'Judge' already"):
        ball.add(Judge())


def test_keyboard_interrupt_in_a_system_is_no_fault_of_it(ball):
    class Stops(pongsim.System):
        def update(self, info):
            if info.iteration == 5:
                raise KeyboardInterrupt

    system = Stops()
    ball.add(system)
    with pytest.raises(KeyboardInterrupt):
        ball.step(100)
    assert ball.iterations == 5 and system.error is None
    ball.step()


def test_one_that_uses_what_is_gone_rests_until_the_reset(ball, capfd):
    judge = Judge()
    ball.add(judge)
    ball.remove(ball.model("ball"))
    ball.step(3)
    assert "stops until the next reset" in capfd.readouterr().err
    ball.reset()
    judge.calls.clear()
    ball.step()
    assert len(judge.calls) == 3


def test_its_memory_is_in_a_saved_state(ball):
    class Counts(pongsim.System):
        def __init__(self):
            self.count = 0

        def update(self, info):
            self.count += 1

        def save(self):
            return {"count": self.count}

        def restore(self, state):
            self.count = state["count"]

    system = Counts()
    ball.add(system)
    ball.step(5)
    state = ball.save()
    ball.step(5)
    ball.restore(state)
    assert system.count == 5
