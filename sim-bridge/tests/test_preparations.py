"""A component that resets its own world is noticed."""

from collections.abc import Callable
from pathlib import Path

import pytest

from sitaf_bridge.errors import InvalidRequest
from sitaf_bridge.server.operations import operate
from sitaf_bridge.session.session import Session
from sitaf_bridge.session.signals import SignalOrder, SignalStore
from sitaf_bridge.wire import simulation_pb2 as pb
from sitaf_bridge.world.description.source import read_world
from sitaf_bridge.world.world import load_world

WORLD = Path(__file__).parents[2] / "examples" / "joint-settling" / "world" / "joint.world.yaml"


@pytest.fixture
def session() -> Session:
    return Session("1", load_world(read_world(WORLD)), 0, 60)


def call(session: Session, rpc: str, request: object) -> object:
    with session.simulation() as simulation:
        return operate(session, simulation, rpc, request, lambda: True)  # type: ignore[arg-type]


def prepare(session: Session, no: int) -> None:
    call(session, "Prepare", pb.PrepareRequest(case_no=no))


def restore(session: Session) -> None:
    taken = call(session, "TakeSnapshot", pb.TakeSnapshotRequest())
    call(session, "RestoreSnapshot", pb.RestoreSnapshotRequest(snapshot_id=taken.snapshot_id))  # type: ignore[attr-defined]


def reset(session: Session) -> None:
    call(session, "ResetSimulation", pb.ResetSimulationRequest(scope=pb.RESET_SCOPE_TIME))


def again(session: Session) -> None:
    prepare(session, 2)


def with_another(session: Session) -> None:
    prepare(session, 3)


def back_and_forth(session: Session) -> None:
    prepare(session, 3)
    prepare(session, 2)


def test_each_case_is_prepared_once(session: Session) -> None:
    for no in (1, 2, 3):
        prepare(session, no)
        call(session, "StepSimulation", pb.StepSimulationRequest(steps=2))
        session.preparations.check(no)


@pytest.mark.parametrize("interfere", [reset, restore, again, with_another, back_and_forth])
def test_a_reset_in_a_case_is_noticed(session: Session, interfere: Callable[[Session], None]) -> None:
    prepare(session, 1)
    prepare(session, 2)
    interfere(session)
    with pytest.raises(InvalidRequest, match="the component may have reset the simulation"):
        session.preparations.check(2)


def test_other_cases_are_not_affected(session: Session) -> None:
    prepare(session, 1)
    reset(session)
    prepare(session, 2)
    session.preparations.check(2)


def test_a_case_that_was_not_prepared_has_no_signals(session: Session) -> None:
    with pytest.raises(InvalidRequest, match="prepared for case 0, not for case 1"):
        session.preparations.check(1)


@pytest.mark.parametrize("forged_first", [True, False])
def test_signals_that_a_component_keeps_do_not_replace_an_error(session: Session, forged_first: bool) -> None:
    with session.simulation() as simulation:
        simulation.record_signals(("t",), False)
    prepare(session, 1)
    with session.simulation() as simulation:
        forged = simulation.signals(0)
    store = SignalStore(SignalOrder(("t",), False))
    error = InvalidRequest("reset")
    store.keep(1, forged if forged_first else error)
    store.keep(1, error if forged_first else forged)
    if forged_first:
        # The agent rejects signals that were kept twice.
        assert store.take(1) == (forged, 2)
    else:
        with pytest.raises(InvalidRequest, match="reset"):
            store.take(1)
