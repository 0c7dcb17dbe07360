"""`./sitaf new` writes activities that run with exit code 0 at once."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest
from needs import cpp

HOME = Path(__file__).resolve().parents[2]
PROTO = """syntax = "proto3";
package demo;
message Request { double speed = 1; bool enabled = 2; string frame_id = 3; }
message Reply { bool accepted = 1; }
service Motion { rpc Drive(Request) returns (Reply); rpc Stop(Request) returns (Reply); }
"""
ACTION = """uint8 MODE_SLOW=0
uint8 MODE_FAST=1
uint8 mode
geometry_msgs/PoseStamped goal
builtin_interfaces/Duration time_allowance
---
uint16 error_code
---
float32 distance
"""


def sitaf(*arguments: str | Path, timeout: float = 600) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [HOME / "sitaf", *map(str, arguments)],
        stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=timeout, check=False,
        env={**os.environ, "NO_COLOR": "1"},
    )


def begin(folder: Path, *options: str | Path) -> None:
    ended = sitaf("new", folder, *options)
    assert ended.returncode == 0, ended.stderr
    assert f"./sitaf run {folder}" in ended.stdout


def interfaces(folder: Path) -> dict[str, Path]:
    package = folder / "demo_msgs"
    (package / "action").mkdir(parents=True)
    (package / "srv").mkdir()
    (package / "action" / "Approach.action").write_text(ACTION)
    (package / "srv" / "Scale.srv").write_text("float64[] values\nfloat64 factor\n---\nfloat64[] scaled\nbool success\n")
    (folder / "motion.proto").write_text(PROTO)
    examples = HOME / "examples"
    return {
        "action": package / "action" / "Approach.action",
        "srv": package / "srv" / "Scale.srv",
        "proto": folder / "motion.proto",
        "idl": examples / "wrist-kinematics" / "WristService.idl",
        "opros": examples / "ir-sensor" / "InfraredSensorService.xml",
        "installed": Path("sensor_msgs/srv/SetCameraInfo.srv"),
    }


@pytest.mark.parametrize(
    ("kind", "language"),
    [("action", "python"), ("proto", "java"), pytest.param("idl", "cpp", marks=cpp), ("opros", "python"), ("installed", "python"),
     pytest.param("srv", "java", marks=pytest.mark.long), pytest.param("idl", "python", marks=pytest.mark.long)],
)
def test_an_activity_of_each_format_and_language_is_green_at_once(tmp_path: Path, kind: str, language: str) -> None:
    begin(tmp_path / "new", "--language", language, "--interface", interfaces(tmp_path)[kind])
    ended = sitaf("run", tmp_path / "new")
    assert ended.returncode == 0, ended.stdout + ended.stderr
    assert "0 FAIL, 0 ERROR, 0 DONT" in ended.stdout


def test_an_activity_with_a_robot_runs_with_its_world(tmp_path: Path) -> None:
    begin(tmp_path / "new", "--robot", HOME / "examples" / "worlds" / "base" / "base.urdf.xacro")
    assert "differential_drive" in (tmp_path / "new" / "world" / "base.world.yaml").read_text()
    ended = sitaf("run", tmp_path / "new")
    assert ended.returncode == 0, ended.stdout + ended.stderr


def test_an_example_is_copied(tmp_path: Path) -> None:
    begin(tmp_path / "new", "--from", "ir-sensor-python")
    original = HOME / "examples" / "ir-sensor-python" / "activity.yaml"
    assert (tmp_path / "new" / "activity.yaml").read_bytes() == original.read_bytes()


def test_what_exists_is_never_touched(tmp_path: Path) -> None:
    (tmp_path / "notes.txt").write_text("mine")
    ended = sitaf("new", tmp_path)
    assert ended.returncode == 2
    assert "is not empty" in ended.stderr
    assert [path.name for path in tmp_path.iterdir()] == ["notes.txt"]


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--from", "nothing"], "is not an example; examples: "),
        (["--from", "../examples/ir-sensor"], "is not an example"),
        (["--from", "ir-sensor", "--language", "java"], "remove the other options"),
        (["--interface", "missing.idl"], "does not exist"),
        (["--interface", "/etc/hostname"], "is not an interface file"),
        (["--robot", "missing.urdf"], "does not exist"),
    ],
)
def test_a_bad_option_writes_nothing(tmp_path: Path, options: list[str], message: str) -> None:
    ended = sitaf("new", tmp_path / "new", *options)
    assert ended.returncode == 2
    assert message in ended.stderr
    assert not (tmp_path / "new").exists()


@pytest.mark.parametrize(
    ("package", "options", "profile"),
    [
        (
            "examples/rclpy/services/minimal_service",
            ("--class", "examples_rclpy_minimal_service.service:main"),
            "AddTwoInts.srv, name: /add_two_ints",
        ),
        (
            "demos/demo_nodes_py",
            ("--class", "demo_nodes_py.topics.listener:main"),
            "/chatter: input.chatter",
        ),
    ],
)
def test_the_activity_of_a_ros_package_is_green_at_once(
    tmp_path: Path, package: str, options: tuple[str, ...], profile: str
) -> None:
    folder = HOME.parent / "shared" / "ros2-packages" / package
    if not folder.is_dir():
        pytest.skip("../shared/ros2-packages is not there")
    begin(tmp_path / "new", "--node", folder, *options)
    assert profile in (tmp_path / "new" / "activity.yaml").read_text()
    ended = sitaf("run", tmp_path / "new")
    assert ended.returncode == 0, ended.stdout + ended.stderr
    assert "0 FAIL, 0 ERROR, 0 DONT" in ended.stdout


def test_a_package_cannot_be_combined_with_java(tmp_path: Path) -> None:
    ended = sitaf("new", tmp_path / "new", "--node", HOME / "examples" / "wall-stop-ros", "--language", "java")
    assert ended.returncode == 2
    assert "can be combined with --class, and with --language python or cpp" in ended.stderr
    assert not (tmp_path / "new").exists()


def test_a_language_of_nodes_points_to_their_option(tmp_path: Path) -> None:
    ended = sitaf("new", tmp_path / "new", "--language", "ros2-python")
    assert ended.returncode == 2
    assert "for a ROS 2 node use --node PACKAGE" in ended.stderr
