"""What a component commands within one tick travels with that tick's one exchange."""

import importlib.util
import math
import random
import subprocess
import sys

import grpc
import pytest

from sitaf_runtime.simulation.session import Simulation
from sitaf_runtime.simulation.wire.service import client
from sitaf_runtime.simulation.wire.sitaf.sim.v1 import simulation_pb2 as pb
from sitaf_runtime.stopwatch import Stopwatch

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(importlib.util.find_spec("sitaf_bridge") is None, reason="sim-bridge is not installed here"),
]
MJCF = """<mujoco><option timestep="0.002" gravity="0 0 0"/><worldbody>
  <body><joint name="a" axis="0 0 1"/><geom size="0.1"/></body>
  <body pos="1 0 0"><joint name="b" axis="0 0 1"/><geom size="0.1"/></body></worldbody>
<actuator><motor name="a" joint="a" ctrlrange="-3 3"/><motor name="b" joint="b"/></actuator></mujoco>"""
YAML = """mjcf: w.xml
observations:
  A: {device: a, field: effort}
devices:
  a: {kind: joint_motor, actuator: a}
  b: {kind: joint_motor, actuator: b}
  lamp: {kind: digital_io}
"""
DRIVE_MJCF = """<mujoco><option timestep="0.002"/><worldbody><body><freejoint/><geom size="0.1"/>
  <body pos="0 0.2 0"><joint name="l" axis="0 1 0"/><geom size="0.1"/></body>
  <body pos="0 -0.2 0"><joint name="r" axis="0 1 0"/><geom size="0.1"/></body></body></worldbody>
<actuator><velocity name="l" joint="l" kv="1" ctrlrange="-10 10"/>
  <velocity name="r" joint="r" kv="1" ctrlrange="-10 10"/></actuator></mujoco>"""
DRIVE_YAML = """mjcf: w.xml
devices:
  base: {kind: differential_drive, left: l, right: r, wheel_radius: 0.1, track: 0.4}
"""


@pytest.fixture
def target():
    command = [sys.executable, "-m", "sitaf_bridge", "serve", "--stop-with-stdin"]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as process:
        yield process.stdout.readline().split()[1]
        process.stdin.close()
        process.wait(20)
        process.stdout.close()


@pytest.fixture
def simulation(target, tmp_path):
    (tmp_path / "w.world.yaml").write_text(YAML)
    (tmp_path / "w.xml").write_text(MJCF)
    opened = Simulation(target, tmp_path / "w.world.yaml", 1, Stopwatch())
    opened.prepare({})
    yield opened
    opened.close()


@pytest.fixture
def exchanges(target):
    """Counts the exchanges of a kind so far."""
    with grpc.insecure_channel(target) as channel:
        control = client(channel, pb.DESCRIPTOR, "SimulationControl")

        def count(rpc):
            operations = control.GetStatistics(pb.GetStatisticsRequest()).operations
            return sum(operation.count for operation in operations if operation.rpc == rpc)

        yield count


def test_a_tick_with_several_commands_is_one_exchange(simulation, exchanges):
    a, b = simulation.hardware.joint_motor("a"), simulation.hardware.joint_motor("b")

    def tick():
        a.set_effort(1 - a.position())
        b.set_effort(-1 - b.velocity())

    simulation.every(0.004, tick)
    simulation.advance(0.4)
    assert (exchanges("StepSimulation"), exchanges("WriteDevices")) == (100, 0)
    assert a.position() > 0 > b.position()


def test_a_reading_after_a_command_within_one_tick_shows_its_effect(simulation, exchanges):
    a, lamp = simulation.hardware.joint_motor("a"), simulation.hardware.digital_line("lamp")
    a.set_effort(2)
    assert (a.position(), exchanges("WriteDevices")) == (0, 0)
    assert (a.effort(), exchanges("WriteDevices")) == (2, 1)
    lamp.set(True)
    assert lamp.is_high()
    a.set_effort(-1)
    assert simulation.observation("A") == -1


def test_the_last_command_counts_and_a_new_case_forgets_commands(simulation):
    a = simulation.hardware.joint_motor("a")
    a.set_effort(3)
    a.set_effort(-3)
    simulation.advance(0.1)
    assert a.position() < 0
    a.set_effort(3)
    simulation.prepare({})
    simulation.advance(0.1)
    assert (a.position(), a.effort()) == (0, 0)


@pytest.mark.parametrize("wrong", [3.5, math.nan, math.inf])
def test_a_wrong_command_is_refused_at_the_call_and_earlier_ones_stay(simulation, wrong):
    a, b = simulation.hardware.joint_motor("a"), simulation.hardware.joint_motor("b")
    b.set_effort(1)
    with pytest.raises(ValueError, match=r"a\.effort"):
        a.set_effort(wrong)
    with pytest.raises(ValueError, match="a takes effort, not position"):
        a.set_position(0)
    assert (a.effort(), b.effort()) == (0, 1)


def test_more_commands_than_fit_are_sent_in_between(simulation, exchanges):
    a = simulation.hardware.joint_motor("a")
    for count in range(2500):
        a.set_effort(count / 1000)
    assert exchanges("WriteDevices") == 2
    assert a.effort() == 2.499


def test_steps_that_nobody_reads_are_one_exchange(simulation, exchanges):
    a = simulation.hardware.joint_motor("a")
    for count in range(50):
        a.set_effort(count / 50)
        simulation.pass_unread(3)
    assert exchanges("StepSimulation") == 0
    simulation.catch_up()
    assert (exchanges("StepSimulation"), simulation.now_ns) == (1, 300_000_000)
    together = a.position()
    assert together > 0

    simulation.prepare({})
    for count in range(50):
        a.set_effort(count / 50)
        simulation.advance(0.006)
    assert a.position() == together


def test_what_needs_the_world_sends_the_steps_that_nobody_read(simulation, exchanges):
    a = simulation.hardware.joint_motor("a")
    a.set_effort(2)
    simulation.pass_unread(5)
    assert simulation.observation("A") == 2
    assert (exchanges("StepSimulation"), exchanges("WriteDevices")) == (1, 0)
    for _ in range(250):
        simulation.pass_unread(1)
    assert exchanges("StepSimulation") == 3
    simulation.pass_unread(1)
    # Another case forgets them.
    simulation.prepare({})
    simulation.catch_up()
    assert (exchanges("StepSimulation"), simulation.now_ns) == (3, 0)


def test_limits_of_several_numbers_together(target, exchanges, tmp_path):
    (tmp_path / "w.xml").write_text(DRIVE_MJCF)
    (tmp_path / "w.world.yaml").write_text(DRIVE_YAML)
    opened = Simulation(target, tmp_path / "w.world.yaml", 1, Stopwatch())
    opened.prepare({})
    base = opened.hardware.differential_drive("base")
    draw = random.Random(1)
    refused = 0
    for _ in range(300):
        linear = draw.choice([draw.uniform(-1.3, 1.3), 1.0, -1.0, 0.9999999999, 0.5])
        angular = draw.choice([draw.uniform(-5, 5), 0.0, 2.5, -2.5])
        wheels = [(linear + side * angular * 0.4 / 2) / 0.1 for side in (-1, 1)]
        if max(map(abs, wheels)) > 10 * (1 + 1e-12):
            refused += 1
            with pytest.raises(ValueError, match="wheel in rad/s"):
                base.drive(linear, angular)
        else:
            base.drive(linear, angular)
            opened.advance(0.002)
    # At a limit itself the command is sent at once.
    assert 50 < refused < 250
    before = exchanges("WriteDevices")
    base.drive(0.7, 1.0)
    opened.advance(0.002)
    assert exchanges("WriteDevices") == before
    opened.close()
