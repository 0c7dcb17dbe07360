"""Worlds that are proposed for a robot compile at once, and their devices read plausible values."""

import math
import subprocess
import sys
from pathlib import Path

import pytest
import yaml

from sitaf_bridge.world.description.source import read_world
from sitaf_bridge.world.driving.simulation import Simulation
from sitaf_bridge.world.proposal.world_proposal import propose
from sitaf_bridge.world.world import load_world
from tests.test_urdf import ARM, PENDULUM, robots_of_a_package

EXAMPLES = Path(__file__).parents[2] / "examples" / "worlds"


def written(robot: Path, into: Path) -> Path:
    proposed = propose(robot)
    for path, content in proposed.files.items():
        (into / path).parent.mkdir(parents=True, exist_ok=True)
        (into / path).write_bytes(content)
    return into / proposed.description


def readings(description: Path, steps: int = 500) -> dict[str, tuple[float, ...]]:
    """What the devices read after a second, from the files that were written alone."""
    simulation = Simulation(load_world(read_world(description)))
    simulation.step(steps)
    return {r.device.name: tuple(r.values) for r in simulation.state.readings}


def test_an_arm_gets_a_motor_and_an_encoder_for_each_joint(tmp_path: Path) -> None:
    (tmp_path / "arm.urdf").write_text(ARM)
    found = readings(written(tmp_path / "arm.urdf", tmp_path / "new"))
    assert set(found) == {"shoulder", "elbow", "shoulder_encoder", "elbow_encoder", "grip_encoder"}
    assert found["shoulder"][0] == pytest.approx(0, abs=0.02)
    assert found["elbow_encoder"][0] == pytest.approx(1.5, abs=0.02)


def test_a_base_with_two_wheels_is_a_differential_drive(tmp_path: Path) -> None:
    description = written(EXAMPLES / "base" / "base.urdf.xacro", tmp_path / "new")
    world = yaml.safe_load(description.read_text())
    assert world["base"] == "free"
    assert world["devices"]["base"] == {
        "kind": "differential_drive",
        "left": "left_wheel_joint",
        "right": "right_wheel_joint",
        "wheel_radius": 0.1,
        "track": 0.36,
    }
    found = readings(description)
    assert found["base_pose"][2] == pytest.approx(0.1, abs=0.002)
    assert found["base"][0] == pytest.approx(0, abs=0.01)


def test_mjcf_keeps_its_actuators_and_starts_in_its_keyframe(tmp_path: Path) -> None:
    (tmp_path / "arm.xml").write_text(PENDULUM)
    description = written(tmp_path / "arm.xml", tmp_path / "new")
    assert yaml.safe_load(description.read_text())["start"] == "home"
    assert readings(description, 1)["hinge"][0] == pytest.approx(0.5, abs=0.01)
    assert (tmp_path / "new" / "arm.xml").read_text() == PENDULUM


def test_cameras_and_sensors_at_sites_become_devices(tmp_path: Path) -> None:
    world = yaml.safe_load(written(EXAMPLES / "maze" / "maze.xml", tmp_path / "new").read_text())
    kinds = {name: device["kind"] for name, device in world["devices"].items()}
    assert kinds["base"] == "differential_drive"
    assert kinds["lidar"] == "laser_scan"
    assert kinds["imu"] == "imu"
    assert kinds["front"] == "camera"


@pytest.mark.slow
@pytest.mark.parametrize(
    ("model", "joints", "base"),
    [
        ("ur_description/urdf/ur5_robot.urdf", 6, "fixed"),
        ("panda_description/urdf/panda.urdf", 8, "fixed"),
        ("go2_description/urdf/go2.urdf", 12, "free"),
    ],
)
def test_public_robots_get_worlds(tmp_path: Path, model: str, joints: int, base: str) -> None:
    description = written(robots_of_a_package() / model, tmp_path / "new")
    world = yaml.safe_load(description.read_text())
    assert world["base"] == base
    assert sum(d["kind"] == "joint_motor" for d in world["devices"].values()) == joints
    assert all(
        math.isfinite(value) and abs(value) < 1000 for values in readings(description).values() for value in values
    )


def test_the_command_writes_nothing_for_a_bad_robot(tmp_path: Path) -> None:
    (tmp_path / "robot.sdf").write_text("<sdf version='1.9'/>")
    command = [
        sys.executable,
        "-m",
        "sitaf_bridge",
        "propose",
        str(tmp_path / "robot.sdf"),
        "--into",
        str(tmp_path / "n"),
    ]
    ended = subprocess.run(command, capture_output=True, text=True)
    assert ended.returncode == 2
    assert "SDF is not supported" in ended.stderr
    assert not (tmp_path / "n").exists()
