"""Downloads into the cache: versions, names, tokens, dependencies, parallel downloads, continued downloads."""

import os
import signal
import subprocess
import unittest

from fuel_server import FUEL, Place, Server, model_files, streamed_zip_of, until

BIG = {"meshes/big.bin": os.urandom(400_000)}


class Download(unittest.TestCase):
    def setUp(self):
        self.server = self._enter(Server())
        self.place = self._enter(Place(self.server))

    def _enter(self, manager):
        self.addCleanup(manager.__exit__, None, None, None)
        return manager.__enter__()

    def download(self, *words, **more):
        result = self.place.fuel("download", *words, **more)
        self.assertEqual((result.returncode, result.stdout), (0, ""), result.stderr)
        return result.stderr

    def test_a_model_is_laid_out_as_fortress_does(self):
        url = self.server.add("OpenRobotics", "Coke Can", model_files("Coke Can"), 3)
        said = self.download("-u", url)
        folder = self.place.cache / "fuel.gazebosim.org/openrobotics/models/coke can/3"
        self.assertEqual(self.place.files(), [str((folder / name).relative_to(self.place.cache))
                                              for name in ("meshes/box.obj", "model.config", "model.sdf")])
        text = (folder / "model.sdf").read_text()
        address = "https://fuel.gazebosim.org/1.0/openrobotics/models/coke can/3/files/meshes/box.obj"
        self.assertIn(f"<uri> {address} </uri>", text)
        self.assertIn("<!-- model://Coke Can/meshes/box.obj stays here -->", text)
        self.assertIn("<uri>model://elsewhere/a.obj</uri>", text)
        self.assertIn("pongsim: downloading OpenRobotics/Coke Can version 3", said)
        self.assertNotIn("\r", said)
        self.assertEqual((folder / "model.config").stat().st_mode & 0o777, 0o644)
        # the newest version is in the cache, so it is not downloaded again
        count = len(self.server.zips())
        self.assertIn("the newest version is in the cache", self.download(url.replace(" ", "%20")))
        self.assertEqual(len(self.server.zips()), count)
        self.assertTrue(all(headers["User-Agent"].startswith("pongsim/") for _, headers in self.server.requests))

    def test_an_archive_that_was_written_on_the_way(self):
        url = self.server.add("o", "m", streamed_zip_of(model_files("m") | BIG))
        self.download(url)
        self.assertEqual((self.place.cache / "fuel.gazebosim.org/o/models/m/1/meshes/big.bin").read_bytes(),
                         BIG["meshes/big.bin"])

    def test_versions_and_tip(self):
        url = self.server.add("o", "m", model_files("m"), 1)
        self.server.add("o", "m", model_files("m"), 2)
        self.download(url + "/1")
        versions = self.place.cache / "fuel.gazebosim.org/o/models/m"
        self.assertEqual(os.listdir(versions), ["1"])
        self.download(url + "/tip")
        self.assertEqual(sorted(os.listdir(versions)), ["1", "2"])
        self.server.add("o", "m", model_files("m"), 3)
        result = self.place.fuel("update")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(sorted(os.listdir(versions)), ["1", "2", "3"])

    def test_both_names_of_the_server_and_http_are_asked_by_https(self):
        self.server.add("o", "m", model_files("m"))
        self.server.add("o", "n", model_files("n"))
        self.download("https://fuel.ignitionrobotics.org/1.0/o/models/m", "http://fuel.gazebosim.org/o/models/n")
        self.assertEqual(set(self.server.connects), {"fuel.ignitionrobotics.org:443", "fuel.gazebosim.org:443"})
        # the model is in the cache, under the server's other name
        count = len(self.server.zips())
        self.download("https://fuel.gazebosim.org/1.0/o/models/m/1")
        self.assertEqual(len(self.server.zips()), count)

    def test_what_a_model_needs_comes_too(self):
        wheel = self.server.add("o", "wheel", model_files("wheel"))
        tyre = self.server.add("p", "tyre", model_files("tyre"))
        include = f"<include><uri>{tyre}/1</uri></include><!-- <include><uri>{wheel}2</uri></include> -->"
        self.server.add("o", "axle", model_files("axle", include))
        files = model_files("car", f"<include><uri>{wheel}</uri></include>")
        files["metadata.pbtxt"] = f'dependencies {{ uri: "{wheel.replace("wheel", "axle")}" }}\nlicense: "https://a.b/c"'
        self.download(self.server.add("o", "car", files))
        found = {path.split("/")[3] for path in self.place.files()}
        self.assertEqual(found, {"axle", "car", "tyre", "wheel"})

    def test_several_come_at_once(self):
        urls = [self.server.add("o", f"m{i}", model_files(f"m{i}")) for i in range(4)]
        for i in range(4):
            self.server.fault(f"m{i}.zip", "stall", 1)
        process = self.place.start(FUEL, "download", "-j", "4", *urls)
        # all four are in progress at the same time: the downloads are parallel
        until(lambda: len(self.server.zips()) == 4, "four requests")
        self.server.stall.set()
        _, error = process.communicate(timeout=120)
        self.assertEqual(process.returncode, 0, error)
        self.assertEqual(len(self.place.files()), 12)

    def test_a_link_to_another_server_is_followed_without_the_token(self):
        url = self.server.add("o", "m", model_files("m"))
        self.server.token = "secret"
        self.server.fault("m.zip", "link")
        self.place.home.joinpath("c.yaml").write_text(
            "servers:\n  - name: mine\n    url: https://fuel.gazebosim.org\n    private-token: secret\n")
        self.download(url, "-c", "c.yaml")
        seen = {path.split("/")[1]: headers.get("Private-Token") for path, headers in self.server.zips()}
        self.assertEqual(seen, {"1.0": "secret", "storage": None})
        self.assertIn("storage.example.org:443", self.server.connects)

    def test_a_redirection_to_another_server_is_followed_without_the_token(self):
        url = self.server.add("o", "m", model_files("m"))
        self.server.fault("1/m.zip", ("redirect", "https://storage.example.org/storage/o/m/1/x.zip"))
        self.download(url, "--header", "Private-Token: secret")
        seen = {path.split("/")[1]: headers.get("Private-Token") for path, headers in self.server.zips()}
        self.assertEqual(seen, {"1.0": "secret", "storage": None})

    def test_a_token_is_what_private_models_take(self):
        url = self.server.add("o", "m", model_files("m"))
        self.server.token = "secret"
        result = self.place.fuel("download", url)
        self.assertEqual(result.returncode, 1)
        self.assertIn("does not allow it (status 401)\n  hint: private models need a token", result.stderr)
        self.download(url, "--header", "Private-Token: secret")

    def test_other_servers_are_those_of_the_configuration(self):
        self.server.add("o", "m", model_files("m"))
        url = "https://models.example.org/1.0/o/models/m"
        result = self.place.fuel("download", url)
        self.assertEqual(result.returncode, 1)
        self.assertIn("the server models.example.org is not configured\n  hint: add it to", result.stderr)
        self.assertEqual(self.server.requests, [])
        config = self.place.cache / "config.yaml"
        config.parent.mkdir(parents=True)
        config.write_text("servers:\n  - url: https://models.example.org/\n")
        self.download(url)
        self.assertIn("models.example.org/o/models/m/1/model.sdf", self.place.files())

    def test_a_plain_server_is_asked_where_the_configuration_says_so(self):
        plain = self._enter(Server(plain=True))
        plain.add("o", "m", model_files("m"))
        host = f"127.0.0.1:{plain.port}"
        self.place.home.joinpath("c.yaml").write_text(f"servers: [{{url: 'http://{host}'}}]")
        self.download(f"http://{host}/1.0/o/models/m", "-c", "c.yaml")
        self.assertIn(f"{host}/o/models/m/1/model.sdf", self.place.files())

    def test_a_collection_comes_with_all_its_pages(self):
        keys = []
        for i in range(5):
            self.server.add("o", f"m{i}", model_files(f"m{i}"))
            keys.append(("models", "o", f"m{i}"))
        self.server.add("o", "w", {"w.sdf": "<sdf version='1.9'><world name='w'/></sdf>"}, kind="worlds")
        self.server.collections["o", "all"] = [*keys, ("worlds", "o", "w")]
        url = "https://fuel.gazebosim.org/1.0/o/collections/all"
        self.download("-u", url, "-t", "model")
        self.assertEqual(len(self.place.files()), 15)
        self.download("-u", url)
        self.assertIn("fuel.gazebosim.org/o/worlds/w/1/w.sdf", self.place.files())

    def broken_off(self, how, **more):
        """Ends the program when it has half of a zip file. Returns (address, bytes, exit code, errors)."""
        url = self.server.add("o", "m", model_files("m") | BIG)
        self.server.fault("m.zip", "stall", 1)
        process = self.place.start(FUEL, "download", url, **more)
        part = self.place.cache / ".pongsim/fuel.gazebosim.org+o+models+m.zip"
        half = len(self.server.resources["models", "o", "m"]["zips"][1]) // 2
        until(lambda: part.exists() and part.stat().st_size == half, "half a zip file")
        process.send_signal(how)
        _, error = process.communicate(timeout=120)
        self.assertEqual([path for path in self.place.files() if not path.startswith(".pongsim/")], [])
        self.server.stall.set()
        return url, half, process.returncode, error

    def test_killed_in_the_middle_it_goes_on_from_there(self):
        url, half, code, _ = self.broken_off(signal.SIGKILL)
        self.assertEqual(code, -signal.SIGKILL)
        self.assertIn("of an interrupted download", self.place.fuel("check").stdout)
        self.download(url)
        self.assertEqual(self.server.zips()[-1][1].get("Range"), f"bytes={half}-")
        self.assertEqual((self.place.cache / "fuel.gazebosim.org/o/models/m/1/meshes/big.bin").read_bytes(),
                         BIG["meshes/big.bin"])
        self.assertEqual(os.listdir(self.place.cache / ".pongsim"), [])

    def test_interrupted_it_says_so(self):
        _, _, code, error = self.broken_off(signal.SIGINT)
        self.assertEqual(code, 1)
        self.assertIn("it was interrupted\n  hint: what was downloaded is kept", error)

    def test_what_has_changed_since_is_begun_anew(self):
        url, _, _, _ = self.broken_off(signal.SIGKILL)
        other = {"meshes/big.bin": os.urandom(300_000)}
        self.server.add("o", "m", model_files("m") | other)
        self.download(url)
        self.assertEqual((self.place.cache / "fuel.gazebosim.org/o/models/m/1/meshes/big.bin").read_bytes(),
                         other["meshes/big.bin"])

    def test_a_part_that_the_server_does_not_know_again_is_begun_anew(self):
        self.server.has_tags = False
        url, _, _, _ = self.broken_off(signal.SIGKILL)
        self.download(url)
        self.assertNotIn("Range", self.server.zips()[-1][1])

    def test_a_part_that_is_too_long_is_begun_anew(self):
        url, _, _, _ = self.broken_off(signal.SIGKILL)
        with open(self.place.cache / ".pongsim/fuel.gazebosim.org+o+models+m.zip", "ab") as part:
            part.write(bytes(1_000_000))
        self.download(url)
        self.assertTrue((self.place.cache / "fuel.gazebosim.org/o/models/m/1/model.sdf").exists())

    def test_two_processes_share_one_download(self):
        url = self.server.add("o", "m", model_files("m"))
        self.server.fault("m.zip", "stall", 1)
        first = self.place.start(FUEL, "download", url)
        until(lambda: self.server.zips(), "a request")
        second = self.place.start(FUEL, "download", url)
        line = second.stderr.readline()
        self.assertIn("waiting for another download of it", line)
        self.server.stall.set()
        for process in (first, second):
            _, error = process.communicate(timeout=120)
            self.assertEqual(process.returncode, 0, error)
        self.assertEqual(len(self.server.zips()), 1)

    def test_a_folder_that_fortress_left_half_done_is_replaced(self):
        url = self.server.add("o", "m", model_files("m"))
        folder = self.place.cache / "fuel.gazebosim.org/o/models/m/1"
        folder.mkdir(parents=True)
        (folder / "m.zip").write_bytes(b"PK")
        (folder / "model.config").write_text("<model/>")
        self.assertEqual(self.place.fuel("check").returncode, 1)
        self.download(url)
        self.assertEqual(sorted(os.listdir(folder)), ["meshes", "model.config", "model.sdf"])
        self.assertEqual(self.place.fuel("check").returncode, 0)

    def test_offline_nothing_is_asked(self):
        url = self.server.add("o", "m", model_files("m"))
        for words, environment in ((["--offline"], {}), ([], {"PONGSIM_OFFLINE": "1"})):
            result = self.place.fuel("download", url, *words, **environment)
            self.assertEqual(result.returncode, 1)
            self.assertIn("it is not in the cache, and downloads are off", result.stderr)
        self.assertEqual(self.server.connects, [])
        self.download(url)
        count = len(self.server.requests)
        self.download(url, "--offline")
        self.assertEqual(len(self.server.requests), count)

    def test_a_terminal_has_a_bar(self):
        url = self.server.add("o", "m", model_files("m") | BIG)
        master, slave = os.openpty()
        process = subprocess.Popen([str(FUEL), "download", url], env=self.place.environment, stderr=slave)
        os.close(slave)
        said = b""
        try:
            while part := os.read(master, 4096):
                said += part
        except OSError:
            pass
        os.close(master)
        self.assertEqual(process.wait(), 0)
        self.assertIn(b"\r\x1b[K[", said)
        self.assertIn(b" %  ", said)
        self.assertRegex(said, rb"pongsim: o/m version 1: 40\d\.\d kB\r\n(\r\x1b\[K)*$")


if __name__ == "__main__":
    unittest.main()
