"""Nothing from another machine, simulated by a network namespace, gets in without --network."""

import json
import os
import pathlib
import socket
import struct
import subprocess
import sys

import peers
import pytest
from other_machine import HERE, ON_THE_OTHER, THERE, Unavailable, beside_another

WORLD = peers.ROOT / "components/ros2/test/drive.sdf"
GROUP = "239.255.0.1"


def inside(function, distro="humble"):
    """Runs a function of this file within the namespaces, for a distribution, and returns its output."""
    try:
        result = beside_another([sys.executable, __file__, function], ROS_DISTRO=distro)
    except Unavailable as why:
        pytest.skip(str(why))
    assert result.returncode == 0, result.stderr[-3000:]
    return json.loads(result.stdout.splitlines()[-1])


def sockets(pid):
    """The UDP sockets of a process: port, and packets that were dropped."""
    inodes = set()
    for handle in pathlib.Path(f"/proc/{pid}/fd").iterdir():
        try:
            target = os.readlink(handle)
        except OSError:
            continue
        if target.startswith("socket:["):
            inodes.add(target[8:-1])
    found = []
    for line in pathlib.Path(f"/proc/{pid}/net/udp").read_text().splitlines()[1:]:
        words = line.split()
        if words[9] in inodes:
            found.append((words[1].split(":")[0], int(words[1].split(":")[1], 16), int(words[12])))
    return found


def elsewhere(program, *arguments):
    return subprocess.Popen([*ON_THE_OTHER, sys.executable, "-c", program, *map(str, arguments)],
                            stdout=subprocess.PIPE, text=True)


SEND = """
import socket, sys
sender = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
sender.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, 1)
sender.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton(sys.argv[1]))
for port in sys.argv[3:]:
    for _ in range(100):
        sender.sendto(b"RTPS" + bytes(60), (sys.argv[2], int(port)))
"""

HEAR = """
import sys
sys.path.insert(0, sys.argv[1])
import peers
reader = peers.Peer().reader("/clock", peers.Clock)
print("listens", flush=True)
while True:
    peers.take_one(reader, patience=float(sys.argv[2]))
    print("heard", flush=True)
"""

TEST_FOLDER = pathlib.Path(__file__).parent


def packets_from_outside():
    """Counts what the kernel drops of packets sent to each port of the simulation, and to the group."""
    anywhere, here, group = "00000000", "016433C6", "0100FFEF"
    with peers.running(WORLD) as simulation:
        peers.take_one(peers.Peer().reader("/clock", peers.Clock))
        reachable = [port for address, port, _ in sockets(simulation.pid) if address in (anywhere, here)]
        groups = {port for address, port, _ in sockets(simulation.pid) if address == group}

        def drops():
            return sum(count for address, _, count in sockets(simulation.pid) if address in (anywhere, here, group))

        before = drops()
        assert elsewhere(SEND, THERE, HERE, *reachable).wait(60) == 0
        assert elsewhere(SEND, THERE, GROUP, *groups).wait(60) == 0
        sent = 100 * (len(reachable) + len(groups))
        peers.until(lambda: drops() - before >= sent, f"{sent} drops at {reachable} and {groups}")
        peers.take_one(peers.Peer().reader("/clock", peers.Clock))
    print(json.dumps({"ports": len(reachable), "groups": len(groups)}))


def announcement(prefix, port):
    """What a participant that listens here at the port announces itself with (RTPS 8.5.3, 9.6.2.2)."""
    locator = struct.pack("<iI12x4s", 1, port, socket.inet_aton(HERE))
    parameters = [(0x15, bytes([2, 3, 0, 0])), (0x16, bytes([1, 16, 0, 0])), (0x50, prefix + bytes([0, 0, 1, 0xC1])),
                  (0x32, locator), (0x31, locator), (0x02, struct.pack("<iI", 100, 0)), (0x58, struct.pack("<I", 0x3F)),
                  (0x01, b"")]
    content = bytes([0, 3, 0, 0]) + b"".join(struct.pack("<HH", key, len(value)) + value for key, value in parameters)
    data = struct.pack("<HH", 0, 16) + bytes([0, 1, 0, 0xC7, 0, 1, 0, 0xC2]) + struct.pack("<iI", 0, 1) + content
    return b"RTPS" + bytes([2, 3, 1, 16]) + prefix + struct.pack("<BBH", 0x15, 5, len(data)) + data


# Sends packets with source addresses that are not the sender's.
FORGE = """
import json, socket, struct, sys
packets = json.load(sys.stdin)
raw = socket.socket(socket.AF_INET, socket.SOCK_RAW, socket.IPPROTO_RAW)
raw.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton(sys.argv[1]))
for source, to, port, payload in packets:
    payload = bytes.fromhex(payload)
    udp = struct.pack(">HHHH", 40000, port, 8 + len(payload), 0) + payload
    ip = struct.pack(">BBHHHBBH4s4s", 0x45, 0, 20 + len(udp), 0, 0, 1, 17, 0, socket.inet_aton(source), socket.inet_aton(to))
    raw.sendto(ip + udp, (to, port))
"""


def heard_at(listener):
    """The number of packets waiting at a socket."""
    count = 0
    while True:
        try:
            listener.recv(65536)
            count += 1
        except BlockingIOError:
            return count


def forged_packets():
    """Whether announcements with this machine's own addresses, sent from another one, are answered as its own are."""
    listeners = []
    for _ in range(2):
        listener = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        listener.setblocking(False)
        listener.bind(("0.0.0.0", 0))
        listeners.append(listener)
    outside, own = (announcement(bytes([1, 16]) + bytes([number] * 10), listener.getsockname()[1])
                    for number, listener in enumerate(listeners, 1))
    wire = socket.socket(socket.AF_PACKET, socket.SOCK_DGRAM, socket.htons(0x0800))
    wire.bind(("here", 0x0800))
    wire.setblocking(False)
    with peers.running(WORLD) as simulation:
        peers.take_one(peers.Peer().reader("/clock", peers.Clock))
        ports = [port for address, port, _ in sockets(simulation.pid) if address in ("00000000", "016433C6")]
        groups = {port for address, port, _ in sockets(simulation.pid) if address == "0100FFEF"}
        ways = [(HERE, port) for port in ports] + [(GROUP, port) for port in groups]
        packets = [(source, to, port, outside.hex()) for source in (HERE, "127.0.0.1", "127.0.0.2", THERE)
                   for to, port in ways]
        forger = subprocess.run([*ON_THE_OTHER, sys.executable, "-c", FORGE, THERE],
                                input=json.dumps(packets), text=True, timeout=60)
        assert forger.returncode == 0
        arrived = 0

        def all_arrived():
            nonlocal arrived
            while True:
                try:
                    packet, address = wire.recvfrom(65536)
                except BlockingIOError:
                    return arrived >= len(packets)
                arrived += outside in packet and address[2] != socket.PACKET_OUTGOING

        peers.until(all_arrived, "the packets at the interface")
        # behind them, so that they would have been answered before
        sender = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)

        def answered():
            for port in ports:
                sender.sendto(own, (HERE, port))
            return heard_at(listeners[1])

        peers.until(answered, "an answer to this machine's own")
        print(json.dumps({"sent": len(packets), "answered": heard_at(listeners[0])}))


def nodes_outside():
    """Whether another machine's node receives the clock of a closed simulation while a local one does, and of an open one."""
    with peers.running(WORLD):
        node = elsewhere(HEAR, TEST_FOLDER, 3600)
        assert node.stdout.readline() == "listens\n"
        # enough time to discover several local nodes is enough for one that could be discovered
        for _ in range(5):
            peers.take_one(peers.Peer().reader("/clock", peers.Clock))
        assert node.poll() is None
        node.kill()
        closed = node.communicate()[0] == ""
    with peers.running(WORLD, "--network", "here"):
        node = elsewhere(HEAR, TEST_FOLDER, peers.PATIENCE)
        opened = [node.stdout.readline() for _ in range(2)] == ["listens\n", "heard\n"]
        node.kill()
        node.communicate()
    print(json.dumps({"closed": closed, "opened": opened}))


@pytest.mark.parametrize("distro", ["humble", "jazzy"])
def test_no_packet_from_outside_gets_in(distro):
    result = inside("packets_from_outside", distro)
    # of discovery and of data, and the group
    assert result["ports"] >= 2 and result["groups"] == 1


def test_no_packet_with_a_forged_source_gets_in():
    result = inside("forged_packets")
    assert result["sent"] >= 12 and result["answered"] == 0


@pytest.mark.parametrize("distro", ["humble", "jazzy"])
def test_a_node_elsewhere_is_met_only_where_the_network_is_open(distro):
    assert inside("nodes_outside", distro) == {"closed": True, "opened": True}


if __name__ == "__main__":
    globals()[sys.argv[1]]()
