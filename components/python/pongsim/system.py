"""Systems in Python."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ._core import StepInfo
    from .simulation import Simulation


class System:
    """A system: a part of the simulation, called in each step after the systems of the world's file.

    Derive from it, override the functions you need, and pass an object to `Simulation.add`. Functions that are not
    overridden cost nothing. A system that raises is reported on stderr and switched off until the next reset, and the
    world continues; a strict simulation raises SystemFailed instead. These functions can read and command everything, but
    changes of the world's entities or time are only allowed between two steps, and raise Busy here.
    """

    #: Its name in messages; None: the class name.
    name: str | None = None
    #: The exception for which it was switched off, or None.
    error: BaseException | None = None
    _simulation: Simulation | None = None

    def __init_subclass__(cls, **arguments: Any) -> None:
        """Refuses methods such as `preUpdate`, which would never be called. Raises TypeError."""
        super().__init_subclass__(**arguments)
        known = {name.replace("_", ""): name for name in vars(System) if not name.startswith("_") and name not in ("name", "error", "sim")}
        for name, value in vars(cls).items():
            meant = known.get(name.replace("_", "").lower())
            if callable(value) and not name.startswith("_") and meant not in (None, name):
                raise TypeError(f"{cls.__name__}.{name} would never be called; did you mean '{meant}'?")

    def __getstate__(self) -> dict[str, Any]:
        """Leaves out the simulation and what refers to it, which `configure` finds again."""
        from . import _core
        from .sensor import Sensor

        parts = (_core.Simulation, _core.Model, _core.Link, _core.Joint, _core.Collision, _core.Subscription, Sensor)
        return {name: value for name, value in vars(self).items() if not isinstance(value, parts)}

    @property
    def sim(self) -> Simulation:
        """Its simulation. Raises RuntimeError before it is added."""
        if self._simulation is None:
            raise RuntimeError("the system is not in a simulation yet: use Simulation.add")
        return self._simulation

    def configure(self) -> None:
        """Finds models and opens topics. Called once, when it is added."""

    def pre_update(self, info: StepInfo) -> None:
        """Before physics: the place for commands. Messages were delivered just before."""

    def update(self, info: StepInfo) -> None:
        """Before physics, after all systems' `pre_update`."""

    def post_update(self, info: StepInfo) -> None:
        """After physics: the place for reading the state and publishing."""

    def reset(self) -> None:
        """The world was reset."""

    def world_changed(self) -> None:
        """Models or joints were added or removed."""

    def save(self) -> Any:
        """Returns its state between steps; part of `Simulation.save`, and called before a `Simulation.restore`, too.

        It may consist of None, bool, int, float, complex, str, bytes, lists, tuples, dictionaries and sets, poses
        (`pongsim.Pose`), and numbers and arrays of NumPy. Only used if `restore` is overridden too. For anything else,
        `Simulation.save` raises TypeError.
        """

    def restore(self, state: Any) -> None:
        """Restores what `save` has returned. Where it raises, the state is refused."""
