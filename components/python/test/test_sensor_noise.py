"""Noise of sensors that is changed without loading the world again."""

import numpy as np
import pytest
from conftest import LIDAR
from test_gym import NOISY, QUIET
from test_seeing import SCENE

import pongsim


def accelerations(sim, count=300):
    sim.step(10 * count)
    return np.array([each["linear_acceleration"]["x"] for each in sim.heard])


class Listener(pongsim.Simulation):
    def __init__(self, *args, **options):
        super().__init__(*args, **options)
        self.heard = []
        self.subscribe("/imu", self.heard)


@pytest.fixture
def quiet():
    with Listener(QUIET, seed=3) as simulation:
        yield simulation


def test_it_is_told_and_changed(quiet):
    imu = quiet.sensor("imu")
    assert list(imu.noise)[:3] == ["acceleration x", "acceleration y", "acceleration z"]
    assert set(imu.noise.values()) == {pongsim.Noise()} and not imu.has_noise
    imu.set_noise("acceleration x", stddev=0.1, mean=3)
    assert imu.noise["acceleration x"] == pongsim.Noise(stddev=0.1, mean=3) and imu.has_noise
    assert imu.noise["acceleration y"] == pongsim.Noise()
    felt = accelerations(quiet)
    assert felt.std() == pytest.approx(0.1, rel=0.15) and felt.mean() == pytest.approx(3, abs=0.03)
    # other numbers stay
    imu.set_noise(stddev=0)
    assert imu.noise["acceleration x"] == pongsim.Noise(mean=3)
    quiet.reset()
    quiet.heard.clear()
    assert imu.noise["acceleration x"] == pongsim.Noise() and not accelerations(quiet, 10).any()


def test_it_repeats_with_the_seed_as_that_of_a_file():
    with Listener(NOISY, seed=3) as file, Listener(QUIET, seed=3) as changed:
        changed.sensor("imu").set_noise("acceleration x", stddev=0.1)
        assert np.array_equal(accelerations(file, 20), accelerations(changed, 20))


def test_saved_states_have_it(quiet):
    imu = quiet.sensor("imu")
    start = quiet.save()
    imu.set_noise("acceleration x", stddev=0.1, bias_mean=1, dynamic_bias_stddev=0.5, dynamic_bias_correlation_time=1)
    quiet.step(100)
    state = quiet.save()
    quiet.heard.clear()
    expected = accelerations(quiet, 20)
    with Listener(QUIET, seed=3) as other:
        # a message on its way is no part of a state
        other.restore(state)
        assert other.sensor("imu").noise == imu.noise and other.save() == state
        assert np.array_equal(accelerations(other, 20), expected[1:])
        other.restore(start)
        other.heard.clear()
        assert not other.sensor("imu").has_noise and not accelerations(other, 5).any()


def test_of_lidars_and_cameras():
    with pongsim.Simulation(LIDAR) as sim:
        lidar = sim.sensor("lidar")
        lidar.set_noise("range", stddev=0)
        sim.run_until(0.5)
        exact = lidar.ranges.copy()
        lidar.set_noise("range", mean=0.25)
        sim.run_until(1.0)
        finite = np.isfinite(exact)
        assert finite.any() and lidar.ranges[finite] == pytest.approx(exact[finite] + 0.25, abs=1e-3)
    with pongsim.Simulation(SCENE) as sim:
        sim.gravity = (0, 0, 0)
        eye = sim.sensor("eye")
        sim.run_until(0.2)
        clear = eye.image.astype(int)
        eye.set_noise(stddev=0.1)
        sim.run_until(0.4)
        assert np.std(eye.image - clear) > 5
        eye.set_noise(stddev=0)
        sim.run_until(0.6)
        assert np.array_equal(eye.image, clear)


def test_what_is_wrong_is_told(quiet):
    imu = quiet.sensor("imu")
    with pytest.raises(KeyError, match="has no noise of a value 'acceleraton x'; did you mean 'acceleration x'"):
        imu.set_noise("acceleraton x", stddev=1)
    with pytest.raises(TypeError, match="noise has no 'stdev'; did you mean 'stddev'"):
        imu.set_noise(stdev=1)
    for bad in (-1, np.nan, np.inf):
        with pytest.raises(pongsim.Refused, match="imu"):
            imu.set_noise(stddev=bad)
    assert not imu.has_noise
