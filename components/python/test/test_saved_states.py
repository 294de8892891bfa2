"""Saved states that somebody has forged: they are refused, or restored, and never crash or hang."""

import pickle
import random
import struct

import numpy as np
import pongsim
import pytest
from conftest import COURT, PROJECT

HEADER = 24
SPECIAL = [struct.pack("<Q", number) for number in (0, 1, 5, 7, 10**6, 1 << 40, 1 << 63, (1 << 64) - 1)] + [
    struct.pack("<d", number) for number in (float("nan"), float("inf"), 1e308, 1e9, -1.0)]
# worlds whose systems remember much, of Fortress and others
WORLDS = sorted(PROJECT.glob("plugins/*/*/*.sdf"))


def with_checksum(state):
    value = 0xCBF29CE484222325
    for byte in state[HEADER:]:
        value = (value ^ byte) * 0x100000001B3 & 0xFFFFFFFFFFFFFFFF
    return state[:16] + struct.pack("<Q", value) + state[HEADER:]


def forge(state, dice):
    content = bytearray(state[HEADER:])
    kind = dice.randrange(8)
    place = dice.randrange(max(len(content) - 8, 1))
    if kind == 0:
        del content[place:]
    elif kind == 1:
        content[place:place] = dice.randbytes(dice.randrange(1, 16))
    elif kind < 5:
        content[place:place + 8] = dice.choice(SPECIAL)
    else:
        for _ in range(dice.randrange(1, 4)):
            content[dice.randrange(len(content))] = dice.randrange(256)
    return with_checksum(state[:HEADER] + bytes(content))


def attack(sim, count, dice):
    """Returns how many forged states were restored."""
    good = sim.save()
    restored = 0
    for _ in range(count):
        try:
            sim.restore(forge(good, dice))
            restored += 1
        except pongsim.Refused:
            assert sim.save() == good
            continue
        try:
            sim.step(20)
        except pongsim.SystemFailed as error:
            assert "no longer finite" in str(error)
        sim.restore(good)
    return restored


def test_forged_states_are_refused_or_go_on():
    with pongsim.Simulation(COURT) as sim:
        sim.publish("/cmd_vel", {"linear": {"x": 0.5}})
        sim.step(300)
        assert 50 < attack(sim, 300, random.Random(46)) < 250
        before = sim.state_hash()
        sim.step(100)
        assert sim.state_hash() != before


@pytest.mark.parametrize("world", WORLDS, ids=lambda world: world.stem)
@pytest.mark.filterwarnings("ignore::pongsim.WorldWarning")
def test_forged_memories_of_systems_are_refused_or_go_on(world, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)  # the COLLADA exporter writes into the current folder
    with pongsim.Simulation(world) as sim:
        sim.step(50)
        attack(sim, 30, random.Random(world.stem))


class Remembers(pongsim.System):
    def __init__(self, memory):
        self.memory = memory

    def save(self):
        return self.memory

    def restore(self, state):
        self.memory = state


def test_plain_values_are_remembered(ball):
    dice = random.Random(3)
    memory = {
        "none": None, "numbers": [True, 3, -0.1, float("inf"), 2j, 1 << 70], "text": "ä\0\ud800", ("a", 1): b"\0\xff",
        "sets": ({1, 2}, frozenset({"x"})), "pose": ball.model("ball").pose, "dice": dice.getstate(),
        "grid": np.arange(6, dtype=np.float32).reshape(2, 3), "none of them": np.zeros((0, 3)),
        "number": np.float64(0.1), "times": np.array(["2020-01-01"], "datetime64[s]"),
        "generator": np.random.default_rng(1).bit_generator.state,
    }
    system = Remembers(memory)
    ball.add(system)
    state = ball.save()
    system.memory = None
    ball.restore(state)
    assert repr(system.memory) == repr(memory)
    assert type(system.memory["pose"]) is pongsim.Pose
    system.memory["grid"][0, 0] = 9


def test_nothing_else_is_saved(ball):
    system = Remembers(None)
    ball.add(system)
    for memory, text in [
        ({"a": [random.Random()]}, r"Remembers.save has returned what can't be saved: \['a'\]\[0\] is of type random.Random"),
        (np.array([None]), "it is of type numpy.ndarray of object"),
        (print, "builtin_function_or_method"),
    ]:
        system.memory = memory
        with pytest.raises(TypeError, match=text):
            ball.save()
    system.memory = []
    system.memory.append(system.memory)
    with pytest.raises(ValueError, match="in itself"):
        ball.save()


def test_a_state_runs_no_code(ball, tmp_path):
    mark = tmp_path / "ran"

    class Evil:
        def __reduce__(self):
            return open, (str(mark), "w")

    # room in the state for a pickle of the same length
    crafted = pickle.dumps(Evil())
    system = Remembers("x" * 1000)
    ball.add(system)
    state = ball.save()
    hole = b'"' + b"x" * 1000 + b'"'
    assert hole in state
    with pytest.raises(pongsim.Refused, match="system Remembers: ValueError: it is not what a system has saved"):
        ball.restore(with_checksum(state.replace(hole, crafted + b" " * (len(hole) - len(crafted)))))
    assert not mark.exists()
    assert system.memory == "x" * 1000


def test_a_state_that_a_system_refuses_changes_nothing(ball):
    class Refuses(Remembers):
        def restore(self, state):
            if state == "bad":
                raise KeyError(state)
            super().restore(state)

    system = Refuses("bad")
    ball.add(system)
    bad = ball.save()
    system.memory = "good"
    ball.step(10)
    before = ball.state_hash()
    with pytest.raises(pongsim.Refused, match="system Refuses: KeyError: 'bad'"):
        ball.restore(bad)
    assert (ball.state_hash(), ball.iterations, system.memory, system.error) == (before, 10, "good", None)
    ball.step()
