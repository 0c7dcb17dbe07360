"""Compiled components: shared objects with headers, jars, Python packages and wheels; and packages of Maven and PyPI."""

import os
import re
import shutil
import subprocess
import zipfile

import pytest
from needs import cpp

PASSED = "GetInfraredData: 55 cases, 55 PASS"


def change(profile, **entries):
    """Replace the component's sources by the given entries; None removes one."""
    lines = [line for line in profile.read_text().splitlines() if line.strip().partition(":")[0] not in ("sources", *entries)]
    at = next(i for i, line in enumerate(lines) if line.startswith("component:")) + 1
    lines[at:at] = [f"  {name}: {value}" for name, value in entries.items() if value is not None]
    profile.write_text("\n".join(lines) + "\n")


def copy_of(sitaf, example, folder):
    return shutil.copytree(sitaf.root / "examples" / example, folder)


def tool(*command):
    ended = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    assert ended.returncode == 0, ended.stderr


@pytest.fixture
def built_cpp(sitaf, tmp_path):
    """The C++ sensor with headers but without sources; returns the activity and a compile function."""
    activity = copy_of(sitaf, "ir-sensor-cpp", tmp_path / "activity")
    sources = tmp_path / "sources"
    shutil.move(activity / "component", sources)
    (activity / "include").mkdir()
    shutil.copy(sources / "infrared_sensor.hpp", activity / "include")
    (activity / "lib").mkdir()
    runtime = sitaf.root / "tba-agent" / "runtime-cpp" / "include"
    return activity, ["g++", "-std=c++17", "-fPIC", "-I", runtime, "-I", sources, sources / "infrared_sensor.cpp"]


@cpp
def test_a_shared_object_with_headers(sitaf, built_cpp):
    activity, compiler = built_cpp
    # With a file name that differs from its SONAME.
    tool(*compiler, "-shared", "-Wl,-soname,libinfrared.so.1", "-o", activity / "lib" / "libinfrared.so.1.0.3")
    change(activity / "activity.yaml", library="lib/libinfrared.so.1.0.3", headers="include/")
    run = sitaf("run", activity)
    assert run.returncode == 0, run.stdout + run.stderr
    assert PASSED in run.stdout


@cpp
@pytest.mark.long  # A library is linked as the shared one.
def test_a_static_library_with_headers(sitaf, built_cpp, tmp_path):
    activity, compiler = built_cpp
    tool(*compiler, "-c", "-o", tmp_path / "sensor.o")
    tool("ar", "rcs", activity / "lib" / "libinfrared.a", tmp_path / "sensor.o")
    change(activity / "activity.yaml", library="lib/libinfrared.a", headers="include/")
    run = sitaf("run", activity)
    assert run.returncode == 0, run.stdout + run.stderr
    assert PASSED in run.stdout


@cpp
def test_a_shared_object_that_needs_another_of_the_activity(sitaf, built_cpp, tmp_path):
    activity, compiler = built_cpp
    (tmp_path / "bounds.cpp").write_text("int smallestIndex() { return 1; }\n")
    tool("g++", "-shared", "-fPIC", "-o", activity / "lib" / "libbounds.so", tmp_path / "bounds.cpp")
    source = tmp_path / "sources" / "infrared_sensor.cpp"
    text = source.read_text()
    assert "indexOfSensor < 1" in text
    source.write_text("int smallestIndex();\n" + text.replace("indexOfSensor < 1", "indexOfSensor < smallestIndex()"))
    tool(*compiler, "-shared", "-L", activity / "lib", "-lbounds", "-o", activity / "lib" / "libinfrared.so")
    change(activity / "activity.yaml", library="lib/libinfrared.so", headers="include/")
    profile = activity / "activity.yaml"
    profile.write_text(profile.read_text().replace("libraries: []", "libraries: [lib/libbounds.so]"))
    # The second run uses the program of the first one, whose folder is gone. The libraries have no SONAME.
    for _ in range(2):
        run = sitaf("run", activity)
        assert run.returncode == 0, run.stdout + run.stderr
        assert PASSED in run.stdout


@cpp
def test_a_missing_symbol_of_a_shared_object_is_reported(sitaf, built_cpp, tmp_path):
    activity, _ = built_cpp
    (tmp_path / "empty.cpp").write_text("int nothing = 0;\n")
    tool("g++", "-shared", "-fPIC", "-o", activity / "lib" / "libinfrared.so", tmp_path / "empty.cpp")
    change(activity / "activity.yaml", library="lib/libinfrared.so", headers="include/")
    run = sitaf("run", activity)
    assert run.returncode == 2
    assert "undefined reference to `robot::InfraredSensor::" in run.stderr


def runtime_jars(sitaf):
    # Built by an earlier command.
    return os.pathsep.join(map(str, (sitaf.root / ".sitaf" / "dist" / "agent" / "runtime-java").glob("*.jar")))


def test_a_jar(sitaf, tmp_path):
    assert sitaf("run", "examples/ir-sensor").returncode == 0
    activity = copy_of(sitaf, "ir-sensor", tmp_path / "activity")
    sources = tmp_path / "sources"
    shutil.move(activity / "component", sources)
    (activity / "lib").mkdir()
    classes = tmp_path / "classes"
    tool("javac", "--release", "17", "-d", classes, "-cp", runtime_jars(sitaf), *sources.rglob("*.java"))
    tool("jar", "--create", "--file", activity / "lib" / "sensor.jar", "-C", classes, ".")
    change(activity / "activity.yaml", library="lib/sensor.jar")
    run = sitaf("run", activity)
    assert run.returncode == 0, run.stdout + run.stderr
    assert PASSED in run.stdout
    profile = activity / "activity.yaml"
    profile.write_text(profile.read_text().replace("ir.InfraredSensor", "ir.Lidar"))
    run = sitaf("run", activity)
    assert run.returncode == 2
    assert "org.sitaf.examples.ir.Lidar is neither among the sources nor in the libraries" in run.stderr


@pytest.fixture
def python_package(sitaf, tmp_path):
    """The sensor in a module of the package `robot`."""
    activity = copy_of(sitaf, "ir-sensor-python", tmp_path / "activity")
    package = activity / "lib" / "robot"
    package.mkdir(parents=True)
    shutil.move(activity / "component" / "infrared_sensor.py", package / "infrared_sensor.py")
    shutil.rmtree(activity / "component")
    (package / "__init__.py").write_text(
        '"""A robot."""\n\nfrom robot.infrared_sensor import InfraredSensor\n\n__all__ = ["InfraredSensor"]\n'
    )
    return activity


def test_a_python_package(sitaf, python_package):
    change(python_package / "activity.yaml", library="lib/robot", **{"class": "robot.InfraredSensor"})
    run = sitaf("run", python_package)
    assert run.returncode == 0, run.stdout + run.stderr
    assert PASSED in run.stdout


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("robot.Lidar", "lib/robot/__init__.py does not define Lidar, and no class at all; name one of the component's classes"),
        ("robot.infrared_sensor.Lidar", "lib/robot/infrared_sensor.py does not define Lidar; it defines InfraredSensor"),
        ("robot.lidar.Lidar", "there is no robot/lidar.py below lib/; write the module that defines Lidar, then the class"),
    ],
)
def test_a_missing_class_of_a_python_package_is_reported(sitaf, python_package, name, message):
    change(python_package / "activity.yaml", library="lib/robot", **{"class": name})
    run = sitaf("run", python_package)
    assert run.returncode == 2
    assert f"activity.yaml: error: component.class: {name}: {message}" in run.stderr


def wheel(folder, package, requires=()):
    """Build a wheel of a package."""
    file = folder / "robot-1.0-py3-none-any.whl"
    with zipfile.ZipFile(file, "w") as archive:
        for path in sorted(package.rglob("*.py")):
            archive.write(path, path.relative_to(package.parent))
        needs = "".join(f"Requires-Dist: {name}\n" for name in requires)
        archive.writestr("robot-1.0.dist-info/METADATA", f"Metadata-Version: 2.1\nName: robot\nVersion: 1.0\n{needs}")
        archive.writestr("robot-1.0.dist-info/WHEEL", "Wheel-Version: 1.0\nGenerator: test\nRoot-Is-Purelib: true\nTag: py3-none-any\n")
        names = [*archive.namelist(), "robot-1.0.dist-info/RECORD"]
        archive.writestr("robot-1.0.dist-info/RECORD", "".join(f"{name},,\n" for name in names))
    return file


def test_a_wheel_with_requirements(sitaf, python_package):
    package = python_package / "lib" / "robot"
    (package / "gains.py").write_text("from simple_pid import PID\n\nGAINS = PID(1, 2, 3).tunings\n")
    init = package / "__init__.py"
    init.write_text(init.read_text() + "\nfrom robot.gains import GAINS\n\nassert GAINS == (1, 2, 3)\n")
    wheel(python_package, package, ["simple-pid==2.0.1"])
    shutil.rmtree(package.parent)
    change(python_package / "activity.yaml", library="robot-1.0-py3-none-any.whl", **{"class": "robot.InfraredSensor"})
    run = sitaf("run", python_package)
    assert run.returncode == 0, run.stdout + run.stderr
    assert PASSED in run.stdout
    # The import succeeds only if the package is installed.
    change(python_package / "activity.yaml", **{"class": "robot.Lidar"}, library="robot-1.0-py3-none-any.whl")
    run = sitaf("run", python_package)
    assert run.returncode == 2
    assert "robot has no class Lidar" in run.stdout + run.stderr


def test_packages_of_requirements_are_installed(sitaf, tmp_path):
    activity = copy_of(sitaf, "ir-sensor-python", tmp_path / "activity")
    (activity / "component" / "requirements.txt").write_text("simple-pid==2.0.1\n")
    source = activity / "component" / "infrared_sensor.py"
    source.write_text(source.read_text() + "\n\nfrom simple_pid import PID\n\nassert PID(1, 2, 3).tunings == (1, 2, 3)\n")
    run = sitaf("run", activity)
    assert run.returncode == 0, run.stdout + run.stderr
    assert PASSED in run.stdout


SOLVER = """
package solver;

import org.apache.commons.math3.analysis.solvers.BrentSolver;

public final class Root {
  public double Of(double square) {
    return new BrentSolver(1e-12).solve(1000, x -> x * x - square, 0, 100);
  }
}
"""
SQUARE = """<?xml version="1.0" encoding="UTF-8"?>
<test_model>
  <name>Of</name>
  <input_spec_list>
    <test_element abstract_type="NUMERIC" real_type="double">
      <name>square</name>
      <type>TDI</type>
      <user_value_list><value>4</value><value>9</value></user_value_list>
    </test_element>
  </input_spec_list>
  <output_spec_list>
    <test_element abstract_type="NUMERIC" real_type="double">
      <name>return</name>
      <type>RETURN</type>
      <expected>square == 4.0 ? 2.0 : 3.0</expected>
      <tolerance absolute="1e-9"/>
    </test_element>
  </output_spec_list>
  <order_of_combinations>1</order_of_combinations>
</test_model>
"""


@pytest.fixture
def maven_activity(tmp_path):
    (tmp_path / "adapter" / "solver").mkdir(parents=True)
    (tmp_path / "adapter" / "solver" / "Root.java").write_text(SOLVER)
    (tmp_path / "root.idl").write_text("interface Root { double Of(in double square); };\n")
    (tmp_path / "Of.xml").write_text(SQUARE)
    (tmp_path / "activity.yaml").write_text(
        "name: root\n"
        "component:\n"
        "  language: java\n"
        "  package: org.apache.commons:commons-math3:3.6.1\n"
        "  adapter: adapter/\n"
        "  class: solver.Root\n"
        "provided: [root.idl]\n"
        "models: [Of.xml]\n"
    )
    return tmp_path


def test_a_package_by_its_maven_coordinates(sitaf, maven_activity):
    run = sitaf("run", maven_activity)
    assert run.returncode == 0, run.stdout + run.stderr
    assert "Of: 2 cases, 2 PASS" in run.stdout


@pytest.mark.parametrize(
    ("coordinates", "message"),
    [
        ("commons-math3", "'commons-math3' is not a package such as org.apache.commons:commons-math3:3.6.1"),
        ("org.apache.commons:commons-math3:99.99", "org.apache.commons:commons-math3:99.99: .*ould not find artifact"),
    ],
)
def test_a_package_missing_in_maven_central_is_reported(sitaf, maven_activity, coordinates, message):
    change(maven_activity / "activity.yaml", package=coordinates)
    run = sitaf("run", maven_activity)
    assert run.returncode == 2
    assert re.search(f"activity.yaml: error: component: package: {message}", run.stderr), run.stderr
