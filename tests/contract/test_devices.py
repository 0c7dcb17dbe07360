"""Devices: sensor values against closed-form solutions, commands, noise, delay and faults."""

import math
import statistics

import grpc
import numpy as np
import pytest

from client import folder, pb, world

G = 9.81


def at(reading, *names):
    return [getattr(reading, name) for name in names]


@pytest.fixture
def sled(client):
    """A sled that a motor pushes towards a wall, in one dimension."""
    mjcf = """
    <option timestep="0.001" gravity="0 0 -9.81"/>
    <worldbody>
      <geom name="wall" type="box" size="0.1 1 1" pos="3.1 0 0"/>
      <body name="sled"><joint name="x" type="slide" axis="1 0 0"/><geom name="sled" type="box" size="0.1 0.1 0.1" mass="2"/>
        <site name="eye" pos="0.1 0 0" quat="0.5 0.5 0.5 0.5"/><site name="flat" pos="0.1 0 0"/></body>
    </worldbody>
    <actuator><motor name="push" joint="x" ctrlrange="-10 10"/></actuator>
    <sensor><rangefinder name="eye" site="eye"/></sensor>"""
    yaml = """
parameters:
  X: {unit: m, range: [-50, 2.8], default: 0, bind: {set: joint.x.pos}}
  Noise: {unit: m, range: [0, 5], default: 0, bind: {set: device.eye.noise}}
  Delay: {unit: s, range: [0, 5], default: 0, bind: {set: device.eye.delay}}
  Gain: {unit: "1", range: [0, 5], default: 1, bind: {set: actuator.push.gain}}
devices:
  eye: {kind: range, sensor: eye, min: 0.05, max: 20}
  encoder: {kind: joint_encoder, joint: x}
  push: {kind: joint_motor, actuator: push}
  bumper: {kind: contact, geom: sled}
  scan: {kind: laser_scan, site: flat, angles: [-0.5, 0.5], rays: 5, min: 0, max: 20}
  line: {kind: digital_io}
"""
    with client.open(world(mjcf, yaml)) as session:
        yield session


def effort(value):
    return pb.DeviceCommand(device="push", joint=pb.JointCommand(effort=value))


def test_a_free_fall_takes_the_time_of_the_closed_form(client):
    # Semi-implicit Euler falls g h t / 2 too far: 9.81 * 0.001 * 0.5 / 2 m.
    mjcf = """<option timestep="0.001"/><worldbody><body name="b" pos="0 0 10"><freejoint/>
      <geom type="sphere" size="0.1"/><site name="s"/></body></worldbody>"""
    with client.open(world(mjcf, "devices: {imu: {kind: imu, site: s}, pose: {kind: pose, site: s}}")) as session:
        session.step(500)
        fallen = 10 - session.read("pose").position.z
        assert fallen == pytest.approx(G * 0.5**2 / 2, abs=0.003)
        imu = session.read("imu").linear_acceleration
        assert math.hypot(imu.x, imu.y, imu.z) == pytest.approx(0, abs=1e-9)


def test_at_rest_an_imu_reads_gravity_upwards_and_a_force_sensor_the_weight(client):
    mjcf = """<worldbody><body name="b" pos="0 0 1"><joint type="slide" axis="1 0 0"/><geom type="sphere" size="0.1" mass="2"/>
      <site name="s"/></body></worldbody>"""
    with client.open(world(mjcf, "devices: {imu: {kind: imu, site: s}, ft: {kind: force_torque, site: s}}")) as session:
        assert at(session.read("imu").linear_acceleration, "x", "y", "z") == pytest.approx([0, 0, G], abs=1e-9)
        wrench = session.read("ft")
        assert at(wrench.force, "x", "y", "z") == pytest.approx([0, 0, 2 * G], abs=1e-9)


def test_a_pendulum_swings_with_its_period(client):
    mjcf = """<option timestep="0.0005" integrator="RK4"/><worldbody><body name="b" pos="0 0 2"><joint name="j" axis="0 1 0"/>
      <geom type="sphere" size="0.001" pos="0 0 -1" mass="1"/></body></worldbody>"""
    yaml = """parameters: {Angle: {unit: rad, range: [0, 1], default: 0.01, bind: {set: joint.j.pos}}}
devices: {j: {kind: joint_encoder, joint: j}}"""
    with client.open(world(mjcf, yaml)) as session:
        session.prepare()
        crossings = []
        for bound in ("below", "above"):
            condition = pb.Condition(device=pb.DeviceCondition(device="j", field="position", **{bound: 0.0}))
            answer = session("AdvanceUntil", condition=condition, limit_ns=10**10)
            assert answer.met
            crossings.append(answer.state.time_ns / 1e9)
        # Two crossings are half a period apart; the amplitude of 0.01 adds a sixteenth of its square, 6e-6.
        assert 2 * (crossings[1] - crossings[0]) == pytest.approx(2 * math.pi * math.sqrt(1 / G), abs=0.002)


def test_the_sliding_distance_of_a_box_follows_friction(client):
    mjcf = """<option timestep="0.001" cone="elliptic" impratio="100"/><worldbody><geom name="floor" type="plane" size="0 0 .1" friction="0.2"/>
      <body name="b" pos="0 0 0.1"><freejoint/><geom name="box" type="box" size="0.2 0.2 0.1" mass="1" friction="0.1"/></body></worldbody>"""
    yaml = """parameters: {Mu: {unit: "1", range: [0, 2], default: 0.2, bind: {set: geom.floor.friction.0}}}
observations: {x: {entity: b, axis: x}}"""
    with client.open(world(mjcf, yaml)) as session:
        for mu in (0.2, 0.5):
            session.prepare(Mu=mu, settle_ns=200_000_000)
            session("SetEntityState", entity="b", state=pb.EntityState(twist=pb.Twist(linear=pb.Vector3(x=2))))
            began = session.step(1).observations[0].value
            slid = session.step(3000).observations[0].value - began
            # v^2 / (2 mu g); soft contacts change the distance by a few percent.
            assert slid == pytest.approx(4 / (2 * mu * G), rel=0.03)


def test_ranges_to_a_wall_are_exact(sled):
    for x in (0, 0.5, -7.25, 2.5):
        sled.prepare(X=x)
        assert sled.read("eye").range_m == pytest.approx(2.9 - x, abs=1e-12)
        scan = sled.read("scan")
        angles = [scan.angle_min + ray * scan.angle_increment for ray in range(5)]
        expected = [(2.9 - x) / math.cos(a) if abs((2.9 - x) * math.tan(a)) < 1 else math.inf for a in angles]
        assert list(scan.ranges_m) == pytest.approx(expected, abs=1e-9)


def test_a_push_accelerates_by_force_over_mass(sled):
    sled.step(1000, commands=[effort(1.0)])
    joint = sled.read("push")
    assert (joint.velocity, joint.effort) == pytest.approx((0.5, 1.0), abs=1e-9)
    assert joint.position == sled.read("encoder").position == pytest.approx(0.25, abs=0.001)
    sled.prepare(Gain=3)
    sled.step(1000, commands=[effort(1.0)])
    assert sled.read("push").velocity == pytest.approx(1.5, abs=1e-9)


def test_an_advance_ends_at_a_contact_and_the_bumper_detects_it(sled):
    sled("WriteDevices", commands=[effort(10)])
    contact = pb.Condition(contact=pb.ContactCondition(geom1="wall", geom2="sled"))
    answer = sled("AdvanceUntil", condition=contact, limit_ns=5 * 10**9)
    assert answer.met
    # 2.9 m at 5 m/s^2, to the step that finds the contact.
    assert answer.state.time_ns / 1e9 == pytest.approx(math.sqrt(2 * 2.9 / 5), abs=0.003)
    assert sled.read("bumper").pressed
    assert not sled("AdvanceUntil", condition=pb.Condition(time_ns=10**12), limit_ns=10**6).met


@pytest.mark.parametrize(
    ("command", "code"),
    [
        (effort(math.nan), "INVALID_ARGUMENT"),
        (effort(math.inf), "INVALID_ARGUMENT"),
        (effort(11), "OUT_OF_RANGE"),
        (pb.DeviceCommand(device="push", joint=pb.JointCommand(velocity=1)), "INVALID_ARGUMENT"),
        (pb.DeviceCommand(device="push", level=True), "INVALID_ARGUMENT"),
        (pb.DeviceCommand(device="eye", level=True), "INVALID_ARGUMENT"),
        (pb.DeviceCommand(device="nope", level=True), "INVALID_ARGUMENT"),
        (pb.DeviceCommand(device="push"), "INVALID_ARGUMENT"),
    ],
)
def test_a_bad_command_is_refused_by_name_and_changes_nothing(sled, refused, command, code):
    sled("WriteDevices", commands=[effort(2)])
    got, message = refused(lambda: sled("WriteDevices", commands=[effort(5), command]))
    assert got.name == code
    assert command.device in message
    sled.step(1000)
    assert sled.read("push").velocity == pytest.approx(1.0, abs=1e-9)


def test_a_digital_line_keeps_its_level(sled):
    assert sled.read("line") is False
    sled("WriteDevices", commands=[pb.DeviceCommand(device="line", level=True)])
    assert sled.step(5).step == 5
    assert sled.read("line") is True
    sled("ResetSimulation")
    assert sled.read("line") is False


def test_noise_is_gaussian_and_keyed_by_step(sled):
    sled.prepare(Noise=0.5)
    errors = []
    for _ in range(400):
        sled.step(1)
        errors.append(sled.read("eye").range_m - 2.9)
    assert abs(statistics.mean(errors)) < 4 * 0.5 / 20
    assert statistics.stdev(errors) == pytest.approx(0.5, rel=0.15)
    sled.prepare(Noise=0.5, settle_ns=400_000_000)
    assert sled.read("eye").range_m - 2.9 == errors[-1]


def test_a_delayed_device_reads_earlier_values(sled):
    truth = []
    sled.prepare()
    sled("WriteDevices", commands=[effort(1)])
    for _ in range(60):
        truth.append(sled.step(1).readings[0].range.range_m)
    for way in ("one by one", "at once"):
        sled.prepare(Delay=0.02)
        sled("WriteDevices", commands=[effort(1)])
        if way == "at once":
            sled.step(60)
        for _ in range(60 if way == "one by one" else 0):
            sled.step(1)
        assert sled.read("eye").range_m == truth[59 - 20]


@pytest.mark.parametrize(
    ("faults", "expected"),
    [
        ([("OFFSET", 0.5)], 3.4),
        ([("SCALE", 2.0)], 5.8),
        ([("OFFSET", 0.5), ("SCALE", 2.0)], 6.8),
        ([("OFFSET", -2.88)], -math.inf),
        ([("OFFSET", 50)], math.inf),
        ([("DROPOUT", 0)], math.nan),
        ([("OUT_OF_RANGE", 0)], math.inf),
        ([("INTERMITTENT", 1)], math.nan),
        ([("INTERMITTENT", 0)], 2.9),
        ([], 2.9),
    ],
)
def test_a_faulty_device_reads_wrong_values_without_an_error(sled, faults, expected):
    healthy = sled("ReadDevices").state.readings[0]
    sled.fault("eye", *faults)
    faulty = sled("ReadDevices").state.readings[0]
    assert faulty.range.range_m == pytest.approx(expected, nan_ok=True)
    faulty.range.range_m = healthy.range.range_m
    assert faulty == healthy
    sled.fault("eye")
    assert sled("ReadDevices").state.readings[0] == healthy


def test_a_stuck_device_keeps_its_reading_until_the_fault_is_removed(sled):
    sled("WriteDevices", commands=[effort(1)])
    sled.fault("eye", ("STUCK", 0))
    sled.step(1000)
    assert sled.read("eye").range_m == pytest.approx(2.9, abs=1e-12)
    sled.fault("eye")
    assert sled.read("eye").range_m == pytest.approx(2.65, abs=0.001)


def test_an_intermittent_device_drops_out_at_the_given_rate(sled):
    sled.fault("eye", ("INTERMITTENT", 0.3))
    failed = 0
    for _ in range(300):
        sled.step(1)
        failed += math.isnan(sled.read("eye").range_m)
    assert 60 < failed < 120


def test_bad_faults_are_refused(sled, refused):
    for device, fault in (("nope", ("STUCK", 0)), ("eye", ("NOISE", -1)), ("eye", ("DELAY", 1e9)), ("eye", ("INTERMITTENT", 2)),
                          ("eye", ("OFFSET", math.nan))):
        assert refused(lambda d=device, f=fault: sled.fault(d, f))[0] == grpc.StatusCode.INVALID_ARGUMENT


def test_entities_are_moved_pushed_spawned_and_removed(sled, refused):
    pose = pb.Pose(position=pb.Vector3(x=1, z=0), orientation=pb.Quaternion(w=1))
    wall = {"entity": "box", "shape": pb.SHAPE_BOX, "size_m": [0.1, 0.5, 0.5], "pose": pose}
    sled("SpawnEntity", **wall)
    assert sled.read("eye").range_m == pytest.approx(0.8, abs=1e-12)
    assert refused(lambda: sled("SpawnEntity", **wall))[0] == grpc.StatusCode.INVALID_ARGUMENT
    moved = pb.EntityState(pose=pb.Pose(position=pb.Vector3(x=2)))
    sled("SetEntityState", entity="box", state=moved)
    assert sled.read("eye").range_m == pytest.approx(1.8, abs=1e-12)
    sled("SpawnEntity", entity="ball", shape=pb.SHAPE_SPHERE, size_m=[0.1], mass_kg=2,
         pose=pb.Pose(position=pb.Vector3(y=9, z=50)))
    sled("ApplyWrench", entity="ball", wrench=pb.Wrench(force=pb.Vector3(x=4, z=2 * G)))
    sled.step(1000)
    ball = sled("GetEntityState", entity="ball").state
    assert at(ball.twist.linear, "x", "z") == pytest.approx([2, 0], abs=1e-6)
    sled("DeleteEntity", entity="box")
    assert sled.read("eye").range_m == pytest.approx(2.9, abs=1e-9)
    kept = sled("GetEntityState", entity="ball").state
    assert at(kept.pose.position, "x", "y", "z") == pytest.approx(at(ball.pose.position, "x", "y", "z"), abs=1e-9)
    assert refused(lambda: sled("DeleteEntity", entity="sled"))[0] == grpc.StatusCode.INVALID_ARGUMENT
    assert refused(lambda: sled("SetEntityState", entity="sled", state=moved))[0] == grpc.StatusCode.INVALID_ARGUMENT
    sled("ResetSimulation")
    assert refused(lambda: sled("GetEntityState", entity="ball"))[0] == grpc.StatusCode.INVALID_ARGUMENT


def test_a_base_drives_through_the_maze_and_its_devices_agree(client, worlds):
    with client.open(folder(worlds / "worlds" / "maze")) as maze:
        drive = pb.DeviceCommand(device="base", drive=pb.DriveCommand(linear=0.3))
        maze.step(1000, commands=[drive])
        before = {o.name: o.value for o in maze("ReadDevices").state.observations}
        assert maze.read("base").linear == pytest.approx(0.3, rel=0.05)
        after = {o.name: o.value for o in maze.step(1000).observations}
        assert after["robot_x"] - before["robot_x"] == pytest.approx(0.6, rel=0.05)
        scan = maze.read("lidar")
        assert scan.ranges_m[90] == pytest.approx(1.95 - after["robot_x"], abs=0.01)
        assert maze.read("battery").charge_ah == pytest.approx(2.5 - 1.2 * 4 / 3600)
        hit = pb.Condition(device=pb.DeviceCondition(device="bumper", field="pressed", above=0.5))
        assert maze("AdvanceUntil", condition=hit, limit_ns=20 * 10**9).met
        turn = pb.DeviceCommand(device="base", drive=pb.DriveCommand(angular=1.0))
        maze.prepare(Heading=1.0, StartX=0, StartY=0)
        maze.step(1000, commands=[turn])
        yaw = {o.name: o.value for o in maze("ReadDevices").state.observations}["robot_yaw"]
        # Tyres with a line contact slip when the base turns.
        assert yaw == pytest.approx(3.0, abs=0.4)


def test_cameras_show_the_scene(client, worlds):
    with client.open(folder(worlds / "worlds" / "maze")) as maze:
        try:
            depth = maze.read("depth")
        except grpc.RpcError as error:
            assert error.code() == grpc.StatusCode.FAILED_PRECONDITION
            pytest.skip(f"this machine cannot render: {error.details()}")
        assert (depth.height, depth.width, depth.encoding, depth.step) == (240, 320, "32FC1", 1280)
        metres = np.frombuffer(depth.data, "<f4").reshape(240, 320)
        # Distance to the east wall from the camera, which is 0.17 m in front of the robot's centre at -1.2.
        assert metres[118, 160] == pytest.approx(1.95 + 1.2 - 0.17, abs=0.02)
        colour = np.frombuffer(maze.read("camera").data, np.uint8)
        assert colour.size == 240 * 320 * 3
        maze.prepare(Light=0)
        assert np.frombuffer(maze.read("camera").data, np.uint8).mean() < colour.mean()
        assert not any(r.HasField("image") for r in maze("ReadDevices").state.readings)


ROBOTS = ("arm", "quadruped")


def robot_world(client, worlds, name):
    try:
        return client.open(folder(worlds / "worlds" / name))
    except grpc.RpcError as error:
        if "this machine needs" in error.details():
            pytest.skip(error.details())
        raise


# Joint angles with the fingers around the block, and 0.15 m above.
AT_BLOCK = (0, 0.4265, 0, -2.3591, 0, 2.7856, 0.7854)
ABOVE = (0, 0.0459, 0, -2.3763, 0, 2.4222, 0.7854)


def test_an_arm_grasps_and_lifts_a_block_and_measures_its_weight(client, worlds):
    with robot_world(client, worlds, "arm") as arm:

        def move(pose, width, seconds):
            joints = enumerate(pose, 1)
            commands = [pb.DeviceCommand(device=f"motor{i}", joint=pb.JointCommand(position=q)) for i, q in joints]
            commands.append(pb.DeviceCommand(device="gripper", gripper=pb.GripperCommand(width_m=width)))
            state = arm.step(round(seconds * 10**9 / arm.timestep_ns), commands=commands)
            return {o.name: o.value for o in state.observations}

        def weight():
            force = arm.read("wrist").force
            return math.hypot(force.x, force.y, force.z)

        arm.prepare(BlockMass=0.3)
        move(ABOVE, 0.08, 2)
        positions = [arm.read(f"encoder{i}").position for i in range(1, 8)]
        assert positions == pytest.approx(ABOVE, abs=0.05)
        empty = weight()
        lying = move(AT_BLOCK, 0.08, 2)
        assert (lying["block_z"], lying["block_on_table"], lying["block_held"]) == (pytest.approx(0.025, abs=1e-3), 1, 0)
        move(AT_BLOCK, 0.0, 1)
        # The block is 40 mm wide; contacts are soft.
        assert arm.read("gripper").width_m == pytest.approx(0.04, abs=0.001)
        for part in range(1, 11):
            lifted = move([a + (b - a) * part / 10 for a, b in zip(AT_BLOCK, ABOVE, strict=True)], 0.0, 0.2)
        assert lifted["block_z"] > 0.16
        assert (lifted["block_on_table"], lifted["block_held"]) == (0, 1)
        move(ABOVE, 0.0, 2)
        held = move(ABOVE, 0.0, 1)
        assert move(ABOVE, 0.0, 3)["block_z"] == pytest.approx(held["block_z"], abs=0.0005)
        assert arm.read("gripper").width_m == pytest.approx(0.04, abs=0.001)
        assert weight() - empty == pytest.approx(0.3 * G, abs=0.05)


def test_a_quadruped_stands_and_its_imu_reads_gravity(client, worlds):
    with robot_world(client, worlds, "quadruped") as dog:
        stance = {"hip": 0.0, "thigh": 0.9, "calf": -1.8}
        commands = [
            pb.DeviceCommand(device=f"{leg}_{joint}", joint=pb.JointCommand(position=q))
            for leg in ("FL", "FR", "RL", "RR")
            for joint, q in stance.items()
        ]
        state = dog.step(1500, commands=commands)
        seen = {o.name: o.value for o in state.observations}
        assert 0.2 < seen["height"] < 0.4
        assert abs(seen["roll"]) < 0.2
        force = dog.read("imu").linear_acceleration
        assert math.hypot(force.x, force.y, force.z) == pytest.approx(G, abs=0.5)
