"""Packed states equal the encoding of message objects."""

import math
from pathlib import Path

import pytest

from sitaf_bridge.server.packing import state_message, with_state
from sitaf_bridge.server.readings import reading_message
from sitaf_bridge.wire import simulation_pb2 as pb
from sitaf_bridge.world.catalog import Catalog
from sitaf_bridge.world.description.source import read_world
from sitaf_bridge.world.driving.simulation import Simulation
from sitaf_bridge.world.sensing.faults import Fault, FaultKind
from sitaf_bridge.world.state import WorldState

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"


def built(state: WorldState) -> pb.WorldState:
    return pb.WorldState(
        step=state.step,
        time_ns=state.time_ns,
        readings=[reading_message(reading) for reading in state.readings],
        observations=[pb.Observation(name=n, value=v) for n, v in state.observations.items()],
    )


@pytest.mark.parametrize("world", ["ir-sensor/world/ir", "worlds/maze/maze"])
def test_a_packed_state_is_the_built_one(world: str) -> None:
    simulation = Simulation(Catalog().world(read_world(EXAMPLES / f"{world}.world.yaml")), 1)
    device = next(iter(simulation.state.readings)).device.name
    for _ in range(5):
        state = simulation.step(40)
        assert state_message(state) == built(state)
        assert state_message(state).SerializeToString() == built(state).SerializeToString()
        assert with_state(pb.StepSimulationResponse, state) == pb.StepSimulationResponse(state=built(state))
    dropped = simulation.set_faults(device, [Fault(FaultKind.DROPOUT)])
    assert math.isnan(dropped.readings[0].values[0])
    assert state_message(dropped).SerializeToString() == built(dropped).SerializeToString()
