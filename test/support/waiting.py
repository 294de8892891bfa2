"""Waiting in tests, for conditions instead of for a time."""

import time

#: After this time [s] a test fails, even on a busy machine.
PATIENCE = 120.0


def until(condition, what="the condition", patience=PATIENCE):
    """Waits until `condition()` returns a true value, and returns it. `what` names it when the test fails: a text, or a
    function that returns one."""
    end = time.monotonic() + patience
    while not (value := condition()):
        assert time.monotonic() < end, f"waited {patience:g} s in vain for {what() if callable(what) else what}"
        time.sleep(0.01)
    return value
