"""Steps whose readings nobody needs: many in one request leave behind what one request after the other does."""

from collections.abc import Callable, Mapping
from pathlib import Path

import pytest

from sitaf_bridge.errors import Diverged, InvalidRequest, LimitReached, UnreachableValue
from sitaf_bridge.world.description.source import read_world
from sitaf_bridge.world.devices import Command
from sitaf_bridge.world.driving.checking import MAX_RUNS
from sitaf_bridge.world.driving.simulation import Simulation
from sitaf_bridge.world.sensing.faults import Fault, FaultKind
from sitaf_bridge.world.world import World, load_world

MAZE = Path(__file__).parents[2] / "examples" / "worlds" / "maze" / "maze.world.yaml"
# Steps and speed of a base, in turn.
PARTS = [(1 + part % 7, 0.05 * (part % 11)) for part in range(60)]


@pytest.fixture(scope="module")
def maze() -> World:
    return load_world(read_world(MAZE))


def forward(speed: float) -> list[Command]:
    return [Command("base", "drive", {"linear": speed, "angular": speed / 2})]


def sampled(simulation: Simulation) -> None:
    simulation.record_signals(["base.linear", "base.linear.command", "lidar.ranges[5]"], settling=False)


def filmed(simulation: Simulation) -> None:
    simulation.record_motion(20_000_000, 0)


def delayed(simulation: Simulation) -> None:
    simulation.set_faults("lidar", [Fault(FaultKind.DELAY, 0.03)])


def nothing(_: Simulation) -> None:
    pass


@pytest.mark.parametrize("option", [nothing, sampled, filmed, delayed])
@pytest.mark.parametrize(
    "faults",
    [
        {},
        {"fault.lidar.stuck": 1.0, "fault.lidar.stuck.at": 0.1, "fault.lidar.stuck.for": 0.2},
        {"fault.base.ignored": 1.0, "fault.base.ignored.at": 0.16, "fault.base.ignored.for": 0.04},
        {"fault.lidar.delay": 0.05, "fault.lidar.delay.at": 0.1},
    ],
)
def test_many_in_one_request_are_as_one_after_the_other(
    maze: World, option: Callable[[Simulation], None], faults: Mapping[str, float]
) -> None:
    single, together = Simulation(maze), Simulation(maze)
    for simulation in (single, together):
        simulation.prepare(faults, 10 * maze.timestep_ns)
        option(simulation)
    call_ns = single.time_ns
    for steps, speed in PARTS:
        single.step(steps, commands=forward(speed))
    (steps, speed), *later = PARTS
    together.step(steps, commands=forward(speed), later=[(count, forward(speed)) for count, speed in later])

    assert together.state.step == single.state.step == 10 + sum(count for count, _ in PARTS)
    assert together.digest() == single.digest()
    if option is sampled:
        assert together.signals(call_ns).values.tolist() == single.signals(call_ns).values.tolist()
    if option is filmed:
        assert together.take_motion() == single.take_motion()


def test_a_command_that_is_refused_undoes_all(maze: World) -> None:
    simulation = Simulation(maze)
    before = simulation.digest()
    with pytest.raises(UnreachableValue, match="wheel in rad/s"):
        simulation.step(5, commands=forward(0.1), later=[(5, forward(0.2)), (5, forward(1e6))])
    assert simulation.digest() == before
    assert simulation.state.step == 0


def test_a_divergence_is_found_where_it_happens(tmp_path: Path) -> None:
    (tmp_path / "w.xml").write_text(
        '<mujoco><option timestep="0.1"/><worldbody><body><joint name="j" axis="0 0 1"/><geom size="0.1"/></body>'
        '</worldbody><actuator><motor name="m" joint="j"/></actuator></mujoco>'
    )
    (tmp_path / "w.world.yaml").write_text("mjcf: w.xml\ndevices:\n  m: {kind: joint_motor, actuator: m}\n")
    world = load_world(read_world(tmp_path / "w.world.yaml"))
    violent = [Command("m", "joint", {"effort": 1e12})]

    def one_after_the_other(simulation: Simulation) -> None:
        simulation.step(1)
        simulation.step(1, commands=violent)
        for _ in range(50):
            simulation.step(1)

    def together(simulation: Simulation) -> None:
        simulation.step(1, later=[(1, violent), *[(1, ())] * 50])

    with pytest.raises(Diverged) as expected:
        one_after_the_other(Simulation(world))
    with pytest.raises(Diverged) as found:
        together(Simulation(world))
    assert str(found.value) == str(expected.value)


def test_there_are_limits(maze: World) -> None:
    simulation = Simulation(maze)
    with pytest.raises(LimitReached, match="later: 1001 entries; the limit is 1000"):
        simulation.step(1, later=[(1, ())] * MAX_RUNS)
    with pytest.raises(InvalidRequest, match="steps: must be at least 1"):
        simulation.step(1, later=[(1, ()), (0, ())])
    with pytest.raises(LimitReached, match="steps in one call"):
        simulation.step(1, later=[(2**40, ())])
    assert simulation.state.step == 0
