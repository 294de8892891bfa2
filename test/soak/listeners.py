"""Programs that listen to the daemon: some read and end, some are stopped for a while, some are killed."""

import signal
import subprocess

from daemon import DEADLINE, Fault

TOPICS = ("/soak/lidar", "/soak/camera", "/soak/imu", "/soak/contact", "/stats", "/world/heap/pose/info")


class Listeners:
    """One after another; `visit` is called between two rounds of cycles."""

    def __init__(self, program, environment):
        self._program = program
        self._environment = environment
        self._process = None
        self._number = 0
        self.came = 0
        self.killed = 0

    @property
    def is_idle(self):
        """Whether nobody listens now."""
        return self._process is None

    def visit(self, begins):
        """Ends the one that listens, if it has heard enough, or begins the next if that is wanted."""
        if self._process is None:
            if begins:
                self._start()
            return
        way = self._number % 3
        if way == 0:
            # checked again in the following rounds until it has ended
            code = self._process.poll()
            if code is None:
                return
            if code != 0:
                raise Fault(f"a listener ends with code {code}")
        elif way == 1:
            self._process.send_signal(signal.SIGCONT)
            self._process.terminate()
            # ended by the signal itself: it had not installed its handler yet
            if self._wait() not in (0, -signal.SIGTERM):
                raise Fault(f"a listener that was stopped ends with code {self._process.returncode}")
        else:
            self._process.kill()
            self._process.wait()
            self.killed += 1
        self._process = None
        self._number += 1

    def _wait(self):
        try:
            return self._process.wait(DEADLINE)
        except subprocess.TimeoutExpired:
            raise Fault("a listener that was stopped does not end") from None

    def _start(self):
        topic = TOPICS[self._number // 3 % len(TOPICS)]
        command = [self._program, "topic", "-e", "-t", topic]
        if self._number % 3 == 0:
            command += ["-n", "3"]
        self._process = subprocess.Popen(
            command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=self._environment
        )
        self.came += 1

    def stop(self):
        """Stops the one that is to be slow: the daemon has to keep its messages, and to give them up."""
        if self._process is not None and self._number % 3 == 1:
            self._process.send_signal(signal.SIGSTOP)

    def end(self):
        if self._process is not None:
            self._process.kill()
            self._process.wait()
