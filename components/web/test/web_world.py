"""What the tests of the web share: a running world, and a client with arbitrary behaviour."""

import base64
import contextlib
import os
import pathlib
import re
import signal
import socket
import ssl
import struct
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "test/support"))

from test_domain import take_domain  # noqa: E402
from waiting import PATIENCE, until  # noqa: E402

PONGSIM = os.environ["PONGSIM"]
ENVIRONMENT = {
    **{name: value for name, value in os.environ.items() if name not in ("PONGSIM_NETWORK", "PONGSIM_WEB_TOKEN")},
    "PONGSIM_DOMAIN": str(take_domain()),
    # the address sanitizer keeps up to 256 MB of what was freed, which is no growth of the simulation's
    "ASAN_OPTIONS": os.environ.get("ASAN_OPTIONS", "") + ":quarantine_size_mb=1",
}
PHYSICS = "<plugin filename='ignition-gazebo-physics-system' name='ignition::gazebo::systems::Physics'/>"
EMPTY_WORLD = "<sdf version='1.9'><world name='w'>" + PHYSICS + "{}</world></sdf>"


class Simulation:
    """`pongsim run`, whose output is read while it runs."""

    def __init__(self, *words, environment=None):
        self.process = subprocess.Popen([PONGSIM, "run", *map(str, words)], env={**ENVIRONMENT, **(environment or {})},
                                        stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        os.set_blocking(self.process.stdout.fileno(), False)
        self.text = ""

    def output(self):
        while chunk := self.process.stdout.read():
            self.text += chunk.decode(errors="replace")
        return self.text

    def wait_for(self, pattern):
        def found():
            has_ended = self.process.poll() is not None
            match = re.search(pattern, self.output(), re.MULTILINE)
            assert match or not has_ended, f"ended with {self.process.returncode}: {self.text}"
            return match
        return until(found, lambda: f"'{pattern}'; it said: {self.text}")

    def address(self):
        """Host, port and token of the page."""
        match = self.wait_for(r"in a browser: https?://([0-9.]+):([0-9]+)/(?:\?token=(\S+))?$")
        return match[1], int(match[2]), match[3]

    def end(self):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
            try:
                self.process.wait(PATIENCE)
            except subprocess.TimeoutExpired:
                self.process.kill()
                self.process.wait()
        self.process.stdout.close()


@contextlib.contextmanager
def running(*words, environment=None):
    simulation = Simulation(*words, environment=environment)
    try:
        yield simulation
    finally:
        simulation.end()


def ended(*words, environment=None):
    """A finished pongsim command."""
    return subprocess.run([PONGSIM, *map(str, words)], env={**ENVIRONMENT, **(environment or {})}, capture_output=True,
                          text=True, timeout=PATIENCE, stdin=subprocess.DEVNULL)


class Connection:
    """A connection to a server, with HTTP and WebSocket written by hand."""

    def __init__(self, host, port, certificate=None):
        self.host, self.port = host, port
        self.socket = socket.create_connection((host, port), timeout=PATIENCE)
        if certificate:
            self.socket = ssl.create_default_context(cafile=certificate).wrap_socket(self.socket, server_hostname="localhost")
        self.stream = self.socket.makefile("rb")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.stream.close()
        self.socket.close()

    def get(self, path, **headers):
        """Status and body."""
        status, _ = self.head(path, Connection="close", **headers)
        return status, self.stream.read()

    def head(self, path, **headers):
        """Status and the headers of the answer."""
        headers = {"Host": f"{self.host}:{self.port}", **{name.replace("_", "-"): value for name, value in headers.items()}}
        lines = [f"GET {path} HTTP/1.1", *(f"{name}: {value}" for name, value in headers.items()), "", ""]
        self.socket.sendall("\r\n".join(lines).encode())
        status = int(self.stream.readline().split()[1])
        answer = {}
        while line := self.stream.readline().strip().decode():
            name, _, value = line.partition(": ")
            answer[name.lower()] = value
        return status, answer

    def open(self, path="/", protocol="foxglove.websocket.v1", **headers):
        """Status of the handshake: 101 if it was accepted."""
        if protocol:
            headers["Sec_WebSocket_Protocol"] = protocol
        return self.head(path, Upgrade="websocket", Connection="Upgrade", Sec_WebSocket_Version="13",
                         Sec_WebSocket_Key=base64.b64encode(os.urandom(16)).decode(), **headers)[0]

    def send(self, payload, opcode=1):
        payload = payload.encode() if isinstance(payload, str) else payload
        size = len(payload)
        head = bytes([0x80 | opcode])
        if size < 126:
            head += bytes([0x80 | size])
        elif size < 65536:
            head += bytes([0xfe]) + struct.pack(">H", size)
        else:
            head += bytes([0xff]) + struct.pack(">Q", size)
        self.socket.sendall(head + bytes(4) + payload)

    def read(self, size):
        data = self.stream.read(size)
        if len(data) < size:
            raise EOFError
        return data

    def next(self):
        """Opcode and payload of the next message."""
        opcode, payload = 0, b""
        while True:
            first, second = self.read(2)
            size = second & 127
            if size > 125:
                size = struct.unpack(">H" if size == 126 else ">Q", self.read(2 if size == 126 else 8))[0]
            part = self.read(size)
            if first & 15 == 9:
                continue
            opcode = first & 15 or opcode
            payload += part
            if first & 128:
                return opcode, payload
