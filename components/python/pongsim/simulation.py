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
    """A world that runs in this process.

    Use it on one thread at a time. Several simulations can run on several threads at once, since stepping releases the
    GIL. It ends with `close`, at the end of a `with` block, or when it is deleted. Models, links, joints and sensors do
    not keep it alive, and raise Gone afterwards.
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

        world: an SDF or URDF file, or its text, which contains a "<".
        file: for a text, its file name, used in messages and as the base of relative paths.
        seed: seed of all random numbers.
        systems: systems in Python in addition to those of the file, as for `add`.
        load_systems: False: only bodies, joints and gravity.
        strict: a failing system ends the step with SystemFailed instead of being switched off.
        threads: number of threads that move bodies; the result has the same bits.
        levels: models in levels exist only while a performer is near.
        network: share topics and services with other processes, such as `pongsim topic`; otherwise they stay within this
            simulation. `domain` and `interface` are like PONGSIM_DOMAIN and PONGSIM_NETWORK.

        Raises LoadError with file, line and column if the world can't run; warns with WorldWarning about what is left
        out.
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
            return "<pongsim.Simulation, closed>"
        return f"<pongsim.Simulation '{self.name}' at {self.time:g} s>"

    def add(self, system: System) -> None:
        """Adds a system in Python after all others. Raises SystemFailed if its `configure` raises."""
        if not isinstance(system, System):
            raise TypeError(f"a system must derive from pongsim.System, but {type(system).__name__} does not")
        if system._simulation is not None:
            raise ValueError("the system is already in a simulation; use a new one")
        system._simulation = self
        try:
            self.add_system(system.name or type(system).__name__, system)
        except BaseException:
            system._simulation = None
            raise

    def sensor(self, name: str, *kinds: str) -> Sensor:
        """Returns the sensor with that name, and switches it on.

        name: "model::link::sensor", or its own name if that is unique.
        kinds: kinds of readings to switch on: "ranges", "points", "image", "depth" or "message"; default: the main one of
            its type.
        Raises KeyError, and ValueError for a kind that the sensor does not have.
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
        """Subscribes to a topic until the subscription is closed.

        to: called with each message; or a queue (`put_nowait`), deque or list (`append`) for the messages. A full queue
            drops its oldest message. It is called at the start of the step after the one that published, or within
            `dispatch`; its exceptions end the step and are raised there.
        type: type of the messages: None: dicts; a message class: its objects; `bytes`: the encoded messages.
        length: largest number of waiting messages; then the oldest is dropped.
        """
        return self.open_subscription(topic, _receiver(to), type, length)

    def publish(self, topic: str, message: Message, *, type: str = "") -> None:
        """Publishes a message. It arrives at the start of the next step.

        type: its type, such as "Twist"; not needed for objects of a message class, or if the topic already exists in this
            simulation.
        Raises ValueError and TypeError that name the wrong field.
        """
        self.publish_message(topic, message, type)

    def request(
        self, service: str, request: Message, *, type: str = "", reply: Any = "Boolean", timeout: float = 5.0
    ) -> Any:
        """Calls a service of this simulation, or with `network` of another process, and returns its response.

        type: the request's type, such as "EntityFactory"; not needed for an object of a message class.
        reply: the response's type: a name for a dict, or a message class for an object of it.
        timeout: time to wait for other processes [s of wall time].
        Raises ServiceError if there is no such service, or if it refuses or does not respond.
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
    raise TypeError(f"a subscription needs a function or a queue, not a {type(to).__name__}")


def _put(queue: Any, message: Any) -> None:
    while queue.full():
        queue.get_nowait()
    queue.put_nowait(message)
