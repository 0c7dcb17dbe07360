"""Converts readings, commands, faults and poses between gRPC messages and Python objects."""

from collections.abc import Callable, Sequence

from google.protobuf.message import Message

from sitaf_bridge.errors import InvalidRequest
from sitaf_bridge.wire import simulation_pb2 as pb
from sitaf_bridge.world.devices import Command, Reading
from sitaf_bridge.world.devices.camera import Image
from sitaf_bridge.world.devices.laser_scan import ScanDeclaration
from sitaf_bridge.world.devices.range import RangeDeclaration
from sitaf_bridge.world.driving.entities import Motion
from sitaf_bridge.world.sensing.faults import Fault, FaultKind

FAULTS = {pb.FaultKind.Value(f"FAULT_KIND_{kind.name}"): kind for kind in FaultKind}
FORMS = {"joint": "joint", "drive": "drive", "gripper": "gripper", "level": "level"}


def reading_message(reading: Reading) -> pb.Reading:
    """The reading of one device."""
    return _BUILDERS[reading.device.kind](reading)


def image_message(image: Image) -> pb.Reading:
    """The image of one camera."""
    device = image.device
    return pb.Reading(
        device=device.name,
        image=pb.Image(
            height=device.height,
            width=device.width,
            encoding=image.encoding,
            step=len(image.data) // device.height,
            data=image.data,
        ),
    )


def commands_of(messages: Sequence[pb.DeviceCommand]) -> list[Command]:
    """Convert commands. Raises InvalidRequest for an empty command."""
    return [_command(message) for message in messages]


def faults_of(messages: Sequence[pb.Fault]) -> list[Fault]:
    """Convert faults. Raises InvalidRequest for an unknown kind."""
    for message in messages:
        if message.kind not in FAULTS:
            raise InvalidRequest(f"faults: {message.kind} is not a kind of fault")
    return [Fault(FAULTS[message.kind], message.value) for message in messages]


def motion_of(message: pb.EntityState) -> Motion:
    """Convert the fields that are present."""
    pose, twist = message.pose, message.twist
    turned = message.HasField("pose") and pose.HasField("orientation")
    moved = message.HasField("pose") and pose.HasField("position")
    return Motion(
        pos=xyz(pose.position) if moved else None,
        quat=wxyz(pose.orientation) if turned else None,
        linear=xyz(twist.linear) if message.HasField("twist") and twist.HasField("linear") else None,
        angular=xyz(twist.angular) if message.HasField("twist") and twist.HasField("angular") else None,
    )


def motion_message(motion: Motion) -> pb.EntityState:
    """Convert all fields of a motion."""
    w, x, y, z = motion.quat or (1.0, 0.0, 0.0, 0.0)
    pose = pb.Pose(position=vector(motion.pos or ()), orientation=pb.Quaternion(x=x, y=y, z=z, w=w))
    twist = pb.Twist(linear=vector(motion.linear or ()), angular=vector(motion.angular or ()))
    return pb.EntityState(pose=pose, twist=twist)


def vector(numbers: Sequence[float]) -> pb.Vector3:
    """Three numbers."""
    x, y, z = numbers
    return pb.Vector3(x=x, y=y, z=z)


def xyz(message: pb.Vector3) -> tuple[float, float, float]:
    """Three numbers."""
    return message.x, message.y, message.z


def wxyz(message: pb.Quaternion) -> tuple[float, float, float, float]:
    """Four numbers, in MuJoCo's order."""
    return message.w, message.x, message.y, message.z


def _command(message: pb.DeviceCommand) -> Command:
    form = message.WhichOneof("command")
    if form is None:
        raise InvalidRequest(f"commands: the command to {message.device!r} is empty")
    if form == "joint":
        joint = message.joint
        target = joint.WhichOneof("target")
        if target is None:
            raise InvalidRequest(f"commands: the command to {message.device!r} has no target")
        return Command(message.device, form, {target: getattr(joint, target)})
    if form == "drive":
        numbers = {"linear": message.drive.linear, "angular": message.drive.angular}
        return Command(message.device, form, numbers)
    if form == "level":
        return Command(message.device, form, {"level": float(message.level)})
    return Command(message.device, "gripper", {"width": message.gripper.width_m})


def _quaternion(numbers: Sequence[float]) -> pb.Quaternion:
    x, y, z, w = numbers
    return pb.Quaternion(x=x, y=y, z=z, w=w)


def _range(reading: Reading) -> pb.Reading:
    device = reading.device
    assert isinstance(device, RangeDeclaration)  # noqa: S101  # of this kind
    value = pb.Range(range_m=reading.values[0], min_range_m=device.low, max_range_m=device.high)
    return pb.Reading(device=device.name, range=value)


def _scan(reading: Reading) -> pb.Reading:
    device = reading.device
    assert isinstance(device, ScanDeclaration)  # noqa: S101  # of this kind
    value = pb.LaserScan(
        angle_min=device.first,
        angle_max=device.last,
        angle_increment=device.increment,
        range_min_m=device.low,
        range_max_m=device.high,
        ranges_m=reading.values,
    )
    return pb.Reading(device=device.name, laser_scan=value)


def _imu(reading: Reading) -> pb.Reading:
    v = reading.values
    value = pb.Imu(orientation=_quaternion(v[:4]), angular_velocity=vector(v[4:7]), linear_acceleration=vector(v[7:]))
    return pb.Reading(device=reading.device.name, imu=value)


def _encoder(reading: Reading) -> pb.Reading:
    position, velocity = reading.values
    return _joint(reading.device.name, position, velocity, float("nan"))


def _motor(reading: Reading) -> pb.Reading:
    return _joint(reading.device.name, *reading.values)


def _joint(device: str, position: float, velocity: float, effort: float) -> pb.Reading:
    return pb.Reading(device=device, joint=pb.JointState(position=position, velocity=velocity, effort=effort))


def _pose(reading: Reading) -> pb.Reading:
    v = reading.values
    return pb.Reading(device=reading.device.name, pose=pb.Pose(position=vector(v[:3]), orientation=_quaternion(v[3:])))


def _wrench(reading: Reading) -> pb.Reading:
    v = reading.values
    return pb.Reading(device=reading.device.name, wrench=pb.Wrench(force=vector(v[:3]), torque=vector(v[3:])))


def _contact(reading: Reading) -> pb.Reading:
    pressed, force = reading.values
    return pb.Reading(device=reading.device.name, contact=pb.Contact(pressed=pressed > 0.5, force_n=force))


def _fields(part: str, message: Callable[..., Message], names: Sequence[str]) -> Callable[[Reading], pb.Reading]:
    def build(reading: Reading) -> pb.Reading:
        value = message(**dict(zip(names, reading.values, strict=True)))
        return pb.Reading(device=reading.device.name, **{part: value})  # pyright: ignore[reportArgumentType]

    return build


def _magnetic(reading: Reading) -> pb.Reading:
    return pb.Reading(device=reading.device.name, magnetic_field=pb.MagneticField(field=vector(reading.values)))


def _level(reading: Reading) -> pb.Reading:
    return pb.Reading(device=reading.device.name, level=reading.values[0] > 0.5)


_BUILDERS: dict[str, Callable[[Reading], pb.Reading]] = {
    "range": _range,
    "laser_scan": _scan,
    "imu": _imu,
    "joint_encoder": _encoder,
    "joint_motor": _motor,
    "pose": _pose,
    "force_torque": _wrench,
    "contact": _contact,
    "differential_drive": _fields("drive", pb.Drive, ("linear", "angular", "left_position", "right_position")),
    "gripper": _fields("gripper", pb.Gripper, ("width_m", "effort_n")),
    "magnetometer": _magnetic,
    "battery": _fields("battery", pb.Battery, ("voltage_v", "current_a", "charge_ah", "percentage")),
    "digital_io": _level,
}
