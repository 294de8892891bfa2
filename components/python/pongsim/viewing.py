"""Worlds in a browser, and in notebooks."""

from __future__ import annotations

import html
import math
import socket
import sys
import time
import webbrowser
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .simulation import Simulation

#: Who may show the page in a frame: a notebook's server on this machine.
_NOTEBOOKS = ("http://localhost:*", "http://127.0.0.1:*")
_HEIGHT = 480
#: How often a world that stands still answers the page [1/s].
_RATE = 30.0


class View:
    """The page of a world. In a notebook, it is shown where it is the value of a cell."""

    def __init__(self, simulation: Simulation, port: int, read_only: bool, in_notebook: bool) -> None:
        """See `Simulation.view`."""
        self._simulation = simulation
        port = port or _free_port()
        parameters = [("port", str(port)), ("read_only", "true" if read_only else "false")]
        if in_notebook:
            parameters += [("framing_origin", origin) for origin in _NOTEBOOKS]
        simulation._add_watcher("pongsim-web-system", "pongsim::systems::Web", parameters)
        #: The page's address.
        self.url = f"http://127.0.0.1:{port}/"

    def __repr__(self) -> str:
        return f"<pongsim.View {self.url}>"

    def _repr_html_(self) -> str:
        return (
            f'<iframe src="{html.escape(self.url)}" style="width: 100%; height: {_HEIGHT}px; border: 0" '
            'allow="fullscreen; clipboard-write"></iframe>'
        )

    def run(self, duration: float = math.inf, speed: float = 1.0) -> None:
        """Runs the world at the pace of the clock, until Ctrl-C or the end of a notebook's cell.

        duration: simulated time [s].
        speed: simulated seconds per second of the clock; 0: the world stands still, and the page is answered, for
            `duration` seconds of the clock.
        Raises ValueError for numbers below 0.
        """
        if not (duration >= 0 and speed >= 0 and math.isfinite(speed)):
            raise ValueError("duration and speed must be 0 or more")
        simulation = self._simulation
        begin = time.monotonic()
        try:
            if speed == 0:
                while time.monotonic() < begin + duration:
                    simulation.step_paused()
                    time.sleep(1 / _RATE)
                return
            start = simulation.time
            while simulation.time < start + duration - simulation.step_size / 2:
                simulation.step()
                late = time.monotonic() - begin - (simulation.time - start) / speed
                if late < 0:
                    time.sleep(-late)
        except KeyboardInterrupt:
            pass


def is_in_notebook() -> bool:
    """Returns whether this is the process of a Jupyter notebook."""
    shell = sys.modules["IPython"].get_ipython() if "IPython" in sys.modules else None
    return hasattr(shell, "kernel")


def show(simulation: Simulation, port: int, read_only: bool, browser: bool | None) -> View:
    """See `Simulation.view`."""
    if not isinstance(port, int) or not 0 <= port <= 65535:
        raise ValueError(f"a port must be 1 to 65535, or 0 for a free one, not {port!r}")
    in_notebook = is_in_notebook()
    view = View(simulation, port, read_only, in_notebook)
    simulation.step_paused()
    if browser if browser is not None else not in_notebook:
        webbrowser.open(view.url)
    return view


def _free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port: int = probe.getsockname()[1]
        return port
