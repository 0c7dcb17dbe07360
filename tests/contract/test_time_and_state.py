"""Time, isolation, snapshots, recordings."""

import threading
import time

import grpc
import pytest

from client import folder, numbers, pb, world

BALL = """
<option timestep="0.001"/>
<worldbody>
  <geom name="floor" type="plane" size="0 0 0.1"/>
  <body name="ball" pos="0 0 2"><freejoint/><geom name="ball" type="sphere" size="0.1" mass="1"/>
    <site name="ball"/></body>
  <body name="arm" pos="1 0 1"><joint name="hinge" axis="0 1 0"/><geom type="capsule" size="0.02" fromto="0 0 0 0 0 -0.4"/></body>
</worldbody>
<actuator><motor name="motor" joint="hinge" ctrlrange="-1 1"/></actuator>
"""
BALL_YAML = """
parameters:
  Height: {unit: m, range: [0.1, 10], default: 2, bind: {set: body.ball.pos.z}}
  Mass: {unit: kg, range: [0.1, 10], default: 1, bind: {set: body.ball.mass}}
devices:
  imu: {kind: imu, site: ball, noise: 0.01}
  pose: {kind: pose, site: ball}
  motor: {kind: joint_motor, actuator: motor}
observations:
  z: {entity: ball, axis: z}
"""


@pytest.fixture
def ball(client):
    with client.open(world(BALL, BALL_YAML)) as session:
        yield session


def test_exactly_the_requested_steps_pass_under_load(client, ball):
    stop = threading.Event()

    def load():
        with client.open(world(BALL, BALL_YAML)) as other:
            while not stop.is_set():
                other.step(50)

    threads = [threading.Thread(target=load) for _ in range(3)]
    for thread in threads:
        thread.start()
    try:
        total = 0
        for steps in (1, 7, 100, 1, 333):
            total += steps
            state = ball.step(steps)
            assert (state.step, state.time_ns) == (total, total * 1_000_000)
    finally:
        stop.set()
        for thread in threads:
            thread.join()


def test_sensors_are_right_immediately_after_a_reset(ball):
    first = ball.prepare()
    ball.step(500, commands=[pb.DeviceCommand(device="motor", joint=pb.JointCommand(effort=0.5))])
    assert numbers(ball("ResetSimulation").state) == numbers(first)


def test_two_sessions_never_influence_each_other(client, ball):
    alone = numbers(ball.step(200))
    ball("ResetSimulation")
    with client.open(world(BALL, BALL_YAML)) as other:
        for _ in range(20):
            last = ball.step(10)
            other("SetParameters", values={"Mass": 5, "Height": 7})
            other.step(3)
    assert numbers(last) == alone


def test_the_seed_decides_the_noise_and_reading_twice_changes_nothing(client):
    def read(seed):
        with client.open(world(BALL, BALL_YAML), seed=seed) as session:
            session.step(10)
            assert session.read("imu") == session.read("imu")
            return session.read("imu")

    assert read(1) == read(1)
    assert read(1) != read(2)


def test_a_snapshot_restores_the_exact_state_and_its_future(ball):
    ball("SetParameters", values={"Mass": 3})
    ball.fault("pose", ("OFFSET", 1.0))
    here = ball.step(100)
    taken = ball("TakeSnapshot")
    future = numbers(ball.step(300))
    ball("ResetSimulation")
    assert numbers(ball("RestoreSnapshot", snapshot_id=taken.snapshot_id).state) == numbers(here)
    assert ball("TakeSnapshot").digest == taken.digest
    assert numbers(ball.step(300)) == future
    assert dict(ball("GetParameters").values) == {"Mass": 3, "Height": 2}


def test_an_unknown_snapshot_is_refused(ball, refused):
    assert refused(lambda: ball("RestoreSnapshot", snapshot_id="77"))[0] == grpc.StatusCode.INVALID_ARGUMENT


def test_a_recording_replays_to_the_same_digest_in_another_session(client, ball):
    ball("StartRecording")
    ball.prepare(Height=3, settle_ns=20_000_000)
    kept = ball("TakeSnapshot").snapshot_id
    ball("WriteDevices", commands=[pb.DeviceCommand(device="motor", joint=pb.JointCommand(effort=-0.25))])
    ball.step(100)
    ball("SpawnEntity", entity="crate", shape=pb.SHAPE_BOX, size_m=[0.1, 0.1, 0.1], mass_kg=1,
         pose=pb.Pose(position=pb.Vector3(x=3, z=1)))
    ball("ApplyWrench", entity="ball", wrench=pb.Wrench(force=pb.Vector3(x=1)))
    ball.fault("imu", ("NOISE", 0.5), ("INTERMITTENT", 0.5))
    ball.step(50)
    ball("RestoreSnapshot", snapshot_id=kept)
    ball.step(5)
    recording = ball("StopRecording").recording
    assert len(recording.operations) == 10
    with client.open(world(BALL, BALL_YAML)) as other:
        replayed = other("ReplayRecording", recording=recording)
        assert (replayed.identical, replayed.digest) == (True, recording.digest)
        assert numbers(replayed.state) == numbers(ball("ReadDevices").state)
        recording.operations[3].request = pb.StepSimulationRequest(steps=101).SerializeToString()
        changed = other("ReplayRecording", recording=recording)
        assert (changed.identical, changed.first_difference) == (False, 3)


def test_a_recording_of_another_seed_is_refused(client, ball, refused):
    ball("StartRecording")
    assert refused(lambda: ball("StartRecording"))[0] == grpc.StatusCode.FAILED_PRECONDITION
    recording = ball("StopRecording").recording
    assert refused(lambda: ball("StopRecording"))[0] == grpc.StatusCode.FAILED_PRECONDITION
    with client.open(world(BALL, BALL_YAML), seed=9) as other:
        code, _ = refused(lambda: other("ReplayRecording", recording=recording))
        assert code == grpc.StatusCode.FAILED_PRECONDITION


def test_waiting_ends_at_its_time_and_blocks_no_other_call(ball):
    answers = []
    waiter = threading.Thread(target=lambda: answers.append(ball("WaitUntil", time_ns=50_000_000, timeout=20)))
    waiter.start()
    for _ in range(5):
        assert not answers
        ball.step(10)
    waiter.join(20)
    assert answers[0].state.time_ns == 50_000_000
    assert ball("WaitUntil", time_ns=3).state.time_ns == 50_000_000


def test_waiting_is_aborted_when_time_goes_back(ball, refused):
    ball.step(10)
    codes = []
    waiter = threading.Thread(
        target=lambda: codes.append(refused(lambda: ball("WaitUntil", time_ns=10**12, timeout=20))[0])
    )
    waiter.start()
    time.sleep(0.3)
    ball("ResetSimulation")
    waiter.join(20)
    assert codes == [grpc.StatusCode.ABORTED]


def test_a_session_whose_client_died_is_freed(client, refused):
    session = client.open(world(BALL, BALL_YAML), lease_s=0.3)
    time.sleep(0.8)
    assert refused(lambda: session.step(1))[0] == grpc.StatusCode.NOT_FOUND


def test_a_divergence_is_reported_and_can_be_reset(client, refused):
    unstable = """<option timestep="0.1" gravity="0 0 0"/><worldbody><body name="b"><joint name="j" type="slide" stiffness="1e9"/>
      <geom type="sphere" size="0.1" mass="0.001"/></body></worldbody>"""
    yaml = "parameters: {X: {unit: m, range: [0, 1], default: 0, bind: {set: joint.j.pos}}}\nobservations: {x: {entity: b, axis: z}}"
    with client.open(world(unstable, yaml)) as session:
        session.prepare(X=0.5)
        kept = session("TakeSnapshot").snapshot_id
        code, message = refused(lambda: session.step(5000))
        assert code == grpc.StatusCode.DATA_LOSS
        assert "diverged" in message
        assert refused(lambda: session.step(1))[0] == grpc.StatusCode.DATA_LOSS
        assert session("RestoreSnapshot", snapshot_id=kept).state.step == 0
        many = session("PrepareMany", parameters=["X"], values=[0.0, 0.5, 0.0], cases=3, settle_ns=500 * 10**9)
        assert list(many.diverged_cases) == [1]
        assert [value == value for value in many.readings] == [True, False, True]


def test_the_stream_does_what_the_unary_calls_do(client, ball):
    requests = [
        pb.OperateRequest(ping=pb.PingRequest()),
        pb.OperateRequest(prepare=pb.PrepareRequest(session_id=ball.id, parameters={"Height": 4})),
        pb.OperateRequest(step=pb.StepSimulationRequest(session_id=ball.id, steps=20, parameters={"Mass": 2})),
        pb.OperateRequest(step=pb.StepSimulationRequest(session_id=ball.id, steps=0)),
        pb.OperateRequest(read=pb.ReadDevicesRequest(session_id=ball.id)),
    ]
    answers = list(client.control.Operate(iter(requests)))
    assert not answers[0].HasField("state")
    assert answers[3].refusal.code == grpc.StatusCode.INVALID_ARGUMENT.value[0]
    assert numbers(answers[4].state) == numbers(answers[2].state)
    ball.prepare(Height=4)
    assert numbers(ball.step(20, parameters={"Mass": 2})) == numbers(answers[2].state)


def test_bulk_cases_have_the_readings_of_single_cases(client, worlds):
    with client.open(folder(worlds / "ir-sensor" / "world")) as session:
        distances = [-1, -0.25, 0, 0.1, 0.3, 0.5, 5, 7.3, 9.5, 10, 10.0001, 20] * 20
        for settle in (0, 20_000_000):
            many = session("PrepareMany", parameters=["Distance"], values=distances, cases=len(distances), settle_ns=settle)
            assert list(many.columns) == [*(f"ir{i}.range" for i in range(1, 8)), "robot_x"]
            for index, distance in enumerate(distances[:12]):
                state = session.prepare(Distance=distance, settle_ns=settle)
                alone = [r.range.range_m for r in state.readings] + [o.value for o in state.observations]
                assert list(many.readings[index * 8 : index * 8 + 8]) == alone


def test_bulk_cases_of_a_noisy_world_have_the_readings_of_single_cases(ball):
    many = ball("PrepareMany", parameters=["Height", "Mass"], values=[1, 1, 2, 5, 3, 0.5] * 12, cases=36, settle_ns=10**7,
                devices=["imu"])
    assert many.columns[4] == "imu.angular_velocity.x"
    for case, (height, mass) in enumerate([(1, 1), (2, 5), (3, 0.5)]):
        ball.prepare(Height=height, Mass=mass, settle_ns=10**7)
        imu = ball.read("imu").linear_acceleration
        row = many.readings[case * 11 : case * 11 + 11]
        assert list(row[7:10]) == [imu.x, imu.y, imu.z]


@pytest.mark.parametrize(
    ("fields", "code"),
    [
        ({"parameters": ["Height"], "values": [1, float("nan")], "cases": 2}, "INVALID_ARGUMENT"),
        ({"parameters": ["Height"], "values": [1, 99], "cases": 2}, "OUT_OF_RANGE"),
        ({"parameters": ["Height"], "values": [1], "cases": 2}, "INVALID_ARGUMENT"),
        ({"parameters": ["Nope"], "values": [1], "cases": 1}, "INVALID_ARGUMENT"),
        ({"parameters": ["Height"], "values": [1], "cases": 1, "devices": ["nope"]}, "INVALID_ARGUMENT"),
        ({"parameters": ["Height", "Height"], "values": [1, 1], "cases": 1}, "INVALID_ARGUMENT"),
        ({"parameters": [], "values": [], "cases": 2_000_000}, "RESOURCE_EXHAUSTED"),
    ],
)
def test_one_invalid_case_makes_the_bulk_call_fail(ball, refused, fields, code):
    assert refused(lambda: ball("PrepareMany", **fields))[0].name == code
