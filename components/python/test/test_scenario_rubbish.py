"""Broken scenarios: each is run, or refused with its place, and nothing else."""

import random
import re

from scenarios import WORLD, write
from test_sweep_rubbish import broken

from pongsim.sweep import SweepError
from pongsim.testing import read
from pongsim.testing.execute import execute
from pongsim.testing.report import junit, lines_of, tap
from pongsim.testing.result import Status

SEEDS = (
    "world: w.sdf\nduration: 0.05\nparameters: {a: {values: [1, 2]}}\nseeds: 2\n"
    "publish: [{topic: /a, type: Int32, message: {data: $a}, at: 0.01}]\n"
    "expect:\n  - {topic: /a, eventually: {data: {at_least: 1}}, within: 0.03}\n"
    "  - {pose: ball, always: {z: {near: 2, tolerance: 0.1}, x: 0}, during: [0, 0.02]}\n",
    "world: w.sdf\nduration: 0.05\npublish:\n  - {topic: /a, type: StringMsg, message: 'data: \"x\"', every: 0.01}\n"
    "expect:\n  - in_order: [{topic: /a}, {contact: [ball, ground], is: {touching: true}}]\n"
    "    after: {velocity: ball::link, is: {speed: {above: 0.01}}}\n"
    "  - {topic: /a, never: {data: {contains: y}}, until: {pose: ball, is: {z: {below: 2}}}}\nlimits: {wall: 20}\n",
)


WORDS = ("eventually", "always", "never", "in_order", "topic", "pose", "joint", "contact", "velocity", "until", "after", "for", "at",
         "within", "during", "near", "above", "between", "tolerance", "contains", "not", "recorded", "is", "true", "0", "-1", "1e999",
         ".nan", "1e-300", "x", "/a", "ball", "ball::link", "''", "[]", "{}", "[1, 2]", "{x: 1}", "$a", "$$", "Twist", "w.sdf", "null")


def changed(text, random_):
    """The text with one word replaced by another."""
    word = random_.choice(list(re.finditer(r"[\w.$/]+", text)))
    return text[:word.start()] + random_.choice(WORDS) + text[word.end():]


def test_a_broken_file_is_run_or_refused(tmp_path):
    write(tmp_path, "w.sdf", WORLD)
    random_ = random.Random(1)
    refused = ran = mistakes = 0
    for number in range(400):
        change = random_.choice((broken, changed, changed, changed))
        text = change(random_.choice(SEEDS), random_)
        file = write(tmp_path, "s.yaml", text)
        try:
            scenario = read(file)
        except SweepError as error:
            assert str(error), text
            refused += 1
            continue
        except Exception as error:
            raise AssertionError(f"{number}: {text!r}") from error
        case = scenario.cases[0]
        if case.programs or case.duration > 1 or case.speed > 0:
            continue
        result = execute(case)
        mistakes += result.status is Status.MISTAKE
        ran += 1
        assert result.judged or result.reason, text
        assert lines_of(case, result) or result.status is Status.PASSED
        assert junit([(case, result)], 1.0) and tap([(case, result)], {case.file: True})
    assert refused > 50 and ran > 30 and mistakes > 5
