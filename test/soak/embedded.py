"""The worlds of the long run in this process: saved, restored, loaded anew, and edited between."""

import xml.etree.ElementTree as xml

import pongsim

from cycles import BALL, PERIOD, STEPS

SENSORS = ("lidar", "camera", "imu", "contact")


def world_texts(file):
    """The worlds of a file by name, each as the text of a file with that one."""
    texts = {}
    for world in xml.parse(file).getroot().findall("world"):
        root = xml.Element("sdf", version="1.9")
        root.append(world)
        texts[world.get("name")] = xml.tostring(root, encoding="unicode")
    return texts


class Embedded:
    """One world, which goes on for the whole run; a second one is loaded each time and ends."""

    def __init__(self, text):
        self._text = text
        self._sim = pongsim.Simulation(text)
        self._heard = {name: 0 for name in SENSORS}
        for name in SENSORS:
            self._sim.subscribe(f"/soak/{name}", lambda _, name=name: self._count(name), type=bytes)

    def _count(self, name):
        self._heard[name] += 1

    @property
    def heard(self):
        """How many messages of each sensor have come."""
        return dict(self._heard)

    def run(self):
        """A cycle in which the state is saved and restored, with a guest in between who comes and goes.

        Yields the kind of each way to the end and the hash there."""
        sim = self._sim
        sim.reset()
        sim.step(PERIOD)
        state = sim.save()
        sim.gravity = (0, 1, -2)
        sim.remove(sim.insert(BALL, pose=(0, 0, 3)))
        sim.step(PERIOD)
        sim.restore(state)
        sim.step(STEPS - PERIOD)
        yield "saved", f"{sim.state_hash():016x}"
        with pongsim.Simulation(self._text) as other:
            other.restore(state)
            other.step(STEPS - PERIOD)
            yield "loaded", f"{other.state_hash():016x}"

    def close(self):
        self._sim.close()
