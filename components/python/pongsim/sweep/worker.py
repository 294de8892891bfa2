"""A process that makes runs, one after another, for its parent process."""

from __future__ import annotations

import ctypes
import os
import signal
import sys
from multiprocessing.connection import Connection

from .. import set_log_level
from .execute import execute
from .plan import Plan

_PR_SET_PDEATHSIG = 1


def main() -> None:
    """Receives a plan, then runs, and sends back a row for each. Exits when the other side does."""
    parent, descriptor = int(sys.argv[1]), int(sys.argv[2])
    # Ctrl-C is handled by the parent
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGKILL)
    if os.getppid() != parent:
        return
    # errors of a run are in its row
    set_log_level(0)
    connection = Connection(descriptor)
    try:
        plan: Plan = connection.recv()
        connection.send(None)
        while True:
            run = connection.recv()
            connection.send(execute(plan, run))
    except (EOFError, OSError):
        return
