"""What becomes of a run where the machine is in trouble. PONGSIM is the program, PONGSIM_FAULTS the library of faults."""

import os
import pathlib
import resource
import signal
import subprocess
import sys
import tempfile
import time
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "support"))

from sweep import DEADLINE, ORDERLY, WORLD  # noqa: E402
from test_domain import take_domain  # noqa: E402

PROGRAM = os.environ["PONGSIM"]
LIBRARY = os.environ["PONGSIM_FAULTS"]
#: Worlds that start at once.
WORLDS = int(os.environ.get("PONGSIM_FAULTS_WORLDS", "8"))
#: Steps that a run may catch up on after it was held up, of 1 ms each (docs/gazebo.md, "pace").
DEBT = 20


class Trouble(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.domain = take_domain()

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def environment(self, **added):
        return {**os.environ, "HOME": str(self.folder), "PONGSIM_DOMAIN": str(self.domain), **added}

    def run_world(self, *options, limit=None, **environment):
        """Runs the first world to its end."""
        return subprocess.run(
            [PROGRAM, "run", str(WORLD), "-w", "first", *options],
            env=self.environment(**environment),
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            timeout=DEADLINE,
            preexec_fn=limit,
        )

    def start(self, *command, **environment):
        """Starts the program; it ends with the test."""
        process = subprocess.Popen(
            [PROGRAM, *command],
            env=self.environment(**environment),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def test_a_wall_clock_that_jumps_changes_nothing(self):
        plain = self.run_world("--iterations", "100", "--hash")
        self.assertEqual(plain.returncode, 0, plain.stderr)
        for jump in "86400:20", "-86400:20":
            jumped = self.run_world("--iterations", "100", "--hash", LD_PRELOAD=LIBRARY, PONGSIM_FAULT_CLOCK=jump)
            self.assertEqual((jumped.returncode, jumped.stdout), (0, plain.stdout), jumped.stderr)

    def test_a_wall_clock_that_jumps_holds_up_no_listener(self):
        world = self.start("run", str(WORLD), "-w", "first", LD_PRELOAD=LIBRARY, PONGSIM_FAULT_CLOCK="-86400:1000")
        self.assertIn("pongsim: world", world.stderr.readline())
        heard = self.start("topic", "-e", "-t", "/clock", "-n", "1500")
        heard.communicate(timeout=DEADLINE)
        self.assertEqual(heard.returncode, 0)

    def test_a_run_that_was_stopped_goes_on_and_does_not_catch_up(self):
        start = time.monotonic()
        world = self.start("run", str(WORLD), "-w", "first", "--hash-every", "1")
        lines = 0
        while lines < 100:
            self.assertIn("state hash after", world.stdout.readline())
            lines += 1
        world.send_signal(signal.SIGSTOP)
        os.waitid(os.P_PID, world.pid, os.WSTOPPED)
        stopped = time.monotonic()
        time.sleep(float(os.environ.get("PONGSIM_FAULTS_STOP", "2")))
        stopped = time.monotonic() - stopped
        world.send_signal(signal.SIGCONT)
        for _ in range(1000):
            self.assertIn("state hash after", world.stdout.readline())
            lines += 1
        ran = time.monotonic() - start - stopped
        self.assertLessEqual(lines, ran * 1000 + DEBT + 1)
        world.send_signal(signal.SIGINT)
        world.communicate(timeout=DEADLINE)
        self.assertEqual(world.returncode, 0)

    def check_recorded(self, run):
        """A recording that could not be written is said, and what has been written can be read."""
        self.assertIn(run.returncode, ORDERLY, run.stderr)
        self.assertTrue("error" in run.stderr or "warning" in run.stderr, run.stderr)
        file = self.folder / "recording" / "state.tlog"
        if file.exists() and run.returncode == 0:
            info = subprocess.run([PROGRAM, "log", "info", str(file)], capture_output=True, text=True, timeout=DEADLINE)
            self.assertIn(info.returncode, ORDERLY, info.stderr)

    def test_a_full_disk_is_said(self):
        for size in "0", "5000", "40000":
            with self.subTest(size=size):
                place = self.folder / "recording"
                run = self.run_world(
                    "-z", "0", "--iterations", "300", "--record-path", str(place), LD_PRELOAD=LIBRARY, PONGSIM_FAULT_DISK=size
                )
                self.check_recorded(run)
                subprocess.run(["rm", "-rf", str(place)], check=True)

    def test_a_limit_on_the_size_of_files_is_said(self):
        limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000))  # noqa: E731
        place = self.folder / "recording"
        self.check_recorded(self.run_world("-z", "0", "--iterations", "300", "--record-path", str(place), limit=limit))

    def test_descriptors_that_run_out_are_an_error(self):
        for most in range(4, 40, 5):
            with self.subTest(most=most):
                limit = lambda most=most: resource.setrlimit(resource.RLIMIT_NOFILE, (most, most))  # noqa: E731
                run = self.run_world("-z", "0", "--iterations", "20", "--hash", limit=limit)
                self.assertIn(run.returncode, (0, 1, 2, 127), run.stderr)
                self.assertTrue(run.returncode == 0 or "error" in run.stderr, run.stderr)
                self.assertNotIn("crashed", run.stderr)

    def test_many_worlds_that_start_at_once_come_up(self):
        text = WORLD.read_text(encoding="utf-8")
        first = text[: text.index('  <world name="second">')] + "</sdf>"
        worlds = []
        start = time.monotonic()
        for i in range(WORLDS):
            file = self.folder / f"world{i}.sdf"
            file.write_text(first.replace('name="first"', f'name="world{i}"'), encoding="utf-8")
            worlds.append(self.start("run", str(file), "--paused"))
        for world in worlds:
            self.assertIn("pongsim: world", world.stderr.readline())
        up = time.monotonic() - start
        missing = range(WORLDS)
        while missing and time.monotonic() < start + 2 * DEADLINE:
            topics = self.start("topic", "-l").communicate(timeout=DEADLINE)[0].split()
            missing = [i for i in range(WORLDS) if f"/world/world{i}/clock" not in topics]
        self.assertEqual(missing, [])
        listed = time.monotonic() - start
        memory = 0
        for world in worlds:
            with open(f"/proc/{world.pid}/smaps_rollup", encoding="ascii") as lines:
                memory += sum(int(line.split()[1]) for line in lines if line.startswith("Pss:"))
        print(f"{WORLDS} worlds: up after {up:.1f} s, all listed after {listed:.1f} s, {memory / 1024 / WORLDS:.1f} MB each")
        for world in worlds:
            world.send_signal(signal.SIGINT)
        for world in worlds:
            self.assertEqual(world.wait(DEADLINE), 0)


if __name__ == "__main__":
    unittest.main()
