"""Sweeps: runs a world with many combinations of parameters and seeds, and collects each run's measures in a table.

    from pongsim import sweep

    results = sweep.run("gains.yaml", jobs=4)
    for row in results:
        print(row["gain"], row["error"], row["state_hash"])
"""

from .errors import SweepError
from .plan import Row, Run
from .plot import plot
from .reading import Sweep, read
from .results import Results
from .runner import run

__all__ = ["Results", "Row", "Run", "Sweep", "SweepError", "plot", "read", "run"]
