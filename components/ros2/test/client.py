"""Services called by an independent peer, including steps of a paused simulation."""

from dataclasses import dataclass, field

import peers
from cyclonedds.idl import IdlStruct
from cyclonedds.idl.types import uint8, uint64
from cyclonedds.pub import DataWriter, Publisher
from cyclonedds.sub import DataReader, Subscriber
from cyclonedds.topic import Topic

MSG = "simulation_interfaces::msg::dds_::"
SRV = "simulation_interfaces::srv::dds_::"


@dataclass
class Result(IdlStruct, typename=MSG + "Result_"):
    result: uint8 = 0
    error_message: str = ""


@dataclass
class StepSimulationRequest(IdlStruct, typename=SRV + "StepSimulation_Request_"):
    steps: uint64 = 1


@dataclass
class StepSimulationResponse(IdlStruct, typename=SRV + "StepSimulation_Response_"):
    result: Result = field(default_factory=Result)


class Client:
    """A single client: the server identifies it by its writer, because cyclonedds can't name the reader of the reply."""

    def __init__(self, peer, service, request, response):
        participant = peer.participant
        self._writer = DataWriter(Publisher(participant), Topic(participant, f"rq{service}Request", request),
                                  qos=peers.RELIABLE)
        self._reader = DataReader(Subscriber(participant), Topic(participant, f"rr{service}Reply", response),
                                  qos=peers.RELIABLE)
        peers.until(lambda: self._writer.get_matched_subscriptions() and self._reader.get_matched_publications(),
                    service)

    def ask(self, request):
        self._writer.write(request)

    def answer(self):
        return peers.take_one(self._reader)

    def __call__(self, request):
        self.ask(request)
        return self.answer()


class Steps:
    """Steps a paused simulation, so that slow readers keep up: `steps(100)` makes 100 steps."""

    def __init__(self, peer, node="/pongsim"):
        self._client = Client(peer, node + "/step_simulation", StepSimulationRequest, StepSimulationResponse)

    def __call__(self, count):
        answer = self._client(StepSimulationRequest(count))
        assert answer.result.result == 1, answer
