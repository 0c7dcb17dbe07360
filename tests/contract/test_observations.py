"""Observations against closed-form solutions."""

import math

import pytest

from client import Gltf, pb, world

G = 9.81
MJCF = """
<option timestep="0.001"/>
<worldbody>
  <geom name="floor" type="plane" size="0 0 0.1"/>
  <body name="base" pos="0 3 0.5"/>
  <body name="ball" pos="0 0 4"><freejoint/><geom name="top" type="sphere" size="0.5" mass="1"/></body>
  <body name="wheel" pos="5 0 1"><joint name="wheel" axis="0 0 1"/><geom type="box" size="0.2 0.1 0.1" contype="0"/>
    <site name="eye" quat="0.5 0.5 0.5 0.5"/></body>
</worldbody>
<sensor><rangefinder name="eye" site="eye"/></sensor>"""
YAML = """
parameters:
  Angle: {unit: rad, range: [-4, 4], default: 0, bind: {set: joint.wheel.pos}}
devices:
  lamp: {kind: digital_io}
  wheel: {kind: joint_encoder, joint: wheel}
  eye: {kind: range, sensor: eye, min: 0, max: 10}
observations:
  x: {entity: ball, axis: x}
  sink: {entity: ball, velocity: z}
  drift: {entity: ball, velocity: x}
  spin: {entity: ball, velocity: yaw}
  turn: {entity: wheel, axis: yaw}
  turn_z: {entity: wheel, orientation: z}
  turn_w: {entity: wheel, orientation: w}
  read: {device: wheel, field: position, unit: rad}
  seen: {device: eye, unit: m}
  lit: {device: lamp}
  landed: {contact: [top, floor]}
  rests: {contact: [floor, ball]}
  apart: {distance: [ball, base]}
"""


@pytest.fixture
def session(client):
    with client.open(world(MJCF, YAML)) as opened:
        yield opened


def observed(state):
    return {observation.name: observation.value for observation in state.observations}


def test_velocities_are_those_of_the_body_in_the_world(session):
    twist = pb.Twist(linear=pb.Vector3(x=2), angular=pb.Vector3(z=3))
    seen = observed(session("SetEntityState", entity="ball", state=pb.EntityState(twist=twist)).state)
    assert (seen["drift"], seen["spin"], seen["sink"]) == pytest.approx((2, 3, 0))
    seen = observed(session.step(500))
    assert (seen["drift"], seen["spin"], seen["sink"]) == pytest.approx((2, 3, -G / 2))
    assert seen["x"] == pytest.approx(1)


@pytest.mark.parametrize("angle", [0, 0.5, -3, 3.5])
def test_an_orientation_does_not_depend_on_how_it_was_reached(session, angle):
    seen = observed(session.prepare(Angle=angle))
    sign = 1 if math.cos(angle / 2) >= 0 else -1
    assert (seen["turn_z"], seen["turn_w"]) == pytest.approx((sign * math.sin(angle / 2), sign * math.cos(angle / 2)))
    assert seen["turn"] == pytest.approx(math.remainder(angle, 2 * math.pi))


def test_an_observed_reading_equals_that_of_the_component(session):
    seen = observed(session.prepare(Angle=0.25))
    assert (seen["read"], seen["seen"], seen["lit"]) == (0.25, math.inf, 0)
    session.fault("wheel", ("OFFSET", 1.0))
    seen = observed(session("WriteDevices", commands=[pb.DeviceCommand(device="lamp", level=True)]).state)
    assert (seen["read"], seen["lit"]) == (1.25, 1)


def test_a_contact_is_observed_while_it_lasts(session):
    fall = math.sqrt(2 * 3.5 / G)
    assert observed(session.step(int(fall * 1000) - 5))["landed"] == 0
    seen = observed(session.step(10))
    # By its geom, and by its body.
    assert (seen["landed"], seen["rests"]) == (1, 1)


def test_a_distance_is_measured_between_origins(session):
    assert observed(session.prepare())["apart"] == pytest.approx(math.hypot(3, 3.5))


def test_units_are_listed_and_bulk_cases_and_recordings_have_the_same_numbers(session):
    units = {o.name: o.unit for o in session.created.world.observations}
    assert units["sink"] == "m/s"
    assert (units["spin"], units["turn"], units["turn_w"], units["seen"], units["apart"]) == (
        "rad/s",
        "rad",
        "1",
        "m",
        "m",
    )
    many = session("PrepareMany", parameters=["Angle"], values=[1.0] * 40, cases=40)
    alone = observed(session.prepare(Angle=1))
    width = len(many.columns)
    for name, value in alone.items():
        assert list(many.readings)[list(many.columns).index(name) :: width] == [value] * 40
    session("RecordMotion", interval_ns=10**7)
    readings = Gltf(session("TakeMotion").gltf).extras["readings"]
    assert readings["columns"][-len(alone) :] == list(alone)


@pytest.mark.parametrize(
    ("entry", "words"),
    [
        ("{entity: ball, axis: x, velocity: y}", "axis and velocity"),
        ("{entity: ball, orientation: roll}", "'roll' is not one of x, y, z, w"),
        ("{entity: ball}", "axis is missing"),
        ("{}", "entity is missing"),
        ("{device: nobody}", "no device 'nobody'"),
        ("{device: wheel}", "position, velocity"),
        ("{device: wheel, field: colour}", "'colour' is not a number of wheel"),
        ("{device: eye, contact: [top, floor]}", "device and contact"),
        ("{contact: [top]}", "list of two"),
        ("{contact: [top, ceiling]}", "neither a geom nor a body 'ceiling'"),
        ("{distance: [ball, nobody]}", "no body 'nobody'"),
        ("{entity: ball, axis: x, colour: red}", "colour is not a known key"),
    ],
)
def test_a_bad_observation_is_refused_with_its_line(client, refused, entry, words):
    source = world(MJCF, YAML + f"  bad: {entry}\n")
    code, message = refused(lambda: client.control.DescribeWorld(pb.DescribeWorldRequest(world=source)))
    assert code.name == "INVALID_ARGUMENT"
    assert f"w.world.yaml:{len(YAML.splitlines()) + 2}: observations.bad" in message
    assert words in message
