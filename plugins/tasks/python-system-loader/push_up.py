"""Pushes its model up once a second."""

from gz.math import Vector3d
from gz.sim import Link, Model


class PushUp:
    def configure(self, entity, sdf, ecm, event_mgr):
        self.link = Link(Model(entity).canonical_link(ecm))
        self.force = sdf.get_double("force")

    def pre_update(self, info, ecm):
        if not info.paused and info.iterations % 1000 == 0:
            self.link.add_world_force(ecm, Vector3d(0, 0, self.force))


def get_system():
    return PushUp()
