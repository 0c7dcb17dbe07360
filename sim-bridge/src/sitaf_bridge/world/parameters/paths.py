"""The `set` paths of a world description and their settings."""

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

import mujoco

from sitaf_bridge.world.devices import KINDS, DeviceDeclaration
from sitaf_bridge.world.parameters.environment import ActuatorGain, DeviceKnob, LightBrightness, Wind
from sitaf_bridge.world.parameters.rotation import FreeRotation, MocapRotation
from sitaf_bridge.world.parameters.settings import (
    BodyMass,
    BodyPosition,
    GeomFriction,
    GeomSize,
    Gravity,
    JointPosition,
    MocapPosition,
    NoSuchSetting,
    Setting,
    name_to_id,
)

AXES = "xyz"
DEVICE_SHAPE = "device.NAME.noise|delay|level"
DEVICE = re.compile(r"device\.(?P<name>[^.]+)\.(?P<last>noise|delay|level)")
ANGLES = ("roll", "pitch", "yaw")


@dataclass(frozen=True)
class _Form:
    shape: str
    find: Callable[[mujoco.MjModel, str, str], Setting]
    pattern: re.Pattern[str] = field(compare=False)


def _knob(model: mujoco.MjModel, devices: Mapping[str, DeviceDeclaration], match: re.Match[str]) -> Setting:
    name, knob = match["name"], match["last"]
    device = devices.get(name)
    if device is None or KINDS[device.kind].image:
        raise NoSuchSetting(f"there is no device {name!r} that has a {knob}")
    if knob == "level" and device.kind not in ("battery", "digital_io"):
        raise NoSuchSetting(f"a device of kind {device.kind} has no level")
    return DeviceKnob(device.address(model, knob))


def find_setting(model: mujoco.MjModel, path: str, devices: Mapping[str, DeviceDeclaration]) -> Setting:
    """The setting of a `set` path. Raises NoSuchSetting."""
    match = DEVICE.fullmatch(path)
    if match:
        return _knob(model, devices, match)
    for form in FORMS:
        match = form.pattern.fullmatch(path)
        if match:
            return form.find(model, match["name"], match["last"])
    raise NoSuchSetting(
        "is not a known path; known forms: " + ", ".join([*(form.shape for form in FORMS), DEVICE_SHAPE])
    )


def _body_position(model: mujoco.MjModel, name: str, last: str) -> Setting:
    body = name_to_id(model, mujoco.mjtObj.mjOBJ_BODY, "body", name)
    axis = AXES.index(last)
    if body == 0:
        raise NoSuchSetting("the world itself cannot be moved")
    if model.body_mocapid[body] >= 0:
        return MocapPosition(int(model.body_mocapid[body]), axis)
    joint = int(model.body_jntadr[body])
    if joint >= 0 and model.jnt_type[joint] == mujoco.mjtJoint.mjJNT_FREE:
        return JointPosition(int(model.jnt_qposadr[joint]) + axis)
    moves = bool(model.body_weldid[body] != 0) or any(
        model.body_dofnum[b] > 0 and _is_below(model, b, body) for b in range(body, model.nbody)
    )
    return BodyPosition(body, axis, moves)


def _is_below(model: mujoco.MjModel, body: int, ancestor: int) -> bool:
    while body > ancestor:
        body = int(model.body_parentid[body])
    return body == ancestor


def _body_mass(model: mujoco.MjModel, name: str, _last: str) -> Setting:
    body = name_to_id(model, mujoco.mjtObj.mjOBJ_BODY, "body", name)
    mass = float(model.body_mass[body])
    if mass <= 0:
        raise NoSuchSetting(f"the body {name!r} has no mass")
    x, y, z = model.body_inertia[body].tolist()
    return BodyMass(body, mass, (x, y, z))


def _geom_friction(model: mujoco.MjModel, name: str, last: str) -> Setting:
    return GeomFriction(name_to_id(model, mujoco.mjtObj.mjOBJ_GEOM, "geom", name), int(last))


def _geom_size(model: mujoco.MjModel, name: str, last: str) -> Setting:
    geom = name_to_id(model, mujoco.mjtObj.mjOBJ_GEOM, "geom", name)
    kind = mujoco.mjtGeom(int(model.geom_type[geom]))
    sizes = {
        mujoco.mjtGeom.mjGEOM_SPHERE: 1,
        mujoco.mjtGeom.mjGEOM_CAPSULE: 2,
        mujoco.mjtGeom.mjGEOM_CYLINDER: 2,
        mujoco.mjtGeom.mjGEOM_ELLIPSOID: 3,
        mujoco.mjtGeom.mjGEOM_BOX: 3,
    }.get(kind, 0)
    if int(last) >= sizes:
        raise NoSuchSetting(f"the geom {name!r} has {sizes} sizes that can be set")
    return GeomSize(geom, int(last))


def _joint_position(model: mujoco.MjModel, name: str, _last: str) -> Setting:
    joint = name_to_id(model, mujoco.mjtObj.mjOBJ_JOINT, "joint", name)
    # Converted, because comparing a NumPy integer with an enumerator of MuJoCo depends on the order of operands.
    if mujoco.mjtJoint(int(model.jnt_type[joint])) not in (mujoco.mjtJoint.mjJNT_HINGE, mujoco.mjtJoint.mjJNT_SLIDE):
        raise NoSuchSetting(f"the joint {name!r} is neither a hinge nor a slide")
    return JointPosition(int(model.jnt_qposadr[joint]))


def _body_rotation(model: mujoco.MjModel, name: str, last: str) -> Setting:
    body = name_to_id(model, mujoco.mjtObj.mjOBJ_BODY, "body", name)
    angle = ANGLES.index(last)
    if model.body_mocapid[body] >= 0:
        return MocapRotation(int(model.body_mocapid[body]), angle)
    joint = int(model.body_jntadr[body])
    if joint >= 0 and model.jnt_type[joint] == mujoco.mjtJoint.mjJNT_FREE:
        return FreeRotation(int(model.jnt_qposadr[joint]) + 3, angle)
    raise NoSuchSetting("only a mocap body and a body with a free joint can be rotated")


def _wind(_model: mujoco.MjModel, _name: str, last: str) -> Setting:
    return Wind(AXES.index(last))


def _light(model: mujoco.MjModel, name: str, _last: str) -> Setting:
    light = name_to_id(model, mujoco.mjtObj.mjOBJ_LIGHT, "light", name)
    red, green, blue = model.light_diffuse[light].tolist()
    return LightBrightness(light, (red, green, blue))


def _gain(model: mujoco.MjModel, name: str, _last: str) -> Setting:
    actuator = name_to_id(model, mujoco.mjtObj.mjOBJ_ACTUATOR, "actuator", name)
    gain = float(model.actuator_gainprm[actuator, 0])
    if mujoco.mjtGain(int(model.actuator_gaintype[actuator])) != mujoco.mjtGain.mjGAIN_FIXED or gain <= 0:
        raise NoSuchSetting(f"the actuator {name!r} has no fixed positive gain")
    return ActuatorGain(actuator, gain, tuple(model.actuator_biasprm[actuator].tolist()))


def _gravity(_model: mujoco.MjModel, _name: str, last: str) -> Setting:
    return Gravity(AXES.index(last))


FORMS = tuple(
    _Form(shape, find, re.compile(pattern))
    for shape, pattern, find in (
        ("body.NAME.pos.x|y|z", r"body\.(?P<name>.+)\.pos\.(?P<last>[xyz])", _body_position),
        ("body.NAME.roll|pitch|yaw", r"body\.(?P<name>.+)\.(?P<last>roll|pitch|yaw)", _body_rotation),
        ("body.NAME.mass", r"body\.(?P<name>.+)\.(?P<last>mass)", _body_mass),
        ("geom.NAME.friction.0|1|2", r"geom\.(?P<name>.+)\.friction\.(?P<last>[012])", _geom_friction),
        ("geom.NAME.size.0|1|2", r"geom\.(?P<name>.+)\.size\.(?P<last>[012])", _geom_size),
        ("joint.NAME.pos", r"joint\.(?P<name>.+)\.(?P<last>pos)", _joint_position),
        ("actuator.NAME.gain", r"actuator\.(?P<name>.+)\.(?P<last>gain)", _gain),
        ("light.NAME.brightness", r"light\.(?P<name>.+)\.(?P<last>brightness)", _light),
        ("option.wind.x|y|z", r"(?P<name>option)\.wind\.(?P<last>[xyz])", _wind),
        ("option.gravity.x|y|z", r"(?P<name>option)\.gravity\.(?P<last>[xyz])", _gravity),
    )
)
