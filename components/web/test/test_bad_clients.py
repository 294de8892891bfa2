"""Malicious or broken clients do not affect the world."""

import json
import os
import pathlib
import signal
import subprocess
import sys
import threading
import time
import unittest

from web_world import ROOT, Connection, running, until

WORLD = ROOT / "worlds/pong_world.sdf"
MEGABYTE = 1 << 20


def memory(pid):
    """Resident bytes of a process."""
    pages = int(pathlib.Path(f"/proc/{pid}/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE")


def listen(connection, topics):
    """Opens the connection and subscribes to those of the topics."""
    assert connection.open() == 101
    found = {}
    while not set(topics) <= set(found):
        opcode, payload = connection.next()
        message = json.loads(payload) if opcode == 1 else {}
        found |= {channel["topic"]: channel["id"] for channel in message.get("channels", [])}
    connection.send(json.dumps({"op": "subscribe", "subscriptions": [
        {"id": number, "channelId": found[topic]} for number, topic in enumerate(topics)]}))


def next_data(connection):
    """Subscription and payload of the next message of a topic."""
    while True:
        opcode, payload = connection.next()
        if opcode == 2 and payload[0] == 1:
            return int.from_bytes(payload[1:5], "little"), payload[13:]


class BadClients(unittest.TestCase):
    def setUp(self):
        context = running(WORLD, "--web", "0")
        self.simulation = context.__enter__()
        self.addCleanup(context.__exit__, None, None, None)
        self.host, self.port, _ = self.simulation.address()

    def connect(self):
        connection = Connection(self.host, self.port)
        self.addCleanup(connection.__exit__, None, None, None)
        return connection

    def check_that_it_goes_on(self):
        with Connection(self.host, self.port) as connection:
            listen(connection, ["/clock"])
            for _ in range(3):
                next_data(connection)

    def test_rubbish(self):
        rubbish = [b"\0" * 10, b"\xff" * 1000, os.urandom(5000), b"{", b"[]", b"{\"op\": 7}", b"{\"op\": \"fly\"}",
                   b"[" * 100_000, b"{\"op\": \"subscribe\", \"subscriptions\": {}}", b"sub,,,", b",,,,,,", b""]
        for protocol in ("foxglove.websocket.v1", "pongsim.web.v1", None):
            for bytes_ in rubbish:
                for opcode in (1, 2):
                    connection = self.connect()
                    self.assertEqual(connection.open(protocol=protocol), 101)
                    connection.send(bytes_, opcode)
        connection = self.connect()
        connection.socket.sendall(os.urandom(100_000))
        self.check_that_it_goes_on()
        self.assertIsNone(self.simulation.process.poll())

    def test_a_message_that_is_too_large(self):
        connection = self.connect()
        self.assertEqual(connection.open(), 101)
        connection.socket.sendall(b"\x81\xff" + (1 << 40).to_bytes(8, "big") + bytes(4) + b"x" * 1000)
        with self.assertRaises((EOFError, OSError)):
            while True:
                opcode, payload = connection.next()
                if opcode == 8:
                    self.assertEqual(int.from_bytes(payload[:2], "big"), 1009)
                    raise EOFError
        self.check_that_it_goes_on()

    def test_a_message_of_5_mib_is_answered_with_the_reason(self):
        connection = self.connect()
        self.assertEqual(connection.open(), 101)
        # it is read while it is sent, as browsers do
        sender = threading.Thread(target=connection.send, args=(b"x" * (5 * MEGABYTE), 2))
        sender.start()
        opcode = 0
        while opcode != 8:
            opcode, payload = connection.next()
        self.assertEqual(int.from_bytes(payload[:2], "big"), 1009)
        self.assertIn(b"up to 4194304 bytes", payload)
        sender.join()
        self.check_that_it_goes_on()

    def test_600_slow_handshakes_keep_nobody_out(self):
        slow = []
        for number in range(600):
            slow.append(self.connect())
            if number % 2:
                slow[-1].socket.sendall(b"GET / HTTP/1.1\r\nHost: ")
        begin = time.monotonic()
        with Connection(self.host, self.port) as connection:
            self.assertEqual(connection.get("/assets/none.png")[0], 404)
        self.check_that_it_goes_on()
        # far below the time after which a handshake ends by itself
        self.assertLess(time.monotonic() - begin, 5)

    def test_clients_that_never_read_cost_a_bounded_memory(self):
        self.check_that_it_goes_on()
        before = memory(self.simulation.process.pid)
        for _ in range(20):
            listen(self.connect(), ["/clock", "/world/pong_world/stats", "/world/pong_world/state"])
        witness = self.connect()
        listen(witness, ["/clock"])
        begin = time.monotonic()
        while time.monotonic() < begin + 5:
            next_data(witness)
        self.assertLess(memory(self.simulation.process.pid) - before, 100 * MEGABYTE)

    def test_twenty_killed_clients_leave_nothing_behind(self):
        self.check_that_it_goes_on()
        before = memory(self.simulation.process.pid)
        sockets = pathlib.Path(f"/proc/{self.simulation.process.pid}/fd")
        # the connection of the check may still exist
        quiet = len(list(sockets.iterdir()))
        program = ("import sys; sys.path.insert(0, sys.argv[1])\n"
                   "from test_bad_clients import Connection, listen, next_data\n"
                   "connection = Connection(sys.argv[2], int(sys.argv[3]))\n"
                   "listen(connection, ['/clock', '/world/pong_world/stats'])\n"
                   "print('listens', flush=True)\n"
                   "while True: next_data(connection)\n")
        here = str(pathlib.Path(__file__).parent)
        clients = [subprocess.Popen([sys.executable, "-c", program, here, self.host, str(self.port)],
                                    stdout=subprocess.PIPE) for _ in range(20)]
        for client in clients:
            self.assertEqual(client.stdout.readline(), b"listens\n")
        for client in clients:
            client.send_signal(signal.SIGKILL)
            client.wait()
            client.stdout.close()
        self.check_that_it_goes_on()
        until(lambda: len(list(sockets.iterdir())) <= quiet, "the end of the sockets")
        self.assertLess(memory(self.simulation.process.pid) - before, 40 * MEGABYTE)


if __name__ == "__main__":
    unittest.main()
