"""Services for nodes with rmw_cyclonedds, which puts a header in front of requests and replies."""

from dataclasses import dataclass, field

import client
import peers
from cyclonedds.core import Policy, Qos
from cyclonedds.idl import IdlStruct
from cyclonedds.idl.types import int64, uint64
from cyclonedds.pub import DataWriter, Publisher
from cyclonedds.sub import DataReader, Subscriber
from cyclonedds.topic import Topic

WORLD = peers.ROOT / "components/ros2/test/drive.sdf"


@dataclass
class Request(IdlStruct, typename=client.SRV + "StepSimulation_Request_"):
    sender: uint64 = 0
    number: int64 = 0
    steps: uint64 = 1


@dataclass
class Response(IdlStruct, typename=client.SRV + "StepSimulation_Response_"):
    sender: uint64 = 0
    number: int64 = 0
    result: client.Result = field(default_factory=client.Result)


class CycloneClient:
    """As rmw_cyclonedds's: writer and reader announce the same id, and the header of a reply is that of its request."""

    def __init__(self, peer, number):
        qos = Qos(*peers.RELIABLE.policies, Policy.Userdata(f"clientid=1.{number:x};".encode()))
        participant = peer.participant
        self.number = number
        self._writer = DataWriter(Publisher(participant), Topic(participant, "rq/pongsim/step_simulationRequest", Request),
                                  qos=qos)
        self.reader = DataReader(Subscriber(participant), Topic(participant, "rr/pongsim/step_simulationReply", Response),
                                 qos=qos)
        peers.until(lambda: self._writer.get_matched_subscriptions() and self.reader.get_matched_publications(),
                    "the service")

    def ask(self, number):
        self._writer.write(Request(self.number, number, 1))


def test_each_client_gets_the_replies_to_its_own_requests():
    with peers.running(WORLD):
        peer = peers.Peer()
        clients = CycloneClient(peer, 0x1234567890ABCDEF), CycloneClient(peer, 2)
        for number in (7, 8):
            for each in clients:
                each.ask(number)
                # both readers are in one participant, and the clients tell the replies apart by the header
                answer = peers.take_one(each.reader, where=lambda reply: reply.sender == each.number)
                assert answer.number == number
                # it is not paused
                assert answer.result.result == 4 and "paused" in answer.result.error_message
