"""Real and recorded devices in place of simulated ones."""

import json
import math
import signal
import subprocess
import sys
import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path

import pytest
from sitaf_hardware import Device, DeviceError, Limits, Reading, serving

from sitaf_bridge.errors import InvalidRequest, UnreachableValue, WrongState
from sitaf_bridge.hardware.checking import check
from sitaf_bridge.hardware.client import CommandRefused, ProviderClient
from sitaf_bridge.hardware.live import Backend, LiveHardware
from sitaf_bridge.hardware.provide import devices_of
from sitaf_bridge.hardware.replay import Recorded, read_recording
from sitaf_bridge.session.session import Session
from sitaf_bridge.world.description.source import read_world
from sitaf_bridge.world.devices import Command
from sitaf_bridge.world.driving.simulation import Simulation
from sitaf_bridge.world.world import World, load_world

# The time limit of heartbeats in tests of something else; the machine of a test may be loaded.
PATIENT_MS = 10_000
EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def bay() -> World:
    return load_world(read_world(EXAMPLES / "serial-range" / "world" / "bay.world.yaml"))


@pytest.fixture(scope="module")
def joint() -> World:
    return load_world(read_world(EXAMPLES / "modbus-joint" / "world" / "joint.world.yaml"))


class Finder(Device):
    """A range finder that a test controls."""

    kind = "range"
    fields: Mapping[str, str] = {"range": "m"}

    def __init__(self) -> None:
        self.distance = 1.5
        self.age_s = 0.0
        self.broken = ""

    def read(self) -> Reading:
        if self.broken:
            raise DeviceError(self.broken)
        return Reading([self.distance], time.monotonic() - self.age_s)


class Motor(Device):
    """A motor that keeps its commands."""

    kind = "joint_motor"
    fields: Mapping[str, str] = {"position": "rad", "velocity": "rad/s", "effort": "N m"}
    commands: Mapping[str, Limits] = {"velocity": Limits("rad/s", -3, 3)}

    def __init__(self) -> None:
        self.commanded: list[float] = []
        self.stopped: list[float] = []

    def read(self) -> Sequence[float]:
        return [0.25, self.commanded[-1] if self.commanded else 0.0, 0.0]

    def command(self, numbers: Mapping[str, float]) -> None:
        self.commanded.append(numbers["velocity"])

    def stop(self) -> None:
        self.stopped.append(time.monotonic())


@contextmanager
def provided(folder: Path, **devices: Device) -> Iterator[ProviderClient]:
    address = f"unix:{folder}/p.sock"
    with serving(devices, address):
        client = ProviderClient(address, PATIENT_MS)
        try:
            yield client
        finally:
            client.close()


@contextmanager
def live(world: World, client: ProviderClient | None, *backends: Backend) -> Iterator[tuple[LiveHardware, Simulation]]:
    hardware = LiveHardware(lambda _: {backend.device: backend for backend in backends}, client)
    hardware.attach(world)
    simulation = Simulation(world)
    simulation.attach(hardware)
    hardware.begin(1)
    yield hardware, simulation
    hardware.close()


def reading(simulation: Simulation, device: str) -> tuple[float, ...]:
    return next(r.values for r in simulation.state.readings if r.device.name == device)


def test_a_real_device_replaces_the_simulated_one_and_faults_act_after_it(tmp_path: Path, bay: World) -> None:
    finder = Finder()
    with provided(tmp_path, front=finder) as client, live(bay, client, Backend("front", 1.0)) as (hardware, simulation):
        assert simulation.prepare({"Distance": 3.0}, 0).readings[0].values == (1.5,)
        assert simulation.state.observations["measured"] == 1.5
        # The same step is not read again.
        finder.distance = 2.0
        assert reading(simulation, "front") == (1.5,)
        assert simulation.step(1).readings[0].values == (2.0,)
        # Beyond what the world's device can measure, as in REP-117.
        finder.distance = 7.0
        assert simulation.step(1).readings[0].values == (math.inf,)
        finder.distance = 2.0
        assert simulation.set({"fault.front.offset": 0.5}).readings[0].values == (2.5,)
        assert hardware.report(1).faults == []
        assert hardware.report(1).readings > 0


@pytest.mark.parametrize("backend", [Backend("front", 5.0), Backend("front", 5.0, shadow=True)])
def test_a_reading_that_is_too_old_is_a_fault_and_never_repeated(tmp_path: Path, bay: World, backend: Backend) -> None:
    finder = Finder()
    with provided(tmp_path, front=finder) as client, live(bay, client, backend) as (hardware, simulation):
        simulation.prepare({"Distance": 3.0}, 0)
        assert hardware.report(1).stale == 0
        finder.age_s = 5.1
        seen = simulation.step(1).readings[0].values
        assert hardware.report(1).stale == 1
        assert "older than max_age_s: 5" in hardware.report(1).faults[0]
        # The component uses the simulated device of a shadow.
        assert seen == (3.0,) if backend.shadow else math.isnan(seen[0])


def test_a_broken_device_and_a_lost_provider_are_faults_of_their_case_only(tmp_path: Path, bay: World) -> None:
    finder = Finder()
    address = f"unix:{tmp_path}/p.sock"
    client = ProviderClient(address, PATIENT_MS)
    with serving({"front": finder}, address):
        hardware = LiveHardware(lambda _: {"front": Backend("front", 1.0)}, client)
        hardware.attach(bay)
        simulation = Simulation(bay)
        simulation.attach(hardware)
        hardware.begin(1)
        finder.broken = "the cable is loose"
        assert math.isnan(simulation.prepare({}, 0).readings[0].values[0])
        assert hardware.report(1).faults == ["front: the cable is loose"]
        finder.broken = ""
        hardware.begin(2)
        assert simulation.prepare({}, 0).readings[0].values == (1.5,)
        assert hardware.report(2).faults == []
    hardware.begin(3)
    assert math.isnan(simulation.prepare({}, 0).readings[0].values[0])
    assert hardware.report(3).faults
    with serving({"front": Finder()}, address):
        end = time.monotonic() + 10
        while time.monotonic() < end:
            hardware.begin(4)
            if simulation.prepare({}, 0).readings[0].values == (1.5,):
                break
            time.sleep(0.05)
        hardware.begin(5)
        assert simulation.prepare({}, 0).readings[0].values == (1.5,)
        assert hardware.report(5).faults == []
        client.close()


def test_a_shadow_is_compared_at_each_step(tmp_path: Path, bay: World) -> None:
    finder = Finder()
    backend = Backend("front", 1.0, shadow=True)
    with provided(tmp_path, front=finder) as client, live(bay, client, backend) as (_, simulation):
        simulation.record_signals(["front.shadow_error", "front.range"], settling=False)
        assert simulation.prepare({"Distance": 2.0}, 0).readings[0].values == (2.0,)
        finder.distance = 2.25
        simulation.step(3)
        trace = simulation.signals(0)
        assert trace.values.tolist() == [[0.5, 2.0], [0.25, 2.0], [0.25, 2.0], [0.25, 2.0]]


def test_simulation_time_is_paced_and_lateness_is_measured(bay: World) -> None:
    clock = [1_000_000_000]
    hardware = LiveHardware(
        lambda _: {"front": Backend("front", math.inf, recorded=Recorded([0.0], [(1.0,)]))},
        None,
        lambda: clock[0],
        lambda seconds: clock.__setitem__(0, clock[0] + round(seconds * 1e9)),
    )
    hardware.attach(bay)
    simulation = Simulation(bay)
    simulation.attach(hardware)
    hardware.begin(1)
    simulation.prepare({}, 0)
    hardware.settled()
    # The call under test may take any time before the first step.
    clock[0] += 300_000_000
    begin = clock[0]
    simulation.step(10)
    assert clock[0] - begin == 10 * bay.timestep_ns
    clock[0] += 7_000_000
    simulation.step(1)
    report = hardware.report(1)
    assert (report.exchanges, report.max_jitter_ns, report.missed) == (2, 2_000_000, 0)
    clock[0] += 20_000_000
    simulation.step(1)
    assert (report.max_jitter_ns, report.missed) == (17_000_000, 1)


def test_commands_reach_a_real_actuator_after_faults_and_only_within_its_envelope(tmp_path: Path, joint: World) -> None:
    motor = Motor()
    with (
        provided(tmp_path, motor=motor) as client,
        guard(tmp_path, motor={"limits": {"velocity": [-1.5, 1.5]}, "timeout_ms": PATIENT_MS}) as guarded,
        live(joint, guarded, Backend("motor", 1.0)) as (hardware, simulation),
    ):
        del client
        simulation.prepare({}, 0)
        simulation.step(1, commands=[Command("motor", "joint", {"velocity": 1.0})])
        assert motor.commanded == [1.0]
        assert reading(simulation, "motor")[:2] == (0.25, 1.0)
        for attempt in range(1000):
            beyond = (1 if attempt % 2 else -1) * (1.5 + (attempt + 1) / 700)
            with pytest.raises(UnreachableValue, match=r"velocity"):
                simulation.step(1, commands=[Command("motor", "joint", {"velocity": beyond})])
        assert motor.commanded == [1.0]
        assert hardware.report(1).refused > 900
        simulation.set({"fault.motor.ignored": 1.0})
        simulation.step(1, commands=[Command("motor", "joint", {"velocity": 0.5})])
        assert motor.commanded == [1.0]


def test_a_guard_limits_the_change_of_commands(tmp_path: Path) -> None:
    motor = Motor()
    entry = {"limits": {"velocity": [-3, 3]}, "rates": {"velocity": 2.0}, "timeout_ms": PATIENT_MS}
    with provided(tmp_path, motor=motor), guard(tmp_path, motor=entry) as guarded:
        guarded.hold(["motor"])
        with pytest.raises(CommandRefused, match="more than 2 per second"):
            guarded.command([("motor", {"velocity": 1.0})])
        sent, value = 0, 0.0
        while value < 0.2:
            value += 0.02
            time.sleep(0.015)
            guarded.command([("motor", {"velocity": value})])
            sent += 1
        assert len(motor.commanded) == sent
        with pytest.raises(CommandRefused):
            guarded.command([("motor", {"velocity": -0.5})])


@contextmanager
def guard(folder: Path, **devices: Mapping[str, object]) -> Iterator[ProviderClient]:
    """A guard process of the provider in a folder."""
    with guard_process(folder, **devices) as (client, _):
        yield client


@contextmanager
def guard_process(
    folder: Path, **devices: Mapping[str, object]
) -> Iterator[tuple[ProviderClient, "subprocess.Popen[str]"]]:
    entries = {name: {"address": f"unix:{folder}/p.sock", **entry} for name, entry in devices.items()}
    (folder / "devices.json").write_text(json.dumps(entries))
    command = [sys.executable, "-m", "sitaf_bridge", "guard", "--listen", f"unix:{folder}/g.sock"]
    command += ["--devices", str(folder / "devices.json")]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        assert process.stdin is not None
        assert process.stdout.readline().startswith("listening")
        client = ProviderClient(f"unix:{folder}/g.sock", PATIENT_MS)
        try:
            yield client, process
        finally:
            client.close()
            process.stdin.close()
            process.wait(20)


@pytest.mark.parametrize("end", [signal.SIGKILL, signal.SIGSTOP, signal.SIGTERM])
def test_devices_stop_when_the_guard_dies_or_hangs(tmp_path: Path, end: signal.Signals) -> None:
    motor = Motor()
    with provided(tmp_path, motor=motor), guard_process(tmp_path, motor={}) as (guarded, process):
        guarded.hold(["motor"])
        guarded.command([("motor", {"velocity": 1.0})])
        before = len(motor.stopped)
        began = time.monotonic()
        process.send_signal(end)
        while len(motor.stopped) == before and time.monotonic() < began + 5:
            time.sleep(0.001)
        assert len(motor.stopped) > before
        process.send_signal(signal.SIGKILL)
    # The time limit of heartbeats is 90 ms; the machine of a test may be loaded.
    assert motor.stopped[before] - began < 1.0


def test_devices_must_fit_the_world_and_follow_what_a_test_sets(tmp_path: Path, bay: World, joint: World) -> None:
    finder = Finder()
    finder.fields = {"range": "mm"}
    with provided(tmp_path, front=finder, motor=Motor()) as client:
        backends = {name: Backend(name, 1.0) for name in ("front", "frnt")}
        with pytest.raises(InvalidRequest) as raised:
            check(bay, backends, client, ["Distance", "fault.front.dropout"])
        assert str(raised.value).splitlines() == [
            "hardware.front: the provider gives range in mm, but the world in m",
            "hardware.front: a test sets Distance, which the device cannot follow, because its provider declares no "
            "set for Distance; write independent_of: [Distance] if the readings do not depend on it",
            "hardware.frnt: the world has no such device; did you mean front?",
        ]
        finder.fields = {"range": "m"}
        independent = {"front": Backend("front", 1.0, independent_of=("Distance",))}
        assert check(bay, independent, client, ["Distance"]) == ["front: a real device"]
        with pytest.raises(InvalidRequest, match="only a simulated actuator can have"):
            check(joint, {"motor": Backend("motor", 1.0)}, client, ["fault.motor.saturated"])
    with (
        provided(tmp_path, encoder=finder) as client,
        pytest.raises(InvalidRequest, match="is of the kind range, but the world declares a joint_encoder"),
    ):
        check(joint, {"encoder": Backend("encoder", 1.0)}, client, [])


def test_the_devices_of_a_world_can_be_provided_again(tmp_path: Path, joint: World) -> None:
    with provided(tmp_path, **devices_of(joint, None)) as client:
        backends = [Backend("motor", 1.0), Backend("encoder", 1.0)]
        assert len(check(joint, {b.device: b for b in backends}, client, ["StartAngle"])) == 2
        with live(joint, client, *backends) as (hardware, simulation):
            alone = Simulation(joint)
            for each in (simulation, alone):
                each.prepare({"StartAngle": 0.5}, 0)
                each.step(20, commands=[Command("motor", "joint", {"velocity": 1.0})])
            assert simulation.state.readings == alone.state.readings
            assert hardware.report(1).faults == []


def test_operations_that_need_simulated_devices_are_refused(bay: World) -> None:
    session = Session("s", bay, 1, 10.0)
    session.hardware = LiveHardware(lambda _: {}, None)
    with pytest.raises(WrongState, match="needs simulated devices"):
        session.check_simulated("PrepareMany")


def test_a_recording_holds_until_the_next_reading_and_not_longer_than_allowed() -> None:
    text = b"t,front.range,other\n0.5,1.0,x\n1.0,2.0,x\n"
    recorded = read_recording("f.csv", text, "", device="front", kind="range", fields=["range"])
    assert recorded.at(0.4, math.inf) is None
    assert recorded.at(0.5, math.inf) == (1.0,)
    assert recorded.at(0.99, math.inf) == (1.0,)
    assert recorded.at(9.0, math.inf) == (2.0,)
    assert recorded.at(1.2, 0.2) == (2.0,)
    assert recorded.at(1.21, 0.2) is None


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (b"", "f.csv:1: has no column 't'"),
        (b"t,x\n0,1\n", "f.csv:1: has no column 'range'; its columns are t, x"),
        (b"t,range\n0,1\nx,2\n", "f.csv:3: t: 'x' is not a number"),
        (b"t,range\n0,1\n1\n", "f.csv:3: has 1 columns instead of 2"),
        (b"t,range\n1,1\n0,2\n", "f.csv:3: t: 0 is before 1; sort the rows"),
        (b"t,range\nnan,1\n", "f.csv:2: t: nan is not a finite number"),
        (b"t,range\n", "f.csv: has no rows"),
        (b"\xff\xfe", "f.csv: is not a CSV file in UTF-8"),
    ],
)
def test_a_bad_recording_is_refused_with_its_line(text: bytes, message: str) -> None:
    with pytest.raises(InvalidRequest) as raised:
        read_recording("f.csv", text, "", device="front", kind="range", fields=["range"])
    assert str(raised.value).startswith(message)


def test_a_topic_of_a_rosbag_is_a_recording(tmp_path: Path) -> None:
    rosbag2 = pytest.importorskip("rosbags.rosbag2")
    typesys = pytest.importorskip("rosbags.typesys")
    store = typesys.get_typestore(typesys.Stores.ROS2_JAZZY)
    types = store.types
    stamp = types["builtin_interfaces/msg/Time"](sec=1, nanosec=0)
    header = types["std_msgs/msg/Header"](stamp=stamp, frame_id="front")
    with rosbag2.Writer(tmp_path / "bag", version=9, storage_plugin=rosbag2.StoragePlugin.MCAP) as writer:
        connection = writer.add_connection("/front", "sensor_msgs/msg/Range", typestore=store)
        for tick in range(3):
            fields = {"radiation_type": 1, "field_of_view": 0.1, "min_range": 0.0, "max_range": 9.0, "variance": 0.0}
            message = types["sensor_msgs/msg/Range"](header=header, range=0.5 + tick, **fields)
            raw = store.serialize_cdr(message, "sensor_msgs/msg/Range")
            writer.write(connection, 5_000_000_000 + tick * 100_000_000, raw)
    content = next((tmp_path / "bag").glob("*.mcap")).read_bytes()

    recorded = read_recording("f.mcap", content, "/front", device="front", kind="range", fields=["range"])
    assert list(recorded.times) == pytest.approx([0.0, 0.1, 0.2])
    assert recorded.at(0.15, math.inf) == (1.5,)
    for topic, kind, message in [
        ("/back", "range", "has no topic '/back'; its topics are /front"),
        ("/front", "imu", "a imu needs one of: sensor_msgs/msg/Imu"),
    ]:
        with pytest.raises(InvalidRequest, match=message):
            read_recording("f.mcap", content, topic, device="front", kind=kind, fields=["range"])
    with pytest.raises(InvalidRequest, match="is not a rosbag2 recording in MCAP"):
        read_recording("f.mcap", content[:200], "/front", device="front", kind="range", fields=["range"])
