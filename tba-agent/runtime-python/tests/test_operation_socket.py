"""The client of the socket of operations, with a server that answers with the number of steps."""

import socket
import struct
import threading

import grpc
import pytest

from sitaf_runtime.simulation.wire.operations import OperationSocket, Refused
from sitaf_runtime.simulation.wire.sitaf.sim.v1 import simulation_pb2 as pb

LENGTH = struct.Struct("<I")
REFUSED, UNANSWERED, LAST = 13, 14, 15


def answer(request):
    if request.step.steps == REFUSED:
        return pb.OperateResponse(refusal=pb.Refusal(code=11, message="too far"))
    return pb.OperateResponse(state=pb.WorldState(step=request.step.steps))


def serve(connection):
    with connection:
        while header := connection.recv(4):
            (length,) = LENGTH.unpack(header)
            message = b""
            while len(message) < length:
                message += connection.recv(length - len(message))
            request = pb.OperateRequest.FromString(message)
            if request.step.steps == LAST:
                return
            if request.step.steps != UNANSWERED:
                frame = answer(request).SerializeToString()
                for byte in LENGTH.pack(len(frame)) + frame:
                    connection.send(bytes([byte]))


@pytest.fixture
def path(tmp_path):
    with socket.socket(socket.AF_UNIX) as listener:
        listener.bind(str(tmp_path / "s.ops"))
        listener.listen()

        def accept():
            while True:
                try:
                    connection, _ = listener.accept()
                except OSError:
                    return
                threading.Thread(target=serve, args=(connection,), daemon=True).start()

        threading.Thread(target=accept, daemon=True).start()
        yield str(tmp_path / "s.ops")
        listener.shutdown(socket.SHUT_RDWR)


def step(steps, session=""):
    return "step", pb.StepSimulationRequest(steps=steps, session_id=session)


def test_operations_are_answered_and_refusals_have_the_status_of_a_call(path):
    connection = OperationSocket(path)
    assert connection.operate(*step(1), 20).state.step == 1
    with pytest.raises(Refused) as raised:
        connection.operate(*step(REFUSED), 20)
    assert (raised.value.code(), raised.value.details()) == (grpc.StatusCode.OUT_OF_RANGE, "too far")
    assert connection.operate(*step(2, "s" * 1_000_000), 20).state.step == 2
    connection.close()


def test_a_late_answer_is_not_that_of_the_next_operation(path):
    connection = OperationSocket(path)
    with pytest.raises(Refused) as raised:
        connection.operate(*step(UNANSWERED), 0.2)
    assert raised.value.code() is grpc.StatusCode.DEADLINE_EXCEEDED
    assert connection.operate(*step(3), 20).state.step == 3
    connection.close()


def test_a_simulator_that_has_gone_is_unavailable(path):
    connection = OperationSocket(path)
    with pytest.raises(Refused) as raised:
        connection.operate(*step(LAST), 20)
    assert raised.value.code() is grpc.StatusCode.UNAVAILABLE
    connection.close()


def test_without_a_server_there_is_none(tmp_path):
    for path in (tmp_path / "none", tmp_path / ("x" * 200)):
        with pytest.raises(OSError, match=r"No such file|too long"):
            OperationSocket(str(path))
