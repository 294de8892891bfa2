"""Markers for cameras, by Debian's own clients."""

import re
import unittest

from ign_world import PATIENCE, ROOT, call_once, ign, needs_ign, world

WORLD = ROOT / "worlds/pong_lidar.sdf"
LIST = "/sensors/marker/list"


def markers():
    """Name spaces and numbers of all markers."""
    text = ign("service", "-s", LIST, "--reqtype", "ignition.msgs.Empty", "--reptype", "ignition.msgs.Marker_V",
               *PATIENCE, "--req", "")
    return re.findall(r'ns: "(\w+)"\s+id: (\d+)', text)


@needs_ign
class Markers(unittest.TestCase):
    def test_they_are_added_and_listed(self):
        with world(WORLD) as simulation:
            if "libOSMesa" in simulation.output():
                self.skipTest("there is nothing to draw with")
            call_once("/sensors/marker_array", "ignition.msgs.Marker_V",
                      'marker {ns: "path", id: 7, type: SPHERE}, marker {ns: "path", id: 8, type: BOX}', markers)
            self.assertEqual(markers(), [("path", "7"), ("path", "8")])


if __name__ == "__main__":
    unittest.main()
