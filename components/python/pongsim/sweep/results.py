"""The results of a sweep: a table with one row per run, also as CSV and Parquet."""

from __future__ import annotations

import csv
import dataclasses
import os
import pathlib
from typing import Any, Callable, Iterator

from .errors import SweepError, need
from .plan import Row, Value

CSV = "results.csv"
PARQUET = "results.parquet"


@dataclasses.dataclass(frozen=True)
class Results:
    """The results of a sweep."""

    #: Its folder: journal.jsonl, results.csv, results.parquet.
    folder: pathlib.Path
    parameter_names: list[str]
    measure_names: list[str]
    #: In the order of the runs; runs without a row have not been made.
    rows: list[Row]
    #: Number of runs in the sweep.
    total: int
    #: Why the tables could not be written; empty on success.
    table_error: str = ""

    @property
    def failed(self) -> list[Row]:
        """The failed runs, with `reason`."""
        return [row for row in self.rows if not row.is_done]

    @property
    def columns(self) -> list[str]:
        """The names of the table's columns."""
        return ["run", *self.parameter_names, "seed", *self.measure_names, "status", "reason", "state_hash", "sim_time",
                "wall_time"]

    def column(self, name: str) -> list[Value]:
        """Returns all values of a column; None for runs without that measure. Raises KeyError."""
        if name not in self.columns:
            raise KeyError(f"there is no column '{name}': {', '.join(self.columns)}")
        return [_value(row, name) for row in self.rows]

    def __iter__(self) -> Iterator[dict[str, Value]]:
        """Iterates over the rows as dicts keyed by column."""
        return ({name: _value(row, name) for name in self.columns} for row in self.rows)

    def __len__(self) -> int:
        return len(self.rows)

    def write_csv(self) -> pathlib.Path:
        """Writes results.csv atomically. Raises OSError."""

        def write(path: str) -> None:
            with open(path, "w", newline="", encoding="utf-8") as file:
                writer = csv.writer(file)
                writer.writerow(self.columns)
                for row in self:
                    writer.writerow([_text(value) for value in row.values()])

        return _replace(self.folder / CSV, write)

    def write_parquet(self) -> pathlib.Path:
        """Writes results.parquet atomically. Raises OSError, and SweepError without pyarrow."""
        arrow = need("pyarrow", "Parquet")
        parquet = need("pyarrow.parquet", "Parquet")
        table = arrow.table({name: _array(arrow, self.column(name)) for name in self.columns})
        return _replace(self.folder / PARQUET, lambda path: parquet.write_table(table, path))


def _value(row: Row, name: str) -> Value:
    if name in row.parameters:
        return row.parameters[name]
    if name in row.measures:
        return row.measures[name]
    # a measure that a failed run does not have
    return getattr(row, name, None)


def _text(value: Value) -> Value:
    if isinstance(value, bool):
        return str(value).lower()
    return repr(value) if isinstance(value, float) else value


def _array(arrow: Any, values: list[Value]) -> Any:
    try:
        return arrow.array(values)
    except (arrow.ArrowInvalid, arrow.ArrowTypeError, OverflowError):
        # numbers and texts in one column
        return arrow.array([None if value is None else str(_text(value)) for value in values])


def _replace(path: pathlib.Path, write: Callable[[str], None]) -> pathlib.Path:
    """Writes a temporary file, then replaces the old one."""
    made = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        write(str(made))
        os.replace(made, path)
    except BaseException:
        made.unlink(missing_ok=True)
        raise
    return path


def read(folder: pathlib.Path) -> tuple[list[str], list[dict[str, str]]]:
    """Returns the columns and rows of a results.csv, or of the folder that contains it. Raises SweepError."""
    path = folder / CSV if folder.is_dir() else folder
    try:
        with open(path, newline="", encoding="utf-8") as file:
            reader = csv.DictReader(file)
            rows = list(reader)
            columns = list(reader.fieldnames or [])
    except OSError as error:
        raise SweepError(f"{path}: {error.strerror}") from None
    except (UnicodeDecodeError, csv.Error) as error:
        raise SweepError(f"{path}: {error}") from None
    if "run" not in columns or "seed" not in columns or "status" not in columns:
        raise SweepError(f"{path} is not a table of a sweep")
    return columns, rows
