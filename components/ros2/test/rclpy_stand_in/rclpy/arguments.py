"""The arguments after --ros-args."""

import dataclasses
import sys

from ruamel.yaml import YAML


@dataclasses.dataclass
class Arguments:
    parameters: dict = dataclasses.field(default_factory=dict)
    remappings: dict = dataclasses.field(default_factory=dict)


def parse(args=None):
    """Accepts `-p NAME:=VALUE` and `-r FROM:=TO`; anything else is an error."""
    found = Arguments()
    rest = list(sys.argv[1:] if args is None else args)
    if "--ros-args" not in rest:
        return found
    rest = rest[rest.index("--ros-args") + 1:]
    while rest:
        option = rest.pop(0)
        if option not in ("-p", "--param", "-r", "--remap") or not rest or ":=" not in rest[0]:
            raise ValueError(f"the stand-in for rclpy does not know '{option}'")
        name, _, value = rest.pop(0).partition(":=")
        if option in ("-p", "--param"):
            found.parameters[name] = YAML(typ="safe").load(value)
        else:
            found.remappings[name] = value
    return found
