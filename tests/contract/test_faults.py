"""Faults as parameters: every kind of fault on every kind of device has an effect, or is refused."""

import math

import grpc
import pytest

from client import pb, world

DT = 0.002
MJCF = f"""
<option timestep="{DT}" gravity="0 0 -9.81"/>
<worldbody>
  <geom name="wall" type="box" size="0.1 2 2" pos="3.1 0 0"/>
  <camera name="cam" pos="0 -2 1"/>
  <body name="sled" pos="0 0 0"><joint name="x" type="slide" axis="1 0 0" damping="1"/>
    <geom name="sled" type="box" size="0.1 0.1 0.1" mass="2"/>
    <site name="eye" pos="0.1 0 0" quat="0.5 0.5 0.5 0.5"/><site name="flat" pos="0.1 0 0"/></body>
  <body name="box" pos="0 1 0.099"><freejoint/><geom name="box" type="box" size="0.1 0.1 0.1" mass="1"/></body>
  <geom name="floor" type="plane" size="5 5 0.1"/>
  <body name="left" pos="0 -1 1"><joint name="left" axis="0 1 0" damping="0.1" armature="0.05"/><site name="hub"/><geom type="sphere" size="0.05" mass="0.1"/></body>
  <body name="right" pos="0 -1.5 1"><joint name="right" axis="0 1 0" damping="0.1" armature="0.05"/><geom type="sphere" size="0.05" mass="0.1"/></body>
  <body name="f1" pos="1 -1 1"><joint name="f1" type="slide" axis="0 1 0" damping="1"/><geom type="sphere" size="0.02" mass="0.1"/></body>
  <body name="f2" pos="1 -1.2 1"><joint name="f2" type="slide" axis="0 -1 0" damping="1"/><geom type="sphere" size="0.02" mass="0.1"/></body>
</worldbody>
<actuator>
  <motor name="push" joint="x" ctrlrange="-10 10"/>
  <velocity name="left" joint="left" kv="1" ctrlrange="-20 20"/><velocity name="right" joint="right" kv="1" ctrlrange="-20 20"/>
  <position name="f1" joint="f1" kp="10" ctrlrange="0 0.1"/><position name="f2" joint="f2" kp="10" ctrlrange="0 0.1"/>
</actuator>
<sensor><rangefinder name="eye" site="eye"/></sensor>"""
YAML = """
parameters:
  X: {unit: m, range: [-50, 2.8], default: 0, bind: {set: joint.x.pos}}
devices:
  range: {kind: range, sensor: eye, min: 0.05, max: 20}
  laser_scan: {kind: laser_scan, site: flat, angles: [-0.5, 0.5], rays: 5, min: 0, max: 20}
  imu: {kind: imu, site: eye}
  joint_encoder: {kind: joint_encoder, joint: x}
  pose: {kind: pose, site: eye}
  force_torque: {kind: force_torque, site: eye}
  contact: {kind: contact, geom: box}
  camera: {kind: camera, camera: cam, width: 8, height: 8}
  joint_motor: {kind: joint_motor, actuator: push}
  differential_drive: {kind: differential_drive, left: left, right: right, wheel_radius: 0.1, track: 0.5}
  gripper: {kind: gripper, fingers: [f1, f2], width: 0.2}
  magnetometer: {kind: magnetometer, site: hub}
  battery: {kind: battery, capacity: 0.001, current: 1, voltage: [10, 12]}
  digital_io: {kind: digital_io, level: 1}
"""
COMMANDS = {
    "joint_motor": [{"joint": {"effort": 4.0}}, {"joint": {"effort": -4.0}}],
    "differential_drive": [{"drive": {"linear": 0.5, "angular": 0.4}}, {"drive": {"linear": 0.1, "angular": -0.4}}],
    "gripper": [{"gripper": {"width_m": 0.05}}, {"gripper": {"width_m": 0.1}}],
    "digital_io": [{"level": False}, {"level": True}],
}
VALUES = {"offset": 0.5, "scale": 2.0, "noise": 0.3, "delay": 0.1, "intermittent": 0.5}
NUMBERS = {"offset", "scale", "noise", "out_of_range"}
OF_READINGS = ["stuck", "dropout", "offset", "scale", "noise", "delay", "intermittent", "out_of_range"]
DEVICES = [
    "range", "laser_scan", "imu", "joint_encoder", "pose", "force_torque", "contact", "camera", "joint_motor",
    "differential_drive", "gripper", "magnetometer", "battery", "digital_io",
]  # fmt: skip


def fits(device, kind):
    if device == "camera":
        return False
    if kind == "ignored":
        return device in COMMANDS
    if kind == "saturated":
        return device in COMMANDS and device != "digital_io"
    return device != "digital_io" or kind not in NUMBERS


@pytest.fixture
def session(client):
    with client.open(world(MJCF, YAML)) as opened:
        yield opened


def trajectory(session, parameters):
    """What the devices read at each step of a case whose actuators get commands before and after the onset of a fault."""
    session.prepare(**parameters)
    found = []
    for step in range(100):
        index = {0: 0, 30: 1}.get(step)
        commands = [] if index is None else [(name, commands[index]) for name, commands in COMMANDS.items()]
        found.append(state(session, [pb.DeviceCommand(device=name, **_message(command)) for name, command in commands]))
    return found


def _message(command):
    ((form, fields),) = command.items()
    types = {"joint": pb.JointCommand, "drive": pb.DriveCommand, "gripper": pb.GripperCommand}
    return {form: types[form](**fields) if form in types else fields}


def state(session, commands=()):
    state = session.step(1, commands=commands)
    return {reading.device: reading.SerializeToString(deterministic=True) for reading in state.readings}


@pytest.mark.parametrize("device", DEVICES)
@pytest.mark.parametrize("kind", [*OF_READINGS, "ignored", "saturated"])
def test_every_fault_of_every_device_has_an_effect_or_is_refused(session, device, kind):
    fault = {f"fault.{device}.{kind}": VALUES.get(kind, 1.0), f"fault.{device}.{kind}.at": 0.02}
    if not fits(device, kind):
        with pytest.raises(grpc.RpcError) as refused:
            session.prepare(**fault)
        assert f"does not fit a {device}" in refused.value.details()
        return
    healthy, faulty = trajectory(session, {}), trajectory(session, fault)
    changed = [step for step, (a, b) in enumerate(zip(healthy, faulty), 1) if a[device] != b[device]]
    assert changed, "the fault has no effect"
    # Nothing happens before its onset, after 10 steps.
    assert changed[0] >= 10
    others = [name for name in healthy[0] if name != device]
    if kind not in ("ignored", "saturated"):
        assert all(a[name] == b[name] for a, b in zip(healthy, faulty) for name in others)


def test_a_fault_begins_and_ends_at_its_steps(session):
    session.prepare(
        settle_ns=100_000_000,
        **{"fault.range.dropout": 1, "fault.range.dropout.at": 0.01, "fault.range.dropout.for": 0.02},
    )
    missing = [math.isnan(session.step(1) and session.read("range").range_m) for _ in range(20)]
    # Step k is at k * 2 ms after the call: the fault lasts from step 5 up to, not at, step 15.
    assert [k for k, lost in enumerate(missing, 1) if lost] == list(range(5, 15))


def test_onsets_count_from_the_call(session):
    fault = {"fault.range.dropout": 1.0, "fault.range.dropout.for": 0.004}
    state = session("Prepare", parameters=fault, call_after_ns=10_000_000).state
    assert not math.isnan(session.read("range").range_m), state
    missing = [math.isnan(session.step(1) and session.read("range").range_m) for _ in range(10)]
    assert [k for k, lost in enumerate(missing, 1) if lost] == [5, 6]


def test_one_step_at_a_time_gives_the_same_as_all_at_once(session):
    faults = {
        "fault.joint_encoder.stuck": 1, "fault.joint_encoder.stuck.at": 0.05, "fault.joint_encoder.stuck.for": 0.1,
        "fault.pose.position.x.delay": 0.03, "fault.pose.position.x.delay.at": 0.04,
        "fault.joint_motor.saturated": 1, "fault.joint_motor.saturated.at": 0.02, "fault.joint_motor.saturated.for": 0.08,
        "fault.imu.noise": 0.1, "fault.imu.noise.at": 0.03,
    }  # fmt: skip
    for steps in (1, 7, 49, 50, 51, 99, 100, 101, 150, 200):
        session.prepare(**faults)
        commands = [pb.DeviceCommand(device="joint_motor", joint=pb.JointCommand(effort=1.0))]
        at_once = session.step(steps, commands=commands)
        session.prepare(**faults)
        session.step(1, commands=commands)
        one_by_one = [session.step(1) for _ in range(steps - 1)][-1] if steps > 1 else session("ReadDevices").state
        assert at_once.readings == one_by_one.readings


def test_a_field_alone_has_a_fault(session):
    before = session.prepare()
    after = session.prepare(**{"fault.pose.position.offset": 2.0})
    poses = [next(r.pose for r in state.readings if r.device == "pose") for state in (before, after)]
    assert poses[1].position.x == poses[0].position.x + 2
    assert poses[1].position.z == poses[0].position.z + 2
    assert poses[1].orientation == poses[0].orientation
    after = session.prepare(**{"fault.laser_scan.ranges.2.dropout": 1})
    assert [math.isnan(x) for x in session.read("laser_scan").ranges_m] == [False, False, True, False, False], after


def test_a_part_of_a_command_is_ignored(session):
    drive = [pb.DeviceCommand(device="differential_drive", drive=pb.DriveCommand(linear=0.5, angular=0.6))]
    session.prepare(**{"fault.differential_drive.linear.ignored": 1})
    session.step(500, commands=drive)
    moved = session.read("differential_drive")
    assert abs(moved.linear) < 0.05
    assert moved.angular == pytest.approx(0.6, abs=0.3)


def test_a_command_is_carried_out_again_when_its_saturation_ends(session):
    grip = [pb.DeviceCommand(device="gripper", gripper=pb.GripperCommand(width_m=0.05))]
    session.prepare(**{"fault.gripper.saturated": 1, "fault.gripper.saturated.for": 2.0})
    session.step(900, commands=grip)
    assert session.read("gripper").width_m == pytest.approx(0.2, abs=0.02)
    session.step(1500)
    assert session.read("gripper").width_m == pytest.approx(0.05, abs=0.02)


def test_an_ignored_command_is_refused_like_any_other(session):
    session.prepare(**{"fault.joint_motor.ignored": 1})
    with pytest.raises(grpc.RpcError) as refused:
        session.step(1, commands=[pb.DeviceCommand(device="joint_motor", joint=pb.JointCommand(effort=11))])
    assert refused.value.code() == grpc.StatusCode.OUT_OF_RANGE


def test_a_fault_set_during_a_case_begins_then(session):
    session.prepare()
    session.step(10)
    state = session("SetParameters", values={"fault.range.dropout": 1, "fault.range.dropout.for": 0.004}).state
    assert math.isnan(next(r.range.range_m for r in state.readings if r.device == "range"))
    session.step(2)
    assert not math.isnan(session.read("range").range_m)
    assert session("GetParameters", names=["fault.range.dropout", "fault.range.stuck"]).values == {
        "fault.range.dropout": 1,
        "fault.range.stuck": 0,
    }
    session.prepare()
    assert session("GetParameters", names=["fault.range.dropout"]).values["fault.range.dropout"] == 0


def test_a_snapshot_holds_what_a_stuck_device_shows(session):
    session.prepare(**{"fault.joint_encoder.stuck": 1, "X": 1.0})
    session.step(5)
    kept = session("TakeSnapshot").snapshot_id
    shown = session.read("joint_encoder")
    session.prepare(X=2.0)
    session("RestoreSnapshot", snapshot_id=kept)
    session.step(5)
    assert session.read("joint_encoder") == shown


@pytest.mark.parametrize(
    ("faults", "message"),
    [
        ({"fault.range": 1}, "must be fault.DEVICE"),
        ({"fault.range.shaky": 1}, "kinds: stuck, dropout"),
        ({"fault.sonar.dropout": 1}, "no device 'sonar'"),
        ({"fault.range.ignored": 1}, "does not fit a range; its faults: stuck, dropout, offset"),
        ({"fault.pose.speed.offset": 1}, "its fields: position.x"),
        ({"fault.contact.pressed.offset": 1}, "does not fit a contact"),
        ({"fault.camera.dropout": 1}, "it has no faults"),
        ({"fault.range.dropout": 0.5}, "neither 0 nor 1"),
        ({"fault.range.noise": -1}, "is not 0 or more"),
        ({"fault.range.delay": 11}, "is not 0 to 10 s"),
        ({"fault.range.intermittent": 1.5}, "a probability from 0 to 1"),
        ({"fault.range.offset": math.nan}, "is not a finite number"),
        ({"fault.range.dropout.at": -1}, "is not 0 s or more"),
        ({"fault.range.dropout.value": 1}, "only out_of_range has a value"),
        ({"fault.differential_drive.linear.saturated": 1}, "does not fit a differential_drive"),
    ],
)
def test_a_fault_that_cannot_apply_is_refused(client, session, faults, message):
    with pytest.raises(grpc.RpcError) as refused:
        session.prepare(**faults)
    assert message in refused.value.details()
    values = list(faults.values())
    with pytest.raises(grpc.RpcError) as refused:
        session("PrepareMany", parameters=list(faults), values=values, cases=1)
    assert message in refused.value.details()


def test_an_actuator_without_limits_cannot_be_saturated(client):
    mjcf = """<worldbody><body name="b"><joint name="j" axis="0 1 0"/><geom type="sphere" size="0.1"/></body></worldbody>
      <actuator><motor name="m" joint="j"/></actuator>"""
    source = world(mjcf, "devices: {m: {kind: joint_motor, actuator: m}}")
    request = pb.DescribeWorldRequest(world=source, parameters=["fault.m.saturated"])
    with pytest.raises(grpc.RpcError) as refused:
        client.control.DescribeWorld(request)
    assert "has no limits; give it a ctrlrange" in refused.value.details()


def test_many_cases_have_the_readings_of_each(client):
    mjcf = """<worldbody><geom name="wall" type="plane" size="1 1 0.1" zaxis="-1 0 0" pos="9 0 0"/>
      <body name="b" mocap="true"><geom type="box" size="0.1 0.1 0.1"/><site name="eye" pos="0.1 0 0" zaxis="1 0 0"/>
      <site name="ear" pos="0.1 0.1 0" zaxis="1 0 0"/></body></worldbody>
      <sensor><rangefinder name="eye" site="eye"/><rangefinder name="ear" site="ear"/></sensor>"""
    yaml = """
parameters: {X: {unit: m, range: [-5, 5], default: 0, bind: {set: body.b.pos.x}}}
devices: {eye: {kind: range, sensor: eye, min: 0, max: 12}, ear: {kind: range, sensor: ear, min: 0, max: 12}}"""
    names = [
        "X",
        "fault.eye.offset",
        "fault.ear.dropout",
        "fault.eye.noise",
        "fault.eye.delay",
        "fault.ear.scale.at",
        "fault.ear.scale",
    ]
    rows = [
        [x / 10, (x % 3) * 0.5, x % 2, 0.1 * (x % 5 == 0), 0.01 * (x % 7 == 0), 0.1 * (x % 4 == 0), 1 + x % 3]
        for x in range(-40, 40)
    ]
    with client.open(world(mjcf, yaml)) as session:
        for settle in (0, 50_000_000):
            many = session(
                "PrepareMany",
                parameters=names,
                values=[v for row in rows for v in row],
                cases=len(rows),
                settle_ns=settle,
            )
            found = [many.readings[i : i + 2] for i in range(0, len(many.readings), 2)]
            for row, readings in zip(rows, found, strict=True):
                state = session.prepare(settle_ns=settle, **dict(zip(names, row, strict=True)))
                single = [reading.range.range_m for reading in state.readings]
                assert [x.hex() for x in readings] == [x.hex() for x in single]
