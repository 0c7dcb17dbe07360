"""The world of the paper's evaluation, over gRPC."""

import math
import struct

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from sitaf_bridge.wire import simulation_pb2 as pb
from tests.client import Bridge, TestSession, ir_world, observed, ranges

SENSORS = [f"ir{i}" for i in range(1, 8)]


@pytest.mark.parametrize("distance", [0.0, 0.5, 5.0, 9.5, 10.0, 0.1, 0.3, 7.3, 1e-9, 1 / 3, math.pi, math.e])
def test_every_sensor_reads_the_distance_to_the_last_bit(ir: TestSession, distance: float) -> None:
    assert ranges(ir.prepare(Distance=distance)) == dict.fromkeys(SENSORS, distance)


@settings(max_examples=200, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.floats(min_value=1e-6, max_value=10.0))
def test_any_distance_in_range_is_read_to_the_last_bit(ir: TestSession, distance: float) -> None:
    assert ranges(ir.prepare(Distance=distance)) == dict.fromkeys(SENSORS, distance)


def test_touching_reads_positive_zero(ir: TestSession) -> None:
    bits = {struct.pack(">d", value) for value in ranges(ir.prepare(Distance=0.0, settle_ns=10**9)).values()}
    assert bits == {struct.pack(">d", 0.0)}


@pytest.mark.parametrize("distance", [-1e-9, -0.5, -1.0])
def test_inside_of_the_obstacle_reads_minus_infinity(ir: TestSession, distance: float) -> None:
    assert set(ranges(ir.prepare(Distance=distance)).values()) == {-math.inf}


@pytest.mark.parametrize("distance", [math.nextafter(10.0, 11.0), 10.5, 20.0])
def test_beyond_the_range_reads_plus_infinity(ir: TestSession, distance: float) -> None:
    assert set(ranges(ir.prepare(Distance=distance)).values()) == {math.inf}


@pytest.mark.parametrize("distance", [-0.5, 0.1, 10.0])
def test_two_seconds_of_settling_change_no_bit(ir: TestSession, distance: float) -> None:
    still, settled = ir.prepare(Distance=distance), ir.prepare(Distance=distance, settle_ns=2 * 10**9)
    assert (settled.step, settled.time_ns) == (1000, 2 * 10**9)
    assert ranges(settled) == ranges(still)
    assert observed(settled) == observed(still) == {"robot_x": -0.16}


def test_settling_rounds_up_to_whole_steps(ir: TestSession) -> None:
    assert ir.prepare(settle_ns=2_000_001).step == 2
    assert ir.prepare(settle_ns=2_000_000).step == 1


def test_other_parameters_get_their_defaults(ir: TestSession) -> None:
    ir.prepare(Distance=1.0)
    assert set(ranges(ir.prepare()).values()) == {5.0}
    assert ir.parameters() == {"Distance": 5.0}


def test_the_world_describes_itself(bridge: Bridge) -> None:
    described = bridge.describe(ir_world())
    assert described.timestep_ns == 2_000_000
    assert len(described.digest) == 64
    (distance,) = described.parameters
    assert (distance.name, distance.unit, distance.min, distance.max, distance.default_value) == (
        "Distance", "m", -1.0, 20.0, 5.0,
    )  # fmt: skip
    assert [(device.name, device.kind) for device in described.devices] == [(name, "range") for name in SENSORS]
    assert [(o.name, o.unit) for o in described.observations] == [("robot_x", "m")]


def test_a_new_session_has_the_defaults(bridge: Bridge) -> None:
    session = bridge.create(ir_world())
    assert session.created.world == bridge.describe(ir_world())
    assert session.created.state == session.read()
    assert set(ranges(session.created.state).values()) == {5.0}
    session.delete()


def test_features_name_the_engine(bridge: Bridge) -> None:
    features = bridge.control.GetSimulatorFeatures(pb.GetSimulatorFeaturesRequest())
    assert (features.engine, features.engine_version) == ("MuJoCo", "4.0.0")
    assert {"range", "laser_scan", "imu", "camera", "joint_motor"} <= set(features.device_kinds)
