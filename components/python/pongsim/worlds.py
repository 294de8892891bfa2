"""The worlds that come with pongsim, and where worlds are looked for: `pongsim.worlds.names()`.

    sim = pongsim.Simulation("pong_world.sdf")  # from any folder
"""

from __future__ import annotations

import os
import pathlib

#: Where `pongsim run` looks, too.
_VARIABLES = ("PONGSIM_RESOURCE_PATH", "SDF_PATH", "IGN_GAZEBO_RESOURCE_PATH", "GZ_SIM_RESOURCE_PATH", "IGN_FILE_PATH")
_PACKAGE = pathlib.Path(__file__).resolve().parent


def folder() -> pathlib.Path | None:
    """Returns the folder with the worlds of pongsim: of the wheel, of the installation, or of the source tree; None without
    one."""
    own = [_PACKAGE / "share/pongsim/worlds"]
    # PREFIX/lib/python3/dist-packages/pongsim, and build/release/python/pongsim
    own += [parent / "share/pongsim/worlds" for parent in _PACKAGE.parents[:5]]
    own += [parent / "worlds" for parent in _PACKAGE.parents[:4] if (parent / "worlds/pong_world.sdf").is_file()]
    return next((each for each in own if each.is_dir()), None)


def names() -> list[str]:
    """Returns the names of the worlds of pongsim, sorted: "pong_world.sdf"."""
    own = folder()
    return sorted(each.name for each in own.glob("*.sdf")) if own else []


def path(name: str) -> pathlib.Path:
    """Returns the file of a world of pongsim, named with or without ".sdf". Raises KeyError."""
    own = folder()
    for each in (name, name + ".sdf"):
        if own and (own / each).is_file():
            return own / each
    from .names import closest

    raise KeyError(f"pongsim has no world '{name}'{closest(name, names())}")


def find(world: str | os.PathLike[str]) -> str:
    """Returns the file of a world as `pongsim run` finds it: as it is if it is there, else in the folders of
    PONGSIM_RESOURCE_PATH, else among the worlds of pongsim. A text, which contains a "<", and what is not found are returned
    as they are."""
    if not isinstance(world, (str, os.PathLike)):
        raise TypeError(f"a world must be a file or a text, not {type(world).__name__}")
    text = os.fspath(world)
    if "<" in text or not text or os.path.isabs(text) or os.path.exists(text):
        return text
    folders = [each for name in _VARIABLES for each in os.environ.get(name, "").split(":") if each]
    own = folder()
    if own:
        folders.append(str(own))
    return next((found for each in folders if os.path.isfile(found := os.path.join(each, text))), text)


def nearest(world: str) -> str:
    """Returns "; did you mean 'x'?" for a name that is no file and like that of a world of pongsim; otherwise nothing."""
    if "<" in world or os.path.dirname(world) or os.path.exists(world):
        return ""
    from .names import closest

    return closest(world, names())


def to_sdf(world: str | os.PathLike[str]) -> str:
    """Returns what a file says as one text in SDF: of an SDF, URDF or xacro file, or a model's folder, with each `<include>`
    replaced by its content, and absolute paths. The file is found as `Simulation` finds it.

    Raises LoadError with file, line and column, and ValueError for a text.
    """
    from . import _core

    found = find(world)
    if "<" in found:
        raise ValueError("to_sdf wants a file, not a text")
    return _core.resolved_sdf(found)
