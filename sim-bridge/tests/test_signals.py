"""Signals: what is sampled at each step, and that sampling changes nothing."""

from pathlib import Path

import mujoco
import pytest

from sitaf_bridge.errors import InvalidRequest, LimitReached
from sitaf_bridge.session.signals import SignalOrder, SignalStore
from sitaf_bridge.world.description.source import read_world
from sitaf_bridge.world.devices import Command
from sitaf_bridge.world.driving.signals import SignalRecording
from sitaf_bridge.world.driving.simulation import Simulation
from sitaf_bridge.world.world import World, load_world

MAZE = Path(__file__).parents[2] / "examples" / "worlds" / "maze" / "maze.world.yaml"
JOINT = MAZE.parents[2] / "joint-settling" / "world" / "joint.world.yaml"
FORWARD = Command("base", "drive", {"linear": 0.5, "angular": 0.2})


@pytest.fixture(scope="module")
def maze() -> World:
    return load_world(read_world(MAZE))


def recorded(world: World, *names: str, settling: bool = False) -> Simulation:
    simulation = Simulation(world)
    simulation.record_signals(names, settling)
    return simulation


def test_each_step_is_sampled_like_single_steps(maze: World) -> None:
    observation = next(iter(maze.observations))
    sampled, single = recorded(maze, observation, "base.linear"), Simulation(maze)
    expected = []
    for simulation in (sampled, single):
        simulation.prepare({}, 10 * maze.timestep_ns)
        simulation.write([FORWARD])
    call_ns = single.time_ns
    for step in range(21):
        if step:
            single.step(1)
        drive = next(r for r in single.state.readings if r.device.name == "base")
        expected.append((single.state.observations[observation], drive.values[0]))
    sampled.step(5)
    sampled.step(15)

    trace = sampled.signals(call_ns)

    assert trace.first_ns == 0
    assert trace.names == (observation, "base.linear")
    assert trace.values.tolist() == [list(row) for row in expected]
    assert sampled.digest() == single.digest()


@pytest.mark.parametrize("integrator", ["Euler", "RK4", "implicit", "implicitfast"])
def test_sampling_changes_no_bit_of_a_simulation(tmp_path: Path, integrator: str) -> None:
    for file in JOINT.parent.iterdir():
        text = file.read_text().replace('integrator="implicitfast"', f'integrator="{integrator}"')
        (tmp_path / file.name).write_text(text)
    world = load_world(read_world(tmp_path / JOINT.name))
    assert int(world.model.opt.integrator) == int(getattr(mujoco.mjtIntegrator, f"mjINT_{integrator.upper()}"))
    sampled, plain = recorded(world, *world.observations, "motor.effort"), Simulation(world)
    for simulation in (sampled, plain):
        simulation.prepare({}, 0)
        simulation.write([Command("motor", "joint", {"effort": 0.3})])
        simulation.step(700)
    assert sampled.digest() == plain.digest()
    assert len(sampled.signals(0).values) == 701


def test_a_command_shows_from_the_next_sample_on(maze: World) -> None:
    simulation = recorded(maze, "base.linear.command")
    simulation.prepare({}, 0)
    simulation.step(2)
    simulation.write([FORWARD])
    simulation.step(2)
    assert simulation.signals(0).values[:, 0].tolist() == [0, 0, 0, 0.5, 0.5]
    simulation.prepare({}, 0)
    simulation.step(1)
    assert simulation.signals(0).values[:, 0].tolist() == [0, 0]


def test_the_last_sample_is_the_state_at_the_end(maze: World) -> None:
    simulation = recorded(maze, "base.linear.command")
    simulation.prepare({}, 0)
    simulation.step(1)
    simulation.write([FORWARD])
    assert simulation.signals(0).values[:, 0].tolist() == [0, 0.5]


def test_the_ranges_of_a_scanner_are_sampled_by_index(maze: World) -> None:
    names = ("lidar.ranges[180]", "lidar.ranges[0]", "lidar.ranges[90]")
    sampled, single = recorded(maze, *names), Simulation(maze)
    for simulation in (sampled, single):
        simulation.prepare({}, 0)
        simulation.write([FORWARD])
    expected = []
    for step in range(4):
        if step:
            single.step(1)
        ranges = next(r for r in single.state.readings if r.device.name == "lidar").values
        expected.append([ranges[180], ranges[0], ranges[90]])
    sampled.step(3)

    assert sampled.signals(0).values.tolist() == expected
    assert sampled.digest() == single.digest()
    for name in ("lidar.ranges[181]", "lidar.ranges", "lidar.ranges.0", "lidar.ranges[-1]"):
        with pytest.raises(InvalidRequest, match="no signal"):
            recorded(maze, name)


def test_settling_is_sampled_on_demand(maze: World) -> None:
    observation = next(iter(maze.observations))
    settle = 4 * maze.timestep_ns
    for settling, samples in ((False, 3), (True, 7)):
        simulation = recorded(maze, observation, settling=settling)
        simulation.prepare({}, settle)
        simulation.step(2)
        trace = simulation.signals(settle)
        assert len(trace.values) == samples
        assert trace.first_ns == (-settle if settling else 0)


def test_names_that_exist_are_listed(maze: World) -> None:
    for name in ("bass.linear", "base.linear.command.x", "imu.linear.command", ""):
        with pytest.raises(InvalidRequest, match=r"signals of this world: .*base\.linear"):
            recorded(maze, name)


def test_too_many_numbers_are_an_error_of_the_case(maze: World) -> None:
    simulation = Simulation(maze)
    recording = SignalRecording(("base.linear.command",), False, maze, most=3)
    simulation._signals = recording
    simulation.prepare({}, 0)
    simulation.step(3)
    with pytest.raises(LimitReached, match="the limit of one case is 3 numbers"):
        simulation.signals(0)


def test_a_trace_that_a_component_adds_replaces_none(maze: World) -> None:
    simulation = recorded(maze, "base.linear.command")
    simulation.prepare({}, 0)
    store = SignalStore(SignalOrder(("base.linear.command",), False))
    first, second = simulation.signals(0), simulation.signals(0)
    store.keep(1, first)
    store.keep(1, second)
    assert store.take(1) == (first, 2)
    store.keep(1, second)
    with pytest.raises(InvalidRequest, match="taken already"):
        store.take(1)
    assert store.take(2) == (None, 0)
