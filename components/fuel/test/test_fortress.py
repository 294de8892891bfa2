"""Fortress's own library finds what pongsim has cached, and vice versa."""

import os
import pathlib
import sys
import unittest

from fuel_server import PONGSIM, Place, Server, model_files

PEER = os.environ.get("PONGSIM_FORTRESS_PEER")


class Fortress(unittest.TestCase):
    def setUp(self):
        self.server = self._enter(Server())
        self.place = self._enter(Place(self.server))
        self.place.cache.mkdir(parents=True)

    def _enter(self, manager):
        self.addCleanup(manager.__exit__, None, None, None)
        return manager.__enter__()

    def peer(self, action, address, code=0):
        # leaks of Fortress's library are ignored
        result = self.place.run(PEER, action, address, ASAN_OPTIONS="detect_leaks=0")
        self.assertEqual(result.returncode, code, result.stderr + result.stdout)
        return result.stdout.strip().splitlines()[-1] if code == 0 else ""

    def test_it_finds_what_we_have_cached(self):
        for name in ("Box", "Coke Can"):
            url = self.server.add("OpenRobotics", name, model_files(name), 3)
            self.assertEqual(self.place.fuel("download", url).returncode, 0)
            folder = self.place.cache / f"fuel.gazebosim.org/openrobotics/models/{name.lower()}/3"
            self.assertEqual(self.peer("find", url), str(folder))
            self.assertEqual(self.peer("find", url + "/3"), str(folder))
            mesh = next(line for line in (folder / "model.sdf").read_text().splitlines() if "look" in line)
            address = mesh.split("<uri>")[1].split("</uri>")[0].strip()
            self.assertEqual(self.peer("file", address), str(folder / "meshes/box.obj"))
        world = self.server.add("OpenRobotics", "Court", {"w.sdf": "<sdf version='1.9'><world name='w'/></sdf>"}, 2, "worlds")
        self.assertEqual(self.place.fuel("download", world).returncode, 0)
        self.assertEqual(self.peer("find", world), str(self.place.cache / "fuel.gazebosim.org/openrobotics/worlds/court/2"))
        count = len(self.server.requests)
        self.assertTrue(self.peer("fetch", world))
        self.assertEqual(len(self.server.requests), count)

    def test_we_find_what_it_has_cached(self):
        files = model_files("Coke Can")
        url = self.server.add("OpenRobotics", "Coke Can", files, 3)
        self.peer("download", url)
        result = self.place.fuel("info", url, "--cached")
        self.assertIn("Cached: version 3 in ", result.stdout, result.stderr)
        self.assertEqual(self.place.fuel("check").returncode, 0)
        world = pathlib.Path(self.place.home) / "w.sdf"
        world.write_text(f"<sdf version='1.9'><world name='w'><include><uri>{url}</uri></include></world></sdf>")
        result = self.place.run(PONGSIM, "sdf", "-k", world, "--offline")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertNotIn("box.obj", result.stderr)

    def test_both_unpack_the_same(self):
        url = self.server.add("OpenRobotics", "Box", model_files("Box"), 3)
        self.peer("download", url)
        folder = self.place.cache / "fuel.gazebosim.org/openrobotics/models/box/3"
        theirs = {str(path.relative_to(folder)): path.read_text() for path in folder.rglob("*") if path.is_file()}
        self.assertEqual(self.place.fuel("delete", "--cached", url).returncode, 0)
        self.assertEqual(self.place.fuel("download", url).returncode, 0)
        ours = {str(path.relative_to(folder)): path.read_text() for path in folder.rglob("*") if path.is_file()}
        self.assertEqual(theirs.keys(), ours.keys())
        for name in ("model.config", "meshes/box.obj"):
            self.assertEqual(theirs[name], ours[name])
        # the addresses are equal, although libsdformat formats the file anew
        self.assertEqual([part.split("<")[0].strip() for part in theirs["model.sdf"].split("<uri>")[1:2]],
                         [part.split("<")[0].strip() for part in ours["model.sdf"].split("<uri>")[1:2]])


if __name__ == "__main__":
    if not PEER:
        print("skipped: libignition-fuel-tools-dev is not installed")
        sys.exit(77)
    unittest.main()
