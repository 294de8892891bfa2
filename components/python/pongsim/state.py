"""The state of a world as vectors, and names for their numbers."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

if TYPE_CHECKING:
    from . import _core

_POSITIONS = ("x", "y", "z", "qx", "qy", "qz", "qw")
_VELOCITIES = ("vx", "vy", "vz", "wx", "wy", "wz")


class Layout(NamedTuple):
    """What the numbers of `Simulation.qpos` and `Simulation.qvel` are."""

    #: A name for each number of `qpos`: "ball.x", "ball.qw", "arm::hinge", "cart::fork#1" for a second axis.
    qpos_names: list[str]
    #: A name for each number of `qvel`: "ball.vx", "ball.wz", "arm::hinge".
    qvel_names: list[str]
    #: Where each free model or link, and each joint, is in `qpos`, by its scoped name.
    qpos: dict[str, slice]
    #: The same for `qvel`.
    qvel: dict[str, slice]


def layout_of(core: _core.Simulation) -> Layout:
    """Returns the layout of a world's vectors as they are now."""
    layout = Layout([], [], {}, {})
    for name, is_free, position, positions, velocity, velocities in core._state_pieces():
        layout.qpos[name] = slice(position, position + positions)
        layout.qvel[name] = slice(velocity, velocity + velocities)
        if is_free:
            layout.qpos_names.extend(f"{name}.{part}" for part in _POSITIONS)
            layout.qvel_names.extend(f"{name}.{part}" for part in _VELOCITIES)
        else:
            axes = [name if axis == 0 else f"{name}#{axis}" for axis in range(positions)]
            layout.qpos_names.extend(axes)
            layout.qvel_names.extend(axes)
    return layout


def numbers(given: ArrayLike, shape: tuple[int, ...], what: str) -> NDArray[np.float64]:
    """Returns it as an array of doubles without gaps. Raises ValueError for another shape."""
    array = np.ascontiguousarray(given, np.float64)
    if array.shape != shape:
        raise ValueError(f"{what} must be an array of shape {shape}, not {array.shape}")
    return array


def models_of(core: _core.Simulation, names: Sequence[str] | None) -> list[_core.Model]:
    """Returns the named models, or all. Raises KeyError."""
    return [core.model(name) for name in (core.model_names if names is None else names)]
