"""Sessions: isolation, time, resets, leases, and errors that change nothing."""

import math
import subprocess
import sys
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

import grpc
import pytest

from sitaf_bridge.wire import simulation_pb2 as pb
from tests.client import Bridge, TestSession, ir_world, observed, ranges, running_bridge, world
from tests.conftest import Refused

INVALID = grpc.StatusCode.INVALID_ARGUMENT
OUT_OF_RANGE = grpc.StatusCode.OUT_OF_RANGE
NOT_FOUND = grpc.StatusCode.NOT_FOUND
EXHAUSTED = grpc.StatusCode.RESOURCE_EXHAUSTED

# A block that falls onto a floor and slides, with parameters of both sorts: of the model and of the state.
BLOCK = world(
    """
    <option timestep="0.001"/>
    <worldbody>
      <geom name="floor" type="plane" size="0 0 1"/>
      <body name="block" pos="0 0 0.1"><freejoint/>
        <geom name="block" type="box" size="0.1 0.1 0.1" mass="1" friction="0"/>
      </body>
    </worldbody>
    """,
    """
parameters:
  Pull: {unit: m/s^2, range: [-1e9, 1e9], default: 2, bind: {set: option.gravity.x}}
  Friction: {unit: "1", range: [0, 2], default: 1, bind: {set: geom.floor.friction.0}}
  Height: {unit: m, range: [-1, 5], default: 0.1, bind: {set: body.block.pos.z}}
observations:
  x: {entity: block, axis: x}
  z: {entity: block, axis: z}
""",
)


@pytest.fixture
def block(bridge: Bridge):
    session = bridge.create(BLOCK)
    yield session
    session.delete()


def test_two_sessions_never_influence_each_other(bridge: Bridge) -> None:
    first, second = bridge.create(BLOCK), bridge.create(BLOCK)
    alone = [observed(first.prepare(Friction=0.0, settle_ns=10**8 * i)) for i in range(4)]

    def disturb() -> None:
        for i in range(20):
            second.prepare(Friction=2.0, Pull=-5.0 * i, settle_ns=3 * 10**7)

    with ThreadPoolExecutor() as pool:
        disturbance = pool.submit(disturb)
        together = [observed(first.prepare(Friction=0.0, settle_ns=10**8 * i)) for i in range(4)]
        disturbance.result()
    assert together == alone
    assert first.parameters()["Pull"] == 2.0
    first.delete()
    second.delete()


def test_many_callers_of_one_session_take_turns(block: TestSession) -> None:
    with ThreadPoolExecutor(8) as pool:
        states = list(pool.map(lambda _: block.step(10).step, range(40)))
    assert sorted(states) == list(range(10, 401, 10))


def test_single_steps_equal_one_call_of_many(bridge: Bridge) -> None:
    once, often = bridge.create(BLOCK), bridge.create(BLOCK)
    last = often.read()
    for _ in range(300):
        last = often.step(1)
        assert often.read() == last
    assert once.step(300) == last
    assert (last.step, last.time_ns) == (300, 300_000_000)
    once.delete()
    often.delete()


def test_the_same_calls_give_the_same_bits_in_another_process(bridge: Bridge) -> None:
    def run(client: Bridge) -> bytes:
        session = client.create(BLOCK, seed=7)
        states = [session.prepare(Friction=0.1 * i, Height=0.3, settle_ns=4 * 10**8) for i in range(5)]
        states += [session.step(37), session.set(Pull=-3.0), session.step(50)]
        session.delete()
        return b"".join(state.SerializeToString(deterministic=True) for state in states)

    with running_bridge() as address:
        other = Bridge(address)
        assert run(other) == run(bridge)
        other.channel.close()


def test_friction_and_gravity_have_their_effect(block: TestSession) -> None:
    # Without friction a body under 2 m/s^2 covers t^2 metres; with friction 1 gravity cannot move it.
    sliding = observed(block.prepare(Friction=0.0, settle_ns=10**9))["x"]
    assert sliding == pytest.approx(1.0, rel=2e-3)
    assert observed(block.prepare(Friction=1.0, settle_ns=10**9))["x"] < 1e-2


@pytest.mark.parametrize("values", [{"Friction": 0.5, "Nope": 1.0}, {"Friction": 0.5, "Height": math.nan}])
def test_a_request_with_one_bad_value_changes_nothing(
    block: TestSession, refused: Refused, values: dict[str, float]
) -> None:
    block.prepare(Friction=0.2, settle_ns=10**8)
    before, parameters = block.read(), block.parameters()
    actions: list[Callable[..., object]] = [block.set, block.prepare]
    for action in actions:
        code, message = refused(lambda action=action: action(**values))
        assert code is INVALID
        assert "Nope" in message or "Height" in message
        assert (block.read(), block.parameters()) == (before, parameters)
    assert block.step(100) == _undisturbed(block, 100)


def test_a_value_out_of_range_changes_nothing(block: TestSession, refused: Refused) -> None:
    block.prepare(Friction=0.2, settle_ns=10**8)
    before = block.read()
    code, message = refused(lambda: block.set(Pull=1.0, Friction=2.5))
    assert code is OUT_OF_RANGE
    assert "Friction" in message
    assert "[0, 2]" in message
    assert block.read() == before
    assert block.step(100) == _undisturbed(block, 100)


def _undisturbed(block: TestSession, steps: int) -> pb.WorldState:
    fresh = block.bridge.create(BLOCK)
    fresh.prepare(Friction=0.2, settle_ns=10**8)
    state = fresh.step(steps)
    fresh.delete()
    return state


def test_reset_restores_the_scope(block: TestSession) -> None:
    start = block.read()
    block.set(Friction=0.0, Height=0.3)
    moved = block.step(200)

    timeless = block.reset(pb.RESET_SCOPE_TIME)
    assert (timeless.step, timeless.time_ns) == (0, 0)
    assert observed(timeless) == observed(moved)

    block.step(5)
    placed = block.reset(pb.RESET_SCOPE_STATE)
    assert placed.step == 5
    assert observed(placed) == {"x": 0.0, "z": 0.3}
    assert block.parameters()["Friction"] == 0.0

    assert block.reset(pb.RESET_SCOPE_ALL) == start
    assert block.parameters() == {"Pull": 2.0, "Friction": 1.0, "Height": 0.1}
    block.step(3)
    assert block.reset(pb.RESET_SCOPE_UNSPECIFIED) == start


def test_divergence_freezes_the_session_until_it_is_reset(block: TestSession, refused: Refused) -> None:
    start = block.read()
    block.set(Pull=1e9)
    assert refused(lambda: block.step(20_000))[0] is grpc.StatusCode.DATA_LOSS
    for action in (block.read, lambda: block.step(1), block.set, lambda: block.reset(pb.RESET_SCOPE_STATE)):
        code, message = refused(action)
        assert code is grpc.StatusCode.DATA_LOSS
        assert "RESET_SCOPE_ALL" in message
    assert block.reset(pb.RESET_SCOPE_ALL) == start


def test_malformed_requests_name_the_field(block: TestSession, refused: Refused) -> None:
    control = block.bridge.control
    calls = {
        "steps": lambda: block.step(0),
        "settle_ns": lambda: block.prepare(settle_ns=-1),
        "scope": lambda: control.ResetSimulation(pb.ResetSimulationRequest(session_id=block.id, scope=17)),  # type: ignore[arg-type]
        "session_id": lambda: control.RenewSession(pb.RenewSessionRequest()),
        "lease": lambda: block.bridge.create(BLOCK, lease_s=0.0),
        "Nope": lambda: block.parameters("Nope"),
        "world.description": lambda: block.bridge.describe(pb.WorldSource()),
    }
    for field, call in calls.items():
        code, message = refused(call)
        assert code is INVALID, field
        assert field in message


def test_limits_are_named(block: TestSession, refused: Refused) -> None:
    for call in (
        lambda: block.step(2**63),
        lambda: block.prepare(settle_ns=2**62),
        lambda: block.bridge.create(BLOCK, lease_s=1e7),
    ):
        code, message = refused(call)
        assert code is EXHAUSTED
        assert "limit" in message


def test_a_cancelled_call_is_undone(block: TestSession, refused: Refused) -> None:
    before = block.read()
    assert refused(lambda: block.step(10_000_000, timeout=0.3))[0] is grpc.StatusCode.DEADLINE_EXCEEDED
    assert block.read() == before


def test_a_deleted_session_is_not_found(bridge: Bridge, refused: Refused) -> None:
    session = bridge.create(ir_world())
    session.delete()
    for action in (session.read, session.delete, session.renew, session.reset, lambda: session.step(1)):
        assert refused(action)[0] is NOT_FOUND


@pytest.mark.slow
def test_every_call_renews_the_lease(bridge: Bridge, refused: Refused) -> None:
    kept, left = bridge.create(ir_world(), lease_s=0.6), bridge.create(ir_world(), lease_s=0.6)
    assert kept.created.lease.nanos == 600_000_000
    for _ in range(6):
        time.sleep(0.2)
        assert kept.renew() == 0.6
    assert set(ranges(kept.read()).values()) == {5.0}
    assert refused(left.read)[0] is NOT_FOUND
    time.sleep(0.8)
    assert refused(kept.read)[0] is NOT_FOUND


@pytest.mark.slow
def test_sessions_of_dead_clients_expire(refused: Refused) -> None:
    with running_bridge("--max-sessions", "2", "--default-lease", "0.5") as address:
        bridge = Bridge(address)
        for _ in range(2):
            bridge.create(ir_world())
        code, message = refused(lambda: bridge.create(ir_world()))
        assert code is EXHAUSTED
        assert "--max-sessions" in message
        time.sleep(0.8)
        bridge.create(ir_world()).delete()
        bridge.channel.close()


@pytest.mark.slow
def test_a_killed_client_loses_its_session_only(bridge: Bridge, ir: TestSession, refused: Refused) -> None:
    # The client process is killed.
    program = (
        "import sys, os; from tests.client import *; b = Bridge(sys.argv[1]);"
        "s = b.create(ir_world(), lease_s=1.0); print(s.id, flush=True); os.kill(os.getpid(), 9)"
    )
    died = subprocess.run([sys.executable, "-c", program, bridge.address], capture_output=True, text=True)
    orphan = TestSession(bridge, pb.CreateSessionResponse(session_id=died.stdout.strip()))
    assert set(ranges(orphan.read()).values()) == {5.0}
    time.sleep(1.3)
    assert refused(orphan.read)[0] is NOT_FOUND
    assert set(ranges(ir.read()).values()) == {5.0}
