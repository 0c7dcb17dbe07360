"""The SI units of the numbers in readings and commands."""

import mujoco

from sitaf_bridge.world.devices.joints import EncoderDeclaration, MotorDeclaration
from sitaf_bridge.world.devices.kind import DeviceDeclaration

PLAIN = "1"
# By kind and field; for a vector or a list, the field without its component or index.
UNITS = {
    "range.range": "m",
    "laser_scan.ranges": "m",
    "contact.force": "N",
    "differential_drive.linear": "m/s",
    "differential_drive.angular": "rad/s",
    "differential_drive.left_position": "rad",
    "differential_drive.right_position": "rad",
    "gripper.width": "m",
    "gripper.effort": "N",
    "battery.voltage": "V",
    "battery.current": "A",
    "battery.charge": "Ah",
    "magnetometer.field": "T",
    "force_torque.force": "N",
    "force_torque.torque": "N m",
    "pose.position": "m",
    "imu.angular_velocity": "rad/s",
    "imu.linear_acceleration": "m/s^2",
}
HINGE = {"position": "rad", "velocity": "rad/s", "effort": "N m"}
SLIDE = {"position": "m", "velocity": "m/s", "effort": "N"}


def unit_of(model: mujoco.MjModel, device: DeviceDeclaration, field: str) -> str:
    """The unit of a number of a device."""
    if isinstance(device, EncoderDeclaration | MotorDeclaration):
        return (SLIDE if _slides(model, device) else HINGE).get(field, PLAIN)
    return UNITS.get(f"{device.kind}.{field.partition('.')[0]}", PLAIN)


def _slides(model: mujoco.MjModel, device: EncoderDeclaration | MotorDeclaration) -> bool:
    if isinstance(device, EncoderDeclaration):
        joint = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, device.joint)
    else:
        actuator = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_ACTUATOR, device.actuator)
        joint = int(model.actuator_trnid[actuator, 0])
    return mujoco.mjtJoint(int(model.jnt_type[joint])) == mujoco.mjtJoint.mjJNT_SLIDE
