"""Real devices in activities: the same verdicts as simulated, and no verdict from a device that failed."""

import re
import shutil
import signal
import sys
import threading
import time
import xml.etree.ElementTree as ElementTree
from contextlib import contextmanager
from pathlib import Path

import grpc
import pytest
from needs import socat
from snippets import snippet

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "contract"))

from provider_contract import example, running, simulated  # noqa: E402

pb = pytest.importorskip("sitaf_hardware.wire.hardware_pb2", reason="pip install ./hardware/python")
pb_grpc = pytest.importorskip("sitaf_hardware.wire.hardware_pb2_grpc")

WORLD = "ir-sensor/world/ir.world.yaml"


def with_hardware(folder, lines, limits="jitter_ms: 2000"):
    """Add hardware to activity.yaml. The machine of a test is loaded, so time may be late."""
    profile = folder / "activity.yaml"
    text = re.sub(r"(?m)^(limits|hardware):.*\n(?:  .*\n)*", "", profile.read_text())
    profile.write_text(text + "hardware:\n" + "".join(f"  {line}\n" for line in lines) + f"limits: {{{limits}}}\n")
    return folder


def provider(address, name, age=5):
    return f'{name}: {{backend: provider, address: "{address}", max_age_s: {age}}}'


def counts(run):
    found = re.search(r"(\d+) cases, (\d+) PASS, (\d+) FAIL, (\d+) ERROR, (\d+) DONT", run.stdout)
    assert found, run.stdout + run.stderr
    return [int(number) for number in found.groups()]


@pytest.mark.parametrize("count", [7, pytest.param(1, marks=pytest.mark.long)])
def test_sensors_behind_a_provider_give_the_verdicts_of_simulated_ones(sitaf, activity, tmp_path, count):
    result = tmp_path / "results"
    with running(lambda address: simulated(WORLD, address)) as (_, address):
        with_hardware(activity, [provider(address, f"ir{n}") for n in range(1, count + 1)])
        # A heartbeat can be late on a busy machine, which makes a case DONT, but never FAIL or ERROR.
        for _ in range(3):
            run = sitaf("run", activity, "--result", result)
            total, passed, *failed, not_run = counts(run)
            assert failed == [0, 0], run.stdout
            if not_run == 0:
                break
    assert run.returncode == 0, run.stdout + run.stderr
    assert total == passed == 55
    assert "devices: ir1: a real device" in run.stdout
    for case in ElementTree.parse(result / "GetInfraredData.xml").getroot().findall(".//test_result"):
        hardware = case.find("hardware")
        assert len(hardware.findall("device")) == count
        assert int(hardware.get("readings")) >= count
        assert int(hardware.get("safe_stops")) == 1
        assert not hardware.findall("fault")


def run_with(sitaf, tmp_path, name, address, **replaced):
    """Run an example whose provider is at another address, as docs/hardware.md shows it."""
    assert f"./sitaf run examples/{name.removesuffix('-faulty')}\n" in snippet("hardware-5-sh")
    folder = shutil.copytree(sitaf.root / "examples" / name, tmp_path / name)
    profile = folder / "activity.yaml"
    text = re.sub(r'"unix:/tmp/[^"]*"', f'"{address}"', profile.read_text())
    for key, value in replaced.items():
        text = re.sub(rf"{key}: [\d.]+", f"{key}: {value}", text)
    profile.write_text(text)
    return sitaf("run", folder)


@socat
def test_a_range_finder_on_a_serial_line_passes_and_the_faulty_component_fails(sitaf, tmp_path):
    with running(lambda address: example("serial-range", address)) as (_, address):
        sound = run_with(sitaf, tmp_path, "serial-range", address, jitter_ms=5000, max_age_s=5)
        faulty = run_with(sitaf, tmp_path, "serial-range-faulty", address, jitter_ms=5000, max_age_s=5)
    assert sound.returncode == 0, sound.stdout + sound.stderr
    assert counts(sound) == [14, 14, 0, 0, 0]
    assert faulty.returncode == 1, faulty.stdout + faulty.stderr
    assert counts(faulty) == [14, 7, 7, 0, 0]


def test_a_servo_drive_on_modbus_never_fails_a_sound_component(sitaf, tmp_path):
    """A machine that is too slow for the loop of the example gives DONT; its time limits are not raised."""
    pytest.importorskip("pymodbus")
    with running(lambda address: example("modbus-joint", address)) as (_, address):
        run = run_with(sitaf, tmp_path, "modbus-joint", address)
    total, passed, failed, errors, not_run = counts(run)
    assert total == 4
    assert failed == errors == 0, run.stdout + run.stderr
    assert not_run == 0 or "infrastructure: " in run.stdout


def test_a_killed_provider_gives_no_verdict(sitaf, activity):
    """The provider is killed while the build runs, and never comes back."""
    with running(lambda address: simulated(WORLD, address)) as (process, address):
        with_hardware(activity, [provider(address, "ir1")])
        with killing(process, address, activity):
            run = sitaf("run", activity)
    total, passed, failed, errors, not_run = counts(run)
    assert total == 55
    assert failed == errors == 0
    assert not_run > 0, run.stdout
    assert "infrastructure: " in run.stdout
    assert run.returncode != 0


@contextmanager
def killing(process, address, activity):
    """Kill a provider after its first case has ended; each case waits a little."""
    component = next((activity / "component").rglob("InfraredSensor.java"))
    text = component.read_text()
    call = re.search(r"public \w+ GetInfraredData\([^)]*\)[^{]*\{", text)
    assert call
    wait = " try { Thread.sleep(60); } catch (InterruptedException e) { }"
    component.write_text(text[: call.end()] + wait + text[call.end() :])

    def kill():
        with grpc.insecure_channel(address) as channel:
            stub = pb_grpc.HardwareProviderStub(channel)
            while not all(device.held for device in stub.CheckHealth(pb.CheckHealthRequest(devices=["ir1"])).devices):
                time.sleep(0.02)
            while not any(
                device.safe_stops for device in stub.CheckHealth(pb.CheckHealthRequest(devices=["ir1"])).devices
            ):
                time.sleep(0.005)
        process.send_signal(signal.SIGKILL)

    thread = threading.Thread(target=kill, daemon=True)
    thread.start()
    yield
    thread.join(10)


def test_what_cannot_work_is_refused_before_anything_is_built(sitaf, activity):
    cases = {
        "ir9: {backend: provider}": ["world/ir.world.yaml has no such device", "activity.yaml:"],
        "ir1: {backend: provder}": ["must be sim, provider, replay or shadow, not 'provder'; did you mean 'provider'?"],
        "ir1: {backend: provider, adress: x}": ["unknown entry; did you mean 'address'?"],
        "ir1: {backend: provider, address: /tmp/x}": ["'/tmp/x' is not an address"],
        "ir1: {backend: provider, max_age_s: 0}": ["must be above 0"],
        "ir1: {backend: provider, envelope: {velocity: 1}}": ["commands of a range have no number 'velocity'"],
        "ir1: {backend: replay, file: no.csv}": ["'no.csv' does not exist in the activity"],
        "ir1: {backend: replay, file: ir.csv, independent_of: [Distnce]}": [
            "no parameter 'Distnce'; did you mean 'Distance'?"
        ],
    }
    for line, messages in cases.items():
        run = sitaf("run", with_hardware(activity, [line]))
        assert run.returncode == 2, (line, run.stdout, run.stderr)
        for message in messages:
            assert message in run.stderr, (line, run.stderr)
