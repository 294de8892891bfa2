"""Failures are reported, give exit code 1, and leave no incomplete files in the cache."""

import os
import stat
import subprocess
import unittest
import zipfile

from fuel_server import FUEL, Place, Server, authority, model_files, special, zip_of


class Faults(unittest.TestCase):
    def setUp(self):
        self.server = self._enter(Server())
        self.place = self._enter(Place(self.server))

    def _enter(self, manager):
        self.addCleanup(manager.__exit__, None, None, None)
        return manager.__enter__()

    def refused(self, *said, url="https://fuel.gazebosim.org/1.0/o/models/m", keeps_part=False, place=None, **more):
        place = place or self.place
        result = place.fuel("download", url, **more)
        self.assertEqual((result.returncode, result.stdout), (1, ""), result.stderr)
        for text in said:
            self.assertIn(text, result.stderr)
        left = place.files() if place.cache.exists() else []
        self.assertEqual([path for path in left if not (keeps_part and path.startswith(".pongsim/"))], [])
        self.assertFalse(list(place.cache.glob(".pongsim/*.unpacked")))
        return result.stderr

    def test_a_model_that_is_not_there(self):
        self.refused("'https://fuel.gazebosim.org/1.0/o/models/m' can't be downloaded: the server fuel.gazebosim.org does "
                     "not have it (status 404)\n  hint: is the address right?")
        self.server.add("o", "m", model_files("m"))
        self.refused("(status 404)", url="https://fuel.gazebosim.org/1.0/o/models/m/7")

    def test_a_server_that_fails(self):
        self.server.add("o", "m", model_files("m"))
        self.server.fault("m.zip", 500)
        said = self.refused("the server fuel.gazebosim.org failed (status 500)\n  hint: try again later")
        self.assertEqual(said.count("trying again"), 2)

    def test_a_server_that_fails_once(self):
        url = self.server.add("o", "m", model_files("m"))
        self.server.fault("m.zip", 503, 1)
        self.assertEqual(self.place.fuel("download", url).returncode, 0)

    def test_a_circle(self):
        self.server.add("o", "m", model_files("m"))
        self.server.fault("m.zip", "circle")
        self.refused("redirects too often: more than 10 redirections")

    def test_a_way_out_of_https(self):
        self.server.add("o", "m", model_files("m"))
        self.server.fault("m.zip", ("redirect", "http://storage.example.org/storage/o/m/1/x.zip"))
        self.refused("redirects to an unsafe address: http://storage.example.org")
        self.server.fault("m.zip", ("redirect", "file:///etc/passwd"))
        self.refused("redirects to an unsafe address: file:///etc/passwd")

    def test_one_byte_a_second(self):
        self.server.add("o", "m", model_files("m"))
        self.server.fault("m.zip", "drip")
        self.refused("sent almost nothing for 2 seconds", keeps_part=True, PONGSIM_FUEL_TIMEOUT="2")

    def test_a_patience_that_is_no_number(self):
        self.server.add("o", "m", model_files("m"))
        self.refused("PONGSIM_FUEL_TIMEOUT is 'x', not a number", PONGSIM_FUEL_TIMEOUT="x")

    def test_half_a_body_is_gone_on_with(self):
        url = self.server.add("o", "m", model_files("m"))
        self.server.fault("m.zip", "half")
        self.refused("closed the connection", keeps_part=True)
        self.server.faults.clear()
        result = self.place.fuel("download", url)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("Range", self.server.zips()[-1][1])

    def test_a_length_that_lies(self):
        self.server.add("o", "m", model_files("m"))
        self.server.fault("m.zip", "lying")
        self.refused("closed the connection", keeps_part=True)
        self.server.fault("m.zip", "short")
        self.refused("did not send a complete zip file")

    def test_what_is_no_zip(self):
        self.server.add("o", "m", model_files("m"))
        for what in ("garbled", "garbage"):
            self.server.fault("m.zip", what)
            self.refused("the server did not send a complete zip file")

    def test_an_answer_that_is_no_json(self):
        self.server.fault("models/m", "garbage")
        self.refused("it is not JSON")

    def test_damaged_bytes(self):
        data = bytearray(zip_of(model_files("m") | {"a.bin": os.urandom(1000)}))
        data[len(data) // 2] ^= 0xff
        self.server.add("o", "m", bytes(data))
        self.refused("the archive is damaged")

    def test_another_version_than_asked_for(self):
        url = self.server.add("o", "m", model_files("m"))
        self.server.fault("m.zip", "version")
        self.refused("the server sends version 99 instead of 1", url=url + "/1")

    def test_ways_out_of_the_folder(self):
        for name in ("../../etc/passwd", "/etc/passwd", "a/../../b", "meshes\\..\\..\\b", "C:/x", ".."):
            self.server.add("o", "m", zip_of(model_files("m") | {zipfile.ZipInfo(name): "x"}))
            self.refused("is outside the model's folder")
        self.assertFalse((self.place.cache / "etc").exists())

    def test_links_and_devices(self):
        self.server.add("o", "m", zip_of(model_files("m") | {special("link"): "/etc/passwd"}))
        self.refused("'link' is a link")
        self.server.add("o", "m", zip_of(model_files("m") | {special("pipe", stat.S_IFIFO): ""}))
        self.refused("'pipe' is neither a file nor a folder")

    def test_the_same_file_twice(self):
        self.server.add("o", "m", zip_of(model_files("m") | {zipfile.ZipInfo("./model.sdf"): "other"}))
        self.refused("it has 'model.sdf' twice")

    def test_a_bomb(self):
        self.server.add("o", "m", zip_of(model_files("m") | {"zeros": bytes(100_000_000)}))
        self.refused("the archive was refused: its ", "bytes would become 100")

    def test_a_bomb_that_lies(self):
        size = 5_000_000
        data = zip_of(model_files("m") | {"zeros": bytes(size)})
        data = data.replace(size.to_bytes(4, "little"), (100).to_bytes(4, "little"))
        self.server.add("o", "m", data)
        self.refused("can't be downloaded: ")

    def test_no_model_in_it(self):
        self.server.add("o", "m", {"a.txt": "x"})
        self.refused("the server's response can't be used: there is no model.config in it")
        self.server.add("o", "m", {"model.config": "<model><sdf>model.sdf</sdf></model>"})
        self.refused("its model.config names 'model.sdf', which does not exist")
        self.server.add("o", "m", zip_of({}))
        self.refused("can't be downloaded")

    def test_a_file_too_large_for_the_limit(self):
        self.server.add("o", "m", model_files("m") | {"a.bin": os.urandom(100_000)})
        self.refused("can't be written: File too large", prefix=["prlimit", "--fsize=50000"])

    def test_a_full_disk(self):
        folder = self.place.home / "small"
        folder.mkdir()
        self.server.add("o", "m", model_files("m") | {"a.bin": os.urandom(300_000)})
        mount = f"mount -t tmpfs -o size=200k tmpfs {folder} && exec \"$@\""
        prefix = ["unshare", "--user", "--map-root-user", "--mount", "sh", "-c", mount, "sh"]
        if subprocess.run([*prefix, "true"], capture_output=True).returncode != 0:
            prefix = ["unshare", "--mount", *prefix[4:]]
            if subprocess.run([*prefix, "true"], capture_output=True).returncode != 0:
                self.skipTest("a file system can't be mounted here")
        self.refused("No space left on device\n  hint: free disk space", prefix=prefix,
                     IGN_FUEL_CACHE_PATH=str(folder))
        # there is room for the zip file, but not for its unpacked content
        self.server.add("o", "m", model_files("m") | {"a.bin": bytes(300_000)})
        self.refused("not enough disk space for 30", prefix=prefix, IGN_FUEL_CACHE_PATH=str(folder))

    def test_a_cache_that_can_not_be_written(self):
        self.server.add("o", "m", model_files("m"))
        file = self.place.home / "file"
        file.write_text("")
        self.refused("can't be created: Not a directory", IGN_FUEL_CACHE_PATH=str(file / "cache"))

    def test_a_certificate_of_another(self):
        stranger = self._enter(Server(certificate="stranger"))
        self.refused("the certificate of fuel.gazebosim.org is not trusted", place=self._enter(Place(stranger)))
        self.assertEqual(stranger.requests, [])

    def test_a_certificate_that_nobody_knows(self):
        self.refused("the certificate of fuel.gazebosim.org is not trusted", SSL_CERT_FILE="")
        self.assertEqual(self.server.requests, [])

    def test_no_server(self):
        self.refused("the server fuel.gazebosim.org ", "hint: ", https_proxy="http://127.0.0.1:9")

    def test_the_good_ones_come_all_the_same(self):
        good = self.server.add("o", "good", model_files("good"))
        result = self.place.fuel("download", "https://fuel.gazebosim.org/1.0/o/models/bad", good)
        self.assertEqual(result.returncode, 1)
        self.assertEqual(result.stderr.count("can't be downloaded"), 1)
        self.assertEqual(len(self.place.files()), 3)


if __name__ == "__main__":
    unittest.main()
