"""Compares each type with rosbags, an independent codec with its own definitions: bytes, hashes and fields."""

import os
import pathlib
import random
import re
import subprocess

import pytest
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

CODEC = os.environ["PONGSIM_ROS2_CODEC"]
DEFINITIONS = pathlib.Path(__file__).with_name("definitions.txt")
SINGLE, NAMED, ARRAY, SEQUENCE = 1, 2, 3, 4


def known(name):
    """rosbags only knows messages: requests of services and actions are registered as such under another name."""
    return name.replace("/srv/", "/msg/Srv").replace("/action/", "/msg/Action")


def all_types():
    store = get_typestore(Stores.ROS2_HUMBLE)
    added = {}
    for block in DEFINITIONS.read_text().split("=== ")[1:]:
        name, _, definition = block.partition("\n")
        if name not in store.fielddefs:
            added.update(get_types_from_msg(definition, known(name)))
    store.register(added)
    return store


STORE = all_types()


def ours():
    """The names of the program's types."""
    text = DEFINITIONS.with_name("all_types.hh").read_text()
    messages, services, actions = re.findall(r"TypeList<(.*?)>;", text, re.S)
    for name in re.findall(r"(\w+)::(\w+)", messages):
        yield "/msg/".join(name)
    for package, name in re.findall(r"(\w+)::srv::(\w+)", services):
        yield f"{package}/srv/{name}_Request"
        yield f"{package}/srv/{name}_Response"
    for package, name in re.findall(r"(\w+)::action::(\w+)", actions):
        for part in ("Goal", "Result", "Feedback", "SendGoal_Request", "SendGoal_Response", "GetResult_Request",
                     "GetResult_Response", "FeedbackMessage"):
            yield f"{package}/action/{name}_{part}"


@pytest.fixture(scope="module")
def codec():
    process = subprocess.Popen([CODEC], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def ask(line):
        process.stdin.write(line + "\n")
        process.stdin.flush()
        return process.stdout.readline().strip()

    yield ask
    process.stdin.close()
    assert process.wait(60) == 0


def some_primitive(chance, kind):
    name, bound = kind if isinstance(kind, tuple) else (kind, 0)
    if name == "string":
        return "".join(chance.choice("abcä /:") for _ in range(chance.randrange(min(bound or 9, 9) + 1)))
    if name == "bool":
        return chance.random() < 0.5
    if name == "float32":
        return chance.randrange(-1000, 1000) / 8
    if name == "float64":
        return chance.uniform(-1e9, 1e9)
    if name in ("octet", "byte", "char"):
        return chance.randrange(256)
    bits = int(re.search(r"\d+", name).group())
    low = 0 if name.startswith("u") else -(1 << (bits - 1))
    return chance.randrange(low, low + (1 << bits))


def some_value(chance, kind, detail):
    if int(kind) == SINGLE:
        return some_primitive(chance, detail)
    if int(kind) == NAMED:
        return some_message(chance, detail)
    (element_kind, element), bound = detail
    count = bound if int(kind) == ARRAY else chance.randrange(min(bound or 4, 4) + 1)
    values = [some_value(chance, element_kind, element) for _ in range(count)]
    name = element[0] if isinstance(element, tuple) else element
    if int(element_kind) == SINGLE and name != "string":
        import numpy

        return numpy.array(values, dtype={"octet": "uint8", "byte": "uint8", "char": "uint8"}.get(name, name))
    return values


def some_message(chance, name):
    _, fields = STORE.fielddefs[name]
    if [field for field, _ in fields] == ["structure_needs_at_least_one_member"]:
        return STORE.types[name](0)
    return STORE.types[name](**{field: some_value(chance, *what) for field, what in fields})


@pytest.mark.parametrize("name", sorted(ours()))
def test_has_the_same_bytes(codec, name):
    chance = random.Random(name)
    for _ in range(20):
        sent = bytes(STORE.serialize_cdr(some_message(chance, known(name)), known(name)))
        heard = codec(f"{name} {sent.hex()}")
        assert heard == sent.hex()


@pytest.mark.parametrize("name", sorted(name for name in ours() if "/msg/" in name))
def test_has_the_same_hash(codec, name):
    assert codec(name) == STORE.hash_rihs01(name)


@pytest.mark.parametrize("name", sorted(name for name in ours() if "/msg/" in name))
def test_has_the_same_definition(codec, name):
    """Constants are left out of ours, because readers do not need them."""
    described = get_types_from_msg(codec(f"{name} definition").replace("|", "\n"), name)
    assert name in described
    for each, (_, fields) in described.items():
        wanted = [field for field in STORE.fielddefs[each][1] if field[0] != "structure_needs_at_least_one_member"]
        assert [with_octets(field) for field in fields] == [with_octets(field) for field in wanted], each


def with_octets(field):
    """'byte' and 'octet' are the same."""
    return repr(field).replace("'byte'", "'octet'")
