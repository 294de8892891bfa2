"""Runs of a sweep: measures, commands, end conditions, and equality with single runs."""

import csv
import math
import subprocess

import pytest
from sweeps import WORLD, command, make, write

import pongsim
from pongsim import sweep


def one(folder, **changes):
    """The only run of a sweep without parameters."""
    results = make(folder, parameters=None, **changes)
    assert len(results) == 1
    return results.rows[0]


def test_the_hash_is_that_of_the_simulation_and_of_the_command_line(tmp_path, program):
    results = make(tmp_path, seeds=3, options={"jobs": 3})
    assert [row.status for row in results.rows] == ["done"] * 6
    assert len({row.state_hash for row in results.rows}) == 2
    for row in results.rows:
        world = write(tmp_path, "one.sdf", WORLD.replace("0 0 2 0 0 0", f"0 0 {row.parameters['height']} 0 0 0"))
        with pongsim.Simulation(world, seed=row.seed) as sim:
            sim.run_until(0.2)
            assert f"{sim.state_hash():016x}" == row.state_hash
        run = subprocess.run([program, "run", world, "-z", "0", "--iterations", "200", "--hash", "--seed", str(row.seed)],
                             capture_output=True, text=True, check=True)
        assert row.state_hash in run.stdout


def test_a_world_that_is_reset_gives_the_hash_of_one_that_is_loaded(tmp_path):
    kept = make(tmp_path, seeds=4, options={"jobs": 1})
    fresh = make(tmp_path, seeds=4, fresh=True, options={"jobs": 1, "restart": True})
    assert kept.column("state_hash") == fresh.column("state_hash")
    assert kept.column("z") == fresh.column("z")


def test_noise_differs_by_seed_and_repeats(tmp_path):
    noisy = WORLD.replace("</link>\n    <plugin", "<sensor name='imu' type='imu'><topic>imu</topic><update_rate>100</update_rate>"
                          "<imu><linear_acceleration><x><noise type='gaussian'><stddev>1</stddev></noise></x>"
                          "</linear_acceleration></imu></sensor></link>\n    <plugin")
    noisy = noisy.replace("<model name=\"ground\">", "<plugin filename='ignition-gazebo-imu-system' "
                          "name='ignition::gazebo::systems::Imu'/><model name=\"ground\">")
    write(tmp_path, "w.sdf", noisy)
    measures = {"a": {"topic": "/imu", "field": "linear_acceleration.x", "take": "mean"}}
    first = make(tmp_path, parameters=None, seeds=5, measures=measures).column("a")
    assert None not in first and len(set(first)) == 5
    assert make(tmp_path, parameters=None, seeds=5, measures=measures, options={"restart": True, "jobs": 1}).column("a") == first


def test_what_is_taken_of_a_topic(tmp_path):
    z = {"topic": "/model/ball/odometry", "field": "pose.position.z"}
    row = one(tmp_path, duration=1, measures={
        **{take: {**z, "take": take} for take in ("last", "first", "min", "max", "mean", "count")},
        "time": {**z, "take": "time", "below": 1.0},
        "never": {**z, "take": "time", "above": 5},
        "high": {**z, "take": "count", "above": 1.0, "below": 1.9},
        "stamp": {"topic": "/model/ball/odometry", "field": "header.stamp"},
        "name": {"topic": "/model/ball/odometry", "field": "header.data[0].key"},
        "other": {"topic": "/model/ball/odometry_with_covariance", "take": "count"},
    })
    assert row.reason == ""
    taken = row.measures
    assert taken["count"] == taken["other"] == 51
    assert taken["first"] == taken["max"] > 1.99
    assert 0.45 < taken["min"] <= taken["last"] < 0.55
    assert taken["min"] < taken["mean"] < taken["max"]
    assert math.isclose(taken["time"], math.sqrt(2 / 9.8), abs_tol=0.03)
    assert taken["never"] is None
    assert 0 < taken["high"] < 51
    assert taken["stamp"] == row.sim_time == 1.0
    assert taken["name"] == "frame_id"


def test_commands_are_given_at_their_time(tmp_path):
    judge = "def hear(sim, parameters):\n    sim.heard = []\n    sim.subscribe('/t', lambda m: sim.heard.append((sim.time, m)))\n" \
            "def said(sim, parameters):\n    return str([(t, m['linear']['x']) for t, m in sim.heard])\n"
    write(tmp_path, "judge.py", judge)
    results = make(tmp_path, parameters={"v": {"values": [1, 2.5]}}, setup=str(tmp_path / "judge.py:hear"),
                   commands=[{"topic": "/t", "type": "Twist", "at": 0.1, "message": {"linear": {"x": "$v"}}},
                             {"topic": "/t", "type": "Twist", "message": "linear {x: 1${v}}"}],
                   measures={"said": {"function": str(tmp_path / "judge.py:said")}})
    assert results.column("said") == ["[(0.0, 11.0), (0.1, 1.0)]", "[(0.0, 12.5), (0.1, 2.5)]"]


def test_until_ends_a_run_and_a_limit_fails_it(tmp_path):
    until = {"topic": "/model/ball/odometry", "field": "pose.position.z", "below": 1.5}
    results = make(tmp_path, duration=None, until=until, limits={"simulated": 0.4})
    low, high = results.rows
    assert low.is_done and math.isclose(low.sim_time, math.sqrt(1 / 9.8), abs_tol=0.03)
    assert high.status == "failed" and high.reason == "it did not end within 0.4 simulated seconds"
    assert high.state_hash == "" and high.measures == {}


def test_a_function_measures_and_may_drive(tmp_path):
    write(tmp_path, "helper.py", "FACTOR = 10\n")
    write(tmp_path, "judge.py", "from helper import FACTOR\n"
          "def score(sim, parameters):\n    sim.step(3)\n    return FACTOR * parameters['height'] + sim.iterations\n")
    results = make(tmp_path, duration=0, measures={"score": {"function": str(tmp_path / "judge.py:score")}})
    assert results.column("score") == [23, 33]
    with pongsim.Simulation(WORLD) as sim:
        sim.step(3)
        assert results.rows[0].state_hash == f"{sim.state_hash():016x}"


RAISES = """
def raises(sim, parameters):
    if parameters["height"] == 3:
        raise ValueError("too high")
    return 1
def exits(sim, parameters):
    if parameters["height"] == 3:
        raise SystemExit(3)
    return 1
def gives_a_list(sim, parameters):
    return [] if parameters["height"] == 3 else 1
"""


@pytest.mark.parametrize("name, reason", [
    ("raises", r"ValueError: too high (judge.py:4)"), ("exits", "SystemExit: 3 (judge.py:8)"),
    ("gives_a_list", "measure 'm': gives_a_list returned a list, not a number, text, true or false"),
])
def test_a_measure_that_raises_fails_its_run_only(tmp_path, name, reason):
    write(tmp_path, "judge.py", RAISES)
    results = make(tmp_path, measures={"m": {"function": str(tmp_path / f"judge.py:{name}")}})
    assert [(row.status, row.reason) for row in results.rows] == [("done", ""), ("failed", reason)]


@pytest.mark.parametrize("measure, reason", [
    ({"topic": "/model/ball/odometri"}, "no messages on /model/ball/odometri (did you mean '/model/ball/odometry'?)"),
    ({"field": "pose.positon.z"}, "a message of /model/ball/odometry has no 'positon' (did you mean 'position'?)"),
    ({"field": "pose.position"}, "'pose.position' is not a single value"),
    ({"field": "pose.position[0]"}, "a message of /model/ball/odometry has no [0]: it is not a list"),
    ({"field": "pose..z"}, "'pose..z' is not a field; write pose.position.x or pose[0].name"),
    ({"field": "header.data[0].key", "take": "mean"}, "'header.data[0].key' is 'frame_id', not a number"),
])
def test_a_topic_that_says_nothing_of_it_is_told(tmp_path, measure, reason):
    row = one(tmp_path, measures={"m": {"topic": "/model/ball/odometry", "field": "pose.position.z", **measure}})
    assert row.status == "failed" and row.reason.removeprefix("measure 'm': ") == reason


def test_a_world_that_a_value_breaks_fails_its_run_only(tmp_path):
    results = make(tmp_path, parameters={"mass": {"xpath": "//mass", "values": [1, -1, 2]}})
    assert [row.status for row in results.rows] == ["done", "failed", "done"]
    # the line is that of the file
    assert "w.sdf:7:" in results.rows[1].reason and "mass" in results.rows[1].reason


def test_what_a_world_leaves_out_is_said_once(tmp_path):
    write(tmp_path, "w.sdf", WORLD.replace("<static>true</static><link", "<static>true</static><what/><link", 1))
    said = []
    results = make(tmp_path, options={"say": said.append})
    assert not results.failed
    assert len(said) == 1 and "w.sdf:5:" in said[0] and "what" in said[0]


def test_a_world_finds_what_lies_beside_it(tmp_path):
    write(tmp_path, "box.sdf", "<sdf version='1.9'><model name='box'><link name='l'/></model></sdf>")
    write(tmp_path, "w.sdf", WORLD.replace('<model name="other">', '<include><uri>box.sdf</uri></include><model name="other">'))
    assert not make(tmp_path).failed


def test_the_table(tmp_path):
    write(tmp_path, "judge.py", "def odd(sim, parameters):\n"
          "    if parameters['height'] == 4: raise ValueError('one, \\n\"two\"')\n"
          "    return 'a,b' if parameters['height'] == 3 else True\n")
    results = make(tmp_path, parameters={"height": {"values": [2, 3, 4]}},
                   measures={"odd": {"function": str(tmp_path / "judge.py:odd")}})
    with open(results.folder / "results.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    assert list(rows[0]) == results.columns == ["run", "height", "seed", "odd", "status", "reason", "state_hash", "sim_time",
                                                "wall_time"]
    assert [row["odd"] for row in rows] == ["true", "a,b", ""]
    assert rows[2]["reason"].startswith('ValueError: one, \n"two"')
    parquet = pytest.importorskip("pyarrow.parquet")
    table = parquet.read_table(results.folder / "results.parquet").to_pydict()
    assert table["height"] == [2, 3, 4] and table["odd"] == ["true", "a,b", None]
    assert table["state_hash"] == results.column("state_hash")


def test_plots(tmp_path):
    results = make(tmp_path, seeds=2)
    image = sweep.plot(results.folder)
    assert image == results.folder / "plot.png" and image.read_bytes().startswith(b"\x89PNG")
    assert sweep.plot(results.folder, tmp_path / "p.svg", x=["seed"], y=["z"]).stat().st_size > 1000
    for arguments, message in (({"y": ["zz"]}, r"measure 'zz' is not there \(did you mean 'z'\?\)"),
                               ({"x": ["status"]}, "'status' is not a number"), ({"output": tmp_path / "a.txt"}, "can't be a '.txt' file")):
        with pytest.raises(sweep.SweepError, match=message):
            sweep.plot(results.folder, **arguments)
    assert command(tmp_path, "plot", "out", "--x", "height", "-o", "c.pdf") == (0, "c.pdf\n", "")
    code, _, error = command(tmp_path, "plot", "nothing")
    assert code == 1 and "nothing: No such file" in error


def test_a_plot_leaves_the_figures_of_a_notebook_alone(tmp_path):
    results = make(tmp_path)
    pyplot = pytest.importorskip("matplotlib.pyplot")
    before = pyplot.get_backend()
    pyplot.switch_backend("svg")
    try:
        pyplot.figure()
        sweep.plot(results.folder)
        assert pyplot.get_backend() == "svg" and pyplot.get_fignums() == [1]
    finally:
        pyplot.close("all")
        pyplot.switch_backend(before)
