"""The command `pongsim test`."""

from __future__ import annotations

import argparse
import os
import pathlib
import re
import signal
import sys
import time
from typing import Any, NoReturn, Sequence

from ..sweep.command_line import MISUSED, Parser, say_error
from ..sweep.errors import SweepError, nearest
from ..sweep.runner import processors
from . import places, report
from .pool import Pool
from .result import Result, Status
from .scenario import Case, read

_PASSED, _FAILED = 0, 1

_EXAMPLES = """examples:
  pongsim test wall.yaml                     run it, in all its variants
  pongsim test tests/*.yaml --junit out.xml  many, side by side, with a report for CI
  pongsim test wall.yaml --list              list the runs only
  pongsim test --init world.sdf              write a first scenario, world.yaml, that passes

Exit code 0: all passed, 1: a run failed, 2: wrong command line or scenario. docs/testing.md describes the file;
for editors, its first line can be
  # yaml-language-server: $schema=PATH         with the path that pongsim test --schema prints"""


class _Parser(Parser):
    def error(self, message: str) -> NoReturn:
        unknown = re.match(r"unrecognized arguments: (--[^\s=]+)", message)
        if unknown is not None:
            known = [option for action in self._actions for option in action.option_strings]
            message = f"there is no option {unknown.group(1)} ({nearest(unknown.group(1), known)})"
        super().error(message)


def _jobs(text: str) -> int:
    number = int(text)
    if number < 1:
        raise ValueError(text)
    return number


_jobs.__name__ = "number"


def _parser() -> argparse.ArgumentParser:
    parser = _Parser(prog="pongsim test", epilog=_EXAMPLES, formatter_class=argparse.RawDescriptionHelpFormatter,
                     description="Runs worlds and judges what is expected of them.", usage="pongsim test FILE.yaml... [OPTION...]")
    parser.add_argument("files", metavar="FILE.yaml", nargs="*", help="scenarios")
    parser.add_argument("-j", "--jobs", metavar="N", type=_jobs, help="parallel runs (one per core)")
    parser.add_argument("-o", "--output", metavar="FOLDER", default="test-failures",
                        help="where recordings, pictures and logs of failures go (test-failures)")
    parser.add_argument("--list", action="store_true", help="check the files and list the runs, without running them")
    parser.add_argument("--junit", metavar="FILE", help="write a JUnit report")
    parser.add_argument("--tap", action="store_true", help="print TAP, the Test Anything Protocol")
    parser.add_argument("--github", action="store_true", help="print annotations for GitHub, too")
    parser.add_argument("--renderer", choices=["software", "egl", "auto"],
                        help="what draws cameras' images: software (the default), egl (a graphics card), or auto")
    parser.add_argument("--quiet", action="store_true", help="print failures and the summary only")
    parser.add_argument("--init", metavar="WORLD", help="write a first scenario for a world, into this folder or to -o FILE")
    parser.add_argument("--schema", action="store_true", help="print the file of the JSON schema")
    return parser


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs the command line. Returns the exit code."""
    parser = _parser()
    words = list(sys.argv[1:] if arguments is None else arguments)
    # as in the other commands, the action can be named
    options = parser.parse_args(words[1:] if words[:1] == ["run"] and not os.path.exists("run") else words)
    if options.renderer is not None:
        os.environ["PONGSIM_RENDERER"] = options.renderer
    try:
        if options.schema:
            print(places.schema())
            return _PASSED
        if options.init is not None:
            from .first import write_first

            return write_first(options.init, None if options.output == parser.get_default("output") else options.output)
        if not options.files:
            parser.error("which scenarios? Give their files")
        return _test(options)
    except BrokenPipeError:
        # the reader has closed the pipe; also prevents the final flush from failing
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
    except SweepError as error:
        say_error("test", error)
        return MISUSED
    except OSError as error:
        say_error("test", f"{error.filename}: {error.strerror}" if error.filename else error)
    return _FAILED


def _read(options: argparse.Namespace) -> list[Case] | None:
    """Reads all files; None: there were mistakes, which are all told."""
    cases: list[Case] = []
    wrong = False
    for file in options.files:
        try:
            cases += read(file).cases
        except SweepError as error:
            wrong = True
            say_error("test", error)
            if options.github:
                for each in str(error).splitlines():
                    print(report.annotation(each.replace(": error: ", ": ", 1), file, file), flush=True)
    return None if wrong else cases


def _test(options: argparse.Namespace) -> int:
    begin = time.monotonic()
    cases = _read(options)
    if cases is None:
        return MISUSED
    alone = {file: sum(case.file == file for case in cases) == 1 for file in {case.file for case in cases}}
    if options.list:
        print("\n".join(report.title(case, alone[case.file]) for case in cases))
        return _PASSED
    if options.junit:
        # whether it can be written is known before anything runs
        pathlib.Path(options.junit).touch()
    made: dict[int, Result] = {}
    interrupted = _run(cases, alone, options, made)
    runs = [(cases[number], made[number]) for number in sorted(made)]
    wall = time.monotonic() - begin
    if options.junit:
        pathlib.Path(options.junit).write_text(report.junit(runs, wall), encoding="utf-8")
    if options.tap:
        print(report.tap(runs, alone), end="")
    else:
        print(report.summary(runs, wall, len(cases) - len(runs)))
    sys.stdout.flush()
    if interrupted:
        print("pongsim test: stopped", file=sys.stderr)
        return _FAILED
    statuses = {result.status for _, result in runs}
    if Status.FAILED in statuses:
        return _FAILED
    return MISUSED if Status.MISTAKE in statuses else _PASSED


def _run(cases: list[Case], alone: dict[str, bool], options: argparse.Namespace, made: dict[int, Result]) -> bool:
    """Makes the runs, and says how each ended. Returns whether Ctrl-C or SIGTERM stopped it."""
    def stop(signum: int, frame: Any) -> None:
        raise KeyboardInterrupt

    signal.signal(signal.SIGTERM, stop)
    # a shell lets what it runs in the background ignore Ctrl-C
    signal.signal(signal.SIGINT, stop)
    try:
        with Pool(cases, pathlib.Path(options.output), options.jobs or processors()) as pool:
            for number, result in pool.results():
                made[number] = result
                _say(cases[number], result, alone[cases[number].file], options)
    except KeyboardInterrupt:
        return True
    return False


_WORDS = {Status.PASSED: "ok  ", Status.FAILED: "FAIL", Status.MISTAKE: "BAD "}


def _say(case: Case, result: Result, alone: bool, options: argparse.Namespace) -> None:
    if not options.tap and (result.status is not Status.PASSED or not options.quiet):
        times = f"{result.sim_time:g} s in {result.wall_time:.2f} s"
        print(f"{_WORDS[result.status]} {report.title(case, alone)}  ({times})")
        if result.status is not Status.PASSED:
            print("\n".join(f"     {line}".rstrip() for line in report.lines_of(case, result)))
    if options.github and result.status is not Status.PASSED:
        print("\n".join(report.github(case, result, alone)))
    sys.stdout.flush()
