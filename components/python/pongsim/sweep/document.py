"""YAML values that know their position in the file."""

from __future__ import annotations

import dataclasses
import math
import re
import sys
from typing import Any, Iterable, NoReturn

from .errors import SweepError, nearest, need

_GREATEST = sys.float_info.max


@dataclasses.dataclass(frozen=True)
class Node:
    """A value in the file: a mapping of names to nodes, a list of nodes, or a scalar."""

    value: Any
    at: str

    def fail(self, message: str, hint: str = "") -> NoReturn:
        """Raises SweepError with this position."""
        raise SweepError(message, at=self.at, hint=hint)

    def plain(self) -> Any:
        """Returns the value without positions."""
        if isinstance(self.value, dict):
            return {key: node.plain() for key, node in self.value.items()}
        if isinstance(self.value, list):
            return [node.plain() for node in self.value]
        return self.value

    def mapping(self, what: str, known: Iterable[str] | None = None) -> dict[str, Node]:
        """Returns the content by name; names other than `known` are errors."""
        if not isinstance(self.value, dict):
            self.fail(f"{what} must be a mapping with lines 'name: value', not {self._kind()}")
        children: dict[str, Node] = self.value
        if known is not None:
            names = list(known)
            for name, child in children.items():
                if name not in names:
                    child.fail(f"{what} has no '{name}'", nearest(name, names))
        return children

    def list(self, what: str) -> list[Node]:
        """Returns the list's elements, at least one."""
        if not isinstance(self.value, list):
            self.fail(f"{what} must be a list such as [1, 2], not {self._kind()}")
        children: list[Node] = self.value
        if not children:
            self.fail(f"{what} is empty")
        return children

    def text(self, what: str) -> str:
        """A text that is not empty."""
        if not isinstance(self.value, str) or not self.value.strip():
            self.fail(f"{what} must be text, not {self._kind()}")
        return self.value

    def number(self, what: str, *, above: float = -math.inf, least: float = -math.inf) -> float:
        """A finite number."""
        # YAML integers are unlimited
        if isinstance(self.value, bool) or not isinstance(self.value, (int, float)) or not abs(self.value) <= _GREATEST:
            self.fail(f"{what} must be a number, not {self._kind()}")
        number: float = self.value
        if number <= above:
            self.fail(f"{what} must be above {above:g}, not {number:g}")
        if number < least:
            self.fail(f"{what} must be at least {least:g}, not {number:g}")
        return number

    def whole(self, what: str, *, least: int = 0, most: int = 2**63 - 1) -> int:
        """A whole number."""
        if isinstance(self.value, bool) or not isinstance(self.value, int) or not least <= self.value <= most:
            self.fail(f"{what} must be a whole number from {least} to {most}, not {self._kind()}")
        number: int = self.value
        return number

    def scalar(self, what: str) -> Any:
        """A number, a text, true or false."""
        if not isinstance(self.value, (bool, int, float, str)):
            self.fail(f"{what} must be a number, text, true or false, not {self._kind()}")
        return self.value

    def _kind(self) -> str:
        if isinstance(self.value, dict):
            return "a mapping"
        if isinstance(self.value, list):
            return "a list"
        return "nothing" if self.value is None else repr(self.value)


# As in YAML 1.2: 1e-3 is a number.
_FLOAT = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$")


def read(text: str, file: str, purpose: str = "a sweep") -> Node:
    """Parses the file. Raises SweepError with the position."""
    yaml = need("yaml", purpose)

    class Loader(yaml.SafeLoader):  # type: ignore[misc, name-defined]
        """Does not accept aliases, with which a few lines can produce endless values."""

        def compose_node(self, parent: Any, index: Any) -> Any:
            if self.check_event(yaml.events.AliasEvent):
                event = self.peek_event()
                raise SweepError("aliases (*name) are not supported", at=_place(file, event.start_mark))
            return super().compose_node(parent, index)

    Loader.yaml_implicit_resolvers = {
        first: [(tag, _FLOAT if tag.endswith(":float") else pattern) for tag, pattern in resolvers
                if not tag.endswith(":timestamp")]
        for first, resolvers in yaml.SafeLoader.yaml_implicit_resolvers.items()
    }
    # integers are tried first, and .inf and .nan stay as they are
    for first in "-+.0123456789":
        resolvers = Loader.yaml_implicit_resolvers.setdefault(first, [])
        resolvers.sort(key=lambda each: each[0].endswith(":float"))
        resolvers.append(("tag:yaml.org,2002:float", re.compile(r"[-+]?\.(inf|Inf|INF|nan|NaN|NAN)$")))
    try:
        loader = Loader(text)
        root = loader.get_single_node()
        if root is None:
            raise SweepError("the file is empty", at=f"{file}:1:1")
        return _convert(loader, root, file)
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        unquoted = any(words in str(error.problem) for words in ("mapping values", "expected ',' or"))
        hint = "put text with : # { [ > and the like in quotes" if unquoted else ""
        raise SweepError(str(error.problem or error.context), at=_place(file, mark), hint=hint) from None
    except yaml.YAMLError as error:
        raise SweepError(" ".join(str(error).split()), at=file) from None
    except RecursionError:
        raise SweepError("it is nested too deeply", at=file) from None


def _place(file: str, mark: Any) -> str:
    return f"{file}:{mark.line + 1}:{mark.column + 1}" if mark is not None else file


def _convert(loader: Any, node: Any, file: str) -> Node:
    at = _place(file, node.start_mark)
    if node.id == "sequence":
        return Node([_convert(loader, each, file) for each in node.value], at)
    if node.id != "mapping":
        try:
            return Node(loader.construct_object(node), at)
        except ValueError as error:
            raise SweepError(f"'{node.value}': {error}", at=at) from None
    children: dict[str, Node] = {}
    for key, value in node.value:
        name = key.value if key.id == "scalar" else None
        if name is None:
            raise SweepError("names must be text", at=_place(file, key.start_mark))
        if name in children:
            raise SweepError(f"'{name}' is given twice", at=_place(file, key.start_mark))
        child = _convert(loader, value, file)
        # errors in a block are reported at its name
        children[name] = Node(child.value, _place(file, key.start_mark)) if value.id != "scalar" else child
    return Node(children, at)


def from_plain(value: Any, at: str) -> Node:
    """Converts values from a Python program to a node; its position is the path to it."""
    if isinstance(value, dict):
        return Node({str(key): from_plain(each, f"{at}.{key}") for key, each in value.items()}, at)
    if isinstance(value, (list, tuple)):
        return Node([from_plain(each, f"{at}[{i}]") for i, each in enumerate(value)], at)
    return Node(value, at)
