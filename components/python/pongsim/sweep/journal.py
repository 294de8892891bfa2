"""The progress of a sweep on disk: one line for each finished run."""

from __future__ import annotations

import contextlib
import dataclasses
import fcntl
import io
import json
import os
import pathlib
from typing import Any, Mapping

from .errors import SweepError
from .plan import Row

NAME = "journal.jsonl"
_FORMAT = 1


class Journal:
    """The journal of a sweep in its folder. Only one process at a time can open it."""

    def __init__(self, folder: pathlib.Path, digests: Mapping[str, str], restart: bool) -> None:
        """Opens or creates it. Raises SweepError if another process has it open, or if it belongs to another sweep."""
        self.path = folder / NAME
        #: The last row of each run, by its number.
        self.rows: dict[int, Row] = {}
        try:
            folder.mkdir(parents=True, exist_ok=True)
            self._file: io.FileIO = open(self.path, "a+b", buffering=0)
        except OSError as error:
            raise SweepError(f"{self.path}: {error.strerror}") from None
        try:
            self._open(dict(digests), restart)
        except BaseException:
            self._file.close()
            raise

    def add(self, row: Row) -> None:
        """Writes a row. If that fails, for example because the disk is full, raises OSError and leaves the journal
        unchanged."""
        self._write(dataclasses.asdict(row))
        self.rows[row.run] = row

    def reread(self) -> None:
        """Takes the rows from the file again: a Ctrl-C can come after a row was written and before it was counted."""
        lines, _ = self._lines()
        self._take(lines)

    def close(self) -> None:
        """Releases it for others."""
        self._file.close()

    def _open(self, digests: dict[str, str], restart: bool) -> None:
        try:
            fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            raise SweepError(f"{self.path.parent}: another pongsim sweep is running there") from None
        lines, torn = self._lines()
        if restart or not lines:
            self._file.truncate(0)
            try:
                self._write({"pongsim_sweep": _FORMAT, "files": digests})
            except OSError as error:
                raise SweepError(f"{self.path}: {error.strerror}") from None
            return
        if torn:
            self._file.truncate(os.fstat(self._file.fileno()).st_size - len(torn))
        self._check(lines[0], digests)
        self._take(lines)

    def _lines(self) -> tuple[list[bytes], bytes]:
        """Returns the complete lines, and an incomplete last one, which does not count."""
        self._file.seek(0)
        lines = self._file.read().split(b"\n")
        torn = lines.pop()
        return lines, torn

    def _take(self, lines: list[bytes]) -> None:
        for number, line in enumerate(lines[1:], 2):
            try:
                row = Row(**json.loads(line))
            except (ValueError, TypeError):
                raise SweepError("this is not a row of a sweep", at=f"{self.path}:{number}", hint="use --restart to start anew") from None
            self.rows[row.run] = row

    def _check(self, line: bytes, digests: dict[str, str]) -> None:
        try:
            header = json.loads(line)
            known: dict[str, str] = header["files"]
            version = header["pongsim_sweep"]
        except (ValueError, TypeError, KeyError):
            raise SweepError("this is not a journal of a sweep", at=f"{self.path}:1", hint="choose another folder with --output") from None
        changed = sorted(name for name in known.keys() | digests.keys() if known.get(name) != digests.get(name))
        if changed or version != _FORMAT:
            raise SweepError(
                f"the runs in {self.path.parent} were made with a different {'version of ' + ' and '.join(changed) if changed else 'format'}",
                hint="use --restart to discard them, or --output FOLDER to keep them")

    def _write(self, value: dict[str, Any]) -> None:
        line = json.dumps(value).encode() + b"\n"
        size = os.fstat(self._file.fileno()).st_size
        try:
            written = self._file.write(line)
            if written < len(line):
                # the remaining text is the reason
                self._file.write(line[written:])
        except OSError:
            with contextlib.suppress(OSError):
                self._file.truncate(size)
            raise
        if os.fstat(self._file.fileno()).st_size != size + len(line):
            with contextlib.suppress(OSError):
                self._file.truncate(size)
            raise OSError(0, "the line was not written to its end")
