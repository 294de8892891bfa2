"""A node's log output, on stderr as in ROS."""

import inspect
import sys
import time


class Logger:
    def __init__(self, name, clock):
        self.name = name
        self._clock = clock
        self._said = {}

    def _log(self, level, text, throttle_duration_sec=None):
        if throttle_duration_sec is not None:
            caller = inspect.currentframe().f_back.f_back
            place, now = (caller.f_code.co_filename, caller.f_lineno), time.monotonic()
            if place in self._said and now < self._said[place] + throttle_duration_sec:
                return
            self._said[place] = now
        stamp = self._clock.now().nanoseconds
        print(f"[{level}] [{stamp // 10**9}.{stamp % 10**9:09}] [{self.name}]: {text}", file=sys.stderr, flush=True)

    def info(self, text, **options):
        self._log("INFO", text, **options)

    def warning(self, text, **options):
        self._log("WARN", text, **options)

    def error(self, text, **options):
        self._log("ERROR", text, **options)
