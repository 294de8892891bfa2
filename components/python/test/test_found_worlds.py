"""Worlds are found as `pongsim run` finds them."""

import pathlib
import subprocess
import sys

import pytest
from conftest import COURT, PROJECT

import pongsim


def test_a_world_of_pongsim_from_any_folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pongsim.Simulation("pong_world.sdf", seed=7) as sim, pongsim.Simulation(COURT, seed=7) as same:
        sim.step(10), same.step(10)
        assert sim.state_hash() == same.state_hash()
    assert "pong_world.sdf" in pongsim.worlds.names()
    assert pongsim.worlds.path("pong_world").samefile(COURT)
    with pytest.raises(KeyError, match="pong_world.sdf"):
        pongsim.worlds.path("pong_word")


def test_a_file_that_is_there_comes_first(tmp_path, monkeypatch):
    (tmp_path / "pong_world.sdf").write_text("<sdf version='1.9'><world name='mine'/></sdf>")
    monkeypatch.chdir(tmp_path)
    assert pongsim.Simulation("pong_world.sdf").name == "mine"
    monkeypatch.chdir("/")
    monkeypatch.setenv("PONGSIM_RESOURCE_PATH", f"/nowhere:{tmp_path}")
    assert pongsim.Simulation("pong_world.sdf").name == "mine"


def test_one_that_is_nowhere_is_named_as_it_was_given():
    with pytest.raises(pongsim.LoadError, match="no_such.sdf"):
        pongsim.Simulation("no_such.sdf")
    with pytest.raises(pongsim.LoadError):
        pongsim.Simulation("")


def test_one_text_of_a_file_and_all_that_it_includes(tmp_path, monkeypatch):
    text = pongsim.to_sdf("pong_world.sdf")
    with pongsim.Simulation(text, seed=7) as sim, pongsim.Simulation(COURT, seed=7) as same:
        sim.step(10), same.step(10)
        assert sim.state_hash() == same.state_hash()
    (tmp_path / "part.sdf").write_text("<sdf version='1.9'><model name='part'><link name='l'/></model></sdf>")
    whole = tmp_path / "whole.sdf"
    whole.write_text("<sdf version='1.9'><world name='w'><include><uri>part.sdf</uri></include></world></sdf>")
    assert "<include>" not in pongsim.to_sdf(whole) and "name='part'" in pongsim.to_sdf(whole).replace('"', "'")
    robot = tmp_path / "robot.urdf"
    robot.write_text("<robot name='r'><link name='l'><inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1' ixy='0' "
                     "ixz='0' iyz='0'/></inertial></link></robot>")
    assert "<sdf" in pongsim.to_sdf(robot)
    whole.write_text("<sdf version='1.9'>\n<world/></sdf>")
    with pytest.raises(pongsim.LoadError, match=r"whole\.sdf:2"):
        pongsim.to_sdf(whole)
    with pytest.raises(pongsim.LoadError, match="no_such.sdf"):
        pongsim.to_sdf("no_such.sdf")
    with pytest.raises(ValueError, match="a file"):
        pongsim.to_sdf("<sdf version='1.9'/>")


def test_in_a_wheel(tmp_path):
    """The package's folder has everything, as in a wheel."""
    package = tmp_path / "site/pongsim"
    package.mkdir(parents=True)
    for file in pathlib.Path(pongsim.__file__).parent.iterdir():
        if not file.name.startswith("_core"):
            (package / file.name).symlink_to(file)
    for name in ("worlds.py", "names.py"):
        (package / name).unlink()
        (package / name).write_text((PROJECT / "components/python/pongsim" / name).read_text())
    (package / "share/pongsim").mkdir(parents=True)
    (package / "share/pongsim/worlds").symlink_to(PROJECT / "worlds")
    code = ("import importlib.util as u; s = u.spec_from_file_location('w', 'site/pongsim/worlds.py'); m = u.module_from_spec(s);"
            "s.loader.exec_module(m); print(m.find('pong_world.sdf'))")
    done = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True)
    assert done.stdout.strip() == str(package / "share/pongsim/worlds/pong_world.sdf"), done.stderr
