"""Control loops in each language exchange their operations over the socket of frames, and over gRPC where there is none."""

import os
import socket
import subprocess
import sys
import threading
from pathlib import Path

import pytest

from needs import cpp

LOOPS = Path(__file__).parents[1] / "benchmarks" / "simulation"
sys.path.insert(0, str(LOOPS))
from loops import JOINTS, write_world  # noqa: E402

LANGUAGES = ["java", pytest.param("cpp", marks=cpp), "python"]
# Each program makes five rounds of 500 ticks.
TICKS = 2500


@pytest.fixture
def bridge(tmp_path):
    """The folder of a bridge's sockets: `s` and `s.ops`."""
    folder = tmp_path / "b"
    folder.mkdir()
    command = [sys.executable, "-m", "sitaf_bridge", "serve", "--listen", f"unix:{folder}/s", "--stop-with-stdin"]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout.readline().startswith("listening ")
        yield folder
        process.stdin.close()
        process.wait(20)
        process.stdout.close()


class Relay:
    """Takes the place of a socket of operations, forwards what it gets, and counts the pieces that clients send."""

    def __init__(self, path):
        self.sent = 0
        self._to = path.rename(path.with_name("moved"))
        self._listener = socket.socket(socket.AF_UNIX)
        self._listener.bind(str(path))
        self._listener.listen()
        threading.Thread(target=self._accept, daemon=True).start()

    def _accept(self):
        client, _ = self._listener.accept()
        simulator = socket.socket(socket.AF_UNIX)
        simulator.connect(str(self._to))
        threading.Thread(target=self._forward, args=(client, simulator, True), daemon=True).start()
        self._forward(simulator, client, False)

    def _forward(self, source, target, counts):
        while piece := source.recv(1 << 16):
            self.sent += counts
            target.sendall(piece)
        target.shutdown(socket.SHUT_WR)


@pytest.fixture(scope="module")
def program(sitaf, tmp_path_factory):
    """The command of a language's program, and its environment."""
    dist, folder = sitaf.root / ".sitaf" / "dist" / "agent", tmp_path_factory.mktemp("loops")

    def command(language):
        if language == "python":
            return [sys.executable, LOOPS / "loop.py"], {"PYTHONPATH": str(dist / "runtime-python")}
        if language == "java":
            classpath = f"{dist}/runtime-java/*:{dist}/lib/*"
            subprocess.run(["javac", "-proc:none", "-d", folder, "-cp", classpath, LOOPS / "Loops.java"], check=True)
            return ["java", "-cp", f"{folder}:{classpath}", "Loops"], {}
        # A run of a component builds the library of the runtime.
        assert sitaf("run", "examples/joint-settling-cpp", "--no-coverage").returncode == 0
        library = max((sitaf.root / ".sitaf/cache/cpp/runtime").glob("*/lib"), key=lambda path: path.stat().st_mtime)
        options = [f"-I{dist}/runtime-cpp/include", f"-L{library}", "-lsitaf_runtime", f"-Wl,-rpath,{library}"]
        subprocess.run(["g++", "-std=c++17", LOOPS / "loops.cpp", *options, "-o", folder / "loops"], check=True)
        return [folder / "loops"], {}

    return command


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_control_loop_uses_the_socket_of_operations_if_there_is_one(bridge, program, tmp_path, language):
    command, environment = program(language)

    def control():
        arguments = [f"unix:{bridge}/s", write_world(tmp_path), str(JOINTS)]
        subprocess.run([*command, *arguments], check=True, env={**os.environ, **environment}, timeout=120)

    relay = Relay(bridge / "s.ops")
    control()
    assert relay.sent >= TICKS
    (bridge / "s.ops").unlink()
    control()
