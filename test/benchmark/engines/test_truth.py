"""pongsim beside what mechanics say: the cases of truth.py that hold, and how well."""

import math
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))

import pongsim_engine
import references
import truth

#: Largest errors: relative, or in metres.
PROMISED = {
    "ellipsoid": 1e-3,
    "wheel": 0.02,
    "coin": 0.1,
    "dominoes": 0.02,
    "cradle": 0.005,
    "slider": 5e-5,
}


@pytest.mark.parametrize("case", PROMISED)
def test_holds_what_is_promised(case):
    _, function, _ = truth.CASES[case]
    assert abs(function(pongsim_engine.Engine)) < PROMISED[case]


def test_stays_on_a_slope():
    # one minute; tools/bench truth takes ten
    assert truth.anchor(pongsim_engine.Engine, 60) < 1e-5


def test_start_is_that_of_friction_by_the_normal_forces_of_ground_without_friction():
    found = (1 + truth.start(pongsim_engine.Engine)) * references.wheelie_way(0.030, 0.5)
    assert found == pytest.approx(references.wheelie_way(0.030, 0.5, coupled=False), rel=0.04)


def test_coin_of_no_thickness_goes_round_as_the_textbook_has_it():
    rate, _, _ = references.rolling_cylinder(0.1, 1e-9, 1.0, (0.0025, 0.005), 1.0, 0.0)
    assert rate**2 == pytest.approx(4 * references.G / (0.1 * math.sin(1.0)))


def test_ellipsoid_that_hardly_moves_is_a_pendulum():
    moment = 0.026
    small = 2 * math.pi * math.sqrt((moment + 0.04) / (references.G * (0.09 / 0.2 - 0.2)))
    assert references.rocking_period(0.3, 0.2, 1.0, moment, 0.001) == pytest.approx(small, rel=1e-5)
