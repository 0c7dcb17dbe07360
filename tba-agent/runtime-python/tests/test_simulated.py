"""The example of the paper with a simulator."""

import importlib.util
import subprocess
import sys
from xml.etree import ElementTree

import pytest

from tests.applications import GOLDENS, PROJECT, run

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(importlib.util.find_spec("sitaf_bridge") is None, reason="sim-bridge is not installed here"),
]
EXAMPLE = PROJECT / "examples/ir-sensor-python"
GOLDEN = GOLDENS / "ir-sensor-python"
ENTRY = "sitaf_harness.get_infrared_data.concrete_test_driver"
WORLD = EXAMPLE / "world/ir.world.yaml"


@pytest.fixture(scope="module")
def bridge(tmp_path_factory):
    target = f"unix:{tmp_path_factory.mktemp('b') / 's'}"
    process = subprocess.Popen(
        [sys.executable, "-m", "sitaf_bridge", "serve", "--listen", target], stdout=subprocess.PIPE, text=True
    )
    try:
        process.stdout.readline()
        yield target
    finally:
        process.terminate()
        process.wait(10)
        process.stdout.close()


def execute(bridge, tmp_path, suite, component):
    return run(
        ENTRY, suite, tmp_path / "results", [GOLDEN / "harness", component], "--bridge", bridge, "--world", WORLD
    )


def outcomes(results):
    return {no: result.attrib["outcome"] for no, result in results.items()}


def cases_of(suite):
    return {int(case.attrib["no"]): case for case in ElementTree.parse(suite).iter("case")}


def assert_as_expected(results):
    assert outcomes(results) == dict.fromkeys(range(1, 56), "RETURNED")
    for no, case in cases_of(GOLDEN / "suite.xml").items():
        assert float(results[no].findtext("actual")) == pytest.approx(float(case.findtext("expected")), abs=1e-9)


def test_the_infrared_sensor_passes_every_case(bridge, tmp_path):
    ended, results = execute(bridge, tmp_path, GOLDEN / "suite.xml", EXAMPLE / "component")
    assert ended.returncode == 0, ended.stderr
    assert_as_expected(results)
    assert any(float(r.find("processing_time").attrib["hardware"]) > 0 for r in results.values())


def test_a_component_that_waits_gets_the_same_readings(bridge, tmp_path):
    folder = tmp_path / "component"
    folder.mkdir()
    source = (EXAMPLE / "component/infrared_sensor.py").read_text()
    called = "        distance = self._sensors"
    assert called in source
    (folder / "infrared_sensor.py").write_text(source.replace(called, f"        self._hardware.sleep(0.01)\n{called}"))
    ended, results = execute(bridge, tmp_path, GOLDEN / "suite.xml", folder)
    assert ended.returncode == 0, ended.stderr
    assert_as_expected(results)


def test_a_value_that_the_world_rejects_is_dont_and_the_others_run(bridge, tmp_path):
    suite = tmp_path / "suite.xml"
    text = (GOLDEN / "suite.xml").read_text()
    assert "<value>10.5</value>" in text
    suite.write_text(text.replace("<value>10.5</value>", "<value>99.0</value>"))
    ended, results = execute(bridge, tmp_path, suite, EXAMPLE / "component")
    assert ended.returncode == 0, ended.stderr
    rejected = {no for no, outcome in outcomes(results).items() if outcome == "NOT_CALLED"}
    assert rejected == {no for no, case in cases_of(suite).items() if case.findall("value")[2].text == "99.0"}
    assert rejected
    assert all("OUT_OF_RANGE" in results[no].findtext("message") for no in rejected)
    assert set(outcomes(results).values()) == {"RETURNED", "NOT_CALLED"}


def test_a_case_is_limited_in_simulation_time(bridge, tmp_path):
    folder = tmp_path / "component"
    folder.mkdir()
    source = (EXAMPLE / "component/infrared_sensor.py").read_text()
    (folder / "infrared_sensor.py").write_text(
        source.replace(
            "        distance = self._sensors", "        self._hardware.sleep(5)\n        distance = self._sensors"
        )
    )
    ended, results = run(
        ENTRY,
        GOLDEN / "suite.xml",
        tmp_path / "results",
        [GOLDEN / "harness", folder],
        *("--bridge", bridge, "--world", WORLD, "--case-sim", "2"),
    )
    assert ended.returncode == 0, ended.stderr
    errors = [r.findtext("message") for r in results.values() if r.attrib["outcome"] != "RETURNED"]
    assert errors
    assert set(errors) == {"the case took more than 2 s of simulation time"}


def test_the_motion_of_each_case_is_recorded(bridge, tmp_path):
    folder = tmp_path / "recording"
    ended, results = run(
        ENTRY,
        GOLDEN / "suite.xml",
        tmp_path / "results",
        [GOLDEN / "harness", EXAMPLE / "component"],
        *("--bridge", bridge, "--world", WORLD, "--recording", folder),
    )
    assert ended.returncode == 0, ended.stderr
    assert not ended.stderr
    assert_as_expected(results)
    assert {file.name for file in folder.iterdir()} == {f"{no}.glb" for no in range(1, 56)}
    assert all(file.read_bytes().startswith(b"glTF") for file in folder.iterdir())
