"""Images of a world, and its page in a browser."""

import json
import socket
import subprocess
import sys
import urllib.request

import numpy as np
import pytest
from conftest import BALL

import pongsim

# a red ball above a green floor, and a camera that looks down on them
SCENE = """<sdf version="1.9"><world name="w">
  <plugin filename="ignition-gazebo-physics-system" name="ignition::gazebo::systems::Physics"/>
  <plugin filename="ignition-gazebo-sensors-system" name="ignition::gazebo::systems::Sensors"/>
  <scene><ambient>1 1 1 1</ambient><background>0 0 1 1</background></scene>
  <model name="floor"><static>true</static><link name="l"><visual name="v"><geometry><box><size>20 20 0.1</size></box>
    </geometry><material><ambient>0 1 0 1</ambient></material></visual></link></model>
  <model name="ball"><pose>0 0 2 0 0 0</pose><link name="l"><visual name="v"><geometry><sphere><radius>0.5</radius></sphere>
    </geometry><material><ambient>1 0 0 1</ambient></material></visual></link></model>
  <model name="mast"><static>true</static><pose>0 0 6 0 1.5707963 0</pose><link name="l"><sensor name="eye" type="camera">
    <camera><horizontal_fov>1.0</horizontal_fov><image><width>64</width><height>48</height></image></camera></sensor></link>
  </model></world></sdf>"""


@pytest.fixture
def scene():
    with pongsim.Simulation(SCENE) as simulation:
        yield simulation


def colours(picture):
    """The colours that are there: "r", "g", "b"."""
    brightest = picture.argmax(axis=2)[picture.max(axis=2) > 60]
    return {"rgb"[each] for each in np.unique(brightest)}


def test_a_camera_of_the_world_a_pose_and_everything(scene):
    before = scene.state_hash()
    seen = scene.render("eye")
    assert seen.shape == (48, 64, 3) and seen.dtype == np.uint8 and seen.flags.writeable
    assert colours(seen) == {"r", "g"} and seen[24, 32].argmax() == 0
    assert np.array_equal(scene.render("mast::l::eye"), seen)
    assert np.array_equal(scene.render((0, 0, 6, 0, np.pi / 2, 0), (64, 48), field_of_view=1.0), seen)
    assert scene.render("eye", (30, 20)).shape == (20, 30, 3)
    # from below the floor, ahead is the sky
    assert colours(scene.render(pongsim.Pose((0.0, 0.0, -5.0)))) == {"b"}
    everything = scene.render()
    assert everything.shape == (240, 320, 3) and colours(everything) == {"r", "g", "b"}
    assert scene.state_hash() == before and scene.time == 0


def test_it_shows_the_present(scene):
    first = scene.render("eye")
    scene.run_until(0.3)
    fallen = scene.render("eye")
    assert (fallen[:, :, 0] > fallen[:, :, 1]).sum() < (first[:, :, 0] > first[:, :, 1]).sum()
    scene.remove(scene.model("ball"))
    assert colours(scene.render("eye")) == {"g"}
    scene.reset()
    assert np.array_equal(scene.render("eye"), first)
    # earlier images are not written to
    assert not np.array_equal(fallen, first)


def test_what_cant_be_drawn_is_said(scene):
    with pytest.raises(KeyError, match="eya"):
        scene.render("eya")
    for size in ((0, 10), (10, -1), (10, 9000)):
        with pytest.raises(ValueError, match="pixel"):
            scene.render(size=size)
    for size in (7, (1,), (1.5, 2), "ab"):
        with pytest.raises((TypeError, ValueError)):
            scene.render(size=size)
    for angle in (0.0, 4.0, np.nan):
        with pytest.raises(ValueError, match="field of view"):
            scene.render(field_of_view=angle)
    with pytest.raises(ValueError):
        scene.render((0, 0))
    scene.close()
    with pytest.raises(pongsim.Gone):
        scene.render()


def read(url):
    with urllib.request.urlopen(url, timeout=20) as answer:
        return answer.status, dict(answer.headers), answer.read().decode()


def test_the_page_is_served_and_changes_nothing():
    with pongsim.Simulation(BALL) as alone, pongsim.Simulation(BALL) as sim:
        sim.step(10)
        state = sim.save()
        view = sim.view(browser=False)
        assert sim.view() is view and view.url in repr(view)
        status, headers, page = read(view.url)
        assert status == 200 and "<title>" in page
        assert "frame-ancestors 'none'" in headers["content-security-policy"]
        assert f'src="{view.url}"' in view._repr_html_()
        sim.restore(state)
        view.run(duration=0.1, speed=100)
        assert sim.iterations == 110
        alone.step(110)
        assert sim.state_hash() == alone.state_hash() and sim.save() == alone.save()
        view.run(duration=0.05, speed=0)
        assert sim.iterations == 110
        with pytest.raises(ValueError):
            view.run(speed=-1)
    with pytest.raises(OSError):
        read(view.url)


def test_a_taken_port_is_told_of():
    with socket.socket() as other, pongsim.Simulation(BALL) as sim:
        other.bind(("127.0.0.1", 0))
        other.listen()
        with pytest.raises(pongsim.SystemFailed, match="port"):
            sim.view(port=other.getsockname()[1], browser=False)
        sim.step()
        sim.view(browser=False)


def test_a_notebook_shows_it_inline():
    code = """
import sys, types, json, urllib.request
shell = types.SimpleNamespace(kernel=1)
sys.modules["IPython"] = types.SimpleNamespace(get_ipython=lambda: shell)
import webbrowser
webbrowser.open = lambda url: sys.exit("a browser was opened")
import pongsim
sim = pongsim.Simulation(sys.argv[1])
view = sim.view(read_only=True)
with urllib.request.urlopen(view.url, timeout=20) as answer:
    print(json.dumps([view._repr_html_(), answer.headers["content-security-policy"]]))
"""
    result = subprocess.run([sys.executable, "-c", code, BALL], capture_output=True, text=True)
    assert result.returncode == 0, result.stderr
    frame, policy = json.loads(result.stdout)
    assert frame.startswith("<iframe") and policy.endswith("frame-ancestors http://localhost:* http://127.0.0.1:*")
