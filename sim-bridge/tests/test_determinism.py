"""The same world, seed and calls give the same bits in another process and with any number of threads."""

from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sitaf_bridge.wire import simulation_pb2 as pb
from sitaf_bridge.world.sensing.noise import gaussian, stream, uniform
from tests.client import Bridge, TestSession, running_bridge

MAZE = Path(__file__).parents[2] / "examples" / "worlds" / "maze"


def maze() -> pb.WorldSource:
    files = {path.name: path.read_bytes() for path in MAZE.iterdir()}
    return pb.WorldSource(description="maze.world.yaml", files=files)


def drive(session: TestSession) -> pb.Recording:
    control, session_id = session.bridge.control, session.id
    control.StartRecording(pb.StartRecordingRequest(session_id=session_id))
    session.prepare(StartX=-1.0, LidarNoise=0.05, LidarDelay=0.1, Friction=0.4, settle_ns=100_000_000)
    fault = pb.Fault(kind=pb.FAULT_KIND_INTERMITTENT, value=0.3)
    control.SetDeviceFault(pb.SetDeviceFaultRequest(session_id=session_id, device="imu", faults=[fault]))
    for speed in (0.1, 0.5, -0.3):
        command = pb.DeviceCommand(device="base", drive=pb.DriveCommand(linear=speed, angular=0.4))
        control.StepSimulation(pb.StepSimulationRequest(session_id=session_id, steps=300, commands=[command]))
    return control.StopRecording(pb.StopRecordingRequest(session_id=session_id)).recording


@pytest.mark.slow
def test_a_recording_has_the_same_digest_in_another_process(bridge: Bridge) -> None:
    with running_bridge() as address:
        other = Bridge(address)
        first, second = bridge.create(maze(), seed=5), other.create(maze(), seed=5)
        recording = drive(first)
        assert recording.digest == drive(second).digest
        replay = pb.ReplayRecordingRequest(session_id=second.id, recording=recording)
        assert other.control.ReplayRecording(replay).identical
        assert drive(other.create(maze(), seed=6)).digest != recording.digest
        other.channel.close()


def test_a_reset_session_equals_a_new_one(bridge: Bridge) -> None:
    new, used = bridge.create(maze(), seed=5), bridge.create(maze(), seed=5)
    drive(used)
    used.set(Friction=0.9, StartX=0.7)
    used.reset()
    assert used.read() == new.read()
    assert used.parameters() == new.parameters()
    assert drive(used).digest == drive(new).digest


def test_threads_do_not_change_a_bit(bridge: Bridge) -> None:
    session = bridge.create(maze(), seed=3)
    values = [0.1 * i - 1.2 for i in range(20)]
    answers = [
        bridge.control.PrepareMany(
            pb.PrepareManyRequest(
                session_id=session.id,
                parameters=["StartX"],
                values=values,
                cases=len(values),
                settle_ns=50_000_000,
                threads=threads,
            )
        ).SerializeToString()
        for threads in (1, 2)
    ]
    assert answers[0] == answers[1]


@settings(max_examples=50, deadline=None)
@given(st.integers(0, 2**64 - 1), st.integers(0, 2**40), st.integers(1, 100))
def test_noise_is_a_function_of_its_key_and_step(seed: int, step: int, count: int) -> None:
    key = stream(seed, "lidar")
    numbers = gaussian(key, step, count)
    assert (numbers == gaussian(key, step, count)).all()
    assert (abs(numbers) < 10).all()
    assert (numbers != gaussian(key, step + 1, count)).any()
    assert (numbers != gaussian(stream(seed, "sonar"), step, count)).any()
    assert ((uniform(key, step, count) > 0) & (uniform(key, step, count) <= 1)).all()
