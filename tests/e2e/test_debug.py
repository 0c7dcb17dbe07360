"""`./sitaf run --case N --debug`: a scripted session of the debugger of each language."""

import json
import os
import shutil
import signal
import socket
import urllib.error
import urllib.request
from pathlib import Path

from needs import gdb

ROOT = Path(__file__).resolve().parents[2]
LIMIT_S = 300


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


class Ide:
    """A client of the Debug Adapter Protocol, as an IDE is one."""

    def __init__(self, port):
        self._socket = socket.create_connection(("127.0.0.1", port), LIMIT_S)
        self._stream = self._socket.makefile("rb")
        self._sent = 0

    def ask(self, command, **arguments):
        """Send a request without waiting."""
        self._sent += 1
        content = {"seq": self._sent, "type": "request", "command": command, "arguments": arguments}
        body = json.dumps(content).encode()
        self._socket.sendall(b"Content-Length: %d\r\n\r\n%s" % (len(body), body))

    def expect(self, kind, name):
        """The body of the next event, or of the next response to a command, of this name."""
        while True:
            length = 0
            while header := self._stream.readline().strip():
                length = int(header.split(b":")[1])
            assert length, "the debugger has closed the connection"
            message = json.loads(self._stream.read(length))
            if message["type"] == kind and message[{"event": "event", "response": "command"}[kind]] == name:
                assert message.get("success", True), message
                return message.get("body", {})

    def answer(self, command, **arguments):
        self.ask(command, **arguments)
        return self.expect("response", command)

    def close(self):
        self._socket.close()


def test_an_ide_debugs_a_python_component(terminal, tmp_path):
    activity = shutil.copytree(ROOT / "examples" / "ir-sensor-python-faulty", tmp_path / "activity")
    (activity / "requirements.txt").write_text("debugpy==1.8.22\n")
    source = activity / "component" / "infrared_sensor.py"
    lines = source.read_text().splitlines()
    line = next(i for i, text in enumerate(lines, 1) if "if not 1 <= num_of_sensor" in text)
    run = terminal("run", activity, "--case", "7", "--debug", "--print-command")
    port = int(run.expect(r"debugpy to host 127\.0\.0\.1, port (\d+)")[1])
    local, remote = run.expect(r"path mapping: (\S+) -> (\S+)").groups()
    assert Path(local) == source.parent
    run.expect("waits for the debugger")
    ide = Ide(port)
    ide.answer("initialize", adapterID="test", pathFormat="path")
    ide.ask("attach", pathMappings=[{"localRoot": local, "remoteRoot": remote}], justMyCode=False)
    ide.expect("event", "initialized")
    ide.answer("setBreakpoints", source={"path": str(source)}, breakpoints=[{"line": line}])
    ide.answer("configurationDone")
    stopped = ide.expect("event", "stopped")
    frame = ide.answer("stackTrace", threadId=stopped["threadId"])["stackFrames"][0]
    assert (frame["source"]["path"], frame["name"]) == (str(source), "get_infrared_data")
    value = ide.answer("evaluate", expression="num_of_sensor + 40", frameId=frame["id"], context="watch")
    assert value["result"] == "42"
    # The process may end before it answers.
    ide.ask("continue", threadId=stopped["threadId"])
    require_the_verdict_of_case_7(run)
    ide.close()


def test_the_scene_of_a_case_that_stands_still_is_served_to_those_who_know_its_address(terminal):
    pdb = terminal("run", "examples/ir-sensor-python-faulty", "--case", "7", "--debug", "--view")
    address = pdb.expect(r"scene: (http://127\.0\.0\.1:\d+/[0-9a-f]{32}/)")[1]
    pdb.expect(r"\(Pdb\) ")
    with urllib.request.urlopen(address + "case.json") as answer:
        case = json.load(answer)
    assert case["no"] == 7
    assert not case["ended"]
    assert {"name": "IndexOfSensor", "literal": "2"} in case["inputs"]
    with urllib.request.urlopen(address + "motion.glb") as answer:
        assert answer.read(4) == b"glTF"
        tag = answer.headers["ETag"]
    unchanged = urllib.request.Request(address + "motion.glb", headers={"If-None-Match": tag})
    assert status_of(unchanged) == 304
    root = address.rsplit("/", 2)[0]
    assert status_of(root + "/case.json") == 404
    assert status_of(f"{root}/{'0' * 32}/case.json") == 404
    assert status_of(address + "assets/../live.html") == 404
    assert status_of(urllib.request.Request(address, headers={"Host": "robot.example"})) == 404
    pdb.send("continue")
    require_the_verdict_of_case_7(pdb)


def status_of(request):
    try:
        with urllib.request.urlopen(request) as answer:
            return answer.status
    except urllib.error.HTTPError as error:
        return error.code


def test_a_scene_needs_a_debugger_and_a_world(sitaf):
    run = sitaf("run", "examples/ir-sensor", "--case", "7", "--view")
    assert run.returncode == 2
    assert "--view needs --debug" in run.stderr
    run = sitaf("run", "examples/heading", "--case", "1", "--debug", "--view")
    assert run.returncode == 2
    assert "--view: the activity has no world; leave --view out" in run.stderr


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
