"""The examples in docs/sweeps.md are those in examples/, and its Python runs."""

import os
import re
import subprocess
import sys

from conftest import PROJECT

from pongsim import sweep
from pongsim.sweep import plan, reading

PAGE = (PROJECT / "docs/sweeps.md").read_text()
BLOCK = r"((?:(?:    .*)?\n)+)"


def code_of(block):
    return "\n".join(line[4:] for line in block.rstrip("\n").split("\n")) + "\n"


def test_the_examples_are_those_that_are_there():
    shown = re.findall(r"<!-- sweep: (.*?) -->\n" + BLOCK, PAGE)
    assert len(shown) == 2
    for name, block in shown:
        assert code_of(block) == (PROJECT / name).read_text()


def test_the_python_runs():
    [(prints, block)] = re.findall(r"<!-- python: prints (.*?) -->\n" + BLOCK, PAGE)
    result = subprocess.run([sys.executable, "-W", "error", "-c", code_of(block)], capture_output=True, text=True, cwd=PROJECT,
                            env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"})
    assert result.returncode == 0, result.stderr
    assert re.search(prints, result.stdout, re.MULTILINE), result.stdout


def test_everything_has_a_docstring():
    assert [name for name in sweep.__all__ if not (getattr(sweep, name).__doc__ or "").strip()] == []


def test_all_keys_are_told():
    for key in (*reading._KEYS, *plan.TAKES, *reading.RESERVED):
        assert f"`{key}`" in PAGE, key


def test_the_commands_do_what_the_page_says(program):
    result = subprocess.run([PROJECT / "tools/cli-tour", "docs/sweeps.md"], capture_output=True, text=True, cwd=PROJECT,
                            env={**os.environ, "PONGSIM": program, "PONGSIM_PYTHON": sys.executable})
    assert result.returncode == 0, result.stdout + result.stderr
