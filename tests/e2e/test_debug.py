"""`./sitaf run --case N --debug`: a scripted session of the debugger of each language."""

import os
import re
import signal
import subprocess
import threading
import time
from pathlib import Path

import pytest
from needs import gdb

ROOT = Path(__file__).resolve().parents[2]
LIMIT_S = 300


class Terminal:
    """A command whose output is read while it runs."""

    def __init__(self, *arguments, command=None):
        self.process = subprocess.Popen(
            command or [str(ROOT / "sitaf"), *map(str, arguments)],
            cwd=ROOT,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            start_new_session=True,
        )
        self.output = ""
        self._seen = 0
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def _read(self):
        while data := os.read(self.process.stdout.fileno(), 65536):
            self.output += data.decode(errors="replace")

    def expect(self, pattern):
        """Wait until further output matches."""
        end = time.monotonic() + LIMIT_S
        while time.monotonic() < end:
            running = self._reader.is_alive()
            if found := re.compile(pattern).search(self.output, self._seen):
                self._seen = found.end()
                return found
            if not running:
                break
            time.sleep(0.02)
        raise AssertionError(
            f"no output matches {pattern!r} after character {self._seen}:\n{self.output}"
        )

    def send(self, line):
        self.process.stdin.write(f"{line}\n".encode())
        self.process.stdin.flush()

    def end(self):
        """Close the input and wait for the end; return the exit code."""
        if not self.process.stdin.closed:
            self.process.stdin.close()
        code = self.process.wait(LIMIT_S)
        self._reader.join(LIMIT_S)
        return code


@pytest.fixture
def terminal():
    started = []

    def start(*arguments, command=None):
        started.append(Terminal(*arguments, command=command))
        return started[-1]

    yield start
    for each in started:
        if each.process.poll() is None:
            os.killpg(each.process.pid, signal.SIGKILL)


def require_the_verdict_of_case_7(debugged):
    """It fails in the same way without a debugger (test_cpp, test_python, test_run)."""
    assert debugged.end() == 1, debugged.output
    assert "FAIL in 1 case: expected 0.5, but was -1.0" in debugged.output
    assert (
        "GetInfraredData: 1 cases, 0 PASS, 1 FAIL, 0 ERROR, 0 DONT" in debugged.output
    )
    assert "the processing time includes the time in the debugger" in debugged.output


def test_jdb_stops_in_a_java_component(terminal):
    jdb = terminal("run", "examples/ir-sensor-faulty", "--case", "7", "--debug")
    jdb.expect(r"Breakpoint hit: .*InfraredSensor\.GetInfraredData\(\)")
    jdb.send("print numOfSensor")
    jdb.expect(r"numOfSensor = 2\b")
    jdb.send("where")
    jdb.expect(r"\[1\] org\.sitaf\.examples\.ir\.InfraredSensor\.GetInfraredData")
    jdb.send("cont")
    require_the_verdict_of_case_7(jdb)


@gdb
def test_gdb_stops_in_a_cpp_component(terminal):
    gdb = terminal("run", "examples/ir-sensor-cpp-faulty", "--case", "7", "--debug")
    gdb.expect(r"Breakpoint 1, robot::InfraredSensor::GetInfraredData \(")
    gdb.send("list")
    gdb.expect(r"GetInfraredData\(")
    gdb.send("info args")
    gdb.expect(r"= 2\b")
    gdb.send("continue")
    gdb.expect("exited normally")
    require_the_verdict_of_case_7(gdb)


@gdb
def test_leaving_gdb_lets_the_case_continue(terminal):
    gdb = terminal("run", "examples/ir-sensor-cpp-faulty", "--case", "7", "--debug")
    gdb.expect("Breakpoint 1, ")
    require_the_verdict_of_case_7(gdb)


@gdb
def test_a_killed_component_is_an_error(terminal):
    gdb = terminal("run", "examples/ir-sensor-cpp-faulty", "--case", "7", "--debug")
    gdb.expect("Breakpoint 1, ")
    gdb.send("kill")
    assert gdb.end() == 1
    assert "GetInfraredData: 1 cases, 0 PASS, 0 FAIL, 1 ERROR, 0 DONT" in gdb.output


def test_pdb_stops_in_a_python_component(terminal):
    pdb = terminal("run", "examples/ir-sensor-python-faulty", "--case", "7", "--debug")
    pdb.expect(r"infrared_sensor\.py\(\d+\)get_infrared_data\(\)")
    pdb.expect(r"\(Pdb\) ")
    pdb.send("p num_of_sensor + 40")
    pdb.expect(r"\b42\n")
    pdb.send("step")
    pdb.expect(r"get_infrared_data\(\)")
    pdb.send("continue")
    require_the_verdict_of_case_7(pdb)


def test_leaving_pdb_lets_the_case_continue(terminal):
    pdb = terminal("run", "examples/ir-sensor-python-faulty", "--case", "7", "--debug")
    pdb.expect(r"\(Pdb\) ")
    pdb.send("quit")
    require_the_verdict_of_case_7(pdb)


def test_ctrl_c_is_for_the_debugger(terminal):
    pdb = terminal("run", "examples/ir-sensor-python-faulty", "--case", "7", "--debug")
    pdb.expect(r"\(Pdb\) ")
    os.killpg(pdb.process.pid, signal.SIGINT)
    pdb.send("p index_of_sensor + 40")
    pdb.expect(r"\b42\n")
    pdb.send("continue")
    require_the_verdict_of_case_7(pdb)


def test_another_debugger_attaches(terminal):
    run = terminal(
        "run", "examples/ir-sensor-faulty", "--case", "7", "--debug", "--print-command"
    )
    port = run.expect(r"host 127\.0\.0\.1, port (\d+)")[1]
    run.expect("waits for the debugger")
    jdb = terminal(
        command=[
            "jdb",
            "-connect",
            f"com.sun.jdi.SocketAttach:hostname=127.0.0.1,port={port}",
        ]
    )
    jdb.expect(r"main\[1\]")
    jdb.send("stop in org.sitaf.examples.ir.InfraredSensor.GetInfraredData")
    jdb.expect("Deferring breakpoint")
    jdb.send("resume")
    jdb.expect("Breakpoint hit")
    jdb.send("print numOfSensor")
    jdb.expect(r"numOfSensor = 2\b")
    jdb.end()
    require_the_verdict_of_case_7(run)


def test_one_case_is_needed(sitaf):
    run = sitaf("run", "examples/ir-sensor", "--case", "1-3", "--debug")
    assert run.returncode == 2
    assert (
        "--debug: error: debugs one case, but 3 of GetInfraredData are selected; add --case"
        in run.stderr
    )


def test_a_node_is_refused(sitaf):
    run = sitaf("run", "examples/wall-stop-ros", "--case", "1", "--debug")
    assert run.returncode == 2
    assert "ROS 2 nodes cannot be debugged" in run.stderr
