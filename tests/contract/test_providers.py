"""The protocol of hardware providers. Any provider: pytest tests/contract/test_providers.py --provider ADDRESS."""

import math
import queue
import time
from contextlib import suppress

import grpc
import pytest
from needs import socat
from provider_contract import PROVIDERS, running

pb = pytest.importorskip("sitaf_hardware.wire.hardware_pb2", reason="pip install ./hardware/python")
pb_grpc = pytest.importorskip("sitaf_hardware.wire.hardware_pb2_grpc")

# The time limit of a hold.
TIMEOUT_MS = 1000


class Hold:
    """A stream that holds devices."""

    def __init__(self, stub, devices, timeout_ms=10_000):
        self._messages = queue.SimpleQueue()
        self._messages.put(pb.HoldRequest(devices=devices, timeout_ms=timeout_ms))
        self.call = stub.Hold(iter(self._messages.get, None))
        self.identity = next(self.call).hold

    def beat(self):
        self._messages.put(pb.HoldRequest())
        return next(self.call).hold

    def close(self):
        self._messages.put(None)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()
        # The provider may have ended the hold before.
        with suppress(grpc.RpcError):
            list(self.call)


@pytest.fixture(
    scope="module",
    params=[pytest.param(name, marks=socat) if name == "serial line" else name for name in PROVIDERS],
)
def address(request):
    named = request.config.getoption("--provider")
    if named:
        if request.param != next(iter(PROVIDERS)):
            pytest.skip("the suite runs once against --provider")
        yield named
        return
    if request.param == "Modbus":
        pytest.importorskip("pymodbus")
    with running(PROVIDERS[request.param]) as (_, target):
        yield target


@pytest.fixture(scope="module")
def stub(address):
    with grpc.insecure_channel(address) as channel:
        yield pb_grpc.HardwareProviderStub(channel)


@pytest.fixture(scope="module")
def devices(stub):
    return {device.name: device for device in stub.Describe(pb.DescribeRequest()).devices}


@pytest.fixture
def hold(stub, devices):
    with Hold(stub, list(devices)) as held:
        yield held


def read(stub, hold, devices):
    simulated = [
        pb.SimulatedReading(device=d.name, values=[0.5] * len(d.fields))
        for d in devices.values()
        if d.follows_simulation
    ]
    return stub.Read(pb.ReadRequest(hold=hold.identity, devices=list(devices), simulated=simulated)).readings


def health(stub, name):
    (found,) = stub.CheckHealth(pb.CheckHealthRequest(devices=[name])).devices
    return found


def actuator(devices):
    found = next((d for d in devices.values() if d.commands), None)
    if found is None:
        pytest.skip("the provider has sensors only")
    return found


def middle(number):
    low = number.min if number.HasField("min") else -1.0
    high = number.max if number.HasField("max") else 1.0
    return (low + high) / 2


def command(stub, hold, device, **numbers):
    whole = {number.name: middle(number) for number in device.commands}
    # One number for a motor, which takes one; all of them for the others.
    chosen = {**({} if device.kind == "joint_motor" else whole), **numbers} or dict([next(iter(whole.items()))])
    message = pb.DeviceCommand(device=device.name, numbers=chosen)
    return stub.Command(pb.CommandRequest(hold=hold.identity, commands=[message]))


def test_a_description_names_each_device_its_kind_and_the_units_of_its_numbers(devices):
    assert devices
    for device in devices.values():
        assert device.kind
        assert device.fields
        numbers = [*device.fields, *device.commands]
        assert all(number.name and number.unit for number in numbers), device
        assert len({field.name for field in device.fields}) == len(device.fields)
        for number in device.commands:
            if number.HasField("min") and number.HasField("max"):
                assert number.min <= number.max


def test_a_reading_has_the_described_numbers_and_an_age(stub, devices, hold):
    readings = read(stub, hold, devices)
    assert [reading.device for reading in readings] == list(devices)
    for reading in readings:
        assert reading.fault == ""
        assert len(reading.values) == len(devices[reading.device].fields)
        assert 0 <= reading.age_ns < 5e9


def test_devices_that_are_not_held_cannot_be_read_or_commanded(stub, devices, refused):
    name = next(iter(devices))
    for hold in ("", "another"):
        code, message = refused(lambda hold=hold: stub.Read(pb.ReadRequest(hold=hold, devices=[name])))
        assert code == grpc.StatusCode.FAILED_PRECONDITION
        assert name in message


def test_a_device_has_one_holder(stub, devices, hold):
    call = stub.Hold(iter([pb.HoldRequest(devices=[next(iter(devices))], timeout_ms=1000)]))
    with pytest.raises(grpc.RpcError) as raised:
        list(call)
    assert raised.value.code() == grpc.StatusCode.RESOURCE_EXHAUSTED
    assert hold.beat() == hold.identity


def test_a_device_can_be_held_again_after_its_holder_has_closed(stub, devices):
    for _ in range(3):
        with Hold(stub, list(devices)) as held:
            assert held.identity


def test_an_unknown_device_is_named(stub, devices, hold, refused):
    calls = [
        lambda: stub.Read(pb.ReadRequest(hold=hold.identity, devices=["no such device"])),
        lambda: stub.CheckHealth(pb.CheckHealthRequest(devices=["no such device"])),
        lambda: stub.StopSafely(pb.StopSafelyRequest(devices=["no such device"])),
    ]
    for call in calls:
        code, message = refused(call)
        assert code == grpc.StatusCode.NOT_FOUND
        assert "no such device" in message


@pytest.mark.parametrize("timeout_ms", [0, 9, 10_001])
def test_the_time_limit_of_a_hold_is_checked(stub, devices, timeout_ms):
    call = stub.Hold(iter([pb.HoldRequest(devices=list(devices), timeout_ms=timeout_ms)]))
    with pytest.raises(grpc.RpcError) as raised:
        list(call)
    assert raised.value.code() == grpc.StatusCode.INVALID_ARGUMENT


def test_a_command_within_the_limits_is_carried_out(stub, devices, hold):
    command(stub, hold, actuator(devices))


@pytest.mark.parametrize("beyond", [1.001, 10.0, 1e9])
def test_a_command_beyond_the_limits_is_refused(stub, devices, hold, refused, beyond):
    device = actuator(devices)
    limited = [number for number in device.commands if number.HasField("max")]
    if not limited:
        pytest.skip("the commands have no limits")
    number = limited[0]
    value = number.max + beyond * (abs(number.max) + 1)
    code, message = refused(lambda: command(stub, hold, device, **{number.name: value}))
    assert code == grpc.StatusCode.OUT_OF_RANGE
    assert number.name in message


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf])
def test_a_command_that_is_not_finite_is_refused(stub, devices, hold, refused, value):
    device = actuator(devices)
    code, _ = refused(lambda: command(stub, hold, device, **{device.commands[0].name: value}))
    assert code == grpc.StatusCode.INVALID_ARGUMENT


def test_an_unknown_number_and_an_empty_command_are_refused(stub, devices, hold, refused):
    device = actuator(devices)
    code, message = refused(lambda: command(stub, hold, device, no_such_number=0.0))
    assert code == grpc.StatusCode.INVALID_ARGUMENT
    assert "no_such_number" in message
    empty = pb.CommandRequest(hold=hold.identity, commands=[pb.DeviceCommand(device=device.name)])
    assert refused(lambda: stub.Command(empty))[0] == grpc.StatusCode.INVALID_ARGUMENT


def test_only_described_parameters_can_be_set(stub, devices, hold, refused):
    code, message = refused(lambda: stub.Set(pb.SetRequest(hold=hold.identity, parameters={"no such parameter": 1.0})))
    assert code == grpc.StatusCode.INVALID_ARGUMENT
    assert "no such parameter" in message
    for device in devices.values():
        for parameter in device.parameters:
            stub.Set(pb.SetRequest(hold=hold.identity, parameters={parameter: 0.5}))


def test_devices_stop_when_the_holder_closes(stub, devices):
    name = next(iter(devices))
    before = health(stub, name).safe_stops
    with Hold(stub, list(devices)):
        assert health(stub, name).held
    assert health(stub, name).safe_stops > before
    assert not health(stub, name).held


def test_devices_stop_when_the_holder_disconnects(address, stub, devices):
    name = next(iter(devices))
    before = health(stub, name).safe_stops
    channel = grpc.insecure_channel(address, options=[("grpc.use_local_subchannel_pool", 1)])
    Hold(pb_grpc.HardwareProviderStub(channel), list(devices))
    channel.close()
    assert stops_within(stub, name, before, 5.0)


def test_devices_stop_when_heartbeats_stop(stub, devices):
    name = next(iter(devices))
    with Hold(stub, list(devices), TIMEOUT_MS) as held:
        for _ in range(5):
            time.sleep(TIMEOUT_MS / 1000 / 4)
            assert held.beat() == held.identity
        before = health(stub, name).safe_stops
        assert stops_within(stub, name, before, TIMEOUT_MS / 1000 + 5.0)
        with pytest.raises(grpc.RpcError) as raised:
            list(held.call)
        assert raised.value.code() == grpc.StatusCode.DEADLINE_EXCEEDED


def test_anyone_may_stop_devices(stub, devices, hold):
    name = next(iter(devices))
    before = health(stub, name)
    stub.StopSafely(pb.StopSafelyRequest(devices=[name], reason="an operator asked for it"))
    after = health(stub, name)
    assert after.safe_stops == before.safe_stops + 1
    assert after.last_stop == "an operator asked for it"
    # The next command moves it again.
    assert not read(stub, hold, devices)[0].fault


def test_devices_are_healthy(stub, devices):
    for found in stub.CheckHealth(pb.CheckHealthRequest()).devices:
        assert found.fault == "" or devices[found.device].follows_simulation


def stops_within(stub, name, before, limit_s):
    end = time.monotonic() + limit_s
    while time.monotonic() < end:
        if health(stub, name).safe_stops > before:
            return True
        time.sleep(0.005)
    return False
