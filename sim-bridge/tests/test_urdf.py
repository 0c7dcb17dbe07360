"""Robots from URDF, xacro and MJCF among the files of a world."""

import importlib.metadata
import math
from pathlib import Path

import grpc
import pytest

from sitaf_bridge.wire import simulation_pb2 as pb
from tests.client import Bridge, observed, world
from tests.conftest import Refused

EXAMPLES = Path(__file__).parents[2] / "examples" / "worlds"
INERTIAL = '<inertial><mass value="2"/><inertia ixx=".1" ixy="0" ixz="0" iyy=".1" iyz="0" izz=".1"/></inertial>'


def joint(name: str, kind: str, parent: str, child: str, more: str = "") -> str:
    ends = f'<parent link="{parent}"/><child link="{child}"/>'
    return f'<joint name="{name}" type="{kind}">{ends}<axis xyz="0 1 0"/>{more}</joint>'


ARM = f"""<robot name="arm">
  <link name="base"><collision><geometry><box size=".2 .2 .2"/></geometry></collision></link>
  <link name="upper">{INERTIAL}<visual><geometry><mesh filename="package://arm/upper.dae"/></geometry></visual></link>
  <link name="lower">{INERTIAL}</link>
  <link name="finger"/>
  {joint("shoulder", "revolute", "base", "upper", '<limit lower="-1" upper="2" effort="80" velocity="2"/>')}
  {joint("elbow", "revolute", "upper", "lower", '<limit lower="1" upper="2" effort="50" velocity="2"/>')}
  {joint("grip", "prismatic", "lower", "finger", '<limit lower="0" upper=".1" effort="5"/><mimic joint="elbow"/>')}
  <gazebo><plugin name="ros_control" filename="libgazebo_ros_control.so"/></gazebo>
</robot>"""


def urdf_world(text: str, description: str = "", **files: bytes) -> pb.WorldSource:
    yaml = f"mjcf: robot.urdf\n{description}"
    return pb.WorldSource(
        description="w.world.yaml", files={"w.world.yaml": yaml.encode(), "robot.urdf": text.encode(), **files}
    )


def joints(state: pb.WorldState) -> dict[str, float]:
    return {r.device: r.joint.position for r in state.readings if r.HasField("joint")}


DEVICES = """
devices:
  shoulder: {kind: joint_motor, actuator: shoulder}
  elbow: {kind: joint_encoder, joint: elbow}
"""


def command(bridge: Bridge, session: str, **positions: float) -> None:
    commands = [
        pb.DeviceCommand(device=device, joint=pb.JointCommand(position=position))
        for device, position in positions.items()
    ]
    bridge.hardware.WriteDevices(pb.WriteDevicesRequest(session_id=session, commands=commands))


def test_a_urdf_is_a_world_whose_joints_take_positions(bridge: Bridge) -> None:
    session = bridge.create(urdf_world(ARM, DEVICES))
    # An elbow that cannot be at zero starts in the middle of its range.
    assert joints(session.prepare()) == pytest.approx({"shoulder": 0, "elbow": 1.5}, abs=1e-9)
    command(bridge, session.id, shoulder=1.0)
    assert joints(session.step(1000)) == pytest.approx({"shoulder": 1.0, "elbow": 1.5}, abs=0.02)
    session.delete()


def test_a_command_beyond_the_limit_of_the_joint_is_refused(bridge: Bridge, refused: Refused) -> None:
    session = bridge.create(urdf_world(ARM, DEVICES))
    code, message = refused(lambda: command(bridge, session.id, shoulder=2.5))
    assert code == grpc.StatusCode.OUT_OF_RANGE
    assert "[-1, 2]" in message
    session.delete()


@pytest.mark.parametrize(
    ("actuators", "part", "mode"),
    [
        ("velocity", "", "velocity"),
        ("{shoulder: effort}", "", "effort"),
        (
            "",
            '<ros2_control><joint name="shoulder"><command_interface name="velocity"/></joint></ros2_control>',
            "velocity",
        ),
        (
            "",
            '<transmission><joint name="shoulder"><hardwareInterface>hardware_interface/EffortJointInterface'
            "</hardwareInterface></joint></transmission>",
            "effort",
        ),
    ],
)
def test_the_mode_of_an_actuator_comes_from_the_world_or_the_urdf(
    bridge: Bridge, refused: Refused, actuators: str, part: str, mode: str
) -> None:
    text = ARM.replace("</robot>", part + "</robot>")
    keys = f"actuators: {actuators}\n" if actuators else ""
    session = bridge.create(urdf_world(text, keys + "devices: {shoulder: {kind: joint_motor, actuator: shoulder}}"))
    _, message = refused(lambda: command(bridge, session.id, shoulder=0.0))
    assert f"takes {mode}, not position" in message
    session.delete()


def test_a_robot_from_a_file_joins_the_world_of_an_mjcf(bridge: Bridge) -> None:
    yaml = """
robots:
  a: {file: arms/arm.urdf, pos: [0, 0, 1]}
  b: {file: arms/arm.urdf, pos: [1, 0, 1], base: free}
devices: {motor: {kind: joint_motor, actuator: b_shoulder}, elbow: {kind: joint_encoder, joint: a_elbow}}
"""
    source = world('<worldbody><geom type="plane" size="0 0 1"/></worldbody>', yaml, {"arms/arm.urdf": ARM.encode()})
    session = bridge.create(source)
    assert joints(session.prepare())["elbow"] == pytest.approx(1.5)
    assert {"a_upper", "b_upper"} <= set(bridge.describe(source).entities)
    session.delete()


PENDULUM = """<mujoco><worldbody>
<body name="arm"><joint name="hinge" axis="0 1 0"/><geom size=".1" pos="0 0 -1"/></body>
</worldbody><actuator><position name="motor" joint="hinge" kp="100" kv="10"/></actuator>
<keyframe><key name="home" qpos="0.5" ctrl="0.5"/><key name="up" qpos="3" ctrl="3"/></keyframe></mujoco>"""
HINGE = "devices: {hinge: {kind: joint_encoder, joint: PREFIXhinge}}\n"


def test_a_session_starts_in_a_keyframe(bridge: Bridge, refused: Refused) -> None:
    session = bridge.create(world(PENDULUM, "start: home\n" + HINGE.replace("PREFIX", "")))
    assert joints(session.prepare()) == {"hinge": 0.5}
    session.step(50)
    assert joints(session.reset()) == {"hinge": 0.5}
    session.delete()
    _, message = refused(lambda: bridge.describe(world(PENDULUM, "start: down")))
    assert message == "w.world.yaml:2: start: the model has no keyframe 'down'; keyframes: home, up"


def test_a_parameter_chooses_among_keyframes(bridge: Bridge, refused: Refused) -> None:
    chosen = 'parameters: {Start: {unit: "1", range: [0, 1], default: 1, bind: {set: start, choices: [home, up]}}}\n'
    session = bridge.create(world(PENDULUM, chosen + HINGE.replace("PREFIX", "")))
    assert joints(session.prepare()) == {"hinge": 3.0}
    assert joints(session.prepare(Start=0.0)) == {"hinge": 0.5}
    session.delete()
    _, message = refused(lambda: bridge.describe(world(PENDULUM, chosen.replace("[0, 1]", "[0, 4]"))))
    assert "range: must be [0, 1], the indices of `choices`" in message


def test_mjcf_with_includes_and_keyframes_is_a_robot_unchanged(bridge: Bridge) -> None:
    files = {
        "menagerie/arm/arm.xml": b'<mujoco><compiler meshdir="assets"/><include file="parts.xml"/>'
        b'<asset><mesh name="m" file="m.obj"/></asset></mujoco>',
        "menagerie/arm/parts.xml": PENDULUM.replace('size=".1"', 'type="mesh" mesh="m"').encode(),
        "menagerie/arm/assets/m.obj": b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n",
    }
    floor = '<worldbody><geom type="plane" size="0 0 1"/></worldbody>'
    yaml = "start: r_home\nrobots: {r: {file: menagerie/arm/arm.xml, pos: [0, 0, 3]}}\n" + HINGE.replace("PREFIX", "r_")
    session = bridge.create(world(floor, yaml, files))
    assert joints(session.prepare()) == {"hinge": 0.5}
    session.delete()


def test_the_example_of_a_base_drives_at_the_commanded_speed(bridge: Bridge) -> None:
    folder = EXAMPLES / "base"
    files = {str(p.relative_to(folder)): p.read_bytes() for p in folder.rglob("*") if p.is_file()}
    session = bridge.create(pb.WorldSource(description="base.world.yaml", files=files))
    state = session.prepare(settle_ns=10**9)
    readings = {reading.device: reading for reading in state.readings}
    assert readings["imu"].imu.linear_acceleration.z == pytest.approx(9.81, abs=0.05)
    assert readings["pose"].pose.position.z == pytest.approx(0.08, abs=0.002)
    drive = pb.DeviceCommand(device="base", drive=pb.DriveCommand(linear=0.5, angular=0))
    bridge.hardware.WriteDevices(pb.WriteDevicesRequest(session_id=session.id, commands=[drive]))
    assert observed(session.step(1000))["speed"] == pytest.approx(0.5, abs=0.03)
    session.delete()


XACRO = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{}<link name="base"/></robot>'


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ('<xacro:include filename="/etc/passwd"/>', "'/etc/passwd' is not among the files of the world"),
        ('<xacro:include filename="../../../etc/passwd"/>', "is not among the files of the world"),
        ("<a b=\"${xacro.load_yaml('/etc/passwd')}\"/>", "is not among the files of the world"),
        ('<a b="$(find numpy)"/>', "the package 'numpy' is not known"),
        ('<a b="$(env HOME)"/>', "environment variable"),
        ('<a b="${().__class__}"/>', "'__class__' is not allowed"),
        ('<a b="${(lambda: ().__class__)()}"/>', "'__class__' is not allowed"),
        ('<a b="${(x for x in [1]).gi_frame}"/>', "'gi_frame' is not allowed"),
        ('<a b="${python.type(1)}"/>', "'type'"),
        ("<a b=\"${python.vars(xacro)['x']}\"/>", "'vars'"),
        ("<a b=\"$(eval 'x'.__class__)\"/>", "may not contain double underscore"),
        ('<a b="${__import__(1)}"/>', "not allowed"),
        ('<a b="${open(1)}"/>', "name 'open' is not defined"),
        ('<xacro:macro name="m"><xacro:m/></xacro:macro><xacro:m/>', "nested too deep"),
        ('<xacro:property name="x" value="${x}"/><a b="${x}"/>', "circular"),
        ('<a b="${len([0] * 10**10)}"/>', "needs more memory"),
        ('<!DOCTYPE x [<!ENTITY a "b">]>', "not"),
    ],
)
def test_hostile_xacro_is_refused(bridge: Bridge, refused: Refused, content: str, message: str) -> None:
    code, found = refused(lambda: bridge.describe(urdf_world(XACRO.format(content + "<xacro:x/>"))))
    assert code == grpc.StatusCode.INVALID_ARGUMENT
    assert message in found


@pytest.mark.slow
def test_endless_xacro_ends(bridge: Bridge, refused: Refused) -> None:
    endless = '<a b="${[0 for i in range(10**6) for j in range(10**6) if i + j &lt; 0]}"/><xacro:x/>'
    code, found = refused(lambda: bridge.describe(urdf_world(XACRO.format(endless))))
    assert code == grpc.StatusCode.INVALID_ARGUMENT
    assert "xacro takes longer than" in found


MESH = '<link name="m"><collision><geometry><mesh filename="{}"/></geometry></collision></link></robot>'


@pytest.mark.parametrize(
    ("text", "keys", "message"),
    [
        ("<sdf version='1.9'><model/></sdf>", "", "SDF is not supported"),
        (ARM.replace("</robot>", MESH.format("package://arm/m.dae")), "", "MuJoCo reads STL, OBJ and MSH"),
        (ARM.replace("</robot>", MESH.format("package://arm/m.stl")), "", "write `packages: {arm: FOLDER}`"),
        (ARM.replace("</robot>", MESH.format("file:///etc/m.stl")), "", "files of this machine are not read"),
        (ARM.replace("</robot>", MESH.format("../../m.stl")), "", "files of this machine are not read"),
        ("<!DOCTYPE robot><robot/>", "", "a document type"),
        (ARM, "packages: {arm: ../arm}", "contains '.', '..'"),
        (ARM, "packages: [arm]", "must be a mapping"),
        (ARM, "actuators: fast", "is not one of position, velocity, effort, none"),
        (ARM, "actuators: {wrist: position}", "the robot has no such joint to drive; joints: shoulder, elbow"),
        (ARM, "xacro_args: {a: 1}", "the file is not xacro"),
        (ARM, "base: floating", "is not one of fixed, free"),
        (ARM, "sites: {s: {body: nose}}", "sites.s.body: the robot has no body 'nose'"),
        (ARM.replace('upper="2"', 'upper="nan"'), "", "must be finite"),
        ("<robot/>", "", "the robot has no link"),
    ],
)
def test_a_bad_urdf_is_refused(bridge: Bridge, refused: Refused, text: str, keys: str, message: str) -> None:
    code, found = refused(lambda: bridge.describe(urdf_world(text, keys)))
    assert code == grpc.StatusCode.INVALID_ARGUMENT
    assert message in found


def robots_of_a_package() -> Path:
    try:
        found = importlib.metadata.distribution("example-robot-data")
    except importlib.metadata.PackageNotFoundError:
        pytest.skip("example-robot-data is not installed")
    return Path(str(found.locate_file("cmeel.prefix/share/example-robot-data/robots")))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("folder", "model", "count"),
    [
        ("ur_description", "urdf/ur5_robot.urdf", 6),
        ("ur_description", "urdf/ur10_robot.urdf", 6),
        ("panda_description", "urdf/panda.urdf", 7),
        ("xarm_description", "urdf/xarm7.urdf", 7),
        ("talos_data", "robots/talos_left_arm.urdf", 7),
        ("go2_description", "urdf/go2.urdf", 12),
    ],
)
def test_public_robots_hold_their_initial_pose(bridge: Bridge, folder: str, model: str, count: int) -> None:
    root = robots_of_a_package()
    suffixes = (".urdf", ".stl", ".obj")
    files = {
        f"robots/{p.relative_to(root)}": p.read_bytes()
        for p in (root / folder).rglob("*")
        if p.suffix.lower() in suffixes
    }
    # The package's own folder is above these files.
    yaml = f"mjcf: robots/{folder}/{model}\npackages: {{example-robot-data: .}}\ndevices:\n"
    names = joints_of(files[f"robots/{folder}/{model}"])
    devices = "".join(f"  d{i}: {{kind: joint_encoder, joint: {name}}}\n" for i, name in enumerate(names))
    source = pb.WorldSource(
        description="w.world.yaml",
        files={**files, "w.world.yaml": (yaml + devices).encode()},
    )
    session = bridge.create(source)
    before = joints(session.prepare())
    after = joints(session.step(500))
    assert len(before) >= count
    assert max(abs(after[name] - before[name]) for name in before) < 0.02
    assert all(math.isfinite(value) for value in after.values())
    session.delete()


def joints_of(text: bytes) -> list[str]:
    import xml.etree.ElementTree as ET

    root = ET.fromstring(text)
    return [
        j.get("name", "")
        for j in root.findall("joint")
        if j.get("type") in ("revolute", "continuous") and j.find("mimic") is None
    ]
