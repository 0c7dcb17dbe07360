"""Hostile worlds are rejected or stopped by limits, and the bridge continues to run."""

from __future__ import annotations

import importlib.util
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import grpc
import pytest

from sitaf_bridge.wire import administration_pb2 as admin
from sitaf_bridge.wire import administration_pb2_grpc as admin_grpc
from sitaf_bridge.wire import simulation_pb2 as pb
from tests.client import IR_WORLD, Bridge, ir_world, ranges, running_bridge

pytestmark = pytest.mark.slow

HOSTILE = Path(__file__).parents[2] / "tests" / "faults" / "hostile" / "worlds.py"
LONGEST_S = 90.0
# Limit for all processes of a bridge, lower than that of an agent.
MOST_MEMORY_KIB = 1700 * 1024
REFUSALS = (grpc.StatusCode.INVALID_ARGUMENT, grpc.StatusCode.RESOURCE_EXHAUSTED)


def _hostile() -> list[tuple[str, dict[str, bytes], str]]:
    spec = importlib.util.spec_from_file_location("hostile_worlds", HOSTILE)
    assert spec is not None
    assert spec.loader is not None
    module: Any = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.worlds()


WORLDS = _hostile()


@pytest.fixture(scope="module")
def guarded() -> Iterator[Bridge]:
    """A bridge that no other test uses."""
    with running_bridge() as address:
        client = Bridge(address)
        yield client
        client.channel.close()


def _source(files: dict[str, bytes]) -> pb.WorldSource:
    """The files of the world's folder, as a build sends them."""
    all_files = {path.name: path.read_bytes() for path in IR_WORLD.iterdir()}
    all_files.update({path.removeprefix("world/"): content for path, content in files.items()})
    return pb.WorldSource(description="ir.world.yaml", files=all_files)


def _answer(guarded: Bridge, source: pb.WorldSource) -> tuple[grpc.StatusCode | None, str]:
    try:
        guarded.control.DescribeWorld(pb.DescribeWorldRequest(world=source), timeout=LONGEST_S)
    except grpc.RpcError as error:
        assert isinstance(error, grpc.Call)
        return error.code(), error.details() or ""
    return None, ""


def test_there_are_twenty_kinds_with_unique_names() -> None:
    names = [name for name, _, _ in WORLDS]
    assert len(set(names)) == len(names) >= 20


@pytest.mark.parametrize(("files", "outcome"), [pytest.param(f, o, id=n) for n, f, o in WORLDS])
def test_a_hostile_world_is_refused_or_limited(guarded: Bridge, files: dict[str, bytes], outcome: str) -> None:
    code, message = _answer(guarded, _source(files))
    if outcome == "refused":
        assert code in REFUSALS, message
        assert message.startswith(("ir.xml", "ir.world.yaml", "includes", "a.xml", "b.xml", "world.")), message
    elif outcome == "survived":
        assert code is None, message
    else:
        assert code is None or code in REFUSALS, message
    session = guarded.create(ir_world())
    assert set(ranges(session.read()).values()) == {5.0}
    session.delete()


def test_hostile_worlds_stay_within_the_memory_limit(guarded: Bridge) -> None:
    for name, files, _ in WORLDS:
        if "touch" in name or "pixels" in name:
            _answer(guarded, _source(files))
    peaks = [
        int(line.split()[1])
        for status in Path("/proc").glob("[0-9]*/status")
        if _is_bridge(status.parent)
        for line in _lines(status)
        if line.startswith("VmHWM")
    ]
    assert peaks
    assert max(peaks) < MOST_MEMORY_KIB


def _is_bridge(process: Path) -> bool:
    try:
        return b"sitaf_bridge\0serve" in (process / "cmdline").read_bytes()
    except OSError:
        return False


def _lines(path: Path) -> list[str]:
    try:
        return path.read_text().splitlines()
    except OSError:
        return []


class Endpoint:
    """An endpoint of a build's bridge."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def open(self, bridge: Bridge, name: str, digest: str) -> Bridge:
        stub = admin_grpc.SimulatorAdministrationStub(bridge.channel)
        return Bridge(stub.OpenEndpoint(admin.OpenEndpointRequest(name=name, world_digest=digest)).target)

    def close(self, bridge: Bridge, name: str) -> bool:
        stub = admin_grpc.SimulatorAdministrationStub(bridge.channel)
        return stub.CloseEndpoint(admin.CloseEndpointRequest(name=name)).idle


@pytest.fixture
def build(tmp_path: Path) -> Iterator[tuple[Bridge, Endpoint]]:
    with running_bridge("--endpoints", str(tmp_path), listen=f"unix:{tmp_path}/control") as address:
        client = Bridge(address)
        yield client, Endpoint(tmp_path)
        client.channel.close()


def _refusal(call: Any) -> grpc.StatusCode:
    with pytest.raises(grpc.RpcError) as raised:
        call()
    error = raised.value
    assert isinstance(error, grpc.Call)
    return error.code()


def test_an_endpoint_offers_one_session_and_the_world_of_the_build(build: tuple[Bridge, Endpoint]) -> None:
    bridge, endpoints = build
    digest = bridge.describe(ir_world()).digest
    reached = endpoints.open(bridge, "e1", digest)
    session = reached.create(ir_world())
    assert set(ranges(session.read()).values()) == {5.0}
    assert _refusal(lambda: reached.create(ir_world())) is grpc.StatusCode.RESOURCE_EXHAUSTED
    other = ir_world()
    other.files["more.txt"] = b"."
    assert _refusal(lambda: reached.describe(other)) is grpc.StatusCode.PERMISSION_DENIED
    assert _refusal(lambda: reached.create(other)) is grpc.StatusCode.PERMISSION_DENIED
    assert _refusal(lambda: endpoints.open(reached, "e2", digest)) is grpc.StatusCode.UNIMPLEMENTED
    session.delete()
    reached.create(ir_world())
    reached.channel.close()


def test_sessions_of_one_endpoint_are_unknown_at_another(build: tuple[Bridge, Endpoint]) -> None:
    bridge, endpoints = build
    digest = bridge.describe(ir_world()).digest
    first, second = (endpoints.open(bridge, name, digest) for name in ("e1", "e2"))
    session = first.create(ir_world())
    request = pb.DeleteSessionRequest(session_id=session.id)
    for other in (second, bridge):
        assert _refusal(lambda other=other: other.control.DeleteSession(request)) is grpc.StatusCode.NOT_FOUND
    assert endpoints.close(bridge, "e1")
    assert _refusal(session.read) is grpc.StatusCode.UNAVAILABLE
    assert not (endpoints.folder / "e1").exists()
    assert not (endpoints.folder / "e1.ops").exists()
    assert set(ranges(second.create(ir_world()).read()).values()) == {5.0}
    for one in (first, second):
        one.channel.close()


def test_names_of_endpoints_are_checked(build: tuple[Bridge, Endpoint]) -> None:
    bridge, endpoints = build
    for name in ("", "../e", "a/b", "e" * 17):
        code = _refusal(lambda name=name: endpoints.open(bridge, name, "0"))
        assert code is grpc.StatusCode.INVALID_ARGUMENT
    endpoints.open(bridge, "e1", "0").channel.close()
    assert _refusal(lambda: endpoints.open(bridge, "e1", "0")) is grpc.StatusCode.INVALID_ARGUMENT
    assert endpoints.close(bridge, "e1")
    assert _refusal(lambda: endpoints.close(bridge, "e1")) is grpc.StatusCode.NOT_FOUND
