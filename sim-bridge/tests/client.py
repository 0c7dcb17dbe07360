"""A client for tests: short names for the generated stubs, and worlds as text."""

from __future__ import annotations

import contextlib
import subprocess
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path

import grpc
from google.protobuf.duration_pb2 import Duration

from sitaf_bridge.wire import simulation_pb2 as pb
from sitaf_bridge.wire import simulation_pb2_grpc as pb_grpc

IR_WORLD = Path(__file__).parents[2] / "examples" / "ir-sensor" / "world"


@contextlib.contextmanager
def running_bridge(*options: str, listen: str = "127.0.0.1:0") -> Iterator[str]:
    """Start a bridge process; yields its address. It ends with the block, or with this process."""
    command = [sys.executable, "-m", "sitaf_bridge", "serve", "--listen", listen, "--stop-with-stdin", *options]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdin is not None
        assert process.stdout is not None
        try:
            word, _, address = process.stdout.readline().strip().partition(" ")
            assert word == "listening"
            yield address
        finally:
            process.stdin.close()
            process.wait(20)
            process.stdout.close()


class Bridge:
    """One channel to a bridge."""

    def __init__(self, address: str) -> None:
        self.address = address
        self.channel = grpc.insecure_channel(address)
        self.control = pb_grpc.SimulationControlStub(self.channel)
        self.hardware = pb_grpc.VirtualHardwareStub(self.channel)

    def create(self, world: pb.WorldSource, seed: int = 1, lease_s: float | None = None) -> TestSession:
        lease = None if lease_s is None else Duration(nanos=round(lease_s * 1e9) % 10**9, seconds=int(lease_s))
        request = pb.CreateSessionRequest(world=world, seed=seed, lease=lease)
        return TestSession(self, self.control.CreateSession(request))

    def describe(self, world: pb.WorldSource) -> pb.WorldDescription:
        return self.control.DescribeWorld(pb.DescribeWorldRequest(world=world)).world


class TestSession:
    """One session and its calls."""

    __test__ = False

    def __init__(self, bridge: Bridge, created: pb.CreateSessionResponse) -> None:
        self.bridge = bridge
        self.created = created
        self.id = created.session_id

    def prepare(self, settle_ns: int = 0, **parameters: float) -> pb.WorldState:
        request = pb.PrepareRequest(session_id=self.id, parameters=parameters, settle_ns=settle_ns)
        return self.bridge.control.Prepare(request).state

    def set(self, **values: float) -> pb.WorldState:
        request = pb.SetParametersRequest(session_id=self.id, values=values)
        return self.bridge.control.SetParameters(request).state

    def parameters(self, *names: str) -> dict[str, float]:
        request = pb.GetParametersRequest(session_id=self.id, names=names)
        return dict(self.bridge.control.GetParameters(request).values)

    def reset(self, scope: pb.ResetScope = pb.RESET_SCOPE_ALL) -> pb.WorldState:
        request = pb.ResetSimulationRequest(session_id=self.id, scope=scope)
        return self.bridge.control.ResetSimulation(request).state

    def step(self, steps: int, timeout: float | None = None) -> pb.WorldState:
        request = pb.StepSimulationRequest(session_id=self.id, steps=steps)
        return self.bridge.control.StepSimulation(request, timeout=timeout).state

    def read(self) -> pb.WorldState:
        return self.bridge.hardware.ReadDevices(pb.ReadDevicesRequest(session_id=self.id)).state

    def renew(self) -> float:
        answer = self.bridge.control.RenewSession(pb.RenewSessionRequest(session_id=self.id))
        return answer.lease.seconds + answer.lease.nanos / 1e9

    def delete(self) -> None:
        self.bridge.control.DeleteSession(pb.DeleteSessionRequest(session_id=self.id))


def ranges(state: pb.WorldState) -> dict[str, float]:
    return {reading.device: reading.range.range_m for reading in state.readings}


def observed(state: pb.WorldState) -> dict[str, float]:
    return {observation.name: observation.value for observation in state.observations}


def ir_world() -> pb.WorldSource:
    files = {path.name: path.read_bytes() for path in IR_WORLD.iterdir()}
    return pb.WorldSource(description="ir.world.yaml", files=files)


def world(mjcf: str, description: str = "", files: Mapping[str, bytes] | None = None) -> pb.WorldSource:
    """A world of one MJCF (the content of <mujoco>) and a description without its `mjcf:` line."""
    text = mjcf if mjcf.lstrip().startswith("<mujoco") else f"<mujoco>\n{mjcf}\n</mujoco>"
    all_files = {"w.world.yaml": f"mjcf: w.xml\n{description}".encode(), "w.xml": text.encode(), **(files or {})}
    return pb.WorldSource(description="w.world.yaml", files=all_files)
