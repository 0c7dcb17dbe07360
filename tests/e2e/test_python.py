"""`./sitaf run` with Python components."""

import re

import pytest


def failed(run):
    return [int(no) for no in re.findall(r"^ *(\d+) +FAIL ", run.stdout, re.MULTILINE)]


@pytest.fixture
def python_activity(tmp_path):
    import shutil
    from pathlib import Path

    folder = tmp_path / "ir-sensor-python"
    shutil.copytree(Path(__file__).parents[2] / "examples/ir-sensor-python", folder)
    return folder


def test_the_python_sensor_has_the_same_verdicts_as_in_java(sitaf):
    run = sitaf("run", "examples/ir-sensor-python")
    assert run.returncode == 0, run.stdout + run.stderr
    assert "GetInfraredData: 55 cases, 55 PASS" in run.stdout
    run = sitaf("run", "examples/ir-sensor-python-faulty")
    assert run.returncode == 1, run.stdout + run.stderr
    assert failed(run) == [1, 7, 13, 19, 25]


def test_a_published_package_passes_and_the_fault_of_an_early_release_is_found(sitaf):
    run = sitaf("run", "examples/simple-pid")
    assert run.returncode == 0, run.stdout + run.stderr
    assert "Respond: 54 cases, 54 PASS" in run.stdout
    run = sitaf("run", "examples/simple-pid-0.1.0")
    assert run.returncode == 1, run.stdout + run.stderr
    assert failed(run) == [19, 20, 24, 28, 50]


def test_a_syntax_error_in_python_is_reported_with_file_line_and_column(sitaf, python_activity):
    source = python_activity / "component/infrared_sensor.py"
    source.write_text(source.read_text() + "\ndef broken(:\n")
    line = len(source.read_text().splitlines())
    run = sitaf("run", python_activity)
    assert run.returncode == 2
    assert re.search(rf"activity/component/infrared_sensor\.py:{line}:\d+: error: ", run.stderr), run.stderr


def test_a_missing_package_is_reported(sitaf, python_activity):
    (python_activity / "component/requirements.txt").write_text("simple-pid==99.99.99\n")
    run = sitaf("run", python_activity)
    assert run.returncode == 2
    assert "activity/component/requirements.txt: error: " in run.stderr
    assert "99.99.99" in run.stderr


def test_a_python_component_that_exits_affects_only_its_case(sitaf, python_activity):
    source = python_activity / "component/infrared_sensor.py"
    text = source.read_text()
    begin = "        if not 1 <= num_of_sensor"
    assert begin in text
    source.write_text(
        text.replace(begin, f"        if (index_of_sensor, num_of_sensor) == (8, 1):\n            __import__('os')._exit(7)\n{begin}")
    )
    run = sitaf("run", python_activity)
    assert run.returncode == 1, run.stderr
    assert "55 cases, 54 PASS, 0 FAIL, 1 ERROR, 0 DONT" in run.stdout
