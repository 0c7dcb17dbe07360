"""The expected sources of the generator tests are formatted, and they run."""

import subprocess
import sys
from pathlib import Path

import pytest

from tests.applications import GOLDENS, PROJECT, run

NAVIGATOR = GOLDENS / "navigator"
ENTRY = "sitaf_harness.step.concrete_test_driver"
NAVIGATOR_PATH = [NAVIGATOR / "harness", NAVIGATOR / "activity/component"]


@pytest.mark.parametrize("name", ["ir-sensor-python", "navigator"])
def test_generated_sources_are_formatted_and_have_nothing_to_lint(name):
    ruff = Path(sys.executable).with_name("ruff")
    harness = GOLDENS / name / "harness"
    formatted = subprocess.run([ruff, "format", "--isolated", "--check", harness], capture_output=True, text=True)
    assert formatted.returncode == 0, formatted.stdout
    linted = subprocess.run(
        [ruff, "check", "--isolated", "--select", "E,F,D1,UP,B", "--ignore", "D102,D107,B024,B027", harness],
        capture_output=True,
        text=True,
    )
    assert linted.returncode == 0, linted.stdout


def test_structs_enumerations_stubs_and_out_parameters_work(tmp_path):
    ended, results = run(ENTRY, NAVIGATOR / "suite.xml", tmp_path / "results", NAVIGATOR_PATH)
    assert (ended.returncode, ended.stderr) == (0, "")
    first = results[1]
    assert first.attrib["outcome"] == "RETURNED", first.findtext("message")
    actual = {element.attrib["name"]: element.text for element in first.findall("actual")}
    assert actual == {"return": "2", "target": "{x: 2.5, y: 0.0}", "heading": "0.5", "target.x": "2.5"}
    calls = [
        (call.attrib["method"], {argument.attrib["name"]: argument.text for argument in call})
        for call in first.findall("call")
    ]
    assert calls == [
        ("RangeFinder.RangeAhead", {"bearing": "0.25"}),
        ("RangeFinder.Beams", {"first": "1"}),
        ("Wheels.Drive", {"linear": "0.5", "angular": "1.5"}),
    ]
    assert results[2].findall("call")[2].findall("argument")[1].text == "NaN"


def with_component(tmp_path, body):
    """The navigator with another implementation of its step."""
    folder = tmp_path / "component/navigation"
    folder.mkdir(parents=True)
    source = (NAVIGATOR / "activity/component/navigation/navigator.py").read_text()
    head, _, _ = source.partition("        if not route.points:")
    (folder / "navigator.py").write_text(head + "".join(f"        {line}\n" for line in body))
    return [NAVIGATOR / "harness", tmp_path / "component"]


@pytest.mark.parametrize(
    ("body", "message"),
    [
        (["raise ValueError('no\\nway')"], "ValueError: no\nway at step (navigation/navigator.py:26)"),
        (["import sys", "sys.exit(4)"], "SystemExit: 4"),
        (["raise KeyboardInterrupt"], "KeyboardInterrupt"),
        (["return 1"], "TypeError: expected a tuple of 3"),
        (["def again(): again()", "again()"], "RecursionError"),
    ],
)
def test_exceptions_of_a_component_are_errors_of_the_case(tmp_path, body, message):
    path = with_component(tmp_path, body)
    ended, results = run(ENTRY, NAVIGATOR / "suite.xml", tmp_path / "results", path)
    assert ended.returncode == 0, ended.stderr
    assert {results[no].attrib["outcome"] for no in (1, 2)} <= {"THREW", "ERROR"}
    assert message in results[1].findtext("message")


def test_a_component_that_ends_the_process_loses_no_result(tmp_path):
    path = with_component(
        tmp_path,
        [
            "import os",
            "if self.__dict__.setdefault('calls', 0): os._exit(9)",
            "self.calls = 1",
            "return 2, Point(2.5), 0",
        ],
    )
    ended, results = run(ENTRY, NAVIGATOR / "suite.xml", tmp_path / "results", path)
    assert (ended.returncode, [results[1].attrib["outcome"]], len(results)) == (9, ["RETURNED"], 1)
    ended, results = run(ENTRY, NAVIGATOR / "suite.xml", tmp_path / "results", path, "--from", 2)
    assert ended.returncode == 0
    assert sorted(results) == [1, 2]


def test_the_process_does_not_wait_for_running_threads(tmp_path):
    path = with_component(
        tmp_path,
        [
            "import threading, time",
            "threading.Thread(target=lambda: time.sleep(600)).start()",
            "return 2, Point(2.5), 0",
        ],
    )
    ended, results = run(ENTRY, NAVIGATOR / "suite.xml", tmp_path / "results", path)
    assert (ended.returncode, len(results)) == (0, 2)


def test_a_component_that_cannot_be_imported_is_reported_before_any_case(tmp_path):
    path = with_component(tmp_path, ["return 1", "", "", "import nowhere"])
    source = tmp_path / "component/navigation/navigator.py"
    source.write_text("import nowhere_to_be_found\n" + source.read_text())
    ended, results = run(ENTRY, NAVIGATOR / "suite.xml", tmp_path / "results", path)
    assert ended.returncode == 3
    assert results == {}
    assert "sitaf: the test application cannot be imported: ModuleNotFoundError" in ended.stderr
    assert "navigation/navigator.py:1" in ended.stderr


def test_a_missing_simulation_is_reported(tmp_path):
    path = [GOLDENS / "ir-sensor-python/harness", PROJECT / "examples/ir-sensor-python/component"]
    ended, _ = run(
        "sitaf_harness.get_infrared_data.concrete_test_driver",
        GOLDENS / "ir-sensor-python/suite.xml",
        tmp_path / "results",
        path,
    )
    assert ended.returncode == 3
    assert "--bridge TARGET" in ended.stderr


FLAKY = """\
calls = getattr(Navigator, "calls", 0)
Navigator.calls = calls + 1
if calls == 4:
    raise ValueError("the fifth time")
return 2, route.points[-1], 0.5
"""


def test_calls_are_repeated_and_a_difference_is_reported(tmp_path):
    path = with_component(tmp_path, FLAKY.splitlines())
    arguments = ["--repeat", "6", "--warm-up", "1"]
    ended, results = run(ENTRY, NAVIGATOR / "suite.xml", tmp_path / "results", path, *arguments)
    assert ended.returncode == 0, ended.stderr
    first = results[1]
    assert first.attrib["outcome"] == "RETURNED", first.findtext("message")
    assert first.findtext("differs") == "call 5: threw ValueError, but the first call returned"
    assert len([int(ns) for ns in first.findtext("repeated_calls").split()]) == 5
    assert len(results[2].findtext("repeated_calls").split()) == 6
    assert results[2].find("differs") is None


def test_options_of_repeated_calls_are_checked(tmp_path):
    for arguments in (["--warm-up", "1"], ["--repeat", "-1"], ["--repeat", "1", "--repeat-within", "0"]):
        ended, _ = run(ENTRY, NAVIGATOR / "suite.xml", tmp_path / "results", NAVIGATOR_PATH, *arguments)
        assert (ended.returncode, ended.stderr.count("\n")) == (3, 1)
