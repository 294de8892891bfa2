"""The example that learns to avoid walls."""

import re
import subprocess
import sys

from conftest import PROJECT

LEARN = PROJECT / "examples/learn_to_avoid/learn.py"


def learn(*options):
    result = subprocess.run([sys.executable, LEARN, "--population", "4", "--iterations", "2", *options],
                            capture_output=True, text=True, check=True)
    return result.stdout


def test_the_same_seed_learns_the_same_policy_on_any_number_of_threads(tmp_path):
    first = learn("--seed", "3", "--threads", "1")
    assert learn("--seed", "3", "--threads", "3", "--output", str(tmp_path / "policy.npz")) == first
    assert (tmp_path / "policy.npz").stat().st_size > 34 * 8
    assert re.search(r"^learnt: return -?\d+\.\d\d, \d of 8 hit a wall$", first, re.MULTILINE)
    other = learn("--seed", "4", "--threads", "2")
    assert other.splitlines()[-1] != first.splitlines()[-1]
