"""Runs a sweep from its file to its results."""

from __future__ import annotations

import contextlib
import dataclasses
import os
import pathlib
import sys
from typing import Any, Callable, Iterator

from . import reading
from .errors import SweepError, need
from .journal import Journal
from .local_pool import LocalPool
from .plan import Row
from .ray_pool import RayPool
from .results import Results

#: Destination of warnings and other messages.
Say = Callable[[str], None]


def run(
    source: reading.Source,
    *,
    folder: str | os.PathLike[str] | None = None,
    jobs: int | None = None,
    ray: str | None = None,
    restart: bool = False,
    parquet: bool | None = None,
    progress: bool = False,
    say: Say | None = None,
) -> Results:
    """Makes those runs of a sweep that its folder does not have yet, and writes the results there.

    source: the sweep's file, or a dict with its content.
    folder: where the results go; None: next to the file, with its name ending in `.sweep` instead of `.yaml`.
    jobs: number of parallel runs; None: the number of processors available to this process.
    ray: the address of a Ray cluster that makes the runs instead of this machine.
    restart: discards the folder's previous results.
    parquet: True: raises SweepError at the start if Parquet can't be written; False: writes only CSV; None: writes it
    if possible.
    progress: shows a progress bar with the remaining time, on a terminal.
    say: called with messages: warnings about the world, results that could not be written.

    A failed run is marked in its row, with the reason, and all others are made. If the tables can't be written,
    `table_error` has the reason, and the journal has the finished runs. Raises SweepError before the first run if the
    sweep is invalid.
    """
    if parquet:
        need("pyarrow", "Parquet")
    if jobs is not None and jobs < 1:
        raise SweepError(f"jobs must be 1 or more, not {jobs}")
    sweep = reading.read(source)
    place = pathlib.Path(folder) if folder is not None else default_folder(sweep)
    report: Say = say or (lambda text: None)
    # check that the cluster is there before anything is discarded
    with _pool(sweep, jobs, ray) as pool, contextlib.closing(Journal(place, sweep.digests, restart)) as journal:
        unwritten: dict[int, Row] = {}
        reported: set[str] = set()
        left = [each for each in sweep.runs if each.number not in journal.rows or not journal.rows[each.number].is_done]
        try:
            if left:
                with _bar(sweep, len(left), progress) as bar:
                    for row in pool.rows(left):
                        _note(row, journal, unwritten)
                        for warning in set(row.warnings) - reported:
                            bar.clear()
                            report(warning)
                        # every process gives the same warnings, and so does every value of a parameter
                        reported.update(row.warnings)
                        bar.update()
        except KeyboardInterrupt:
            journal.reread()
            raise
        finally:
            rows = {**journal.rows, **unwritten}
            results = Results(place, list(sweep.runs[0].parameters), sweep.plan.measure_names,
                              [rows[number] for number in sorted(rows)], len(sweep.runs))
            results = _write(results, parquet, report)
        return results


def default_folder(sweep: reading.Sweep) -> pathlib.Path:
    """Returns the default folder for a sweep's results."""
    if sweep.file is None:
        raise SweepError("a sweep given as a dict needs a folder for its results")
    return sweep.file.with_suffix(".sweep")


def processors() -> int:
    """Returns the number of processors available to this process."""
    return len(os.sched_getaffinity(0))


def _pool(sweep: reading.Sweep, jobs: int | None, ray: str | None) -> LocalPool | RayPool:
    if ray is not None:
        return RayPool(sweep.plan, ray)
    return LocalPool(sweep.plan, jobs or processors())


class _NoBar:
    def update(self) -> None:
        """Shows nothing."""

    def clear(self) -> None:
        """Shows nothing."""


@contextlib.contextmanager
def _bar(sweep: reading.Sweep, left: int, wanted: bool) -> Iterator[Any]:
    if not wanted or not sys.stderr.isatty():
        yield _NoBar()
        return
    tqdm = need("tqdm", "a progress bar")
    with tqdm.tqdm(total=len(sweep.runs), initial=len(sweep.runs) - left, unit="run", dynamic_ncols=True) as bar:
        yield bar


def _note(row: Row, journal: Journal, unwritten: dict[int, Row]) -> None:
    """If it can't be written, the run counts as failed: it is repeated when there is room."""
    try:
        journal.add(row)
    except OSError as error:
        row.status, row.reason = "failed", f"it can't be written to {journal.path}: {error.strerror}"
        row.state_hash, row.measures = "", {}
        unwritten[row.run] = row


def _write(results: Results, parquet: bool | None, report: Say) -> Results:
    """Writes the tables; if there is no room, the results say so."""
    try:
        results.write_csv()
        if parquet is not False:
            results.write_parquet()
    except SweepError as error:
        if parquet:
            raise
        report(f"only CSV was written: {error}")
    except OSError as error:
        return dataclasses.replace(results, table_error=f"{results.folder}: {error.strerror or error}")
    return results
