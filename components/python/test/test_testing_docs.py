"""The examples in docs/testing.md are those in examples/, its Python runs, and its commands do what it says."""

import os
import re
import subprocess
import sys

import yaml
from conftest import PROJECT

from pongsim.testing import conditions, scenario

PAGE = (PROJECT / "docs/testing.md").read_text()
BLOCK = r"((?:(?:    .*)?\n)+)"


def code_of(block):
    return "\n".join(line[4:] for line in block.rstrip("\n").split("\n")) + "\n"


def test_the_example_is_the_one_that_is_there():
    [(name, block)] = re.findall(r"<!-- scenario: (.*?) -->\n" + BLOCK, PAGE)
    there = "".join(line for line in (PROJECT / name).read_text().splitlines(True) if not line.startswith("# twin: "))
    assert code_of(block) == there


def test_the_python_runs():
    [(prints, block)] = re.findall(r"<!-- python: prints (.*?) -->\n" + BLOCK, PAGE)
    result = subprocess.run([sys.executable, "-W", "error", "-c", code_of(block)], capture_output=True, text=True, cwd=PROJECT,
                            env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"})
    assert result.returncode == 0, result.stderr
    assert re.search(prints, result.stdout, re.MULTILINE), result.stdout


def test_all_words_are_told():
    words = (*scenario.KEYS, *scenario.SIGNALS, *scenario.MODES, *scenario.WINDOW, *scenario.KEEP, *conditions.COMPARISONS)
    assert [word for word in words if not re.search(rf"`[^`\n]*\b{word}\b", PAGE)] == []


def test_the_workflows_are_yaml():
    for name in ("github.yml", "gitlab.yml"):
        text = (PROJECT / "examples/ci" / name).read_text()
        assert "pongsim test tests/*.yaml" in str(yaml.safe_load(text))


def test_the_commands_do_what_the_page_says(program):
    result = subprocess.run([PROJECT / "tools/cli-tour", "docs/testing.md"], capture_output=True, text=True, cwd=PROJECT,
                            env={**os.environ, "PONGSIM": program, "PONGSIM_PYTHON": sys.executable})
    assert result.returncode == 0, result.stdout + result.stderr
