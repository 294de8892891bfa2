"""All mistakes of a file at once, instead of the first."""

from __future__ import annotations

import functools
from typing import Callable, Sequence, TypeVar

from ..sweep.document import Node
from ..sweep.errors import SweepError

_Value = TypeVar("_Value")


class SeveralErrors(SweepError):
    """Several mistakes; the text has a line for each."""

    def __init__(self, errors: Sequence[SweepError]) -> None:
        super().__init__("\n".join(map(str, errors)))
        self.errors = list(errors)


class Mistakes:
    """Collects the mistakes of parts that do not depend on each other."""

    def __init__(self) -> None:
        self._found: list[SweepError] = []

    def of(self, read: Callable[[], _Value], instead: _Value) -> _Value:
        """Returns what a function reads; `instead`, if it finds a mistake."""
        try:
            return read()
        except SweepError as error:
            self._found.append(error)
            return instead

    def each(self, node: Node | None, what: str, read: Callable[[Node], _Value]) -> list[_Value]:
        """Returns what a function reads from each element of a list, without those that have mistakes."""
        made: list[_Value] = []
        nodes: list[Node] = []
        if node is not None:
            nodes = self.of(functools.partial(node.list, what), nodes)
        for each in nodes:
            try:
                made.append(read(each))
            except SweepError as error:
                self._found.append(error)
        return made

    def check(self) -> None:
        """Raises SweepError if there are any."""
        if len(self._found) == 1:
            raise self._found[0]
        if self._found:
            raise SeveralErrors(sorted(self._found, key=_place))


def _place(error: SweepError) -> list[int]:
    """Line and column."""
    return [int(each) for each in error.at.split(":")[-2:] if each.isdigit()]
