"""Any input as a world gives a world or an error with its location."""

import random

import grpc
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.client import Bridge, TestSession, ir_world, ranges

FRAGMENTS = [
    b"<", b">", b"/>", b'"', b"=", b"\x00", b"\xff", b"1e999", b"nan", b"-1", b"999999999", b"<geom/>", b"<!--", b"-->",
    b"<![CDATA[", b"<?x?>", b"&amp;", b"&x;", b'file="/etc/passwd"', b'count="99999"', b"<replicate>", b"{", b"}", b"[",
    b"]", b":", b"- ", b"\n", b"*a", b"&a", b"!!map", b"body.robot.pos.z", b"body.robot.mass", b"geom.floor.size.0",
]  # fmt: skip


def mutate(content: bytes, choice: random.Random) -> bytes:
    """Cut, copy and insert some bytes."""
    for _ in range(choice.randint(1, 4)):
        start = choice.randrange(len(content) + 1)
        end = min(len(content), start + choice.choice([0, 1, 5, 40]))
        middle = choice.choice([b"", choice.choice(FRAGMENTS), content[start:end] * 2, bytes([choice.randrange(256)])])
        content = content[:start] + middle + content[end:]
    return content


@pytest.mark.slow
@settings(max_examples=150, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(seed=st.integers(0, 2**32), key=st.sampled_from(["ir.xml", "ir.world.yaml"]))
def test_a_damaged_world_does_not_affect_others(bridge: Bridge, ir: TestSession, seed: int, key: str) -> None:
    source = ir_world()
    source.files[key] = mutate(source.files[key], random.Random(seed))
    try:
        damaged = bridge.create(source)
        damaged.prepare(settle_ns=10**7)
        damaged.delete()
    except grpc.RpcError as error:
        assert isinstance(error, grpc.Call)
        assert error.code() in (
            grpc.StatusCode.INVALID_ARGUMENT, grpc.StatusCode.RESOURCE_EXHAUSTED, grpc.StatusCode.DATA_LOSS,
        )  # fmt: skip
        assert error.details()
    assert set(ranges(ir.read()).values()) == {5.0}
