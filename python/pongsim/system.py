"""Systems in Python."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ._core import StepInfo
    from .simulation import Simulation


class System:
    """A part of the simulation, called in each step behind the systems of the world's file.

    Derive from it, override what is needed, and give an object of it to `Simulation.add`. What is not overridden costs
    nothing. A system that raises is named on stderr and switched off until the next reset, and the world goes on; a strict
    simulation raises SystemFailed in place of that. Within these functions everything can be read and commanded; what
    changes who is in the world, or its time, is for between two steps and raises Busy here.
    """

    #: Names it in messages; None: its class's name.
    name: str | None = None
    #: What it has raised and is switched off for; None where it works.
    error: BaseException | None = None
    _simulation: Simulation | None = None

    @property
    def sim(self) -> Simulation:
        """The simulation that it was added to. Raises RuntimeError before that."""
        if self._simulation is None:
            raise RuntimeError("the system is in no simulation yet: Simulation.add puts it there")
        return self._simulation

    def configure(self) -> None:
        """Finds models and opens topics. Called once, when it is added."""

    def pre_update(self, info: StepInfo) -> None:
        """Before the physics: the place for commands. Messages have been handed over just before."""

    def update(self, info: StepInfo) -> None:
        """Before the physics and after every system's `pre_update`."""

    def post_update(self, info: StepInfo) -> None:
        """After the physics: the place to read the state and to publish."""

    def reset(self) -> None:
        """The world was set back to its start."""

    def world_changed(self) -> None:
        """Models or joints have come or gone."""

    def save(self) -> Any:
        """What it remembers from step to step, as anything that `pickle` takes: part of `Simulation.save`.

        It counts where `restore` is overridden, too.
        """

    def restore(self, state: Any) -> None:
        """Takes back what `save` gave."""
