"""The command `pongsim sweep`."""

from __future__ import annotations

import argparse
import os
import pathlib
import signal
import sys
from typing import Any, Sequence

from . import reading
from .command_line import Parser, say_error
from .errors import SweepError
from .execute import world_of
from .plot import plot
from .results import CSV, PARQUET, Results
from .runner import default_folder, run

_DONE, _FAILED = 0, 1
#: Maximum number of failed runs listed one by one.
_TOLD = 10
_ACTIONS = ("run", "world", "plot")

_EXAMPLES = """examples:
  pongsim sweep gains.yaml                     run the sweep; results in gains.sweep/results.csv
  pongsim sweep gains.yaml --dry-run           list them only
  pongsim sweep gains.yaml --jobs 8            eight in parallel
  pongsim sweep gains.yaml --ray auto          on the Ray cluster of this machine
  pongsim sweep world gains.yaml 17 > 17.sdf   the world of run 17, for pongsim run
  pongsim sweep plot gains.sweep               plot the measures over the parameters

Ctrl-C stops it; the same command resumes with the remaining runs. Exit code 1: a run failed, and its row says why.
pongsim sweep run --help lists the options. docs/sweeps.md describes the file."""


def _parser() -> argparse.ArgumentParser:
    parser = Parser(prog="pongsim sweep", epilog=_EXAMPLES, formatter_class=argparse.RawDescriptionHelpFormatter,
                     description="Runs a world over parameters and seeds, and tabulates the results.",
                     usage="pongsim sweep FILE.yaml [OPTION...] | world FILE.yaml RUN | plot FOLDER")
    actions = parser.add_subparsers(dest="action", required=True, metavar="FILE.yaml", parser_class=Parser)

    each = actions.add_parser("run", help="run the sweep in FILE.yaml, or what remains of it", epilog=_EXAMPLES,
                              formatter_class=argparse.RawDescriptionHelpFormatter, prog="pongsim sweep",
                              usage="pongsim sweep FILE.yaml [OPTION...]",
                              description="Runs the sweep in FILE.yaml, or what remains of it.")
    each.add_argument("file", metavar="FILE.yaml", help="the sweep")
    each.add_argument("-o", "--output", metavar="FOLDER", help="folder of the results (FILE.sweep, beside the file)")
    each.add_argument("-j", "--jobs", metavar="N", type=int, help="parallel runs (one per core)")
    each.add_argument("--ray", metavar="ADDRESS", help="use a Ray cluster: HOST:PORT, ray://HOST:PORT, auto")
    each.add_argument("--restart", action="store_true", help="discard the results so far")
    each.add_argument("--dry-run", action="store_true", help="check the file and list the runs, without running them")
    each.add_argument("--parquet", action="store_true", help="fail at once if Parquet can't be written")
    each.add_argument("--quiet", action="store_true", help="no progress bar")

    each = actions.add_parser("world", help="print the SDF world of a run", prog="pongsim sweep world",
                              description="Prints the world of a run with its parameters in it.")
    each.add_argument("file", metavar="FILE.yaml", help="the sweep")
    each.add_argument("run", metavar="RUN", type=int, help="its number, from 0")

    each = actions.add_parser("plot", help="plot the measures over the parameters", prog="pongsim sweep plot",
                              description="Plots each measure over each parameter, one dot per run.")
    each.add_argument("folder", metavar="FOLDER", help="folder of the results, or results.csv")
    each.add_argument("-o", "--output", metavar="FILE", help="the picture: .png, .svg or .pdf (FOLDER/plot.png)")
    each.add_argument("--x", metavar="NAME", action="append", default=[], help="only over this parameter; repeatable")
    each.add_argument("--y", metavar="NAME", action="append", default=[], help="only this measure; repeatable")
    return parser


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs the command line. Returns the exit code: 1 if something failed, 2 for a wrong command line."""
    words = list(sys.argv[1:] if arguments is None else arguments)
    if words and words[0] not in (*_ACTIONS, "-h", "--help"):
        words.insert(0, "run")
    options = _parser().parse_args(words)
    try:
        if options.action == "world":
            return _world(options)
        if options.action == "plot":
            print(plot(options.folder, options.output, x=options.x, y=options.y))
            return _DONE
        return _list(options) if options.dry_run else _run(options)
    except SweepError as error:
        say_error("sweep", error)
    except BrokenPipeError:
        # the reader has closed the pipe; also prevents the final flush from failing
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
    except OSError as error:
        say_error("sweep", f"{error.filename}: {error.strerror}" if error.filename else error)
    return _FAILED


def _world(options: argparse.Namespace) -> int:
    sweep = reading.read(options.file)
    if not 0 <= options.run < len(sweep.runs):
        raise SweepError(f"there is no run {options.run}: runs are 0 to {len(sweep.runs) - 1}")
    plan = sweep.plan
    # as bytes: a file without parameters need not be UTF-8
    data = pathlib.Path(plan.world).read_bytes() if plan.text is None else world_of(plan, sweep.runs[options.run]).encode()
    sys.stdout.buffer.write(data if data.endswith(b"\n") else data + b"\n")
    sys.stdout.flush()
    return _DONE


def _list(options: argparse.Namespace) -> int:
    for each in reading.read(options.file).runs:
        print(_words(each.number, each.parameters, each.seed))
    sys.stdout.flush()
    return _DONE


def _words(number: int, parameters: dict[str, Any], seed: int) -> str:
    return " ".join([f"run {number}:", *(f"{name}={value}" for name, value in parameters.items()), f"seed={seed}"])


def _run(options: argparse.Namespace) -> int:
    def stop(signum: int, frame: Any) -> None:
        raise KeyboardInterrupt

    signal.signal(signal.SIGTERM, stop)
    try:
        results = run(options.file, folder=options.output, jobs=options.jobs, ray=options.ray, restart=options.restart,
                      parquet=options.parquet or None, progress=not options.quiet,
                      say=lambda text: print(text, file=sys.stderr))
    except KeyboardInterrupt:
        place = options.output or default_folder(reading.read(options.file))
        print(f"\npongsim sweep: stopped; completed runs are in {place}; run the same command to continue",
              file=sys.stderr)
        return _FAILED
    return _report(results)


def _report(results: Results) -> int:
    failed = results.failed
    for row in failed[:_TOLD]:
        print(f"{_words(row.run, row.parameters, row.seed)}: failed: {row.reason}", file=sys.stderr)
    if len(failed) > _TOLD:
        print(f"... and {len(failed) - _TOLD} more", file=sys.stderr)
    written = " and ".join(name for name in (CSV, PARQUET) if (results.folder / name).exists())
    if results.table_error:
        say_error("sweep", f"the tables can't be written: {results.table_error}; completed runs are in the journal")
        written = "no new tables"
    print(f"{len(results)} runs, {len(results) - len(failed)} done, {len(failed)} failed; {results.folder}: {written}")
    return _FAILED if failed or results.table_error else _DONE
