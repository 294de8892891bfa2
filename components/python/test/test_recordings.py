"""A recording that could not be completed is reported when the simulation ends."""

import contextlib
import resource
import signal

import pytest
from conftest import BALL
from sweeps import WORLD, make, write

import pongsim
import pongsim.gym as gym

RECORDER = """<plugin filename="ignition-gazebo-log-system" name="ignition::gazebo::systems::LogRecord">
  <record_path>{0}/rec</record_path><compress>{1}</compress><compress_path>{0}/{2}</compress_path></plugin>"""


def recorded(text, folder, compress="false", packed="rec.zip"):
    """A world that records itself."""
    world = text.replace('<world name="w">', '<world name="w">' + RECORDER.format(folder, compress, packed))
    assert world != text
    return world


def unpackable(text, folder):
    """A world whose recording can't be completed, because the zip file's folder does not exist."""
    return recorded(text, folder, "true", "none/rec.zip")


@contextlib.contextmanager
def full_disk(size):
    """Limits the size of all files that the process writes, as a full disk does."""
    handler = signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
        signal.signal(signal.SIGXFSZ, handler)


def incomplete(folder, file):
    return rf"^log: the recording is incomplete: '{folder}/{file}' can't be .*"


@pytest.mark.filterwarnings("ignore::pongsim.WorldWarning")
def test_close_reports_a_full_disk(tmp_path):
    sim = pongsim.Simulation(recorded(BALL, tmp_path))
    with full_disk(40_000):
        sim.step(500)
        with pytest.raises(pongsim.SystemFailed, match=incomplete(tmp_path, "rec/state.tlog") + r" messages are kept$"):
            sim.close()
    assert sim.is_closed
    sim.close()


@pytest.mark.filterwarnings("ignore::pongsim.WorldWarning")
def test_the_end_of_a_with_block_reports_what_can_not_be_completed(tmp_path):
    with pytest.raises(pongsim.Error, match=incomplete(tmp_path, "none/rec.zip")):
        with pongsim.Simulation(unpackable(BALL, tmp_path)) as sim:
            sim.step(10)
    with pytest.raises(pongsim.Gone):
        sim.step()


@pytest.mark.filterwarnings("ignore::pongsim.WorldWarning")
def test_a_complete_recording_ends_without_a_word(tmp_path):
    with pongsim.Simulation(recorded(BALL, tmp_path, "true")) as sim:
        sim.step(10)
    assert (tmp_path / "rec.zip").exists()


@pytest.mark.filterwarnings("ignore::pongsim.WorldWarning")
def test_environments_close_all_worlds_and_report_the_first_failure(tmp_path):
    task = gym.Task(world=unpackable(BALL, tmp_path), action=[gym.JointForce("arm::hinge", -1.0, 1.0)],
                    observation={"hinge": gym.Joint("arm::hinge")}, reward=lambda now: now["hinge"][:, 0])
    env = gym.Env(task)
    env.reset(seed=1)
    with pytest.raises(pongsim.SystemFailed, match=incomplete(tmp_path, "none/rec.zip")):
        env.close()
    with pytest.raises(pongsim.Gone):
        env.render_mode = "rgb_array"
        env.render()


def test_a_run_of_a_sweep_has_failed_if_its_recording_is_incomplete(tmp_path):
    write(tmp_path, "w.sdf", unpackable(WORLD, tmp_path))
    [row] = make(tmp_path, parameters=None, fresh=True, options={"jobs": 1}).rows
    assert (row.status, row.measures) == ("failed", {})
    assert row.reason.startswith("log: the recording is incomplete")


def test_an_incomplete_recording_of_a_reported_run_is_a_warning(tmp_path, capfd):
    write(tmp_path, "w.sdf", unpackable(WORLD, tmp_path))
    rows = make(tmp_path, options={"jobs": 1}).rows
    assert [row.status for row in rows] == ["done", "done"]
    assert "WorldWarning: log: the recording is incomplete" in capfd.readouterr().err
