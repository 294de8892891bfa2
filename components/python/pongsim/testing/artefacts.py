"""What is kept of a run that failed: a recording, pictures and a log."""

from __future__ import annotations

import os
import pathlib
import re
import shutil
import struct
import zlib
from typing import Callable, TypedDict
from xml.sax.saxutils import escape

from ..simulation import Simulation
from .execute import execute, text_of
from .programs import Noted
from .result import Result, Status
from .scenario import Case

#: Recorded after the failure [s], to see what came of it.
_AFTER = 0.5
_RECORDING, _LOG = "recording", "log.txt"


def folder_for(place: pathlib.Path, case: Case) -> pathlib.Path:
    """Returns the folder of a run's files."""
    stem = pathlib.Path(case.file).name.removesuffix(".yaml").removesuffix(".yml")
    label = re.sub(r"[^A-Za-z0-9_.=-]+", "_", case.label)
    return place / f"{stem}.{label}"


def execute_and_keep(case: Case, place: pathlib.Path, noted: Noted, again: Callable[[], object]) -> Result:
    """Makes the run, and keeps what it asks for if it fails. `again` is called before it is made a second time.

    A run without programs is made again for that, which has the same bits: so the first one pays nothing for it. One with
    programs is recorded as it is.
    """
    keeps = [each for each in case.keep if each != "log"]
    if not case.programs or not keeps:
        result = execute(case, noted)
        if result.status is not Status.FAILED or not case.keep:
            return result
        if keeps and result.state_hash:
            folder = folder_for(place, case)
            folder.mkdir(parents=True, exist_ok=True)
            again()
            recorded = execute(case, noted, until=result.sim_time + _AFTER, **_wanted(case, folder))
            result.kept += _there(folder, keeps, recorded)
    else:
        folder = folder_for(place, case)
        folder.mkdir(parents=True, exist_ok=True)
        result = execute(case, noted, **_wanted(case, folder))
        if result.status is not Status.FAILED:
            shutil.rmtree(folder, ignore_errors=True)
            return result
        result.kept = _there(folder, keeps, result)
    if "log" in case.keep:
        result.kept.append(_write_log(folder_for(place, case), case, result))
    return result


class _Wanted(TypedDict, total=False):
    recorder: str
    pictures: str


def _wanted(case: Case, folder: pathlib.Path) -> _Wanted:
    wanted: _Wanted = {}
    # a file with a robot has no world to put a recorder into
    if "recording" in case.keep and "</world>" in text_of(case):
        path = escape(str((folder / _RECORDING).resolve()))
        wanted["recorder"] = ("<plugin filename='pongsim-log-system' name='ignition::gazebo::systems::LogRecord'>"
                              f"<record_path>{path}</record_path><overwrite>true</overwrite></plugin>")
    if "picture" in case.keep:
        wanted["pictures"] = str(folder)
    return wanted


def _there(folder: pathlib.Path, keeps: list[str], made: Result) -> list[str]:
    """Returns the files that were made, and why others were not."""
    found = [str(folder / _RECORDING)] if (folder / _RECORDING / "state.tlog").is_file() else []
    found += [each for each in made.kept if each not in found]
    if not found and "recording" in keeps:
        found.append(f"(no recording: {made.reason or 'the world makes none'})")
    return found


def _write_log(folder: pathlib.Path, case: Case, result: Result) -> str:
    folder.mkdir(parents=True, exist_ok=True)
    lines = [f"{case.file} {case.label}", f"world: {case.world}", f"ended at {result.sim_time:g} s, state hash {result.state_hash}"]
    lines += [result.reason] if result.reason else []
    for each in result.judged:
        lines += [f"{each.at}: {'met' if each.met else 'not met'} at {each.time:g} s", f"  expected: {each.expected}", f"  seen:     {each.seen}"]
    lines += [f"warning: {each}" for each in result.warnings]
    for name, text in result.printed.items():
        lines += [f"--- {name} printed:", text.rstrip()]
    path = folder / _LOG
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return str(path)


def draw(sim: Simulation, folder: str) -> list[str]:
    """Writes what each camera of the world sees into a PNG file, and returns the files."""
    made = []
    for name in sim.sensor_names:
        sensor = sim._find_sensor(name)
        if "camera" not in sensor.type or "logical" in sensor.type:
            continue
        try:
            pixels = sim.render(name)
        except (ValueError, RuntimeError) as error:
            # such as without the library that renders
            made.append(f"(no picture of {name}: {error})")
            continue
        path = os.path.join(folder, re.sub(r"[^A-Za-z0-9_.-]+", "_", name) + ".png")
        with open(path, "wb") as file:
            height, width, _ = pixels.shape
            file.write(png(pixels.tobytes(), width, height))
        made.append(path)
    return made


def png(pixels: bytes, width: int, height: int) -> bytes:
    """Returns a PNG file of rows of red, green and blue."""
    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    rows = b"".join(b"\0" + pixels[3 * width * y:3 * width * (y + 1)] for y in range(height))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
            + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))
