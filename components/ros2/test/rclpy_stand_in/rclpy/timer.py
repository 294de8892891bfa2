"""Periodic callbacks."""


class Timer:
    def __init__(self, period, callback, clock):
        self.period = int(period * 10**9)
        self.callback = callback
        self.clock = clock
        self._begin()

    def _begin(self):
        self._last = self.clock.now().nanoseconds
        self._due = self._last + self.period

    def seconds_left(self):
        """Not part of rclpy: wall time until it is due; unknown for simulated time."""
        if self.clock.simulated is not None:
            return float("inf")
        return (self._due - self.clock.now().nanoseconds) / 1e9

    def call_when_due(self):
        now = self.clock.now().nanoseconds
        if now < self._last:
            self._begin()  # time began anew
        self._last = now
        if now < self._due:
            return False
        # missed calls are skipped
        self._due += self.period * ((now - self._due) // self.period + 1)
        self.callback()
        return True
