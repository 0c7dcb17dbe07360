from collections.abc import Callable, Iterator

import grpc
import pytest

from tests.client import Bridge, TestSession, ir_world, running_bridge


@pytest.fixture(scope="session")
def bridge() -> Iterator[Bridge]:
    with running_bridge() as address:
        client = Bridge(address)
        yield client
        client.channel.close()


@pytest.fixture
def ir(bridge: Bridge) -> Iterator[TestSession]:
    session = bridge.create(ir_world())
    yield session
    session.delete()


Refused = Callable[[Callable[[], object]], tuple[grpc.StatusCode, str]]


@pytest.fixture
def refused() -> Refused:
    """Make a call that must be rejected; return the status code and the message."""

    def call(action: Callable[[], object]) -> tuple[grpc.StatusCode, str]:
        with pytest.raises(grpc.RpcError) as raised:
            action()
        error = raised.value
        assert isinstance(error, grpc.Call)
        return error.code(), error.details() or ""

    return call
