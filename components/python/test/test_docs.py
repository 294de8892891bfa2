"""The examples of docs/python.md and docs/gym.md run, from the project's folder."""

import os
import re
import subprocess
import sys

import pytest
from conftest import PROJECT

# an indented block after the mark
BLOCK = re.compile(r"<!-- python(?:: needs (\w+))?(?:: prints (.*?))? -->\n((?:(?:    .*)?\n)+)")
PAGES = {page: BLOCK.findall((PROJECT / "docs" / page).read_text()) for page in ("python.md", "gym.md")}
BLOCKS = [block for blocks in PAGES.values() for block in blocks]


def test_there_are_examples():
    assert len(PAGES["python.md"]) >= 5 and len(PAGES["gym.md"]) >= 3


@pytest.mark.parametrize("needs, prints, block", BLOCKS, ids=[str(i) for i in range(len(BLOCKS))])
def test_example(needs, prints, block):
    if needs:
        pytest.importorskip(needs)
    code = "\n".join(line[4:] for line in block.splitlines())
    result = subprocess.run([sys.executable, "-W", "error", "-c", code], capture_output=True, text=True, cwd=PROJECT,
                            env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"})
    assert result.returncode == 0, code + result.stderr
    if prints:
        assert re.search(prints, result.stdout), result.stdout
