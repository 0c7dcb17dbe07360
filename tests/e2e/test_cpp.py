"""`./sitaf run` with C++ components. Skipped if the C++ toolchain is not installed, except in continuous integration."""

import re
import shutil
import xml.etree.ElementTree as ElementTree

import pytest
from needs import clang, cmake, cpp, fmt, kdl


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
def test_the_cpp_sensor_has_the_same_verdicts_as_in_java(sitaf, tmp_path):
    run = sitaf("run", "examples/ir-sensor-cpp", "--result", tmp_path / "cpp")
    assert run.returncode == 0, run.stdout + run.stderr
    assert "GetInfraredData: 55 cases, 55 PASS" in run.stdout
    java = sitaf("run", "examples/ir-sensor", "--result", tmp_path / "java")
    assert java.returncode == 0, java.stdout + java.stderr
    assert verdicts(tmp_path / "cpp") == verdicts(tmp_path / "java")


@cpp
def test_the_faulty_cpp_sensor_fails_exactly_the_affected_cases(sitaf):
    run = sitaf("run", "examples/ir-sensor-cpp-faulty")
    assert run.returncode == 1, run.stdout + run.stderr
    rows = re.findall(r"^ *\d+ +FAIL +(-?\d+) +(-?\d+) +(-?[\d.]+) ", run.stdout, re.MULTILINE)
    assert sorted((int(i), int(n)) for i, n, _ in rows) == [(1, 1), (2, 2), (4, 4), (6, 6), (7, 7)]


@kdl
def test_a_package_of_debian_is_tested_through_an_adapter(sitaf):
    run = sitaf("run", "examples/orocos-kdl")
    assert run.returncode == 0, run.stdout + run.stderr
    assert "ForwardKinematics: 9 cases, 9 PASS" in run.stdout
    assert "InverseKinematics: 16 cases, 16 PASS" in run.stdout
    assert "ProfilePosition: 36 cases, 36 PASS" in run.stdout


@kdl
def test_an_adapter_with_swapped_arguments_is_detected(sitaf):
    run = sitaf("run", "examples/orocos-kdl-faulty")
    assert run.returncode == 1, run.stdout + run.stderr
    assert re.search(r"ProfilePosition: 36 cases, 16 PASS, 20 FAIL, 0 ERROR", run.stdout)


@cpp
def test_a_cpp_compiler_error_is_reported_with_file_and_line(sitaf, cpp_activity):
    source = cpp_activity / "component" / "infrared_sensor.cpp"
    replace(source, "return noDistance;", "return nonsense;")
    line = next(i for i, text in enumerate(source.read_text().splitlines(), 1) if "nonsense" in text)
    run = sitaf("run", cpp_activity)
    assert run.returncode == 2
    assert re.search(rf"infrared_sensor\.cpp:{line}:\d+: error: .*nonsense", run.stderr), run.stderr


@cpp
def test_a_crash_in_cpp_affects_only_its_cases(sitaf, cpp_activity):
    source = cpp_activity / "component" / "infrared_sensor.cpp"
    body = "double InfraredSensor::GetInfraredData(int indexOfSensor, int numOfSensor) const {\n"
    replace(source, body, body + "  if (indexOfSensor == 2) *static_cast<volatile int*>(nullptr) = 1;\n")
    run = sitaf("run", cpp_activity)
    assert run.returncode == 1, run.stdout + run.stderr
    assert re.search(r"GetInfraredData: 55 cases, \d+ PASS, 0 FAIL, [1-9]\d* ERROR, 0 DONT", run.stdout)
    assert "SIGSEGV" in run.stdout
    assert re.search(r"robot::InfraredSensor::GetInfraredData", run.stdout)


@cpp
def test_a_sanitizer_finds_a_write_beyond_the_end(sitaf, tmp_path):
    passing = sitaf("run", "examples/moving-average")
    assert passing.returncode == 0, passing.stdout + passing.stderr
    assert "MeanOfLast: 18 cases, 18 PASS" in passing.stdout
    faulty = shutil.copytree(sitaf.root / "examples" / "moving-average-faulty", tmp_path / "activity")
    source = faulty / "component" / "moving_average.cpp"
    line = next(i for i, text in enumerate(source.read_text().splitlines(), 1) if "recent[i] = " in text)
    run = sitaf("run", faulty)
    assert run.returncode == 1, run.stdout + run.stderr
    assert "18 cases, 6 PASS, 0 FAIL, 12 ERROR" in run.stdout
    assert f"heap-buffer-overflow at moving_average.cpp:{line}" in run.stdout


DRIVE = {
    "activity.yaml": """name: wheels
component: {language: cpp, sources: component/, class: Base}
provided: [Wheels.idl]
world: world/base.world.yaml
models: [Drive.xml]
""",
    "Wheels.idl": "interface Wheels { boolean Drive(in double linear, in double angular); };\n",
    "component/base.hpp": """#pragma once
#include <stdexcept>
#include "sitaf/hardware.hpp"
class Base {
 public:
  explicit Base(sitaf::Hardware& hardware) : base_(hardware.differentialDrive("base")) {}
  bool Drive(double linear, double angular) {
    try {
      base_.drive(linear, angular);
      return true;
    } catch (const std::invalid_argument&) {
      return false;
    }
  }

 private:
  sitaf::DifferentialDrive& base_;
};
""",
    "component/base.cpp": '#include "base.hpp"\n',
    "world/base.xml": """<mujoco><option timestep="0.002"/><worldbody><body><freejoint/><geom size="0.1"/>
<body pos="0 0.2 0"><joint name="l" axis="0 1 0"/><geom size="0.1"/></body>
<body pos="0 -0.2 0"><joint name="r" axis="0 1 0"/><geom size="0.1"/></body></body></worldbody>
<actuator><velocity name="l" joint="l" ctrlrange="-10 10"/><velocity name="r" joint="r" ctrlrange="-10 10"/></actuator>
</mujoco>""",
    "world/base.world.yaml": """mjcf: base.xml
devices:
  base: {kind: differential_drive, left: l, right: r, wheel_radius: 0.1, track: 0.4}
""",
    "Drive.xml": """<test_model><name>Drive</name><target interface="Wheels" method="Drive" run_for="0.1"/><input_spec_list>
<test_element abstract_type="NUMERIC" real_type="double"><name>linear</name><type>TDI</type>
<test_spec type="RANDOM" count="12" min="-1.3" max="1.3"/><user_value_list><value>0.5</value></user_value_list>
</test_element><test_element abstract_type="NUMERIC" real_type="double"><name>angular</name><type>TDI</type>
<test_spec type="RANDOM" count="12" min="-5" max="5"/><user_value_list><value>0</value></user_value_list>
</test_element></input_spec_list><output_spec_list>
<test_element abstract_type="BOOLEAN" real_type="boolean"><name>return</name><type>RETURN</type>
<expected>abs(linear) + abs(angular) * 0.2 &lt;= 1.0</expected></test_element></output_spec_list>
<order_of_combinations>2</order_of_combinations></test_model>
""",
}


@cpp
def test_a_drive_is_refused_where_one_of_its_wheels_is_too_slow(sitaf, tmp_path):
    for name, content in DRIVE.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(content)
    run = sitaf("run", tmp_path, "--result", tmp_path / "result")
    assert run.returncode == 0, run.stdout + run.stderr
    assert "Drive: 169 cases, 169 PASS" in run.stdout
    root = ElementTree.parse(tmp_path / "result" / "Drive.xml").getroot()
    accepted = [actual.text for actual in root.iter("actual")]
    assert min(accepted.count("true"), accepted.count("false")) > 30


@cpp
def test_warnings_and_the_own_frame_of_a_crash_are_shown(sitaf, cpp_activity):
    source = cpp_activity / "component" / "infrared_sensor.cpp"
    body = "double InfraredSensor::GetInfraredData(int indexOfSensor, int numOfSensor) const {\n"
    # The access is in a header of the standard library.
    fault = (
        "  const auto* nowhere = reinterpret_cast<const double*>(8L * indexOfSensor);\n"
        "  if (indexOfSensor == 2) return std::accumulate(nowhere, nowhere + 1, 0.0);\n"
        "  int unused = 0;\n"
    )
    replace(source, body, body + fault)
    source.write_text("#include <numeric>\n" + source.read_text())
    line = next(i for i, text in enumerate(source.read_text().splitlines(), 1) if "std::accumulate" in text)
    run = sitaf("run", cpp_activity)
    assert run.returncode == 1, run.stdout + run.stderr
    assert re.search(rf"infrared_sensor\.cpp:{line + 1}:\d+: warning: unused variable .unused.", run.stderr), run.stderr
    assert re.search(rf"SIGSEGV.*infrared_sensor\.cpp:{line}", run.stdout), run.stdout
    again = sitaf("run", cpp_activity)
    assert "warning: unused variable" in again.stderr, "the warnings of a cached compilation are shown, too"


@cpp
@pytest.mark.long  # Compiles the runtime with the other compiler.
@clang
def test_the_environment_selects_the_compiler(sitaf, cpp_activity):
    clang = {"CXX": "clang++"}
    run = sitaf("run", cpp_activity, env=clang)
    assert run.returncode == 0, run.stdout + run.stderr
    assert "GetInfraredData: 55 cases, 55 PASS" in run.stdout
    replace(cpp_activity / "component" / "infrared_sensor.cpp", "return noDistance;", "return nonsense;")
    spoilt = sitaf("run", cpp_activity, env=clang)
    assert spoilt.returncode == 2
    assert re.search(r"infrared_sensor\.cpp:\d+:\d+: error: use of undeclared identifier 'nonsense'", spoilt.stderr), spoilt.stderr


@cpp
def test_a_missing_compiler_of_the_environment_is_reported(sitaf, cpp_activity):
    missing = sitaf("run", cpp_activity, env={"CXX": "no-such-compiler"})
    assert missing.returncode == 2
    assert "CXX names 'no-such-compiler', which is not an executable program" in missing.stderr, missing.stderr


@cpp
def test_an_exception_in_cpp_is_an_error_with_its_message(sitaf, cpp_activity):
    source = cpp_activity / "component" / "infrared_sensor.cpp"
    body = "double InfraredSensor::GetInfraredData(int indexOfSensor, int numOfSensor) const {\n"
    replace(source, body, body + '  if (indexOfSensor == 2) throw std::runtime_error("gone");\n')
    run = sitaf("run", cpp_activity)
    assert run.returncode == 1, run.stdout + run.stderr
    assert "std::runtime_error: gone" in run.stdout


@cpp
@pytest.mark.parametrize("edits", [3, pytest.param(16, marks=pytest.mark.long)])
def test_caches_do_not_change_the_result_of_edits(sitaf, edits):
    ran = sitaf("bench", "cache", "--edits", edits)
    assert ran.returncode == 0, ran.stdout + ran.stderr
    assert ran.stdout.splitlines()[-1] == "cache: held"


@fmt
def test_a_component_in_cpp20_with_packages(sitaf, tmp_path):
    run = sitaf("run", "examples/covariance-ellipse")
    assert run.returncode == 0, run.stdout + run.stderr
    assert "Axes: 45 cases, 45 PASS" in run.stdout
    faulty = sitaf("run", "examples/covariance-ellipse-faulty")
    assert faulty.returncode == 1, faulty.stdout + faulty.stderr
    assert "45 cases, 30 PASS, 15 FAIL, 0 ERROR" in faulty.stdout
    activity = shutil.copytree(sitaf.root / "examples" / "covariance-ellipse", tmp_path / "activity")
    replace(activity / "activity.yaml", "packages: [eigen3, fmt]", "packages: [eigen3]")
    run = sitaf("run", activity)
    assert run.returncode == 2
    assert "the test application cannot be linked" in run.stderr
    assert "undefined reference to `fmt::" in run.stderr
    assert "linked with eigen3" in run.stderr


@cmake
def test_a_library_of_a_cmake_project_is_tested(sitaf, tmp_path):
    run = sitaf("run", "examples/acceleration-limiter")
    assert run.returncode == 0, run.stdout + run.stderr
    faulty = sitaf("run", "examples/acceleration-limiter-faulty")
    assert faulty.returncode == 1, faulty.stdout + faulty.stderr
    assert "FAIL" in faulty.stdout

    again = sitaf("run", "examples/acceleration-limiter")
    assert again.returncode == 0, again.stdout + again.stderr

    activity = shutil.copytree(sitaf.root / "examples" / "acceleration-limiter", tmp_path / "activity")
    yaml = activity / "activity.yaml"
    text = yaml.read_text()
    for target, message in [
        ("speed_limiter", "the project has no target speed_limiter; its libraries are acceleration_limiter"),
        ("limit", "the target limit is no library; its libraries are acceleration_limiter"),
    ]:
        yaml.write_text(text.replace("target: acceleration_limiter", f"target: {target}"))
        refused = sitaf("run", activity)
        assert refused.returncode == 2
        assert message in refused.stderr
    yaml.write_text(text.replace("limiter}", "limiter, options: {MAX_ACCELERATION: 3.0}}"))
    faster = sitaf("run", activity)
    assert faster.returncode == 1, faster.stdout + faster.stderr
    yaml.write_text(text)

    source = activity / "component" / "src" / "acceleration_limiter.cpp"
    source.write_text(source.read_text().replace("return within", "return nearest"))
    broken = sitaf("run", activity)
    assert broken.returncode == 2
    assert "activity/component/src/acceleration_limiter.cpp:11:" in broken.stderr

    lists = activity / "component" / "CMakeLists.txt"
    lists.write_text(lists.read_text().replace("Eigen3 REQUIRED", "NoSuchPackage REQUIRED"))
    missing = sitaf("run", activity)
    assert missing.returncode == 2
    assert "CMakeLists.txt:5:" in missing.stderr
    assert "NoSuchPackage" in missing.stderr


@cmake
@pytest.mark.parametrize("kind", ["SHARED", pytest.param("OBJECT", marks=pytest.mark.long)])
def test_a_cmake_project_with_another_kind_of_library_is_linked(sitaf, tmp_path, kind):
    activity = shutil.copytree(sitaf.root / "examples" / "acceleration-limiter", tmp_path / "activity")
    lists = activity / "component" / "CMakeLists.txt"
    text = lists.read_text()
    lists.write_text(text.replace("add_library(acceleration_limiter ", f"add_library(acceleration_limiter {kind} "))
    run = sitaf("run", activity)
    assert run.returncode == 0, run.stdout + run.stderr
