"""Broken sweep files: each is read, or refused with SweepError, and nothing else."""

import random

from sweeps import WORLD, write

from pongsim import sweep
from pongsim.sweep import SweepError

SEEDS = (
    "world: w.sdf\nduration: 1\nmeasures: {m: {function: judge.py:score}}\n"
    "parameters: {a: {values: [1, 2]}, b: {range: {from: 0, to: 1, count: 3}}}\nseeds: 2\n",
    "world: w.sdf\nduration: 0.1\ncombine: zip\nmeasures: {m: {function: judge.py:score}}\n"
    "parameters:\n  a: &a {values: [1, x, true]}\n  b: *a\nseeds: [1, 2]\n",
)
PIECES = ("{", "}", "[", "]", ":", "- ", "\n", "  ", "*a", "&a ", "!!python/object:os.system ", "<<: ", "1e999", "-1", ".nan",
          "null", "\t", "\"", "'", "\0", "\x85", "é", "values", "range", "9" * 400, "? ", "|", ">", "#", "%YAML 1.2\n---\n")


def broken(text, random_):
    """The text with a few pieces inserted, removed or repeated."""
    for _ in range(random_.randint(1, 4)):
        at = random_.randrange(len(text) + 1)
        end = min(len(text), at + random_.randint(0, 12))
        text = text[:at] + random_.choice((random_.choice(PIECES), "", text[at:end] * 2)) + text[end:]
    return text


def test_a_broken_file_is_read_or_refused(tmp_path):
    write(tmp_path, "w.sdf", WORLD)
    write(tmp_path, "judge.py", "def score(sim, parameters):\n    return 1\n")
    random_ = random.Random(1)
    refused = 0
    for number in range(300):
        text = broken(random_.choice(SEEDS), random_)
        file = write(tmp_path, "s.yaml", text)
        try:
            sweep.read(file)
        except SweepError as error:
            assert str(error), text
            refused += 1
        except Exception as error:
            raise AssertionError(f"{number}: {text!r}") from error
    assert 0 < refused < 300
