"""Inserts parameters into a world's file by XPath. Everything else in the file stays unchanged, including its lines."""

from __future__ import annotations

import dataclasses
import pathlib
import re
from typing import Any, Iterable, Mapping
from xml.parsers import expat
from xml.sax.saxutils import escape

from . import template
from .errors import SweepError, need
from .plan import Target

#: Maximum number of matches listed in a message.
_MOST_LISTED = 4


@dataclasses.dataclass(frozen=True)
class TargetPath:
    """A target in the sweep's file: where a parameter goes."""

    parameter: str
    xpath: str
    #: A text with $NAME in it, to be inserted instead of the value alone.
    text: str | None
    #: Position in the sweep's file.
    at: str


def read(file: str, at: str) -> str:
    """Returns the world's text. Raises SweepError if there is none."""
    try:
        return pathlib.Path(file).read_text(encoding="utf-8")
    except OSError as error:
        raise SweepError(f"{file}: {error.strerror}", at=at) from None
    except UnicodeDecodeError:
        raise SweepError(f"{file} is not UTF-8 text, so parameters can't be put into it", at=at) from None


def find(text: str, file: str, paths: Iterable[TargetPath]) -> tuple[Target, ...]:
    """Finds the places in the text that the targets select. Raises SweepError, with the position in the sweep's
    file, if one does not select exactly one place."""
    etree = need("lxml.etree", "a sweep whose parameters have an xpath")
    data = text.encode()
    try:
        root = etree.fromstring(data, etree.XMLParser(resolve_entities=False, no_network=True, encoding="utf-8"))
    except etree.XMLSyntaxError as error:
        raise SweepError(f"it is not XML, so parameters can't be put into it: {error.msg}",
                         at=":".join([file, *map(str, error.position)])) from None
    elements = _places(data)
    numbers = {each: i for i, each in enumerate(root.iter(etree.Element))}
    targets: list[Target] = []
    for path in paths:
        thing = _match(etree, root, file, path)
        is_attribute = getattr(thing, "is_attribute", False)
        element = thing.getparent() if isinstance(thing, str) else thing  # type: ignore[attr-defined]
        begin, end = elements[numbers[element]]
        name = thing.attrname if isinstance(thing, str) and is_attribute else ""  # type: ignore[attr-defined]
        target = _target(path, data, begin, end, name)
        if any(target.begin < each.end and each.begin < target.end or target.begin == each.begin for each in targets):
            raise SweepError(f"'{path.xpath}' selects the same place as another parameter", at=path.at)
        targets.append(target)
    return tuple(sorted(targets, key=lambda each: each.begin))


def put(text: str, targets: Iterable[Target], parameters: Mapping[str, Any]) -> str:
    """Returns the world with the values inserted."""
    data = text.encode()
    parts: list[bytes] = []
    end = 0
    for target in targets:
        value = template.fill(target.text, parameters) if target.text is not None else parameters[target.parameter]
        shown = target.before + escape(template.written(value), {'"': "&quot;"}) + target.after
        parts += [data[end:target.begin], shown.encode()]
        end = target.end
    return b"".join([*parts, data[end:]]).decode()


def _places(data: bytes) -> list[tuple[int, int]]:
    """Returns for each element, in the order of the file, where its start tag and its end tag begin."""
    places: list[tuple[int, int]] = []
    inside: list[int] = []
    parser = expat.ParserCreate("utf-8")

    def begin(name: str, attributes: dict[str, str]) -> None:
        inside.append(len(places))
        places.append((parser.CurrentByteIndex, 0))

    def end(name: str) -> None:
        number = inside.pop()
        places[number] = (places[number][0], parser.CurrentByteIndex)

    parser.StartElementHandler = begin
    parser.EndElementHandler = end
    parser.Parse(data, True)
    return places


_TAG = re.compile(rb"""<([^\s/>]+)(?:[^>"']|"[^"]*"|'[^']*')*>""")


def _target(path: TargetPath, data: bytes, begin: int, end: int, attribute: str) -> Target:
    tag = _TAG.match(data, begin)
    assert tag is not None
    if attribute:
        for match in re.finditer(rb"""\s([^\s=]+)\s*=\s*("[^"]*"|'[^']*')""", tag.group()):
            if match.group(1).decode() == attribute:
                return Target(path.parameter, path.text, begin + match.start(2), begin + match.end(2), '"', '"')
        raise SweepError(f"'{path.xpath}' selects an attribute that comes from another file", at=path.at)
    if tag.group().endswith(b"/>"):
        opened = tag.group()[:-2].decode().rstrip() + ">"
        return Target(path.parameter, path.text, begin, tag.end(), opened, f"</{tag.group(1).decode()}>")
    return Target(path.parameter, path.text, tag.end(), end, "", "")


def _match(etree: Any, root: Any, file: str, path: TargetPath) -> Any:
    """Returns the one element or attribute that a path matches."""
    try:
        found = root.getroottree().xpath(path.xpath)
    except (etree.XPathError, ValueError) as error:  # ValueError: a character that XML does not allow
        raise SweepError(f"'{path.xpath}' is not an XPath: {error}", at=path.at) from None
    if not isinstance(found, list):
        raise SweepError(f"'{path.xpath}' gives {found!r}, not an element or attribute", at=path.at, hint="a path, as //wheel/radius")
    if not found:
        raise SweepError(f"'{path.xpath}' matches nothing in {file}", at=path.at, hint=_farthest(etree, root, file, path.xpath))
    if len(found) > 1:
        listed = ", ".join(_name(each, file) for each in found[:_MOST_LISTED])
        more = f" and {len(found) - _MOST_LISTED} more" if len(found) > _MOST_LISTED else ""
        raise SweepError(f"'{path.xpath}' matches {len(found)} places: {listed}{more}", at=path.at,
                         hint="be more specific, such as //model[@name='x']/..., or give a list of paths")
    thing = found[0]
    if isinstance(thing, str):
        if getattr(thing, "is_attribute", False):
            return thing
        if getattr(thing, "is_text", False):
            thing = thing.getparent()  # type: ignore[attr-defined]
    if not etree.iselement(thing) or not isinstance(thing.tag, str):
        raise SweepError(f"'{path.xpath}' is neither an element nor an attribute", at=path.at)
    if len(thing.findall("*")):
        raise SweepError(f"'{path.xpath}' matches {_name(thing, file)}, which contains elements", at=path.at,
                         hint="a value must go into an element with only text: " + _inside(thing))
    return thing


def _name(thing: Any, file: str) -> str:
    if isinstance(thing, str):
        return f"{getattr(thing, 'attrname', None) or 'text'} at {file}:{thing.getparent().sourceline}"  # type: ignore[attr-defined]
    return f"<{getattr(thing, 'tag', '?')}> at {file}:{getattr(thing, 'sourceline', '?')}"


def _inside(element: Any) -> str:
    return ", ".join(dict.fromkeys(str(each.tag) for each in element if isinstance(each.tag, str))) or "nothing"


def _farthest(etree: Any, root: Any, file: str, path: str) -> str:
    """Returns the match of the longest prefix of the path that matches."""
    for i in range(len(path) - 1, 0, -1):
        part = path[:i]
        if path[i] != "/" or not part.strip("/"):
            continue
        try:
            found = root.getroottree().xpath(part)
        except etree.XPathError:  # the slash is inside [ ], so that the prefix is no path
            continue
        if isinstance(found, list) and found and etree.iselement(found[0]):
            return f"'{part}' matches {_name(found[0], file)}, which contains: {_inside(found[0])}"
    return "what the file includes is not part of it"
