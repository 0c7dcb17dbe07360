"""The documents' fragments about real hardware work as shown, at the addresses of the test."""

import os
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from snippets import ROOT, snippet
from sockets import await_listener

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "contract"))

from provider_contract import running  # noqa: E402

pytest.importorskip("sitaf_hardware.wire", reason="pip install ./hardware/python")

DEVICES = """
devices:
  ir1: {kind: range, sensor: ir1, min: 0.05, max: 6}
  base: {kind: differential_drive, left: left_motor, right: right_motor, wheel_radius: 0.06, track: 0.32}
  imu: {kind: imu, site: imu}
  arm: {kind: joint_encoder, joint: left_wheel}
"""
COMPONENT = '''
class Robot:
    """Reads each device once."""

    def __init__(self, hardware):
        self.hardware = hardware

    def look(self) -> float:
        """What the recording says of gravity."""
        self.hardware.differential_drive("base").drive(0.1, 0.0)
        assert self.hardware.range_sensor("ir1").range() > 0.1
        assert self.hardware.joint_encoder("arm").position() == 0.0
        return self.hardware.imu("imu").linear_acceleration().z
'''
MODEL = """<test_model><name>Look</name><target interface="Robot" method="Look"/><input_spec_list/>
<output_spec_list><test_element abstract_type="NUMERIC" real_type="double"><name>return</name><type>RETURN</type>
<expected>9.5</expected></test_element></output_spec_list><order_of_combinations>1</order_of_combinations></test_model>"""
COLUMNS = [f"orientation.{axis}" for axis in "xyzw"]
COLUMNS += [f"{kind}.{axis}" for kind in ("angular_velocity", "linear_acceleration") for axis in "xyz"]


def activity(folder, hardware):
    world = folder / "world"
    shutil.copytree(ROOT / "examples" / "wall-distance" / "world", world)
    scene = (world / "maze.xml").read_text()
    scene = scene.replace(
        '<site name="imu"', '<site name="ir1" pos="0.18 0 0.1" zaxis="1 0 0"/>\n      <site name="imu"'
    )
    scene = scene.replace("</mujoco>", '  <sensor>\n    <rangefinder name="ir1" site="ir1"/>\n  </sensor>\n</mujoco>')
    (world / "maze.xml").write_text(scene)
    (world / "maze.world.yaml").write_text("mjcf: maze.xml\n" + DEVICES)
    (folder / "component").mkdir()
    (folder / "component" / "robot.py").write_text(COMPONENT)
    (folder / "robot.idl").write_text("interface Robot { double Look(); };\n")
    (folder / "Look.xml").write_text(MODEL)
    (folder / "imu.csv").write_text(f"t,{','.join(COLUMNS)}\n0,0,0,0,1,0,0,0,0,0,9.5\n")
    (folder / "activity.yaml").write_text(
        "name: backends\ncomponent: {language: python, sources: component/, class: robot.Robot}\n"
        "provided: [robot.idl]\nworld: world/maze.world.yaml\nmodels: [Look.xml]\nlimits: {jitter_ms: 5000}\n"
        + hardware
    )
    return world / "maze.world.yaml"


def provide(world):
    return lambda address: [sys.executable, "-m", "sitaf_bridge", "provide", world, "--listen", address]


def test_an_activity_has_devices_of_all_kinds(sitaf, tmp_path):
    shown = snippet("hardware-1-yaml")
    world = activity(tmp_path, shown)
    with running(provide(world)) as (_, real), running(provide(world)) as (_, shadow):
        addresses = {"unix:/run/ir1.sock": real, "127.0.0.1:7000": shadow, "0.05": "5"}
        for address, here in addresses.items():
            assert address in shown
            shown = shown.replace(address, here)
        profile = tmp_path / "activity.yaml"
        profile.write_text(profile.read_text().replace(snippet("hardware-1-yaml"), shown))
        # A heartbeat can be late on a busy machine, which makes a case DONT.
        for _ in range(3):
            run = sitaf("run", tmp_path, "--no-coverage")
            if run.returncode == 0:
                break
    assert run.returncode == 0, run.stdout + run.stderr
    devices = "devices: ir1: a real device, imu: a recording, arm: a real device as shadow;"
    assert devices in run.stdout, run.stdout


def test_the_package_of_providers_is_installed(tmp_path):
    command = shlex.split(snippet("hardware-2-sh"), comments=True)
    assert command[:2] == ["pip", "install"]
    subprocess.run([sys.executable, "-m", "venv", tmp_path / "venv"], check=True)
    programs = tmp_path / "venv" / "bin"
    subprocess.run([programs / command[0], *command[1:], "--quiet"], cwd=ROOT, check=True)
    subprocess.run([programs / "python", "-c", "from sitaf_hardware import Device, Limits, serve"], check=True)


BUS = """
class Bus:
    goal = 0.0
    def position(self): return self.goal
    def velocity(self): return 0.0
    def torque(self): return 0.0
    def move(self, goal): self.goal = goal
    def hold(self): pass
bus = Bus()
"""


def test_the_provider_of_the_reference_passes_the_contract(tmp_path):
    address = "unix:/run/finger.sock"
    here = f"unix:{tmp_path}/finger.sock"
    program = tmp_path / "finger.py"
    program.write_text(BUS + snippet("hardware-3-python").replace(address, here))
    env = {**os.environ, "PYTHONPATH": str(ROOT / "hardware" / "python")}
    provider = subprocess.Popen([sys.executable, program], env=env)
    try:
        await_listener(tmp_path / "finger.sock", provider)
        python, *arguments = shlex.split(snippet("hardware-4-sh"))
        assert python == "python"
        ran = subprocess.run(
            [sys.executable, *(here if a == address else a for a in arguments)],
            cwd=ROOT,
            capture_output=True,
            text=True,
            check=False,
        )
        assert ran.returncode == 0, ran.stdout + ran.stderr
        assert " passed" in ran.stdout
    finally:
        provider.terminate()
        provider.wait()
