"""Message packages of ROS 2 Humble, as `from sensor_msgs.msg import LaserScan` finds them: classes for cyclonedds made from
the definitions that rosbags has, and those of definitions.txt."""

import dataclasses
import functools
import importlib.abc
import importlib.machinery
import pathlib
import sys
import types

from cyclonedds.idl import IdlStruct
from cyclonedds.idl import types as idl
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

# rosbags' definitions come without the defaults that a few fields have.
DEFAULTS = {("geometry_msgs/msg/Quaternion", "w"): 1.0}
BASE, NAMED, ARRAY, SEQUENCE = 1, 2, 3, 4
# of a base type: what it is on the wire, and what Python has in its place
TYPES = {"bool": (bool, False), "string": (str, ""), "float32": (idl.float32, 0.0), "float64": (idl.float64, 0.0),
         "byte": (idl.uint8, 0), "octet": (idl.uint8, 0), "char": (idl.uint8, 0),
         **{name: (getattr(idl, name), 0)
            for name in ("int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64")}}


@functools.cache
def store():
    store = get_typestore(Stores.ROS2_HUMBLE)
    added = {}
    for block in pathlib.Path(__file__).with_name("definitions.txt").read_text().split("=== ")[1:]:
        name, _, definition = block.partition("\n")
        if "/msg/" in name and name not in store.fielddefs:
            added.update(get_types_from_msg(definition, name))
    store.register(added)
    return store


def field_of(kind, what):
    """The type of a field, and a function that makes its initial value."""
    if kind == BASE:
        made, default = TYPES[what[0]]
        return made, lambda: default
    if kind == NAMED:
        made = message(what)
        return made, made
    (inner_kind, inner), size = what
    made, first = field_of(inner_kind, inner)
    if kind == ARRAY:
        return idl.array[made, size], lambda: [first() for _ in range(size)]
    return idl.sequence[made, size] if size else idl.sequence[made], list


@functools.cache
def message(name):
    """The class of `sensor_msgs/msg/LaserScan`."""
    constants, fields = store().fielddefs[name]
    package, _, short = name.split("/")
    annotations, values = {}, {}
    for field, (kind, what) in fields:
        annotations[field], first = field_of(int(kind), what)
        default = DEFAULTS.get((name, field))
        if default is not None:
            first = functools.partial(lambda value: value, default)
        values[field] = dataclasses.field(default_factory=first)
    made = types.new_class(short, (IdlStruct,), {"typename": f"{package}::msg::dds_::{short}_"},
                           lambda body: body.update({"__annotations__": annotations, "__module__": f"{package}.msg",
                                                     **values}))
    made = dataclasses.dataclass(made)
    for constant, _, value in constants:
        setattr(made, constant, value)
    return made


def check(value, where=""):
    """Refuses what rclpy refuses: a number of the wrong kind, such as `twist.linear.x = 0`."""
    for field, (kind, what) in store().fielddefs[name_of(type(value))][1]:
        _check_field(getattr(value, field), int(kind), what, f"{where}{field}")


def name_of(kind):
    """The name in ROS of a class."""
    return f"{kind.__module__.replace('.', '/')}/{kind.__name__}"


def _check_field(value, kind, what, where):
    if kind == NAMED:
        assert isinstance(value, message(what)), f"The '{where}' field must be a sub message of type '{what}'"
        check(value, where + ".")
    elif kind == BASE:
        expected = type(TYPES[what[0]][1])
        assert isinstance(value, expected), f"The '{where}' field must be of type '{expected.__name__}'"
    else:
        (inner_kind, inner), size = what
        assert kind != ARRAY or len(value) == size, f"The '{where}' field must have {size} elements"
        for i, each in enumerate(value):
            _check_field(each, int(inner_kind), inner, f"{where}[{i}]")


class Finder(importlib.abc.MetaPathFinder, importlib.abc.Loader):
    """Makes the modules PACKAGE and PACKAGE.msg of the packages that have messages."""

    @functools.cached_property
    def packages(self):
        return {name.split("/")[0] for name in store().fielddefs}

    def find_spec(self, fullname, path=None, target=None):
        package, _, rest = fullname.partition(".")
        if rest not in ("", "msg") or package not in self.packages:
            return None
        return importlib.machinery.ModuleSpec(fullname, self, is_package=rest == "")

    def exec_module(self, module):
        package, _, rest = module.__name__.partition(".")
        if rest == "":
            return

        def find(name):
            if f"{package}/msg/{name}" not in store().fielddefs:
                raise AttributeError(f"module '{module.__name__}' has no attribute '{name}'")
            return message(f"{package}/msg/{name}")

        module.__getattr__ = find


def install():
    # after all others, so that installed packages take precedence
    sys.meta_path.append(Finder())
