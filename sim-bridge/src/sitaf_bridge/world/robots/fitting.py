"""Completes the compiled model of a URDF robot: gains of its actuators, its initial pose, its height.

URDF describes neither. Gains follow from the inertia that each joint moves, so that a small wrist and a heavy shoulder
both reach a commanded position quickly and without overshoot.
"""

from collections.abc import Sequence

import mujoco
import numpy as np

from sitaf_bridge.world.robots.model import RobotModel

# The name of the initial state of a model with a URDF robot; not a valid name in a world description.
START = "sitaf.start"
FLOOR = "floor"
# Between the floor and a fixed robot that would reach below it, in metres.
MARGIN = 0.01
# Stiffness: the angular frequency of the critically damped response to a position command.
POSITION_RATE = 100.0
# Speed: one over the time constant of the response to a velocity command.
VELOCITY_RATE = 50.0


def add_drives(spec: mujoco.MjSpec, model: RobotModel, prefix: str) -> None:
    """Add the actuators of a robot to a specification; `fit` computes their gains."""
    for drive in model.drives:
        actuator = spec.add_actuator(
            name=prefix + drive.joint, target=prefix + drive.joint, trntype=mujoco.mjtTrn.mjTRN_JOINT
        )
        if drive.mode == "position":
            actuator.set_to_position(kp=1.0, kv=1.0)
            if drive.limited:
                actuator.ctrlrange, actuator.ctrllimited = [drive.low, drive.high], 1
        elif drive.mode == "velocity":
            actuator.set_to_velocity(kv=1.0)
            if drive.velocity > 0:
                actuator.ctrlrange, actuator.ctrllimited = [-drive.velocity, drive.velocity], 1
        else:
            actuator.set_to_motor()
            if drive.effort > 0:
                actuator.ctrlrange, actuator.ctrllimited = [-drive.effort, drive.effort], 1
        if drive.effort > 0:
            actuator.forcerange, actuator.forcelimited = [-drive.effort, drive.effort], 1
    if spec.key(START) is None:
        spec.add_key(name=START)


def fit(model: mujoco.MjModel, robots: Sequence[RobotModel]) -> None:
    """Set gains, initial pose and height of all URDF robots in a compiled model."""
    robots = [robot for robot in robots if robot.urdf]
    if not robots:
        return
    key = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_KEY, START)
    qpos = model.qpos0.copy()
    for robot in robots:
        _start_within_limits(model, robot, qpos)
    data = mujoco.MjData(model)
    data.qpos[:] = qpos
    mujoco.mj_forward(model, data)
    for robot in robots:
        _stand(model, data, robot, qpos)
    inertia = np.zeros((model.nv, model.nv))
    if model.nv:
        mujoco.mj_fullM(model, data, inertia)
    for robot in robots:
        _set_gains(model, robot, inertia.diagonal(), model.key_ctrl[key], qpos)
    model.key_qpos[key] = qpos


def _start_within_limits(model: mujoco.MjModel, robot: RobotModel, qpos: np.ndarray) -> None:
    """Start at zero or, where a joint cannot be there, in the middle of its range (as joint_state_publisher does)."""
    for drive in robot.drives:
        if drive.limited and not drive.low <= 0 <= drive.high:
            joint = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, robot.robot.prefix + drive.joint)
            qpos[model.jnt_qposadr[joint]] = (drive.low + drive.high) / 2


def _stand(model: mujoco.MjModel, data: mujoco.MjData, robot: RobotModel, qpos: np.ndarray) -> None:
    """Put a free robot on the floor, and the floor below a fixed one, unless the world says where the robot is."""
    if robot.robot.placed:
        return
    joint = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, f"{robot.robot.prefix}base")
    if robot.robot.base == "free":
        root = int(model.jnt_bodyid[joint])
        lowest = min((_lowest(model, data, g) for g in range(model.ngeom) if _is_part(model, g, root)), default=0.0)
        address = int(model.jnt_qposadr[joint]) + 2
        qpos[address] -= lowest
        model.qpos0[address] -= lowest
        model.body_pos[root, 2] -= lowest
    elif not robot.robot.name:
        moving = [g for g in range(model.ngeom) if model.body_weldid[model.geom_bodyid[g]] != 0]
        lowest = min((_lowest(model, data, g) for g in moving), default=0.0)
        floor = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_GEOM, FLOOR)
        model.geom_pos[floor, 2] = min(0.0, lowest - MARGIN)
        # Compiled at the origin, its position would not be used.
        model.geom_sameframe[floor] = mujoco.mjtSameFrame.mjSAMEFRAME_NONE


def _lowest(model: mujoco.MjModel, data: mujoco.MjData, geom: int) -> float:
    height = float(data.geom_xpos[geom, 2])
    if mujoco.mjtGeom(int(model.geom_type[geom])) == mujoco.mjtGeom.mjGEOM_SPHERE:
        return height - float(model.geom_size[geom, 0])
    up = data.geom_xmat[geom].reshape(3, 3)[2]
    centre, half = model.geom_aabb[geom, :3], model.geom_aabb[geom, 3:]
    return height + float(up @ centre) - float(np.abs(up) @ half)


def _is_part(model: mujoco.MjModel, geom: int, root: int) -> bool:
    return int(model.body_rootid[model.geom_bodyid[geom]]) == root and bool(
        model.geom_contype[geom] or model.geom_conaffinity[geom]
    )


def _set_gains(
    model: mujoco.MjModel, robot: RobotModel, inertia: np.ndarray, controls: np.ndarray, qpos: np.ndarray
) -> None:
    prefix = robot.robot.prefix
    for drive in robot.drives:
        actuator = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_ACTUATOR, prefix + drive.joint)
        joint = int(model.actuator_trnid[actuator, 0])
        moved = float(inertia[model.jnt_dofadr[joint]])
        if drive.mode == "position":
            stiffness, damping = moved * POSITION_RATE**2, 2 * moved * POSITION_RATE
            model.actuator_gainprm[actuator, 0] = stiffness
            model.actuator_biasprm[actuator, :3] = 0, -stiffness, -damping
            controls[actuator] = qpos[model.jnt_qposadr[joint]]
        elif drive.mode == "velocity":
            gain = VELOCITY_RATE * (moved + _rolling_load(model, robot, joint))
            model.actuator_gainprm[actuator, 0] = gain
            model.actuator_biasprm[actuator, :3] = 0, 0, -gain


def _rolling_load(model: mujoco.MjModel, robot: RobotModel, joint: int) -> float:
    """The inertia of the whole robot at the rim of a wheel: a wheel's own is a small part of what it moves."""
    if robot.robot.base != "free":
        return 0.0
    body = int(model.jnt_bodyid[joint])
    first, count = int(model.body_geomadr[body]), int(model.body_geomnum[body])
    radius = max((float(model.geom_rbound[g]) for g in range(first, first + count)), default=0.0)
    return float(model.body_subtreemass[model.body_rootid[body]]) * radius**2
