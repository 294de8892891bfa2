"""A Fuel server on this machine: the part of the REST API that clients use, over TLS, with faults on demand.

Clients reach it under the real host names through an HTTP proxy, so they need no test mode.
"""

import contextlib
import functools
import hashlib
import http.server
import io
import json
import os
import pathlib
import socket
import ssl
import stat
import subprocess
import sys
import tempfile
import threading
import urllib.parse
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
BUILD = pathlib.Path(os.environ.get("PONGSIM_BUILD", ROOT / "build/release"))
PONGSIM = BUILD / "bin/pongsim"
FUEL = BUILD / "libexec/pongsim/pongsim-fuel"
sys.path.append(str(ROOT / "test/support"))
from test_domain import take_domain  # noqa: E402
from waiting import PATIENCE, until  # noqa: E402

DOMAIN = str(take_domain())
NAMES = ["fuel.gazebosim.org", "fuel.ignitionrobotics.org", "models.example.org", "storage.example.org"]
PAGE = 2


def model_files(name, include="", body="", version="1.9"):
    """The files of a model: a box with a mesh, and the given XML."""
    return {
        "model.config": f"""<?xml version="1.0"?>
<model><name>{name}</name><sdf version="{version}">model.sdf</sdf></model>""",
        "model.sdf": f"""<?xml version="1.0"?>
<!-- model://{name}/meshes/box.obj stays here -->
<sdf version="{version}">
  <model name="{name}">{include}
    <link name="body">
      <visual name="look"><geometry><mesh><uri> model://{name}/meshes/box.obj </uri></mesh></geometry></visual>
      <visual name="other"><geometry><mesh><uri>model://elsewhere/a.obj</uri></mesh></geometry></visual>
      <collision name="shape"><geometry><box><size>1 1 1</size></box></geometry></collision>
    </link>{body}
  </model>
</sdf>""",
        "meshes/box.obj": "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n",
    }


def zip_of(files):
    """A zip file; keys are names or ZipInfo, values are contents."""
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in sorted({name.rpartition("/")[0] for name in files if isinstance(name, str) and "/" in name}):
            # an entry for each folder, as the real server writes; Fortress does not create a folder without one
            archive.writestr(name + "/", "")
        for name, content in files.items():
            if isinstance(name, zipfile.ZipInfo):
                name.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(name, content)
    return out.getvalue()


def streamed_zip_of(files):
    """A zip file as written to a stream, as servers in Go do: sizes and checksums come after each file."""
    class Pipe:
        def __init__(self):
            self.data = b""

        def write(self, data):
            self.data += data
            return len(data)

        def flush(self):
            pass

    pipe = Pipe()
    with zipfile.ZipFile(pipe, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            archive.writestr(name, content)
    return pipe.data


def special(name, kind=stat.S_IFLNK):
    info = zipfile.ZipInfo(name)
    info.create_system = 3
    info.external_attr = (kind | 0o777) << 16
    return info


@functools.cache
def authority():
    """A folder with a certificate authority, and a certificate that it has signed for the names of the server."""
    folder = pathlib.Path(tempfile.mkdtemp(prefix="fuel_authority_"))
    names = ",".join("DNS:" + name for name in NAMES) + ",IP:127.0.0.1"

    def openssl(*words):
        subprocess.run(["openssl", *words], cwd=folder, check=True, capture_output=True)

    openssl("req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes", "-days", "2",
            "-keyout", "ca.key", "-out", "ca.pem", "-subj", "/CN=Fuel tests")
    for name in ("server", "stranger"):
        openssl("req", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes", "-keyout", f"{name}.key",
                "-out", f"{name}.csr", "-subj", "/CN=localhost")
        (folder / f"{name}.ext").write_text("subjectAltName=" + (names if name == "server" else "DNS:stranger.org"))
        openssl("x509", "-req", "-in", f"{name}.csr", "-CA", "ca.pem", "-CAkey", "ca.key", "-days", "2", "-out",
                f"{name}.pem", "-extfile", f"{name}.ext")
    import atexit
    import shutil
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return folder


class Server:
    """An HTTPS server for models and worlds, until it is closed."""

    def __init__(self, certificate="server", plain=False):
        self.resources = {}
        self.collections = {}
        # Faults by the end of the path, without query: what goes wrong, and how many times (None: always).
        self.faults = {}
        self.requests = []
        self.connects = []
        self.token = None
        self.chunk = None
        self.has_tags = True
        self.stall = threading.Event()
        self._lock = threading.Lock()
        self._web = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Handler, self))
        self._web.daemon_threads = True
        self._web.handle_error = lambda request, address: None
        if not plain:
            context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
            context.load_cert_chain(authority() / f"{certificate}.pem", authority() / f"{certificate}.key")
            self._web.socket = context.wrap_socket(self._web.socket, server_side=True, do_handshake_on_connect=False)
        self.port = self._web.server_address[1]
        self._proxy = socket.create_server(("127.0.0.1", 0))
        self.proxy_port = self._proxy.getsockname()[1]
        threading.Thread(target=self._web.serve_forever, kwargs={"poll_interval": 0.05}, daemon=True).start()
        threading.Thread(target=self._accept, daemon=True).start()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.stall.set()
        self._web.shutdown()
        self._web.server_close()
        self._proxy.close()

    def add(self, owner, name, files, version=1, kind="models"):
        data = files if isinstance(files, bytes) else zip_of(files)
        self.resources.setdefault((kind, owner.lower(), name.lower()), {"owner": owner, "name": name, "zips": {}})
        self.resources[kind, owner.lower(), name.lower()]["zips"][version] = data
        return f"https://fuel.gazebosim.org/1.0/{owner}/{kind}/{name}"

    def fault(self, ending, what, times=None):
        self.faults[ending] = [what, times]

    def fault_of(self, path):
        with self._lock:
            for ending, entry in self.faults.items():
                if path.endswith(ending) and entry[1] != 0:
                    if entry[1] is not None:
                        entry[1] -= 1
                    return entry[0]
        return None

    def zips(self):
        """The requests for zip files so far, as (path, headers)."""
        return [(path, headers) for path, headers in self.requests if urllib.parse.urlsplit(path).path.endswith(".zip")]

    def _accept(self):
        with contextlib.suppress(OSError):
            while True:
                client, _ = self._proxy.accept()
                threading.Thread(target=self._tunnel, args=(client,), daemon=True).start()

    def _tunnel(self, client):
        with contextlib.suppress(OSError), client:
            head = b""
            while b"\r\n\r\n" not in head:
                part = client.recv(4096)
                if not part:
                    return
                head += part
            self.connects.append(head.split()[1].decode())
            with socket.create_connection(("127.0.0.1", self.port)) as server:
                client.sendall(b"HTTP/1.1 200 Connection established\r\n\r\n")
                back = threading.Thread(target=self._pump, args=(server, client), daemon=True)
                back.start()
                self._pump(client, server)
                back.join()

    @staticmethod
    def _pump(source, target):
        with contextlib.suppress(OSError):
            while part := source.recv(65536):
                target.sendall(part)
            target.shutdown(socket.SHUT_WR)


class Handler(http.server.BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"

    def __init__(self, fuel, *words):
        self.fuel = fuel
        super().__init__(*words)

    def log_message(self, *_):
        pass

    def answer(self, status, body=b"", kind="application/json", **headers):
        self.send_response(status)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(headers.pop("length", len(body))))
        for name, value in headers.items():
            self.send_header(name.replace("_", "-"), str(value))
        self.end_headers()
        with contextlib.suppress(OSError):
            self.wfile.write(body)

    def do_DELETE(self):
        self.fuel.requests.append((self.path, dict(self.headers)))
        if self.fuel.token is None or self.headers.get("Private-Token") != self.fuel.token:
            return self.answer(401)
        parts = urllib.parse.unquote(self.path).split("/")
        found = self.fuel.resources.pop((parts[3], parts[2].lower(), parts[4].lower()), None)
        return self.answer(200 if found else 404, b"{}")

    def do_GET(self):
        self.fuel.requests.append((self.path, dict(self.headers)))
        url = urllib.parse.urlsplit(self.path)
        path = urllib.parse.unquote(url.path)
        query = urllib.parse.parse_qs(url.query)
        what = self.fuel.fault_of(path)
        if isinstance(what, int):
            return self.answer(what, b"an error's page")
        if what == "circle":
            return self.answer(302, Location=self.path)
        if isinstance(what, tuple) and what[0] == "redirect":
            return self.answer(301, Location=what[1])
        if what == "garbage":
            return self.answer(200, b"<html>", kind="text/html")
        if self.fuel.token is not None and path.startswith("/1.0/"):
            if self.headers.get("Private-Token") != self.fuel.token:
                return self.answer(401)
        parts = path.strip("/").split("/")
        if parts[0] == "storage":
            return self.send_zip(self.fuel.resources["models", parts[1], parts[2]]["zips"][int(parts[3])], None, what)
        parts = parts[1:]
        if len(parts) in (1, 2) and parts[-1] in ("models", "worlds"):
            owner = parts[0].lower() if len(parts) == 2 else None
            found = [key for key in sorted(self.fuel.resources) if key[0] == parts[-1] and owner in (None, key[1])]
            return self.send_page(found, query)
        if len(parts) == 4 and parts[1] == "collections":
            return self.send_page([key for key in self.fuel.collections.get((parts[0], parts[2]), []) if key[0] == parts[3]],
                                  query)
        if len(parts) < 3 or (resource := self.fuel.resources.get((parts[1], parts[0].lower(), parts[2].lower()))) is None:
            return self.answer(404)
        if len(parts) == 3:
            return self.answer(200, json.dumps(self.described((parts[1], parts[0].lower(), parts[2].lower()))).encode())
        zips = resource["zips"]
        version = max(zips) if parts[3] == "tip" else int(parts[3])
        if version not in zips:
            return self.answer(404)
        if what == "link":
            link = f"https://storage.example.org/storage/{parts[0].lower()}/{parts[2].lower()}/{version}/x.zip?signature=1"
            return self.answer(200, link.encode(), kind="text/plain; charset=utf-8", X_Ign_Resource_Version=version)
        return self.send_zip(zips[version], version, what)

    def described(self, key):
        resource = self.fuel.resources[key]
        version = max(resource["zips"])
        return {"name": resource["name"], "owner": resource["owner"], "version": version, "private": False,
                "filesize": len(resource["zips"][version]), "license_name": "CC0", "tags": ["box", "test"],
                "description": "A box", "createdAt": "2024-01-02T03:04:05Z", "updatedAt": "2024-02-03T04:05:06Z",
                "likes": 0, "downloads": 1}

    def send_page(self, keys, query):
        page = int(query.get("page", ["1"])[0])
        part = keys[(page - 1) * PAGE:page * PAGE]
        if not part and page > 1:
            return self.answer(404)
        return self.answer(200, json.dumps([self.described(key) for key in part]).encode())

    def send_zip(self, data, version, what):
        tag = '"' + hashlib.sha256(data).hexdigest()[:16] + '"'
        headers = {"ETag": tag} if self.fuel.has_tags else {}
        if version is not None and what != "versionless":
            headers["X_Ign_Resource_Version"] = 99 if what == "version" else version
        status, start = 200, 0
        wanted = self.headers.get("Range")
        if wanted and self.headers.get("If-Range") == tag:
            start = int(wanted.removeprefix("bytes=").removesuffix("-"))
            if start >= len(data):
                return self.answer(416)
            status = 206
            headers["Content_Range"] = f"bytes {start}-{len(data) - 1}/{len(data)}"
        body = data[start:]
        if what == "lying":
            headers["length"] = len(body) + 1000
        elif what == "short":
            headers["length"] = len(body) // 2
            body = body[:len(body) // 2]
        elif what == "garbled":
            body = bytes(len(body))
        if what in ("half", "drip", "stall"):
            self.send_response(status)
            self.send_header("Content-Type", "application/zip")
            self.send_header("Content-Length", str(len(body)))
            for name, value in headers.items():
                self.send_header(name.replace("_", "-"), str(value))
            self.end_headers()
            with contextlib.suppress(OSError):
                self.wfile.write(body[:len(body) // 2])
                self.wfile.flush()
                if what == "stall":
                    self.fuel.stall.wait(PATIENCE)
                    self.wfile.write(body[len(body) // 2:])
                for byte in body[len(body) // 2:] if what == "drip" else b"":
                    if self.fuel.stall.wait(1):
                        break
                    self.wfile.write(bytes([byte]))
                    self.wfile.flush()
            self.close_connection = True
            return None
        self.answer(status, body, kind="application/zip", **headers)
        if what == "lying":
            self.close_connection = True
        return None


class Place:
    """A test's own home folder, cache and environment, in which it runs programs."""

    def __init__(self, server=None, cache=None):
        self._folder = tempfile.TemporaryDirectory(prefix="fuel_test_")
        self.home = pathlib.Path(self._folder.name)
        self.cache = pathlib.Path(cache) if cache else self.home / ".ignition/fuel"
        self.environment = {name: value for name, value in os.environ.items()
                            if name not in ("PONGSIM_OFFLINE", "IGN_FUEL_CACHE_PATH",
                                             "GZ_FUEL_CACHE_PATH") and not name.lower().endswith("_proxy")}
        self.environment |= {"HOME": str(self.home), "PONGSIM_DOMAIN": DOMAIN, "PONGSIM_FUEL_TIMEOUT": "60", "XDG_CACHE_HOME": str(self.home / "xdg")}
        if cache:
            self.environment["IGN_FUEL_CACHE_PATH"] = str(cache)
        if server is not None:
            self.environment["https_proxy"] = f"http://127.0.0.1:{server.proxy_port}"
            self.environment["SSL_CERT_FILE"] = str(authority() / "ca.pem")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._folder.cleanup()

    def start(self, program, *words, prefix=(), **environment):
        return subprocess.Popen([*prefix, str(program), *map(str, words)], cwd=self.home, text=True,
                                env=self.environment | environment, stdin=subprocess.DEVNULL,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def run(self, program, *words, prefix=(), **environment):
        process = self.start(program, *words, prefix=prefix, **environment)
        output, error = process.communicate(timeout=PATIENCE)
        return subprocess.CompletedProcess(words, process.returncode, output, error)

    def fuel(self, *words, **more):
        return self.run(PONGSIM, "fuel", *words, **more)

    def files(self):
        """The sorted paths of all files and links in the cache."""
        return sorted(str(path.relative_to(self.cache)) for path in self.cache.rglob("*")
                      if path.is_file() or path.is_symlink())

