"""Topics and services of other processes, in a domain of this test's own."""

import os
import subprocess

import pytest
from conftest import COURT
from test_domain import take_domain

import pongsim

PATIENCE = 60


@pytest.fixture(scope="module")
def domain():
    return take_domain()


@pytest.fixture
def shared(domain):
    with pongsim.Simulation(COURT, network=True, domain=domain) as simulation:
        yield simulation


@pytest.fixture
def start(program, domain):
    """Starts pongsim in the domain; it ends with the test."""
    started = []

    def begin(*arguments):
        started.append(
            subprocess.Popen([program, *arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                             env={**os.environ, "PONGSIM_DOMAIN": str(domain)})
        )
        return started[-1]

    yield begin
    for process in started:
        process.kill()
        process.communicate()


def output(process, sim):
    """The output of the process until its end, while the simulation continues."""
    while process.poll() is None:
        sim.step(10)
    said = process.communicate(timeout=PATIENCE)[0]
    assert process.returncode == 0, said
    return said


def test_others_hear_what_is_said_here(shared, start):
    echo = start("topic", "-e", "-t", "/model/pong_bot/odometry", "--field", "pose.position.x", "-n", "1")
    float(output(echo, shared))


def test_what_others_say_is_heard_here(shared, start):
    heard = []
    shared.subscribe("/cmd_vel", heard)
    output(start("topic", "-t", "/cmd_vel", "-m", "Twist", "-p", "linear: {x: 0.5}", "--timeout", str(PATIENCE)), shared)
    while not heard:
        shared.step()
    assert heard[0]["linear"]["x"] == 0.5
    before = shared.model("pong_bot").pose.position[0]
    shared.step(500)
    assert shared.model("pong_bot").pose.position[0] != before


def test_others_ask_services_of_this_one(shared, start):
    call = start("service", "-s", "/world/pong_world/remove", "--reqtype", "Entity", "--reptype", "Boolean", "--timeout",
                 str(PATIENCE * 1000), "--req", "name: 'pong_bot', type: MODEL")
    assert "true" in output(call, shared)
    assert "pong_bot" not in shared.model_names


def test_this_one_asks_services_of_others(domain, start, tmp_path):
    other = tmp_path / "other.sdf"
    other.write_text("<sdf version='1.9'><world name='other'><model name='crate'><link name='l'/></model></world></sdf>")
    start("run", str(other))
    with pongsim.Simulation(COURT, network=True, domain=domain) as sim:
        answer = sim.request("/world/other/remove", {"name": "crate", "type": "MODEL"}, type="Entity", timeout=PATIENCE)
        assert answer == {"data": True}
        with pytest.raises(pongsim.ServiceError):
            sim.request("/world/other/remove", {"name": "crate", "type": "MODEL"}, type="Entity", timeout=PATIENCE)
        with pytest.raises(pongsim.ServiceError):
            sim.request("/nobody/has/this", {}, type="Empty", timeout=0.2)


def test_without_a_network_nothing_leaves(start):
    with pytest.raises(ValueError, match="network=True"):
        pongsim.Simulation(COURT, domain=3)
    with pongsim.Simulation(COURT) as sim:
        wait = start("topic", "wait", "-t", "/clock", "--timeout", "1")
        while wait.poll() is None:
            sim.step(10)
        assert wait.returncode == 1


def test_a_domain_there_is_none():
    with pytest.raises(ValueError, match="domain"):
        pongsim.Simulation(COURT, network=True, domain=1000)
