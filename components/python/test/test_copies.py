"""Simulations are pickled by their file, edits and state."""

import copy
import multiprocessing
import pickle

import numpy as np
import pytest
from conftest import BALL, COURT

import pongsim

BOX = "<sdf version='1.9'><model name='box'><link name='l'/></model></sdf>"


class Counts(pongsim.System):
    def __init__(self, by):
        self.by = by
        self.count = 0

    def configure(self):
        self.ball = self.sim.model("ball")

    def post_update(self, info):
        assert self.ball.exists
        self.count += self.by

    def save(self):
        return self.count

    def restore(self, state):
        self.count = state


def again(sim):
    return pickle.loads(pickle.dumps(sim))


def goes_on_alike(one, other):
    assert (one.state_hash(), one.time) == (other.state_hash(), other.time)
    for sim in (one, other):
        sim.step(200)
    assert one.state_hash() == other.state_hash()


def test_of_a_file(tmp_path, monkeypatch):
    file = tmp_path / "court.sdf"
    file.write_text(COURT.read_text())
    monkeypatch.chdir(tmp_path)
    sim = pongsim.Simulation("court.sdf", seed=7)
    sim.publish("/cmd_vel", {"linear": {"x": 0.5}})
    sim.step(300)
    data = pickle.dumps(sim)
    monkeypatch.chdir("/")
    goes_on_alike(sim, pickle.loads(data))
    goes_on_alike(sim, copy.deepcopy(sim))


def test_of_a_text_with_options_and_systems():
    sim = pongsim.Simulation(BALL, seed=3, strict=True, load_systems=False, systems=[Counts(2)])
    sim.step(10)
    other = again(sim)
    system, = other._systems
    assert (system.count, system.by, system.sim) == (20, 2, other)
    goes_on_alike(sim, other)
    assert system.count == 20 + 400


def test_of_models_that_came_and_went():
    with pongsim.Simulation(BALL) as sim:
        sim.remove(sim.insert(BOX, name="gone"))
        sim.insert(BOX, pose=(0, 5, 1))
        sim.insert(BOX, pose=(0, 7, 1), allow_renaming=True)
        sim.remove(sim.model("arm"))
        sim.model("ball").link("link").set_mass(5)
        sim.step(10)
        with again(sim) as other:
            assert other.model_names == sim.model_names == ["ground", "ball", "box", "box_0"]
            assert other.model("ball").link("link").mass == 5
            goes_on_alike(sim, other)
        sim.reset()
        with again(sim) as other:
            assert other.model_names == ["ground", "ball", "arm"]


def position(sim):
    sim.step(100)
    return sim.qpos[:3]


def test_into_another_process():
    with pongsim.Simulation(BALL) as sim:
        sim.step(100)
        with multiprocessing.get_context("spawn").Pool(1) as pool:
            there = pool.apply(position, (sim,))
        assert there.tolist() == position(sim).tolist() and np.isfinite(there).all()


def test_what_came_by_other_means_is_refused():
    with pongsim.Simulation(BALL) as sim:
        sim.request("/world/w/create", {"sdf": BOX, "name": "other"}, type="EntityFactory")
        sim.step()
        data = pickle.dumps(sim)
    with pytest.raises(pongsim.Refused):
        pickle.loads(data)
