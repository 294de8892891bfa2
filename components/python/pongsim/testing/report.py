"""What `pongsim test` says: for people, and as JUnit, TAP and annotations of GitHub."""

from __future__ import annotations

import pathlib
import re
from typing import Sequence
from xml.sax.saxutils import escape, quoteattr

from .result import Judged, Result, Status
from .scenario import Case
from .text_plot import text_plot

Runs = Sequence[tuple[Case, Result]]

#: The characters that XML 1.0 does not have.
_NOT_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def title(case: Case, alone: bool) -> str:
    """The name of a run; with its parameters unless it is the only one."""
    return case.name if alone else f"{case.name} {case.label}"


def lines_of(case: Case, result: Result, plots: bool = True) -> list[str]:
    """What went wrong in a run, for people."""
    lines = [*result.reason.splitlines()]
    for each in result.failures:
        lines += [f"{each.at}: {each.name or 'not met'}", f"  expected  {each.expected}", f"  seen      {each.seen}"]
        if plots:
            lines += [f"    {line}".rstrip() for line in text_plot(each.times, each.values, each.field, each.time)]
    if result.kept:
        lines += ["kept:", *(f"  {each}" for each in result.kept)]
    return lines


def summary(runs: Runs, wall: float, missing: int) -> str:
    """The last line."""
    counts = {status: sum(result.status is status for _, result in runs) for status in Status}
    words = [f"{counts[Status.PASSED]} passed"]
    words += [f"{counts[each]} {words_for}" for each, words_for in
              ((Status.FAILED, "failed"), (Status.MISTAKE, "with mistakes")) if counts[each]]
    words += [f"{missing} not run"] if missing else []
    simulated = sum(result.sim_time for _, result in runs)
    return f"{', '.join(words)}; {simulated:.5g} s simulated in {wall:.3g} s"


def junit(runs: Runs, wall: float) -> str:
    """An XML file for CI systems."""
    failed = sum(result.status is Status.FAILED for _, result in runs)
    wrong = sum(result.status is Status.MISTAKE for _, result in runs)
    lines = ['<?xml version="1.0" encoding="UTF-8"?>',
             f'<testsuites name="pongsim test" tests="{len(runs)}" failures="{failed}" errors="{wrong}" time="{wall:.3f}">']
    files = list(dict.fromkeys(case.file for case, _ in runs))
    for file in files:
        own = [(case, result) for case, result in runs if case.file == file]
        bad = sum(result.status is Status.FAILED for _, result in own)
        mistakes = sum(result.status is Status.MISTAKE for _, result in own)
        lines.append(f'<testsuite name={_attribute(file)} tests="{len(own)}" failures="{bad}" errors="{mistakes}" '
                     f'time="{sum(result.wall_time for _, result in own):.3f}">')
        for case, result in own:
            lines += _junit_case(case, result, len(own) == 1)
        lines.append("</testsuite>")
    return "\n".join([*lines, "</testsuites>", ""])


def _junit_case(case: Case, result: Result, alone: bool) -> list[str]:
    head = (f"<testcase classname={_attribute(pathlib.Path(case.file).stem)} name={_attribute(title(case, alone))} "
            f"file={_attribute(case.file)} time=\"{result.wall_time:.3f}\"")
    if result.status is Status.PASSED:
        return [head + "/>"]
    kind = "error" if result.status is Status.MISTAKE else "failure"
    text = "\n".join(lines_of(case, result))
    printed = "".join(f"{name}:\n{words}\n" for name, words in result.printed.items())
    lines = [head + ">", f"<{kind} message={_attribute(_first_words(result))}>{_text(text)}</{kind}>"]
    if printed:
        lines.append(f"<system-out>{_text(printed)}</system-out>")
    return [*lines, "</testcase>"]


def _first_words(result: Result) -> str:
    if result.reason:
        return result.reason.splitlines()[0]
    first = result.failures[0]
    return f"expected {first.expected}; seen: {first.seen}"


def _attribute(text: str) -> str:
    return quoteattr(_NOT_XML.sub("?", text))


def _text(text: str) -> str:
    return escape(_NOT_XML.sub("?", text))


def tap(runs: Runs, alone: dict[str, bool]) -> str:
    """The Test Anything Protocol, version 13."""
    lines = ["TAP version 13", f"1..{len(runs)}"]
    for number, (case, result) in enumerate(runs, 1):
        word = "ok" if result.status is Status.PASSED else "not ok"
        lines.append(f"{word} {number} - {title(case, alone[case.file])}".replace("#", "\\#"))
        if result.status is not Status.PASSED:
            lines += [f"# {line}" for line in lines_of(case, result, plots=False)]
    return "\n".join([*lines, ""])


_PLACE = re.compile(r"^(?P<file>[^\n]*?):(?P<line>\d+)(?::(?P<column>\d+))?(?:: |$)")


def github(case: Case, result: Result, alone: bool) -> list[str]:
    """Annotations, which GitHub shows at the lines of the scenario."""
    if result.status is Status.MISTAKE:
        return [annotation(each, case.file, title(case, alone)) for each in result.reason.splitlines()]
    if result.reason:
        return [annotation(result.reason, case.file, title(case, alone))]
    return [_annotation(each, case, alone) for each in result.failures]


def _annotation(each: Judged, case: Case, alone: bool) -> str:
    return annotation(f"{each.at}: expected {each.expected}\nseen: {each.seen}", case.file, title(case, alone))


def annotation(text: str, file: str, name: str) -> str:
    """An error at the place that the text begins with."""
    place = _PLACE.match(text)
    parts = {"file": file}
    if place is not None:
        parts = {key: value for key, value in place.groupdict().items() if value is not None}
        parts["col"] = parts.pop("column", "1")
        text = text[place.end():]
    parts["title"] = name
    listed = ",".join(f"{key}={_escaped(value, ',:')}" for key, value in parts.items())
    return f"::error {listed}::{_escaped(text, '')}"


def _escaped(text: str, more: str) -> str:
    for each in "%\r\n" + more:
        text = text.replace(each, f"%{ord(each):02X}")
    return text
