"""The devices of robots: one module per kind or family of kinds, which declares, binds and reads its devices."""

from sitaf_bridge.world.devices.board import BatteryKind, DigitalIoKind
from sitaf_bridge.world.devices.camera import CameraKind
from sitaf_bridge.world.devices.contact import ContactKind
from sitaf_bridge.world.devices.inertial import FORCE_TORQUE, IMU, MAGNETOMETER, POSE
from sitaf_bridge.world.devices.joints import JointEncoderKind, JointMotorKind
from sitaf_bridge.world.devices.kind import KNOBS, Bank, Command, DeviceDeclaration, DeviceKind, Reading
from sitaf_bridge.world.devices.laser_scan import LaserScanKind
from sitaf_bridge.world.devices.range import RangeKind
from sitaf_bridge.world.devices.vehicles import DifferentialDriveKind, GripperKind

KINDS: dict[str, DeviceKind] = {
    kind.name: kind
    for kind in (
        RangeKind(),
        LaserScanKind(),
        IMU,
        JointEncoderKind(),
        POSE,
        FORCE_TORQUE,
        ContactKind(),
        CameraKind(),
        JointMotorKind(),
        DifferentialDriveKind(),
        GripperKind(),
        MAGNETOMETER,
        BatteryKind(),
        DigitalIoKind(),
    )
}

__all__ = ["KINDS", "KNOBS", "Bank", "Command", "DeviceDeclaration", "DeviceKind", "Reading"]
