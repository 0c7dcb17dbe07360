"""Commands that travel with a step: their order, their effect, their refusal, and what a client knows about them."""

import math

import grpc
import pytest

from client import pb, world

MJCF = """
<option timestep="0.002" gravity="0 0 0"/>
<worldbody>
  <geom name="wall" type="box" size="0.1 1 1" pos="1.2 0 0"/>
  <body name="sled"><joint name="x" type="slide" axis="1 0 0"/><geom name="sled" type="box" size="0.1 0.1 0.1" mass="2"/>
    <site name="eye" pos="0.1 0 0"/></body>
  <body name="arm" pos="0 3 0"><joint name="turn" type="hinge" axis="0 0 1"/>
    <geom type="box" size="0.2 0.05 0.05" mass="1"/></body>
  <body name="left" pos="0 6 0"><joint name="left" type="hinge" axis="0 1 0"/>
    <geom type="box" size="0.1 0.1 0.1" mass="1"/></body>
  <body name="right" pos="0 9 0"><joint name="right" type="hinge" axis="0 1 0"/>
    <geom type="box" size="0.1 0.1 0.1" mass="1"/></body>
  <body name="thumb" pos="0 12 0"><joint name="thumb" type="slide" axis="1 0 0"/>
    <geom type="box" size="0.01 0.01 0.01" mass="0.1"/></body>
  <body name="finger" pos="0 15 0"><joint name="finger" type="slide" axis="1 0 0"/>
    <geom type="box" size="0.01 0.01 0.01" mass="0.1"/></body>
</worldbody>
<actuator>
  <motor name="push" joint="x" ctrlrange="-10 10"/>
  <position name="turn" joint="turn" kp="5"/>
  <velocity name="left" joint="left" kv="1"/>
  <velocity name="right" joint="right" kv="1"/>
  <velocity name="slow" joint="right" kv="1" ctrlrange="-2 2"/>
  <position name="thumb" joint="thumb" kp="9" ctrlrange="0 0.03"/>
  <position name="finger" joint="finger" kp="9" ctrlrange="0 0.04"/>
</actuator>"""
YAML = """
parameters:
  Delay: {unit: s, range: [0, 5], default: 0, bind: {set: device.push.delay}}
  Noise: {unit: m, range: [0, 5], default: 0.01, bind: {set: device.encoder.noise}}
devices:
  encoder: {kind: joint_encoder, joint: x}
  push: {kind: joint_motor, actuator: push}
  turn: {kind: joint_motor, actuator: turn}
  base: {kind: differential_drive, left: left, right: right, wheel_radius: 0.1, track: 0.5}
  slow: {kind: differential_drive, left: left, right: slow, wheel_radius: 0.1, track: 0.5}
  hand: {kind: gripper, fingers: [thumb, finger], width: 0.08}
  line: {kind: digital_io}
  imu: {kind: imu, site: eye}
  pose: {kind: pose, site: eye}
  field: {kind: magnetometer, site: eye}
  wrist: {kind: force_torque, site: eye}
  bumper: {kind: contact, geom: sled}
  scan: {kind: laser_scan, site: eye, angles: [-0.5, 0.5], rays: 3, min: 0, max: 20}
  cell: {kind: battery, capacity: 2, current: 1, voltage: [10, 12]}
"""
# Numbers that a command changes before time advances; clients send their pending commands before they read them.
IMMEDIATE = {
    "push.effort",
    "turn.effort",
    "hand.effort",
    "line.level",
    *(f"imu.linear_acceleration.{axis}" for axis in "xyz"),
    *(f"wrist.{part}.{axis}" for part in ("force", "torque") for axis in "xyz"),
    "bumper.pressed",
    "bumper.force",
}


@pytest.fixture
def robot(client):
    with client.open(world(MJCF, YAML)) as session:
        yield session


@pytest.fixture
def twin(client):
    with client.open(world(MJCF, YAML)) as session:
        yield session


def effort(value, device="push"):
    return pb.DeviceCommand(device=device, joint=pb.JointCommand(effort=value))


def position(value):
    return pb.DeviceCommand(device="turn", joint=pb.JointCommand(position=value))


def drive(linear, angular, device="base"):
    return pb.DeviceCommand(device=device, drive=pb.DriveCommand(linear=linear, angular=angular))


def grip(width):
    return pb.DeviceCommand(device="hand", gripper=pb.GripperCommand(width_m=width))


def level(high):
    return pb.DeviceCommand(device="line", level=high)


def commands_of(tick):
    """What a component commands within one tick, of every kind, with one device twice."""
    return [effort(9 - tick), position(0.1 * tick), drive(0.2, 0.1 * tick), grip(0.03), level(tick % 2 == 0), effort(tick)]


@pytest.mark.parametrize(
    "faults",
    [
        {},
        {"Delay": 0.01},
        {"fault.push.ignored": 1, "fault.push.ignored.at": 0.02},
        {"fault.push.saturated": 1},
        {"fault.push.effort.stuck": 1, "fault.push.effort.stuck.at": 0.016},
        {"fault.encoder.delay": 0.012},
    ],
)
def test_commands_act_as_if_each_was_sent_alone_before_the_step(robot, twin, faults):
    robot.prepare(**faults)
    twin.prepare(**faults)
    for tick in range(8):
        for command in commands_of(tick):
            robot("WriteDevices", commands=[command])
        alone = robot.step(4)
        together = twin.step(4, commands=commands_of(tick))
        assert together.SerializeToString() == alone.SerializeToString()


def test_the_last_of_two_commands_of_a_tick_counts(robot):
    robot.step(100, commands=[effort(10), effort(-10)])
    assert robot.read("pose").position.x < 0


@pytest.mark.parametrize(
    ("command", "code", "named"),
    [
        (effort(10.5), grpc.StatusCode.OUT_OF_RANGE, "push.effort: 10.5"),
        (effort(math.nan), grpc.StatusCode.INVALID_ARGUMENT, "push.effort: nan"),
        (effort(1, "turn"), grpc.StatusCode.INVALID_ARGUMENT, "turn takes position"),
        (drive(9, 0, "slow"), grpc.StatusCode.OUT_OF_RANGE, "slow: right wheel"),
        (grip(0.07), grpc.StatusCode.OUT_OF_RANGE, "hand.width/2"),
    ],
)
def test_a_bad_command_of_a_tick_is_refused_by_name_and_no_time_passes(robot, refused, command, code, named):
    before = robot.step(3, commands=[effort(2)])
    got, message = refused(lambda: robot.step(5, commands=[effort(5), command, position(1)]))
    assert (got, named in message) == (code, True), message
    assert robot("ReadDevices").state.SerializeToString() == before.SerializeToString()


def test_a_reading_between_two_commands_of_a_tick_shows_the_first(robot):
    robot.step(1)
    assert robot.read("push").effort == 0
    assert robot("WriteDevices", commands=[effort(3), level(True)]).state.time_ns == 2_000_000
    assert (robot.read("push").effort, robot.read("line")) == (3, True)
    robot.step(1, commands=[effort(-4)])
    assert robot.read("push").effort == -4


def test_commands_change_only_these_numbers_before_time_advances(robot):
    robot.step(40, commands=commands_of(3))
    before = numbers(robot("ReadDevices").state, robot.created.world)
    after = numbers(robot("WriteDevices", commands=commands_of(6)).state, robot.created.world)
    changed = {name for name, value in after.items() if value != before[name] and not math.isnan(value)}
    assert {"push.effort", "turn.effort", "line.level", "imu.linear_acceleration.x"} <= changed <= IMMEDIATE


def test_the_world_tells_which_commands_a_device_accepts(robot):
    told = {d.name: {n.name: (n.min, n.max) for n in d.commands} for d in robot.created.world.devices}
    always = (-math.inf, math.inf)
    assert {name: numbers for name, numbers in told.items() if numbers} == {
        "push": {"effort": (-10, 10)},
        "turn": {"position": always},
        "base": {"linear": always, "angular": always},
        "slow": {"linear": always, "angular": always},
        "hand": {"width": (0, 0.06)},
        "line": {"level": (0, 1)},
    }
    robot.step(1, commands=[effort(10), effort(-10), position(1e6), grip(0.06), grip(0), drive(50, -50)])
    # Numbers that together are within the limits: only the right wheel of one drive has some.
    (device,) = [d for d in robot.created.world.devices if d.bounds]
    (bound,) = device.bounds
    assert device.name == "slow"
    assert dict(bound.factors) == pytest.approx({"linear": 10, "angular": 2.5})
    assert (bound.min, bound.max) == pytest.approx((-2, 2))
    assert -2 < bound.min < bound.max < 2
    for linear in (-4.0, -0.2, 0.0, 0.2, 4.0):
        for total in (bound.min, 0.0, bound.max):
            angular = (total - bound.factors["linear"] * linear) / bound.factors["angular"]
            robot.step(1, commands=[drive(linear, angular, "slow")])


def test_steps_whose_readings_nobody_needs_can_follow_in_one_request(robot, twin):
    parts = [(1 + part % 4, drive(0.1 * part, 0.02 * part)) for part in range(20)]
    for steps, command in parts:
        alone = robot.step(steps, commands=[command])
    (steps, command), *rest = parts
    later = [pb.LaterSteps(steps=more, commands=[given]) for more, given in rest]
    together = twin.step(steps, commands=[command], later=later)
    assert together.SerializeToString() == alone.SerializeToString()


@pytest.mark.parametrize(
    ("wrong", "code", "named"),
    [
        (pb.LaterSteps(steps=1, commands=[drive(9, 0, "slow")]), grpc.StatusCode.OUT_OF_RANGE, "slow: right wheel"),
        (pb.LaterSteps(), grpc.StatusCode.INVALID_ARGUMENT, "steps: must be at least 1"),
    ],
)
def test_one_wrong_entry_of_later_steps_refuses_the_request(robot, wrong, code, named):
    before = robot("ReadDevices").state
    with pytest.raises(grpc.RpcError) as refused:
        robot.step(1, later=[pb.LaterSteps(steps=3, commands=[drive(1, 0)]), wrong])
    assert refused.value.code() == code
    assert named in refused.value.details()
    assert robot("ReadDevices").state == before


def numbers(state, described):
    """All numbers of a state by `device.field`."""
    found = {}
    for reading, device in zip(state.readings, described.devices, strict=True):
        value = getattr(reading, reading.WhichOneof("value"))
        flat = list(_flat(value))
        found.update({f"{device.name}.{field}": number for field, number in zip(device.fields, flat, strict=False)})
    return found


def _flat(value):
    if isinstance(value, (bool, float, int)):
        yield float(value)
    elif hasattr(value, "DESCRIPTOR"):
        for field in value.DESCRIPTOR.fields:
            yield from _flat(getattr(value, field.name))
    else:
        for item in value:
            yield from _flat(item)
