"""Markers that programs add by /marker are seen by `pongsim view` of the running world, in whose page they are."""

import pathlib
import tempfile
import unittest

from web_world import ROOT, ended, running

WORLD = ROOT / "worlds/pong_world.sdf"
# by Fortress's names; the visibility is for the window only
BOX = 'ns: "test", id: 1, type: BOX, pose {position {z: 1}}, material {diffuse {r: 1, a: 1}}'


class Markers(unittest.TestCase):
    def test_they_are_in_pictures_of_the_running_world(self):
        with tempfile.TemporaryDirectory() as folder, running(WORLD, "--paused", "--web", "0") as world:
            world.address()

            def picture():
                file = pathlib.Path(folder) / "picture.png"
                drawn = ended("view", "--camera", "-3 0 2", "--size", "160x120", "-o", file, "--timeout", "20000")
                self.assertEqual(drawn.returncode, 0, drawn.stderr)
                return file.read_bytes()

            def ask(service, request):
                done = ended("service", "-s", service, "--req", request, "--timeout", "20000")
                return done.returncode, done.stdout + done.stderr

            without = picture()
            self.assertEqual(picture(), without)
            self.assertEqual(ask("/marker", BOX)[0], 0)
            self.assertNotEqual(picture(), without)
            self.assertRegex(ask("/marker/list", "")[1], r'ns: "test"\s+id: 1\s+type: BOX')
            code, said = ask("/marker_array", "marker {type: 77} marker {action: DELETE_ALL}")
            self.assertEqual(code, 1)
            self.assertRegex(said, "number 1: marker 0 has an unknown type, 77")
            self.assertEqual(picture(), without)


if __name__ == "__main__":
    unittest.main()
