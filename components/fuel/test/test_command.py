"""pongsim fuel list, info, delete, check, and errors on the command line."""

import shutil
import unittest

from fuel_server import Place, Server, model_files

WORLD = {"w.sdf": "<sdf version='1.9'><world name='w'/></sdf>"}


class Command(unittest.TestCase):
    def setUp(self):
        self.server = self._enter(Server())
        self.place = self._enter(Place(self.server))
        for owner, name in (("Anna", "Box"), ("Anna", "Coke Can"), ("Berta", "Car"), ("Berta", "Axle"), ("Berta", "Wheel")):
            self.server.add(owner, name, model_files(name), 2)
        self.server.add("Anna", "Court", WORLD, kind="worlds")

    def _enter(self, manager):
        self.addCleanup(manager.__exit__, None, None, None)
        return manager.__enter__()

    def fuel(self, *words, code=0, **more):
        result = self.place.fuel(*words, **more)
        self.assertEqual(result.returncode, code, result.stderr)
        return result.stdout if code == 0 else result.stderr

    def test_models_are_listed_as_ign_fuel_does(self):
        text = self.fuel("list", "-t", "model")
        lines = text.splitlines()
        self.assertEqual(lines[0], "Fetching model list from https://fuel.gazebosim.org...")
        self.assertRegex(lines[1], r"^Received model list \(took \d+ms\).$")
        self.assertEqual(lines[2:], ["https://fuel.gazebosim.org", "├── Anna", "│   ├── Box", "│   └── Coke Can", "└── Berta",
                                     "    ├── Axle", "    ├── Car", "    └── Wheel", "2 owners, 5 models"])
        self.assertEqual(self.fuel("list", "-t", "model", "-o", "Anna", "-r"),
                         "https://fuel.gazebosim.org/1.0/Anna/models/Box\n"
                         "https://fuel.gazebosim.org/1.0/Anna/models/Coke%20Can\n")
        self.assertEqual(self.fuel("list", "-t", "world", "-u", "https://fuel.ignitionrobotics.org", "--raw"),
                         "https://fuel.ignitionrobotics.org/1.0/Anna/worlds/Court\n")

    def test_the_cache_is_listed(self):
        self.assertIn("has no models", self.fuel("list", "-t", "model", "--cached"))
        self.fuel("download", "https://fuel.gazebosim.org/1.0/Anna/models/Coke%20Can")
        self.fuel("download", "https://fuel.gazebosim.org/1.0/Anna/worlds/Court")
        count = len(self.server.requests)
        self.assertEqual(self.fuel("list", "-t", "model", "--cached"),
                         "fuel.gazebosim.org\n└── anna\n    └── coke can 2\n1 owners, 1 models\n")
        self.assertEqual(self.fuel("list", "-t", "world", "--cached", "-r", "-o", "Anna"),
                         "https://fuel.gazebosim.org/1.0/anna/worlds/court/1\n")
        self.assertEqual(self.fuel("list", "-t", "world", "--cached", "-r", "-o", "Berta"), "")
        self.assertEqual(len(self.server.requests), count)
        self.assertIn("--cached lists what the cache has", self.fuel("list", "-t", "model", "--offline", code=1))

    def test_a_model_is_told_of(self):
        url = "https://fuel.gazebosim.org/1.0/Berta/models/Car"
        text = self.fuel("info", url)
        self.assertIn(f"{url}\nName: Car\nOwner: Berta\nVersion: 2\nSize: ", text)
        self.assertIn("License: CC0\n", text)
        self.assertIn("Tags: box, test\nDescription: A box\n", text)
        self.assertNotIn("Cached", text)
        self.fuel("download", url)
        where = f"Cached: version 2 in {self.place.cache}/fuel.gazebosim.org/berta/models/car/2\n"
        self.assertTrue(self.fuel("info", "-u", url).endswith(where))
        self.assertEqual(self.fuel("info", "-u", url, PONGSIM_OFFLINE="1"), url + "\n" + where)
        self.assertIn("(status 404)", self.fuel("info", url + "x", code=1))

    def test_what_a_server_says_can_not_move_the_cursor(self):
        self.server.resources["models", "anna", "box"]["name"] = "Box\x1b[2J\nX"
        self.assertNotIn("\x1b", self.fuel("list", "-t", "model"))
        self.assertNotIn("\x1b", self.fuel("info", "https://fuel.gazebosim.org/1.0/Anna/models/Box"))

    def test_a_model_is_deleted_on_the_server_with_a_token(self):
        url = "https://fuel.gazebosim.org/1.0/Berta/models/Car"
        self.assertIn("needs a token", self.fuel("delete", "-u", url, code=2))
        self.assertIn("does not allow it", self.fuel("delete", "-u", url, "--header", "Private-Token: no", code=1))
        self.server.token = "yes"
        self.fuel("delete", "-u", url, "--header", "Private-Token: yes")
        self.assertNotIn(("models", "berta", "car"), self.server.resources)

    def test_a_model_is_deleted_from_the_cache(self):
        url = "https://fuel.gazebosim.org/1.0/Berta/models/Car"
        self.server.add("Berta", "Car", model_files("Car"), 3)
        for version in ("/2", "/3"):
            self.fuel("download", url + version)
        self.assertEqual(self.fuel("delete", "--cached", url + "/2"),
                         f"deleted {self.place.cache}/fuel.gazebosim.org/berta/models/car/2\n")
        self.fuel("delete", "--cached", "-u", url)
        self.assertEqual(self.place.files(), [])
        self.assertIn("is not in the cache", self.fuel("delete", "--cached", url, code=1))
        self.assertIn(("models", "berta", "car"), self.server.resources)

    def test_the_cache_is_checked(self):
        for name in ("Box", "Coke%20Can"):
            self.fuel("download", "https://fuel.gazebosim.org/1.0/Anna/models/" + name)
        self.assertEqual(self.fuel("check"), "2 models, 0 worlds: all complete\n")
        box = self.place.cache / "fuel.gazebosim.org/anna/models/box/2"
        (box / "model.sdf").unlink()
        (box / "out").symlink_to("/etc")
        (box / "in").symlink_to("model.config")
        result = self.place.fuel("check")
        self.assertEqual(result.returncode, 1)
        self.assertEqual(result.stdout.splitlines()[:2],
                         [f"{box}: its model.config names 'model.sdf', which does not exist",
                          f"{box}: 'out' is a link to outside it"])
        self.assertTrue(result.stdout.endswith("2 models, 0 worlds: 1 broken\n"))
        shutil.rmtree(box)
        (box.parent / "3").mkdir()
        self.assertIn("there is no model.config in it", self.place.fuel("check").stdout)

    def test_a_configuration_is_checked(self):
        config = self.place.home / "c.yaml"
        url = "https://fuel.gazebosim.org/1.0/Anna/models/Box"
        for text, said in (("servers: 1", "c.yaml:1:10: 'servers' is not a list"),
                           ("servers:\n  - name: x", "c.yaml:2:5: a server has no 'url'"),
                           ("servers:\n  - url: ftp://x", "'ftp://x' is not the address of a server"),
                           ("servers:\n  - url: https://x/y", "'https://x/y' is not the address of a server"),
                           ("cache: {}", "c.yaml:1:1: 'cache' has no 'path'"), ("[", "c.yaml:1:1: "), ("x", "c.yaml:1:1: ")):
            config.write_text(text)
            self.assertIn(said, self.fuel("download", url, "-c", "c.yaml", code=1))
        config.write_text(f"cache: {{path: '{self.place.home}/there'}}\nextra: 1\n")
        result = self.place.fuel("download", url, "-c", "c.yaml")
        self.assertIn("warning: c.yaml:2: 'extra' is unknown", result.stderr)
        self.assertTrue((self.place.home / "there/fuel.gazebosim.org/anna/models/box/2/model.sdf").exists())
        self.assertIn("can't be read", self.fuel("download", url, "-c", "no.yaml", code=1))

    def test_a_wrong_command_line_is_said(self):
        for words, said in (([], "no action given"), (["lst"], "unknown action 'lst'\n  hint: did you mean 'list'?"),
                            (["list"], "no type given"), (["list", "--ownr", "x"], "unknown option '--ownr'\n  hint: did you mean '--owner'?"),
                            (["fetc"], "unknown action 'fetc'\n  hint: pongsim fuel --help lists them"),
                            (["list", "-t", "x"], "'x' is not a type"), (["download"], "no address given"),
                            (["download", "x"], "'x' is not the address of a model"), (["download", "-j", "17", "x"], "1 to 16"),
                            (["download", "x", "-v", "9"], "level from 0 to 4"), (["info"], "no address given"),
                            (["download", "https://fuel.gazebosim.org/1.0/o/models/m", "--header", "x"], "'x' is not a header"),
                            (["upload"], "'upload' is not supported"), (["edit"], "ign fuel edit"), (["meta"], "model.config"),
                            (["configure"], "config.yaml")):
            self.assertIn(said, self.fuel(*words, code=2), words)
        self.assertIn("download", self.fuel("--help"))
        self.assertIn("--jobs", self.fuel("download", "--help"))
        self.assertEqual(self.fuel("list", "-t", "model", "-v", "-o", "Nobody", "-r"), "")
        self.assertEqual(self.fuel("download", "https://fuel.gazebosim.org/1.0/o/models/m", "-v", "0", code=1).count("\n"), 2)


if __name__ == "__main__":
    unittest.main()
