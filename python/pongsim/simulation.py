"""A simulation in this process."""

from __future__ import annotations

import os
import warnings
from types import TracebackType
from typing import Any, Callable, Iterable, Union

import numpy as np
from numpy.typing import NDArray

from . import _core
from .arrays import view
from .errors import WorldWarning
from .sensor import Sensor
from .system import System

#: A dict by the names of fields, protobuf's text format, or an object of a message's own Python class.
Message = Union["dict[str, Any]", str, Any]


class Simulation(_core.Simulation):
    """One world that runs in this process.

    It belongs to one thread at a time; several simulations run on several threads at once, for other Python threads run
    while one steps. It ends with `close`, at the end of a `with` block, or when nothing holds it any more; models, links,
    joints and sensors do not hold it, and raise Gone then.
    """

    def __init__(
        self,
        world: str | os.PathLike[str],
        *,
        seed: int = 0,
        systems: Iterable[System] = (),
        load_systems: bool = True,
        strict: bool = False,
        threads: int = 1,
        levels: bool = False,
        network: bool = False,
        domain: int | None = None,
        interface: str | None = None,
        file: str | os.PathLike[str] = "<text>",
    ) -> None:
        """Loads a world.

        world: a file in SDF or URDF, or its text, which has a "<" in it.
        file: of a text, the file that it stands for: what it includes is looked for from there, and faults name it.
        seed: where all random numbers come from.
        systems: systems in Python beside those of the file, as `add` takes them.
        load_systems: False: only bodies, joints and gravity.
        strict: a system that fails ends the step with SystemFailed, in place of being switched off.
        threads: how many threads move the bodies; the bits are the same.
        levels: models of levels are there only while a performer is near.
        network: topics and services are those of other processes, too, as of `pongsim topic`; else nothing leaves this
            simulation. `domain` and `interface` are as PONGSIM_DOMAIN and PONGSIM_NETWORK.

        Raises LoadError with file, line and column where the world can't run; warns with WorldWarning of what is left out.
        """
        super().__init__(
            os.fspath(world), seed, load_systems, strict, threads, levels, network, domain, interface,
            os.fspath(file),
        )
        for diagnostic in self.diagnostics:
            warnings.warn(str(diagnostic), WorldWarning, stacklevel=2)
        for system in systems:
            self.add(system)

    def __enter__(self) -> Simulation:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, raised: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def __repr__(self) -> str:
        if self.is_closed:
            return "<pongsim.Simulation that is closed>"
        return f"<pongsim.Simulation '{self.name}' at {self.time:g} s>"

    def add(self, system: System) -> None:
        """Adds a system in Python behind all that are there. Raises SystemFailed where its `configure` raises."""
        if not isinstance(system, System):
            raise TypeError(f"a system derives from pongsim.System, which {type(system).__name__} does not")
        if system._simulation is not None:
            raise ValueError("the system is in a simulation already; each needs one of its own")
        system._simulation = self
        try:
            self.add_system(system.name or type(system).__name__, system)
        except BaseException:
            system._simulation = None
            raise

    def sensor(self, name: str, *kinds: str) -> Sensor:
        """The sensor of that name, "model::link::sensor", or its own name where no other has it, and listens to it.

        kinds: what is listened to from now on: "ranges", "points", "image", "depth" or "message"; without any, the main
        one of its type. Raises KeyError, and ValueError for what such a sensor does not have.
        """
        return Sensor(self.find_sensor(name), kinds)

    def poses(self) -> NDArray[np.float64]:
        """Poses of all models in the world frame, in the order of `model_names`: a new array of n x 7, of x, y, z [m] and
        the quaternion x, y, z, w."""
        return view(self.poses_memory(), "f8", (-1, 7))

    def joint_states(self) -> NDArray[np.float64]:
        """Positions [rad or m] and velocities [rad/s or m/s] of all joints' axes, in the order of `joint_names`: a new
        array of n x 2."""
        return view(self.joint_states_memory(), "f8", (-1, 2))

    def subscribe(
        self, topic: str, to: Callable[[Any], object] | Any, *, type: Any = None, length: int = 1000
    ) -> _core.Subscription:
        """Hears a topic until the subscription is closed.

        to: what is called with each message, or a queue (`put_nowait`) or a deque or list (`append`) that gets it. A full
            queue loses its oldest message. It is called at the start of the step after the one that published, or from
            `dispatch`; what it raises ends that step, which raises it.
        type: what the messages are: None: dicts; a message's own Python class: objects of it; `bytes`: as they came.
        length: so many messages wait for the next step; then the oldest is lost.
        """
        return self.open_subscription(topic, _receiver(to), type, length)

    def publish(self, topic: str, message: Message, *, type: str = "") -> None:
        """Publishes a message. It arrives at the start of the next step.

        type: its type, as "Twist"; not needed for objects of a message's own class, nor where somebody in this simulation
        has the topic already. Raises ValueError and TypeError that name the field which is wrong.
        """
        self.publish_message(topic, message, type)

    def request(
        self, service: str, request: Message, *, type: str = "", reply: Any = "Boolean", timeout: float = 5.0
    ) -> Any:
        """Asks a service, of this simulation or with `network` of another process, and waits for its answer.

        type: the request's type, as "EntityFactory"; not needed for an object of a message's own class.
        reply: the answer's type: a name, and the answer is a dict, or a message's own class, and it is an object of it.
        timeout: how long to wait for other processes [s of wall time].
        Raises ServiceError where there is no such service, or it refuses or does not answer.
        """
        return self.ask(service, request, type, reply, timeout)


def _receiver(to: Any) -> Callable[[Any], object]:
    put = getattr(to, "put_nowait", None)
    if put is not None:
        return lambda message: _put(to, message)
    append = getattr(to, "append", None)
    if append is not None:
        receiver: Callable[[Any], object] = append
        return receiver
    if callable(to):
        called: Callable[[Any], object] = to
        return called
    raise TypeError(f"a topic is heard by a function or a queue, not by a {type(to).__name__}")


def _put(queue: Any, message: Any) -> None:
    while queue.full():
        queue.get_nowait()
    queue.put_nowait(message)
