"""What tests of pongsim log share: a folder and a domain, a running world, a recorder."""

import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
PONGSIM = os.environ.get("PONGSIM", str(ROOT / "build/release/bin/pongsim"))
FORTRESS = pathlib.Path(os.environ.get("PONGSIM_FORTRESS_WORLDS", ROOT / "../shared/fortress"))

sys.path.append(str(ROOT / "test/support"))
from test_domain import take_domain  # noqa: E402
from waiting import PATIENCE, until  # noqa: E402

os.environ["PONGSIM_DOMAIN"] = str(take_domain())


class Place:
    """A folder, and the programs that run in it and end with it."""

    def __enter__(self):
        self._folder = tempfile.TemporaryDirectory(prefix="pongsim-log-")
        self.path = pathlib.Path(self._folder.name)
        self._running = []
        return self

    def __exit__(self, *_):
        for process in self._running:
            if process.poll() is None:
                process.kill()
            process.wait()
        self._folder.cleanup()

    def log(self, *words, code=0):
        """The output and messages of `pongsim log`."""
        done = subprocess.run([PONGSIM, "log", *map(str, words)], cwd=self.path, capture_output=True, text=True,
                              timeout=PATIENCE)
        assert done.returncode == code, (words, done.returncode, done.stdout[-2000:], done.stderr[-2000:])
        return done.stdout if code == 0 else done.stderr

    def start(self, *words):
        with open(self.path / f"said{len(self._running)}", "w") as said:
            process = subprocess.Popen([PONGSIM, *map(str, words)], cwd=self.path, stdout=subprocess.DEVNULL, stderr=said)
        self._running.append(process)
        return process

    def said(self, process):
        return (self.path / f"said{self._running.index(process)}").read_text()

    def record(self, *words):
        recorder = self.start("log", "record", *words)
        until(lambda: "recording to" in self.said(recorder), "a recorder")
        return recorder

    def counts(self, name):
        """The number of messages of each topic in the complete chunks of a recording."""
        return {topic["name"]: topic["count"] for topic in json.loads(self.log("info", name, "--json"))["topics"]}

    def wait_for_messages(self, name, least):
        """Waits until a running recording has this many of each topic, and one more chunk."""
        def has_enough():
            counts = self.counts(name)
            return all(counts.get(topic, 0) >= count for topic, count in least.items())

        until(has_enough, f"{least} in {name}")
        before = sum(self.counts(name).values())
        until(lambda: sum(self.counts(name).values()) > before, f"more in {name}")

    def cut(self, name, to):
        """The rest of a recording of several chunks whose last one is incomplete."""
        from mcap.reader import make_reader

        with open(self.path / name, "rb") as stream:
            last = make_reader(stream).get_summary().chunk_indexes[-1]
        whole = (self.path / name).read_bytes()
        (self.path / to).write_bytes(whole[:last.chunk_start_offset + last.chunk_length // 2])

    def end(self, process, with_signal=signal.SIGINT):
        process.send_signal(with_signal)
        return process.wait(PATIENCE)


WORLD = """<sdf version="1.9"><world name="drive">
  <plugin filename="ignition-gazebo-physics-system" name="ignition::gazebo::systems::Physics"/>
  <model name="box"><link name="body"/>
    <plugin filename="ignition-gazebo-pose-publisher-system" name="ignition::gazebo::systems::PosePublisher">
      <publish_model_pose>true</publish_model_pose><update_frequency>100</update_frequency></plugin>
  </model></world></sdf>"""
