"""Starts servers, agents and a simulation as processes, and calls the REST interface, for fault tests."""

import http.client
import io
import json
import os
import re
import secrets
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
import urllib.error
import urllib.request
import zipfile
from pathlib import Path

HOME = Path(os.environ.get("SITAF_HOME", Path(__file__).resolve().parents[2]))
DIST = Path(os.environ.get("SITAF_DIST", HOME / ".sitaf" / "dist"))
PYTHON = os.environ.get("SITAF_PYTHON", str(HOME / ".sitaf" / "venv" / "bin" / "python"))
EXAMPLE = HOME / "examples" / "ir-sensor"
COMPONENT = "component/org/sitaf/examples/ir/InfraredSensor.java"
MODEL = "GetInfraredData"
OVER = {"DONE", "FAILED", "CANCELLED"}

# Secrets of this run: the servers listen on loopback only.
TOKEN, ENROLMENT = secrets.token_urlsafe(32), secrets.token_urlsafe(32)


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def activity(pause_ms):
    """The paper's example as a zip, with a pause in each call, so that a build takes long but uses little CPU."""
    files = {p.relative_to(EXAMPLE).as_posix(): p.read_bytes() for p in EXAMPLE.rglob("*") if p.is_file()}
    source = files[COMPONENT].decode()
    begin = re.search(r"public double GetInfraredData\([^)]*\) \{\n", source)
    pause = f"    try {{ Thread.sleep({pause_ms}); }} catch (InterruptedException e) {{ return NO_DISTANCE; }}\n"
    files[COMPONENT] = (source[: begin.end()] + pause + source[begin.end() :]).encode()
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w") as archive:
        for name in sorted(files):
            archive.writestr(name, files[name])
    return content.getvalue()


class Refused(Exception):
    """The server answered with an error."""


class Api:
    """The REST interface of a server."""

    def __init__(self, port, tls=None):
        """Create a client of the server at this port; `tls` has the trusted certificates if it uses TLS."""
        self.root, self.tls = f"{'https' if tls else 'http'}://127.0.0.1:{port}", tls

    def call(self, method, path, body=None, content_type="application/json"):
        data = body if isinstance(body, bytes) or body is None else json.dumps(body).encode()
        request = urllib.request.Request(self.root + path, data=data, method=method)
        request.add_header("Authorization", f"Bearer {TOKEN}")
        if data is not None:
            request.add_header("Content-Type", content_type)
        try:
            return self.answer(request)
        except http.client.HTTPException as error:
            # The server died during its answer, which equals a lost connection.
            raise ConnectionError(f"{method} {path}: {error}") from error

    def answer(self, request):
        try:
            with urllib.request.urlopen(request, timeout=120, context=self.tls) as answer:
                content = answer.read()
                return json.loads(content) if answer.headers.get_content_type() == "application/json" else content
        except urllib.error.HTTPError as error:
            text = error.read().decode(errors="replace")
            raise Refused(f"{request.method} {request.selector}: {error.code} {text}") from error

    def get(self, path):
        return self.call("GET", path)

    def post(self, path, body):
        return self.call("POST", path, body)

    def suite(self, pause_ms=0):
        """Upload the example and create a suite; return its id."""
        made = self.call("POST", "/api/v1/activities", activity(pause_ms), "application/zip")
        return self.post(f"/api/v1/activities/{made['id']}/models/{MODEL}/suites", {})["id"]

    def build(self, suite):
        return self.post("/api/v1/builds", {"suiteId": suite})["id"]

    def state(self, build):
        return self.get(f"/api/v1/builds/{build}")["state"]

    def builds(self):
        found, page = [], 0
        while True:
            listing = self.get(f"/api/v1/builds?size=500&page={page}")
            found += listing["items"]
            page += 1
            if len(found) >= listing["total"]:
                return found


class SystemProcess:
    """A process that can be killed and restarted; a context manager that ends it."""

    def __init__(self, name, command, log, environment, ready):
        self.name, self.command, self.log, self.environment, self.ready = name, command, log, environment, ready
        self.process = None

    def start(self, wait=True, limit_s=300):
        began = self.log.stat().st_size if self.log.exists() else 0
        with self.log.open("ab") as out:
            self.process = subprocess.Popen(
                self.command, stdin=subprocess.PIPE, stdout=out, stderr=out, env={**os.environ, **self.environment}
            )
        end = time.monotonic() + limit_s
        while wait and not self.has_logged(self.ready, began):
            if self.process.poll() is not None:
                raise RuntimeError(f"{self.name} ended:\n{self.log.read_text(errors='replace')[-3000:]}")
            if time.monotonic() > end:
                raise RuntimeError(f"{self.name} was not ready:\n{self.log.read_text(errors='replace')[-3000:]}")
            time.sleep(0.1)
        return self

    def __enter__(self):
        return self.start() if self.process is None else self

    def __exit__(self, *_):
        self.stop()

    def has_logged(self, words, since=0):
        with self.log.open("rb") as log:
            log.seek(since)
            return re.search(words, log.read(), re.MULTILINE) is not None

    def kill(self):
        self.process.kill()
        self.process.wait()

    def signal(self, number):
        os.kill(self.process.pid, number)

    def stop(self):
        if self.process is None or self.process.poll() is not None:
            return
        self.process.stdin.close()
        try:
            self.process.wait(20)
        except subprocess.TimeoutExpired:
            self.kill()


def java(part, jar, heap="256m", folder=None):
    """The command of a program of the installation or of another folder of the same layout."""
    folder = folder or DIST / part
    command = ["java", f"-Xmx{heap}", "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC"]
    if (folder / f"{part}.jsa").exists():
        command += [f"-XX:SharedArchiveFile={folder / part}.jsa", "-Xlog:disable", "-Xlog:all=error:stderr"]
    return command + ["-jar", str(folder / jar)]


def server(folder, *options, name="server", database=None, heap="512m"):
    """A server that keeps its ports across restarts."""
    http, grpc = free_port(), free_port()
    command = java("server", "sitaf-server.jar", heap) + [
        f"--sitaf.data-directory={folder / name}",
        f"--server.port={http}",
        f"--spring.grpc.server.port={grpc}",
        "--sitaf.stop-with-stdin=true",
        "--sitaf.max-attempts=100",
        *options,
    ]
    environment = {"SITAF_ACCESS_LAUNCHERTOKEN": TOKEN, "SITAF_ACCESS_LAUNCHERENROLMENT": ENROLMENT}
    if database:
        environment["SITAF_DATABASE_URL"] = database
    process = SystemProcess(name, command, folder / f"{name}.log", environment, rb"^listening ")
    process.http, process.grpc, process.api = http, grpc, Api(http)
    return process


def agent(folder, name, target, *options, slots=1, heap="128m", installation=None):
    """An agent with its own folder; `target` is a server's port, or comma-separated HOST:PORT."""
    command = java("agent", "agent.jar", heap, installation) + [
        "--server", target if ":" in str(target) else f"127.0.0.1:{target}",
        "--name", name,
        "--directory", str(folder / name),
        "--earlier-cache", str(HOME / ".sitaf" / "cache"),
        "--slots", str(slots),
        "--stop-with-stdin",
        *options,
    ]
    process = SystemProcess(name, command, folder / f"{name}.log", {"SITAF_ENROLMENT_TOKEN": ENROLMENT}, rb"^registered ")
    process.directory = folder / name
    return process


def own_bridge():
    return ["--bridge-command", f"'{PYTHON}' -m sitaf_bridge"]


class Bridge:
    """A simulation that agents share."""

    def __enter__(self):
        self.process = subprocess.Popen(
            [PYTHON, "-m", "sitaf_bridge", "serve", "--stop-with-stdin"],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
        )
        self.target = self.process.stdout.readline().split()[1]
        return self

    def __exit__(self, *_):
        self.process.stdin.close()
        self.process.wait(20)


class Postgres:
    """A PostgreSQL server for this run."""

    def __enter__(self):
        command = ["java", "-Xmx128m", "-cp", os.environ["SITAF_POSTGRES_CLASSPATH"], "Postgres"]
        command.append(os.environ["SITAF_POSTGRES_FOLDER"])
        self.errors = tempfile.TemporaryFile("w+")
        self.process = subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=self.errors, text=True
        )
        self.url = self.process.stdout.readline().strip()
        if not self.url.startswith("jdbc:"):
            self.process.kill()
            self.process.wait()
            self.errors.seek(0)
            raise RuntimeError(f"PostgreSQL did not start: {self.errors.read()[-4000:]}")
        return self

    def __exit__(self, *_):
        self.process.stdin.close()
        self.process.wait(30)
        self.errors.close()


def processes_of(directory, word):
    """Ids of processes of an agent's folder whose command line contains a word."""
    found = []
    for entry in Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                line = (entry / "cmdline").read_bytes().replace(b"\0", b" ").decode(errors="replace")
            except OSError:
                continue
            if str(directory) in line and word in line and "agent.jar" not in line:
                found.append(int(entry.name))
    return found


def kill_process(pid):
    try:
        os.kill(pid, signal.SIGKILL)
        return True
    except ProcessLookupError:
        return False


def await_true(condition, limit_s, step_s=0.25):
    """Wait for a condition; return whether it became true in time."""
    end = time.monotonic() + limit_s
    while time.monotonic() < end:
        if condition():
            return True
        time.sleep(step_s)
    return bool(condition())


class Table:
    """Prints rows with their targets, and a last line that states whether all were met."""

    def __init__(self, name):
        self.name, self.short = name, []
        print(f"{'':52}{'measured':>14}  target", flush=True)

    def row(self, what, value, target, held):
        shown = f"{value:,.2f}" if isinstance(value, float) else f"{value:,}" if isinstance(value, int) else str(value)
        print(f"{what:52}{shown:>14}  {target}{'' if held else '   SHORT'}", flush=True)
        if not held:
            self.short.append(f"{what} {shown}, target {target}")

    def end(self):
        print(f"{self.name}: " + ("held" if not self.short else "short: " + "; ".join(self.short)), flush=True)
        return 1 if self.short else 0


def show(*parts, lines=80):
    """Print the ends of the logs, to find the reason of a failure."""
    for part in parts:
        print(f"-- {part.name}", *part.log.read_text(errors="replace").splitlines()[-lines:], sep="\n", file=sys.stderr)


def fill(disk, leave=0):
    """Fill a disk up to the given number of free bytes; return a function that frees the space."""
    filler = disk / "filler"
    free = os.statvfs(disk).f_bavail * os.statvfs(disk).f_frsize
    with filler.open("wb", buffering=0) as out:
        if leave:
            os.posix_fallocate(out.fileno(), 0, free - leave)
            return filler.unlink
        try:
            while True:
                out.write(bytes(1 << 16))
        except OSError:
            pass
        try:
            while True:
                out.write(b"x")
        except OSError:
            pass
    # A server gives back a small reserve.
    assert os.statvfs(disk).f_bavail * os.statvfs(disk).f_frsize < 1 << 20
    return filler.unlink


def together(parts, action):
    threads = [threading.Thread(target=action, args=(part,)) for part in parts]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
