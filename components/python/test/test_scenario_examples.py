"""The scenarios of the project pass, each has a twin that must fail, and both fit the published schema."""

import json
import os
import pathlib
import re

import jsonschema
import pytest
import yaml
from conftest import PROJECT
from scenarios import command

from pongsim.testing import places, read, scenario

SCHEMA = json.loads(places.schema().read_text())
TUTORIALS = pathlib.Path(os.environ.get("PONGSIM_FORTRESS_WORLDS", PROJECT.parent / "shared/fortress")) / "tutorials"
FILES = sorted([*PROJECT.glob("plugins/*/*/*.yaml"), *PROJECT.glob("test/scenarios/*.yaml"), *PROJECT.glob("examples/*/*.scenario.yaml")])
#: A comment: what the twin has instead, and what is said about it.
TWIN = re.compile(r"^# twin: (.+?) => (.+?) => (.+)$", re.MULTILINE)
BUILD = pathlib.Path(os.environ.get("PONGSIM", "")).parents[1]


def name_of(file):
    return str(file.relative_to(PROJECT))


def environment():
    return {"PONGSIM_RESOURCE_PATH": str(TUTORIALS), "PATH": f"{BUILD}/test:{BUILD}/bin:{os.environ['PATH']}"}


def skip_without_its_world(file):
    world = yaml.safe_load(file.read_text())["world"]
    if not (file.parent / world).exists() and not (TUTORIALS / world).exists():
        pytest.skip(f"there is no {world} of Fortress here")


def test_each_example_world_of_a_system_has_one():
    worlds = {file.parent for file in PROJECT.glob("plugins/*/*/*.sdf")}
    assert len(worlds) >= 60
    assert worlds - {file.parent for file in FILES} == set()


@pytest.mark.parametrize("file", FILES, ids=name_of)
def test_it_fits_the_schema(file):
    jsonschema.Draft202012Validator.check_schema(SCHEMA)
    jsonschema.validate(yaml.safe_load(file.read_text()), SCHEMA)


def test_they_pass(tmp_path):
    files = [file for file in FILES if TUTORIALS.is_dir() or not name_of(file).startswith("test/")]
    # some worlds write files into the folder where they run
    code, out, err = command(tmp_path, *files, **environment())
    assert (code, err) == (0, ""), out


@pytest.mark.parametrize("file", FILES, ids=name_of)
def test_its_twin_fails(file, tmp_path):
    skip_without_its_world(file)
    text = file.read_text()
    [(old, new, words)] = TWIN.findall(text)
    body = text.replace(TWIN.search(text).group(), "")
    assert body.count(old) == 1, "the twin differs in one place"
    here = file.parent / yaml.safe_load(text)["world"]
    changed = body.replace(old, new.replace("\\n", "\n"))
    if here.exists():
        changed = re.sub(r"^world: .*$", f"world: {here}", changed, flags=re.MULTILINE)
    twin = tmp_path / "twin.yaml"
    twin.write_text(changed)
    code, out, err = command(tmp_path, "twin.yaml", **environment())
    assert (code, err) == (1, ""), out
    assert re.search(words, out, re.DOTALL), out


def test_all_keys_are_in_the_schema():
    assert sorted(SCHEMA["properties"]) == sorted(scenario.KEYS)
    expectation = SCHEMA["$defs"]["expectation"]["properties"]
    assert sorted(expectation) == sorted(["name", *scenario.SIGNALS, *scenario.MODES, *scenario.WINDOW])


WRONG = {
    "a key": "world: w\nduration: 1\nexpect: [{pose: a, always: {x: 1}}]\nexpct: 1\n",
    "a comparison": "world: w\nduration: 1\nexpect: [{pose: a, always: {x: {abve: 1}}}]\n",
    "no mode": "world: w\nduration: 1\nexpect: [{pose: a}]\n",
    "two modes": "world: w\nduration: 1\nexpect: [{pose: a, always: {x: 1}, never: {x: 2}}]\n",
    "an event": "world: w\nduration: 1\nexpect: [{pose: a, always: {x: 1}, after: {data: 1}}]\n",
    "no time": "world: w\nduration: soon\nexpect: [{pose: a, always: {x: 1}}]\n",
}


@pytest.mark.parametrize("text", WRONG.values(), ids=WRONG.keys())
def test_the_schema_finds_mistakes_as_the_command_does(tmp_path, text):
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(yaml.safe_load(text), SCHEMA)
    (tmp_path / "w").write_text("")
    (tmp_path / "s.yaml").write_text(text)
    with pytest.raises(Exception, match="s.yaml:"):
        read(tmp_path / "s.yaml")
