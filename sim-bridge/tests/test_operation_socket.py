"""The socket of operations: the same answers as unary calls, and clients that do not follow the protocol."""

from __future__ import annotations

import contextlib
import socket
import struct
import threading
import time
from collections.abc import Iterator
from pathlib import Path

import grpc
import pytest

from sitaf_bridge.server.operation_socket import MAX_FRAME_BYTES, path_of_operations
from sitaf_bridge.wire import simulation_pb2 as pb
from tests.client import Bridge, TestSession, ir_world, running_bridge, world

ARM = """<worldbody><body name="arm"><joint name="j" damping="1"/><geom size="0.1"/></body></worldbody>
<actuator><motor name="m" joint="j" ctrlrange="-5 5"/></actuator>"""
DEVICES = """devices:
  motor: {kind: joint_motor, actuator: m}
"""
LENGTH = struct.Struct("<I")
PING = pb.OperateRequest(ping=pb.PingRequest())
# Takes half a minute.
LONG = 10_000_000


@pytest.fixture(scope="module")
def bridge(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Bridge]:
    path = tmp_path_factory.mktemp("b") / "s"
    with running_bridge("--max-sessions", "8", listen=f"unix:{path}") as address:
        client = Bridge(address)
        yield client
        client.channel.close()


@pytest.fixture
def arm(bridge: Bridge) -> Iterator[TestSession]:
    session = bridge.create(world(ARM, DEVICES))
    yield session
    session.delete()


class Line:
    """A connection to the socket of operations of a bridge."""

    def __init__(self, bridge: Bridge) -> None:
        path = path_of_operations(Path(bridge.address.removeprefix("unix:")))
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.settimeout(20)
        self.socket.connect(str(path))

    def __enter__(self) -> Line:
        return self

    def __exit__(self, *_: object) -> None:
        self.socket.close()

    def send(self, request: pb.OperateRequest) -> None:
        message = request.SerializeToString()
        self.socket.sendall(LENGTH.pack(len(message)) + message)

    def receive(self) -> pb.OperateResponse:
        (length,) = LENGTH.unpack(self.read(LENGTH.size))
        return pb.OperateResponse.FromString(self.read(length))

    def read(self, length: int) -> bytes:
        read = b""
        while len(read) < length:
            piece = self.socket.recv(length - len(read))
            if not piece:
                raise EOFError
            read += piece
        return read

    def ask(self, **operation: object) -> pb.OperateResponse:
        self.send(pb.OperateRequest(**operation))  # pyright: ignore[reportArgumentType]
        return self.receive()

    def is_closed(self) -> bool:
        with contextlib.suppress(ConnectionError):
            return self.socket.recv(1) == b""
        return True


def effort(value: float) -> list[pb.DeviceCommand]:
    return [pb.DeviceCommand(device="motor", joint=pb.JointCommand(effort=value))]


def test_operations_answer_as_unary_calls(bridge: Bridge, arm: TestSession) -> None:
    assert arm.created.operation_socket
    other = bridge.create(world(ARM, DEVICES))
    with Line(bridge) as line:
        assert line.ask(prepare=pb.PrepareRequest(session_id=other.id)).state == arm.prepare()
        for value in (1.0, -2.0, 0.5):
            step = pb.StepSimulationRequest(session_id=other.id, steps=3, commands=effort(value))
            mine = pb.StepSimulationRequest(session_id=arm.id, steps=3, commands=effort(value))
            assert line.ask(step=step).state == bridge.control.StepSimulation(mine).state
        write = pb.WriteDevicesRequest(session_id=other.id, commands=effort(1))
        mine_written = pb.WriteDevicesRequest(session_id=arm.id, commands=effort(1))
        assert line.ask(write=write).state == bridge.hardware.WriteDevices(mine_written).state
        read = pb.ReadDevicesRequest(session_id=other.id, devices=["motor"])
        assert line.ask(read=read).state.readings == arm.read().readings
    other.delete()


def test_a_rejected_operation_has_the_code_and_message_of_the_unary_call(bridge: Bridge, arm: TestSession) -> None:
    with Line(bridge) as line:
        step = pb.StepSimulationRequest(session_id=arm.id, steps=1, commands=effort(9))
        with pytest.raises(grpc.RpcError) as raised:
            bridge.control.StepSimulation(step)
        error = raised.value
        assert isinstance(error, grpc.Call)
        refusal = line.ask(step=step).refusal
        assert (refusal.code, refusal.message) == (error.code().value[0], error.details())
        assert line.ask(step=pb.StepSimulationRequest(session_id="gone", steps=1)).refusal.code == 5
        assert line.ask().refusal.message == "operation is missing"
        # The connection still works.
        assert line.ask(step=pb.StepSimulationRequest(session_id=arm.id, steps=1)).state.step == 1


def test_requests_are_answered_in_order_even_if_they_arrive_in_pieces(bridge: Bridge, arm: TestSession) -> None:
    with Line(bridge) as line:
        message = pb.OperateRequest(step=pb.StepSimulationRequest(session_id=arm.id, steps=1)).SerializeToString()
        for byte in LENGTH.pack(len(message)) + message:
            line.socket.sendall(bytes([byte]))
        for _ in range(2):
            line.send(pb.OperateRequest(step=pb.StepSimulationRequest(session_id=arm.id, steps=1)))
        assert [line.receive().state.step for _ in range(3)] == [1, 2, 3]


@pytest.mark.parametrize(
    "sent",
    [LENGTH.pack(MAX_FRAME_BYTES + 1), LENGTH.pack(3) + b"\xff\xff\xff", LENGTH.pack(0xFFFFFFFF)],
    ids=["too long", "no message", "longest length"],
)
def test_what_is_no_frame_ends_its_connection_only(bridge: Bridge, sent: bytes) -> None:
    with Line(bridge) as line, Line(bridge) as other:
        line.socket.sendall(sent)
        assert line.is_closed()
        assert other.ask(ping=pb.PingRequest()) == pb.OperateResponse()


def test_an_announced_length_takes_no_memory(bridge: Bridge) -> None:
    with contextlib.ExitStack() as stack:
        lines = [stack.enter_context(Line(bridge)) for _ in range(4)]
        for line in lines:
            line.socket.sendall(LENGTH.pack(MAX_FRAME_BYTES) + b"x")
        with Line(bridge) as other:
            assert other.ask(ping=pb.PingRequest()) == pb.OperateResponse()


def test_the_end_of_a_connection_cancels_its_operation_which_is_undone(bridge: Bridge, arm: TestSession) -> None:
    line = Line(bridge)
    line.send(pb.OperateRequest(step=pb.StepSimulationRequest(session_id=arm.id, steps=LONG)))
    time.sleep(0.3)
    line.socket.close()
    began = time.monotonic()
    assert arm.step(1).step == 1
    assert time.monotonic() - began < 10


def test_connections_beyond_the_limit_are_closed_and_can_be_made_later(bridge: Bridge) -> None:
    with contextlib.ExitStack() as stack:
        for _ in range(8):
            assert stack.enter_context(Line(bridge)).ask(ping=pb.PingRequest()) == pb.OperateResponse()
        assert stack.enter_context(Line(bridge)).is_closed()
    for _ in range(50):
        # The threads of the closed connections need a moment.
        with contextlib.suppress(OSError, EOFError), Line(bridge) as line:
            assert line.ask(ping=pb.PingRequest()) == pb.OperateResponse()
            return
        time.sleep(0.1)
    pytest.fail("no connection was accepted")


def test_connections_share_a_session(bridge: Bridge, arm: TestSession) -> None:
    def advance() -> None:
        with Line(bridge) as line:
            for _ in range(50):
                line.ask(step=pb.StepSimulationRequest(session_id=arm.id, steps=1))

    threads = [threading.Thread(target=advance) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert arm.step(1).step == 201


def test_a_bridge_that_ends_ends_a_running_operation(tmp_path: Path) -> None:
    with running_bridge(listen=f"unix:{tmp_path}/s") as address:
        client = Bridge(address)
        session = client.create(world(ARM, DEVICES))
        line = Line(client)
        line.send(pb.OperateRequest(step=pb.StepSimulationRequest(session_id=session.id, steps=LONG)))
        time.sleep(0.3)
        client.channel.close()
    with line, contextlib.suppress(EOFError, ConnectionError):
        assert line.receive().refusal.code == grpc.StatusCode.CANCELLED.value[0]
    assert not list(tmp_path.iterdir())


def test_a_killed_bridge_does_not_block_the_next_one(tmp_path: Path) -> None:
    left = tmp_path / "s.ops"
    with socket.socket(socket.AF_UNIX) as one:
        one.bind(str(left))
    assert left.exists()
    with running_bridge(listen=f"unix:{tmp_path}/s") as address, Line(Bridge(address)) as line:
        assert line.ask(ping=pb.PingRequest()) == pb.OperateResponse()


def test_a_file_at_its_path_is_not_deleted(tmp_path: Path) -> None:
    (tmp_path / "s.ops").write_text("mine")
    with pytest.raises(AssertionError), running_bridge(listen=f"unix:{tmp_path}/s"):
        pass
    assert (tmp_path / "s.ops").read_text() == "mine"


def test_other_addresses_have_none(tmp_path: Path) -> None:
    long = tmp_path / ("x" * (106 - len(str(tmp_path))))
    for listen in ("127.0.0.1:0", f"unix:{long}"):
        with running_bridge(listen=listen) as address:
            client = Bridge(address)
            assert not client.create(ir_world()).created.operation_socket
            client.channel.close()
