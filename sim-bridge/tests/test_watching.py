"""What `ShowMotion` shows of a case that runs, and that showing it changes nothing."""

from pathlib import Path

import pytest

from sitaf_bridge.errors import NoSuchEndpoint, NoSuchSession, WrongState
from sitaf_bridge.server.endpoints import Endpoint, Endpoints
from sitaf_bridge.world.catalog import Catalog
from sitaf_bridge.world.description.source import read_world
from sitaf_bridge.world.devices import Command
from sitaf_bridge.world.driving.simulation import Simulation
from sitaf_bridge.world.world import load_world

MAZE = Path(__file__).parents[2] / "examples" / "worlds" / "maze" / "maze.world.yaml"
FORWARD = Command("base", "drive", {"linear": 0.5, "angular": 0.2})


def driven(simulation: Simulation) -> None:
    simulation.prepare({}, 0)
    simulation.record_motion(20_000_000, 0)
    simulation.write([FORWARD])
    simulation.step(100)


def test_the_motion_so_far_is_shown_and_the_recording_goes_on() -> None:
    world = load_world(read_world(MAZE))
    shown, plain = Simulation(world), Simulation(world)
    for simulation in (shown, plain):
        driven(simulation)
    assert len(shown.show_motion()) > len(Simulation(world).scene())
    assert shown.show_motion() == shown.show_motion()
    for simulation in (shown, plain):
        simulation.step(57)
    assert shown.show_motion() == plain.take_motion()[0]
    assert shown.digest() == plain.digest()


@pytest.fixture
def endpoints(tmp_path: Path) -> Endpoints:
    return Endpoints(tmp_path, Catalog(), 60.0, 2)


def test_only_an_endpoint_with_a_session_that_records_shows_something(endpoints: Endpoints) -> None:
    source = read_world(MAZE)
    endpoints.open("e1", source.digest)
    try:
        with pytest.raises(NoSuchEndpoint, match="there is no endpoint 'e2'"):
            endpoints.show_motion("e2", 0)
        with pytest.raises(NoSuchSession, match="the endpoint has no session"):
            endpoints.show_motion("e1", 0)
    finally:
        endpoints.close()


def test_a_state_is_shown_once(tmp_path: Path) -> None:
    source = read_world(MAZE)
    endpoint = Endpoint(tmp_path / "e1", Catalog(), 60.0, 2)
    try:
        session = endpoint.sessions.create(load_world(source), 1, None)
        with pytest.raises(WrongState, match="call RecordMotion first"):
            endpoint.show_motion(0)
        with session.simulation() as simulation:
            driven(simulation)
        shown, version = endpoint.show_motion(0)
        assert shown[:4] == b"glTF"
        assert endpoint.show_motion(version) == (b"", version)
        assert endpoint.show_motion(0) == (shown, version)
        with session.simulation() as simulation:
            simulation.step(1)
        later, next_version = endpoint.show_motion(version)
        assert next_version == version + 1
        assert later != shown
    finally:
        endpoint.close()
