"""`./sitaf run` on components in C++. Where the C++ side is not installed, they are skipped; continuous integration installs it."""

import os
import re
import shutil
import subprocess
import xml.etree.ElementTree as ElementTree

import pytest


def installed(*packages):
    return all(shutil.which(tool) for tool in ("g++", "pkg-config", "grpc_cpp_plugin")) and all(
        subprocess.run(["pkg-config", "--exists", package], check=False).returncode == 0 for package in packages
    )


def requires(*packages):
    # In CI a skipped test would be a test that nobody runs.
    return pytest.mark.skipif(
        not installed(*packages) and "CI" not in os.environ, reason="needs ./sitaf doctor --install cpp, and " + ", ".join(packages)
    )


cpp = requires("grpc++", "protobuf", "expat")
kdl = requires("grpc++", "protobuf", "expat", "orocos-kdl")


@pytest.fixture
def cpp_activity(sitaf, tmp_path):
    return shutil.copytree(sitaf.root / "examples" / "ir-sensor-cpp", tmp_path / "activity")


def replace(path, old, new):
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new))


def verdicts(folder, model="GetInfraredData"):
    root = ElementTree.parse(folder / f"{model}.xml").getroot()
    return [
        ([value.text for value in result.findall("value")], result.attrib["verdict"], float(result.findtext("actual")))
        for result in root.iter("test_result")
    ]


@cpp
def test_the_sensor_in_cpp_has_the_cases_and_verdicts_of_the_one_in_java(sitaf, tmp_path):
    run = sitaf("run", "examples/ir-sensor-cpp", "--result", tmp_path / "cpp")
    assert run.returncode == 0, run.stdout + run.stderr
    assert "GetInfraredData: 55 cases, 55 PASS" in run.stdout
    java = sitaf("run", "examples/ir-sensor", "--result", tmp_path / "java")
    assert java.returncode == 0, java.stdout + java.stderr
    assert verdicts(tmp_path / "cpp") == verdicts(tmp_path / "java")


@cpp
def test_the_faulty_sensor_in_cpp_fails_exactly_the_cases_that_the_fault_touches(sitaf):
    run = sitaf("run", "examples/ir-sensor-cpp-faulty")
    assert run.returncode == 1, run.stdout + run.stderr
    rows = re.findall(r"^ *\d+ +(-?\d+) +(-?\d+) +(-?[\d.]+) .*FAIL", run.stdout, re.MULTILINE)
    assert sorted((int(i), int(n)) for i, n, _ in rows) == [(1, 1), (2, 2), (4, 4), (6, 6), (7, 7)]


@kdl
def test_a_package_of_debian_is_tested_through_an_adapter(sitaf):
    run = sitaf("run", "examples/orocos-kdl")
    assert run.returncode == 0, run.stdout + run.stderr
    assert "ForwardKinematics: 9 cases, 9 PASS" in run.stdout
    assert "InverseKinematics: 16 cases, 16 PASS" in run.stdout
    assert "ProfilePosition: 36 cases, 36 PASS" in run.stdout


@kdl
def test_the_adapter_that_mixes_arguments_up_is_caught(sitaf):
    run = sitaf("run", "examples/orocos-kdl-faulty")
    assert run.returncode == 1, run.stdout + run.stderr
    assert re.search(r"ProfilePosition: 36 cases, 16 PASS, 20 FAIL, 0 ERROR", run.stdout)


@cpp
def test_cpp_that_does_not_compile_is_told_with_file_and_line(sitaf, cpp_activity):
    source = cpp_activity / "component" / "infrared_sensor.cpp"
    replace(source, "return noDistance;", "return nonsense;")
    line = next(i for i, text in enumerate(source.read_text().splitlines(), 1) if "nonsense" in text)
    run = sitaf("run", cpp_activity)
    assert run.returncode == 2
    assert re.search(rf"infrared_sensor\.cpp:{line}:\d+: error: .*nonsense", run.stderr), run.stderr


@cpp
def test_cpp_that_crashes_costs_only_its_own_cases(sitaf, cpp_activity):
    source = cpp_activity / "component" / "infrared_sensor.cpp"
    body = "double InfraredSensor::GetInfraredData(int indexOfSensor, int numOfSensor) const {\n"
    replace(source, body, body + "  if (indexOfSensor == 2) *static_cast<volatile int*>(nullptr) = 1;\n")
    run = sitaf("run", cpp_activity)
    assert run.returncode == 1, run.stdout + run.stderr
    assert re.search(r"GetInfraredData: 55 cases, \d+ PASS, 0 FAIL, [1-9]\d* ERROR, 0 DONT", run.stdout)
    assert "SIGSEGV" in run.stdout
    assert re.search(r"robot::InfraredSensor::GetInfraredData", run.stdout)


@cpp
@pytest.mark.skipif(shutil.which("clang++") is None and "CI" not in os.environ, reason="needs clang++")
def test_another_compiler_is_taken_by_the_name_that_the_environment_gives(sitaf, cpp_activity):
    clang = {"CXX": "clang++"}
    run = sitaf("run", cpp_activity, env=clang)
    assert run.returncode == 0, run.stdout + run.stderr
    assert "GetInfraredData: 55 cases, 55 PASS" in run.stdout
    replace(cpp_activity / "component" / "infrared_sensor.cpp", "return noDistance;", "return nonsense;")
    spoilt = sitaf("run", cpp_activity, env=clang)
    assert spoilt.returncode == 2
    assert re.search(r"infrared_sensor\.cpp:\d+:\d+: error: use of undeclared identifier 'nonsense'", spoilt.stderr), spoilt.stderr
    missing = sitaf("run", cpp_activity, env={"CXX": "no-such-compiler"})
    assert missing.returncode == 2
    assert "CXX names 'no-such-compiler', and there is no such program" in missing.stderr, missing.stderr


@cpp
def test_cpp_that_throws_is_an_error_with_its_words(sitaf, cpp_activity):
    source = cpp_activity / "component" / "infrared_sensor.cpp"
    body = "double InfraredSensor::GetInfraredData(int indexOfSensor, int numOfSensor) const {\n"
    replace(source, body, body + '  if (indexOfSensor == 2) throw std::runtime_error("gone");\n')
    run = sitaf("run", cpp_activity)
    assert run.returncode == 1, run.stdout + run.stderr
    assert "std::runtime_error: gone" in run.stdout


@cpp
def test_edits_give_what_a_compilation_without_caches_gives(sitaf):
    ran = sitaf("bench", "cache", "--edits", "40")
    assert ran.returncode == 0, ran.stdout + ran.stderr
    assert ran.stdout.splitlines()[-1] == "cache: held"
