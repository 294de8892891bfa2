"""Access to a world's server, and permissions of clients."""

import json
import pathlib
import shutil
import subprocess
import tempfile
import unittest

from web_world import EMPTY_WORLD, ROOT, Connection, ended, running, until

WORLD = ROOT / "worlds/pong_world.sdf"


def first_text(connection):
    """The first text message, which in Foxglove's protocol is the server's information."""
    while True:
        opcode, payload = connection.next()
        if opcode == 1:
            return json.loads(payload)


class Security(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def start(self, *words, environment=None):
        """Host, port and token of a world that runs."""
        context = running(WORLD, *words, environment=environment)
        self.simulation = context.__enter__()
        self.addCleanup(context.__exit__, None, None, None)
        return self.simulation.address()

    def status(self, host, port, **headers):
        with Connection(host, port) as connection:
            return connection.open(**headers)

    def status_of_asset(self, host, port, file):
        with Connection(host, port) as connection:
            return connection.get(f"/assets{file}")[0]

    def test_foreign_pages_and_names_are_refused(self):
        host, port, token = self.start("--web", "0")
        self.assertEqual(host, "127.0.0.1")
        self.assertIsNone(token)
        self.assertEqual(self.status(host, port), 101)
        self.assertEqual(self.status(host, port, Origin=f"http://127.0.0.1:{port}"), 101)
        for origin in ("https://evil.example", "null", f"http://127.0.0.1:{port + 1}", "file://"):
            self.assertEqual(self.status(host, port, Origin=origin), 403, origin)
        self.assertEqual(self.status(host, port, Host="evil.example", Origin="http://evil.example"), 421)
        with Connection(host, port) as connection:
            self.assertEqual(connection.get("/", Host=f"evil.example:{port}")[0], 421)
        self.simulation.wait_for("a client was refused: the page of 'https://evil.example' is not allowed")

    def test_a_named_page_may_look_and_one_named_so_may_write(self):
        host, port, _ = self.start("--web", "0", "--web-origin", "https://look.example", "--web-writing-origin",
                                   "https://write.example")
        for origin, may_publish in (("https://look.example", False), ("https://write.example", True)):
            with Connection(host, port) as connection:
                self.assertEqual(connection.open(Origin=origin), 101)
                self.assertEqual("clientPublish" in first_text(connection)["capabilities"], may_publish, origin)

    def test_read_only_is_for_everybody(self):
        host, port, _ = self.start("--web", "0", "--web-read-only")
        with Connection(host, port) as connection:
            self.assertEqual(connection.open(), 101)
            self.assertNotIn("clientPublish", first_text(connection)["capabilities"])

    def test_a_token_is_asked_for_where_there_is_one(self):
        host, port, token = self.start("--web", "0", environment={"PONGSIM_WEB_TOKEN": "known"})
        self.assertEqual(token, "known")
        self.assertEqual(self.status(host, port), 401)
        self.assertEqual(self.status(host, port, path="/?token=guess"), 401)
        self.assertEqual(self.status(host, port, path="/?token=known"), 101)
        self.assertEqual(self.status(host, port, Authorization="Bearer known"), 101)
        with Connection(host, port) as connection:
            self.assertEqual(connection.get("/assets/etc/passwd")[0], 401)
        with Connection(host, port) as connection:
            self.assertEqual(connection.get("/assets/etc/passwd?token=known")[0], 404)

    def test_an_inserted_model_gives_no_access_to_private_folders(self):
        private, models = self.folder / "private", self.folder / "models"
        for folder in (private, models):
            folder.mkdir()
            (folder / "box.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
            (folder / "photo.png").write_bytes(b"picture")
        environment = {"PONGSIM_RESOURCE_PATH": str(models)}
        host, port, _ = self.start("--web", "0", environment=environment)
        for folder in (private, models):
            model = (f"<sdf version='1.9'><model name='{folder.name}'><static>true</static><link name='l'><visual name='v'>"
                     f"<geometry><mesh><uri>{folder}/box.obj</uri></mesh></geometry></visual></link></model></sdf>")
            result = ended("service", "-s", "/world/pong_world/create", "--reqtype", "EntityFactory", "--reptype", "Boolean",
                           "--timeout", "60000", "-r", f'sdf: "{model}"')
            self.assertIn("data: true", result.stdout, result.stderr)
        with Connection(host, port) as client:
            self.assertEqual(client.open(), 101)
            self.simulation.wait_for(f"mesh '{private}/box.obj' is not found: .*\n.*PONGSIM_RESOURCE_PATH")
            until(lambda: self.status_of_asset(host, port, models / "box.obj") == 200, "the mesh of the model's folder")
            for file in (private / "photo.png", private / "box.obj", models / "photo.png"):
                self.assertEqual(self.status_of_asset(host, port, file), 404, file)

    @unittest.skipUnless(shutil.which("openssl"), "makes a certificate with openssl")
    def test_tls_with_a_given_certificate(self):
        certificate, key = self.folder / "c.pem", self.folder / "k.pem"
        subprocess.run(["openssl", "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "2", "-subj", "/CN=localhost",
                        "-addext", "subjectAltName=DNS:localhost,IP:127.0.0.1", "-keyout", key, "-out", certificate],
                       check=True, capture_output=True)
        host, port, _ = self.start("--web", "0", "--web-certificate", certificate, "--web-key", key)
        self.assertIn("https://", self.simulation.output())
        with Connection(host, port, certificate) as connection:
            self.assertEqual(connection.open(Origin=f"https://{host}:{port}"), 101)
            self.assertEqual(first_text(connection)["op"], "serverInfo")
        with self.assertRaises(OSError), Connection(host, port) as connection:
            # without TLS there is no HTTP response
            connection.socket.sendall(b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n")
            if not connection.stream.read():
                raise OSError("closed")

    def test_wrong_options_are_said_before_anything_runs(self):
        for words, code, text in (
                (("--web", "0", "--web-key", "k.pem"), 1, "the certificate is missing"),
                (("--web-certificate", "none.pem", "--web-key", "none.pem", "--web", "0"), 1, "can't be read"),
                (("--web-origin", "app.example", "--web", "0"), 1, "'app.example' is not an origin"),
                (("--web", "70000"), 2, "a whole number from 0 to 65535")):
            result = ended("run", WORLD, "--iterations", "1", *words)
            self.assertEqual(result.returncode, code, result.stderr)
            self.assertIn(text, result.stderr)

    def test_a_port_that_is_taken_is_named(self):
        _, port, _ = self.start("--web", "0")
        result = ended("run", WORLD, "--iterations", "1", "--web", str(port))
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn(f"port {port} of 127.0.0.1 can't be opened: another program uses it", result.stderr)
        self.assertIn("--web PORT", result.stderr)

    def test_the_names_of_gazebos_server_mean_this_one(self):
        for filename, name in (("gz-sim-websocket-server-system", "gz::sim::systems::WebsocketServer"),
                               ("ignition-launch-websocket-server", "ignition::launch::WebsocketServer")):
            file = self.folder / "world.sdf"
            file.write_text(EMPTY_WORLD.format(
                f"<plugin filename='{filename}' name='{name}'><port>0</port><publication_hz>30</publication_hz>"
                "<authorization_key>a</authorization_key></plugin>"))
            with running(file, "--strict") as simulation:
                host, port, _ = simulation.address()
                with Connection(host, port) as connection:
                    self.assertEqual(connection.open(protocol=None), 101)

    def test_worlds_of_a_file_share_the_port(self):
        file = self.folder / "two.sdf"
        file.write_text("<sdf version='1.9'><world name='one'/><world name='two'/></sdf>")
        with running(file, "--web", "0") as simulation:
            host, port, _ = simulation.address()
            with Connection(host, port) as connection:
                self.assertEqual(connection.open(), 101)
                topics = set()
                while not {"/world/one/stats", "/world/two/stats"} <= topics:
                    opcode, payload = connection.next()
                    message = json.loads(payload) if opcode == 1 else {}
                    topics |= {channel["topic"] for channel in message.get("channels", [])}
            self.assertEqual(simulation.output().count("in a browser"), 1)


if __name__ == "__main__":
    unittest.main()
