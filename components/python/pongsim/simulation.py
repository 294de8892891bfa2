"""A simulation in this process."""

from __future__ import annotations

import operator
import os
import warnings
from types import TracebackType
from typing import Any, Callable, Iterable, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from .arrays import view
from .errors import LoadError, WorldWarning
from .names import closest
from .pictures import Eye
from .sensor import Sensor
from .state import Layout, layout_of, models_of, numbers
from .system import System
from .values import Contacts, Pose, RayHit, RayHits
from .viewing import View, show
from .worlds import find, nearest

#: The attributes that can be assigned.
_SETTABLE = ("gravity", "qpos", "qvel", "step_size")

#: What has inserted or removed models, and with which arguments.
_Edit = tuple[str, "dict[str, Any]"]

#: A dict by the names of fields, protobuf's text format, or an object of a message's own Python class.
Message = Union["dict[str, Any]", str, Any]


class Simulation(_core.Simulation):
    """A world that runs in this process.

    Use it on one thread at a time. Several simulations can run on several threads at once, since stepping releases the
    GIL. It ends with `close`, at the end of a `with` block, or when it is deleted. Models, links, joints and sensors do
    not keep it alive, and raise Gone afterwards. It can be pickled and copied: by its file or text, options, systems in
    Python, what `insert` and `remove` have done, and its state.
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
        _plugins: Sequence[Any] = (),
    ) -> None:
        """Loads a world.

        world: an SDF or URDF file, or its text, which contains a "<". A file that is not there is looked for among the
            worlds of pongsim (`pongsim.worlds`).
        file: for a text, its file name, used in messages and as the base of relative paths.
        seed: seed of all random numbers.
        systems: systems in Python in addition to those of the file, as for `add`.
        load_systems: False: only bodies, joints and gravity.
        strict: a failing system ends the step with SystemFailed instead of being switched off.
        threads: number of threads that move bodies; the result has the same bits.
        levels: models in levels exist only while a performer is near.
        network: share topics and services with other processes, such as `pongsim topic`; otherwise they stay within this
            simulation. `domain` and `interface` are like PONGSIM_DOMAIN and PONGSIM_NETWORK.

        Raises LoadError with file, line and column if the world can't run, RuntimeError if the threads can't start; warns with
        WorldWarning about what is left out.
        """
        self._options = {
            "load_systems": load_systems, "strict": strict, "threads": threads, "levels": levels, "network": network,
            "domain": domain, "interface": interface, "file": os.fspath(file), "_plugins": _plugins,
        }
        self._seed = _seed(seed)
        threads = _whole(threads, "threads")
        if domain is not None:
            domain = _whole(domain, "domain")
        found = find(world)
        #: The world's text, or its file from any folder.
        self._source = found if "<" in found else os.path.abspath(found)
        try:
            super().__init__(
                found, self._seed, load_systems, strict, threads, levels, network, domain, interface, os.fspath(file), _plugins,
            )
        except LoadError as error:
            error.args = (f"{error}{nearest(found)}",)
            raise
        self._systems: list[System] = []
        #: Stiffness and damping of the joints that an environment moves to positions, by their names.
        self._gains: dict[str, NDArray[np.float64]] = {}
        #: Made by the first image.
        self._painter: _core.Painter | None = None
        self._view: View | None = None
        #: What `insert` and `remove` have done since the start.
        self._edits: list[_Edit] = []
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

    def __setattr__(self, name: str, value: Any) -> None:
        # a misspelt `step_size` would change nothing, silently; other names are the user's own
        if not hasattr(type(self), name) and (meant := closest(name, _SETTABLE)):
            raise AttributeError(f"a Simulation has no attribute '{name}'{meant}")
        super().__setattr__(name, value)

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickles its file or text, options, systems in Python, models inserted and removed here, and its state."""
        return _again, (type(self), self._source, self._seed, self._options, self._systems, self._edits, self.save())

    def __repr__(self) -> str:
        if self.is_closed:
            return "<pongsim.Simulation, closed>"
        return f"<pongsim.Simulation '{self.name}' at {self.time:g} s>"

    def reset(self, seed: int | None = None) -> None:
        """Resets the world to its start, with the same bits, and a new seed or the same.

        Inserted models are removed, and removed ones return; changed properties are those of the file again; systems and
        subscriptions stay. Messages that wait are dropped, and sensors have no reading until the next one.
        """
        if seed is not None:
            self._seed = _seed(seed)
        super().reset(seed)
        self._edits.clear()

    def insert(
        self,
        source: str | os.PathLike[str],
        *,
        name: str = "",
        pose: Pose | Sequence[float] | None = None,
        allow_renaming: bool = False,
        namespace: str = "",
    ) -> _core.Model:
        """Inserts the first model of a file, a model folder, or SDF or URDF text, with its systems.

        name: replaces its own.
        pose: of the model frame in the world, replaces the file's: a Pose, x y z, or x y z roll pitch yaw [m, rad].
        allow_renaming: use NAME_0, NAME_1 and so on if the name is taken.
        namespace: prefix of all its topics, such as "/robot1".
        Raises LoadError, with the position in the file.
        """
        if not isinstance(source, (str, os.PathLike)):
            raise TypeError(f"a model must be a file or a text, not {type(source).__name__}")
        model = super().insert(source, name=name, pose=pose, allow_renaming=allow_renaming, namespace=namespace)
        text = os.fspath(source)
        self._edits.append(("insert", {
            "source": text if "<" in text else os.path.abspath(text), "name": model.name, "pose": pose,
            "namespace": namespace,
        }))
        return model

    def remove(self, model: _core.Model, *others: _core.Model) -> None:
        """Removes top-level models with their systems and the joints connected to them: all of them or, raising Refused,
        none. Several at once are faster than one by one."""
        for each in (model, *others):
            if not isinstance(each, _core.Model):
                raise TypeError(f"only models can be removed, such as sim.model('robot'), not {each!r}")
        names = [each.name for each in (model, *others) if each.exists]
        super().remove(model, *others)
        self._edits.append(("remove", {"models": names}))

    def add(self, system: System) -> None:
        """Adds a system in Python after all others. Raises SystemFailed if its `configure` raises."""
        if isinstance(system, type):
            raise TypeError(f"a system must be an object, such as {system.__name__}(), not the class")
        if not isinstance(system, System):
            raise TypeError(f"a system must derive from pongsim.System, but {type(system).__name__} does not")
        if system._simulation is not None:
            raise ValueError("the system is already in a simulation; use a new one")
        system._simulation = self
        try:
            self._add_system(system.name or type(system).__name__, system)
        except BaseException:
            system._simulation = None
            raise
        self._systems.append(system)

    def link(self, name: str) -> _core.Link:
        """Returns the link with that scoped name: "model::link". Raises KeyError."""
        model, own = _parts(name, "link")
        return self.model(model).link(own)

    def joint(self, name: str) -> _core.Joint:
        """Returns the joint with that scoped name: "model::joint". Raises KeyError."""
        model, own = _parts(name, "joint")
        return self.model(model).joint(own)

    def sensor(self, name: str, *kinds: str) -> Sensor:
        """Returns the sensor with that name, and switches it on.

        name: "model::link::sensor", or its own name if that is unique.
        kinds: kinds of readings to switch on: "ranges", "points", "image", "depth" or "message"; default: the main one of
            its type.
        Raises KeyError, and ValueError for a kind that the sensor does not have.
        """
        return Sensor(self._find_sensor(name), kinds)

    @property
    def layout(self) -> Layout:
        """What the numbers of `qpos` and `qvel` are: their names, and where each model and joint is."""
        return layout_of(self)

    @property
    def qpos(self) -> NDArray[np.float64]:
        """Positions of everything that moves: a new array, which can't be written to; assign a whole one.

        For each top-level model: if nothing holds it to the world, x, y, z [m] and a quaternion x, y, z, w of its frame in
        the world frame; then the position of each axis of its joints [rad or m]. Of a model whose links are not connected,
        each link that is free has a pose. Ball joints have no axis: they keep their relative pose.
        Assignment keeps `qvel`, and raises ValueError and Refused like `set_state`.
        """
        return view(self._positions(), "f8", (-1,))

    @qpos.setter
    def qpos(self, positions: ArrayLike) -> None:
        self.set_state(qpos=_given(positions, "qpos"))

    @property
    def qvel(self) -> NDArray[np.float64]:
        """Velocities of everything that moves, in the order of `qpos`: a new array, which can't be written to.

        For what is free, the velocity of its frame's origin [m/s] and its angular velocity [rad/s], both in the world frame
        (6 numbers); for each axis its velocity [rad/s or m/s].
        """
        return view(self._velocities(), "f8", (-1,))

    @qvel.setter
    def qvel(self, velocities: ArrayLike) -> None:
        self.set_state(qvel=_given(velocities, "qvel"))

    def set_state(self, qpos: ArrayLike | None = None, qvel: ArrayLike | None = None) -> None:
        """Sets positions and velocities of everything that moves, between two steps.

        What equals the present number is not touched, so `sim.qpos = sim.qpos` changes no bit. Limits of joints are ignored.
        Without `qvel`, velocities keep their numbers.
        Raises ValueError for another size, numbers that are not finite, and quaternions that are not of length 1; Refused
        for joints in loops and for what is joined to another model: then what was set already is put back, but for rounding.
        """
        self._write_state(
            None if qpos is None else np.ascontiguousarray(qpos, np.float64),
            None if qvel is None else np.ascontiguousarray(qvel, np.float64),
        )

    def set_joint_states(self, states: ArrayLike, names: Sequence[str] | None = None) -> None:
        """Sets positions and velocities of joints' axes, all at once, between two steps.

        states: n x 2 numbers like those of `joint_states`.
        names: those of `joint_names` that they are for; None: all.
        Raises KeyError, ValueError and Refused, like `set_state`.
        """
        layout = self.layout
        wanted = self.joint_names if names is None else list(names)
        given = numbers(states, (len(wanted), 2), "joint states")
        places = {name: i for i, name in enumerate(layout.qpos_names)}
        speeds = {name: i for i, name in enumerate(layout.qvel_names)}
        qpos, qvel = self.qpos.copy(), self.qvel.copy()
        for name, (position, velocity) in zip(wanted, given):
            if name not in speeds or name not in places:
                raise KeyError(f"there is no joint axis '{name}'{closest(name, self.joint_names)}")
            qpos[places[name]] = position
            qvel[speeds[name]] = velocity
        self.set_state(qpos, qvel)

    def set_poses(self, poses: ArrayLike, names: Sequence[str] | None = None, *, stop: bool = False) -> None:
        """Moves models with all their links, between two steps.

        poses: n x 7 numbers like those of `poses`.
        names: those of `model_names` that they are for; None: all.
        stop: set their velocities to zero; otherwise these rotate with them, as in Fortress.
        Raises KeyError, ValueError, and Refused if a joint connects a model to something outside of it; then none is moved,
        but for rounding.
        """
        models = models_of(self, names)
        self._move_models(models, numbers(poses, (len(models), 7), "poses"), stop)

    def velocities(self) -> NDArray[np.float64]:
        """Velocities of all models, in the order of `model_names`: a new array of n x 6, of the velocity of the model frame's
        origin [m/s] and the angular velocity [rad/s], both in the world frame."""
        return view(self._model_velocities(models_of(self, None)), "f8", (-1, 6))

    def set_velocities(self, velocities: ArrayLike, names: Sequence[str] | None = None) -> None:
        """Sets the velocities of models. All their links change accordingly; joint velocities stay.

        velocities: n x 6 numbers like those of `velocities`.
        names: those of `model_names` that they are for; None: all.
        Raises KeyError, ValueError for numbers that are not finite, and Refused for a static model that should move.
        """
        models = models_of(self, names)
        given = numbers(velocities, (len(models), 6), "velocities")
        if not np.isfinite(given).all():
            raise ValueError("velocities must be finite")
        self._set_model_velocities(models, given)

    def contacts(self) -> Contacts:
        """The contact points of the last step, as arrays."""
        ids, values, names = self._contacts()
        pairs = view(ids, "u8", (-1, 2))
        rows = view(values, "f8", (-1, 10))
        return Contacts(
            [(names[first], names[second]) for first, second in pairs.tolist()],
            pairs, rows[:, 0:3], rows[:, 3:6], rows[:, 6], rows[:, 7:10],
        )

    def raycast(
        self, origin: ArrayLike, direction: ArrayLike, max_distance: float = np.inf, *, visibility_mask: int = 0xFFFFFFFF
    ) -> RayHit:
        """Finds the first visual that a ray hits, as a lidar does: surfaces are hit from outside.

        origin, direction: x, y, z in the world frame [m]; the direction may have any length.
        max_distance: [m]
        visibility_mask: visuals are visible that share a bit with their `<visibility_flags>`.
        Raises ValueError for numbers that are not finite, and RuntimeError if Embree is not installed.
        """
        hits = self.raycasts(
            numbers(origin, (3,), "an origin")[None], numbers(direction, (3,), "a direction")[None], max_distance,
            visibility_mask=visibility_mask,
        )
        return RayHit(float(hits.distances[0]), hits.points[0], hits.links[0])

    def raycasts(
        self, origins: ArrayLike, directions: ArrayLike, max_distance: float = np.inf, *, visibility_mask: int = 0xFFFFFFFF
    ) -> RayHits:
        """Like `raycast` for many rays: arrays of n x 3, or three numbers for all."""
        begin, along = np.broadcast_arrays(np.asarray(origins, np.float64), np.asarray(directions, np.float64))
        if begin.ndim != 2 or begin.shape[1] != 3:
            raise ValueError(f"origins and directions must be arrays of shape (n, 3), not {begin.shape}")
        begin, along = np.ascontiguousarray(begin), np.ascontiguousarray(along)
        memory, links = self._cast_rays(begin, along, max_distance, visibility_mask)
        distances = view(memory, "f8", (-1,))
        with np.errstate(invalid="ignore"):
            points = begin + along * (distances / np.linalg.norm(along, axis=1))[:, None]
        return RayHits(distances, points, links)

    def render(
        self,
        camera: str | Pose | Sequence[float] | None = None,
        size: tuple[int, int] | None = None,
        *,
        field_of_view: float | None = None,
    ) -> NDArray[np.uint8]:
        """Draws the world as it is now, without a display: a new array of rows x columns x red, green,
        blue from 0 to 255. Nothing in the world changes.

        camera: a camera of the world, by its scoped name or its own, without its noise and distortion; or a pose in the
            world frame, looking along its x axis with z up: a Pose, x y z, or x y z roll pitch yaw [m, rad]; None: from
            the side and above, with everything in view.
        size: width and height [pixels]; None: the camera's, else 320 x 240.
        field_of_view: horizontal [rad]; None: the camera's, else 1.05.
        Raises KeyError for an unknown camera, ValueError for another sensor, and RuntimeError if nothing to draw with is
        installed: OSMesa, or what the environment variable PONGSIM_RENDERER chooses.
        """
        return Eye(self, camera, size, field_of_view).draw()

    def view(self, *, port: int = 0, read_only: bool = False, browser: bool | None = None) -> View:
        """Opens the world in a browser, and returns the page's `View`, which a notebook shows inline.

        The page shows each step that this program makes; `View.run` makes them at the pace of the clock. The world is not
        changed, states that were saved before can be restored, and only this machine reaches the page.

        port: 0: any free one.
        read_only: the page can't change anything.
        browser: open one; None: not in a notebook.
        Raises SystemFailed if the port is taken, and without the package pongsim-web.
        """
        if self._view is None:
            self._view = show(self, port, read_only, browser)
        return self._view

    def poses(self) -> NDArray[np.float64]:
        """Poses of all models in the world frame, in the order of `model_names`: a new array of n x 7, of x, y, z [m] and
        the quaternion x, y, z, w."""
        return view(self._poses(), "f8", (-1, 7))

    def joint_states(self) -> NDArray[np.float64]:
        """Positions [rad or m] and velocities [rad/s or m/s] of all joints' axes, in the order of `joint_names`: a new
        array of n x 2."""
        return view(self._joint_states(), "f8", (-1, 2))

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
        return self._open_subscription(topic, _receiver(to), type, length)

    def publish(self, topic: str, message: Message, *, type: str = "") -> None:
        """Publishes a message. It arrives at the start of the next step.

        type: its type, such as "Twist"; not needed for objects of a message class, or if the topic already exists in this
            simulation.
        Raises ValueError and TypeError that name the wrong field, and ValueError if the topic has another type here or a
        subscriber would refuse a number, such as NaN in a command.
        """
        self._publish(topic, message, type)

    def request(
        self, service: str, request: Message, *, type: str = "", reply: Any = "Boolean", timeout: float = 5.0
    ) -> Any:
        """Calls a service of this simulation, or with `network` of another process, and returns its response.

        type: the request's type, such as "EntityFactory"; not needed for an object of a message class.
        reply: the response's type: a name for a dict, or a message class for an object of it.
        timeout: time to wait for other processes [s of wall time].
        Raises ServiceError if there is no such service, or if it refuses or does not respond.
        """
        return self._ask(service, request, type, reply, timeout)


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


def _parts(name: str, kind: str) -> tuple[str, str]:
    if not isinstance(name, str):
        raise TypeError(f"a {kind} must be named by a text, not {type(name).__name__}")
    model, _, own = name.rpartition("::")
    if not model:
        raise KeyError(f"'{name}' names no model: a {kind} is \"model::{own}\"")
    return model, own


def _given(numbers: ArrayLike, what: str) -> ArrayLike:
    # None would change nothing, silently
    if numbers is None:
        raise TypeError(f"{what} must be an array of numbers, not None")
    return numbers


def _whole(number: Any, what: str) -> int:
    try:
        return operator.index(number)
    except TypeError:
        raise TypeError(f"{what} must be an integer, not {type(number).__name__}") from None


def _seed(seed: Any) -> int:
    """Checks a seed. Raises TypeError and ValueError."""
    number = _whole(seed, "a seed")
    if not 0 <= number < 2**64:
        raise ValueError(f"a seed must be 0 to 2**64 - 1, not {number}")
    return number


def _again(
    kind: type[Simulation], world: str, seed: int, options: dict[str, Any], systems: list[System], edits: list[_Edit],
    state: bytes,
) -> Simulation:
    """Makes a simulation from what `Simulation.__reduce__` has kept of another."""
    with warnings.catch_warnings():
        # they were given when it was loaded first
        warnings.simplefilter("ignore", WorldWarning)
        simulation = kind(world, seed=seed, systems=systems, **options)
        for name, arguments in edits:
            if name == "insert":
                simulation.insert(**arguments)
            else:
                simulation.remove(*(simulation.model(model) for model in arguments["models"]))
    simulation.restore(state)
    return simulation
