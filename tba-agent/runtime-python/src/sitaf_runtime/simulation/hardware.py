"""The hardware of a simulated robot.

Readings come from the state after the last step, without a round trip; images and waits are calls to the simulator.
Commands travel with the next wait, or with a reading that they change before time advances.
"""

from __future__ import annotations

import time
from typing import Any, Protocol, TypeVar

from sitaf_runtime.robot import actuators, sensors
from sitaf_runtime.robot.hardware import Hardware
from sitaf_runtime.simulation import devices as simulated
from sitaf_runtime.simulation.frozen import FrozenWorld, Layout
from sitaf_runtime.simulation.wire.sitaf.sim.v1 import simulation_pb2 as pb
from sitaf_runtime.stopwatch import Stopwatch

_NANOS = 1_000_000_000
D = TypeVar("D", bound=simulated._Simulated)


class Simulator(Protocol):
    """Operations that call the simulator."""

    def write(self, command: pb.DeviceCommand) -> None:
        """Command a device, at the latest with the next step."""
        ...

    def send_pending(self) -> None:
        """Send the commands that wait for the next step."""
        ...

    def look(self, camera: str) -> pb.Reading:
        """Get the current image of a camera."""
        ...

    def wait(self, time_ns: int) -> None:
        """Let simulation time pass."""
        ...


class SimulatedHardware(Hardware):
    """The devices of a world; `settings` are their readings at the start of the session."""

    def __init__(
        self,
        layout: Layout,
        settings: dict[str, pb.Reading],
        stopwatch: Stopwatch,
        world: FrozenWorld,
        simulator: Simulator,
    ) -> None:
        self.world = world
        self.layout = layout
        self.settings = settings
        self.stopwatch = stopwatch
        self.simulator = simulator

    @property
    def devices(self) -> frozenset[str]:
        return frozenset(self.layout.kinds)

    def range_sensor(self, name: str) -> sensors.RangeSensor:
        return self._device(name, "range", "a range sensor", simulated.Range)

    def laser_scanner(self, name: str) -> sensors.LaserScanner:
        return self._device(name, "laser_scan", "a laser scanner", simulated.Scanner)

    def imu(self, name: str) -> sensors.ImuSensor:
        return self._device(name, "imu", "an inertial unit", simulated.Imu)

    def joint_encoder(self, name: str) -> sensors.JointEncoder:
        return self._device(name, "joint_encoder", "a joint encoder", simulated.Encoder)

    def pose_sensor(self, name: str) -> sensors.PoseSensor:
        return self._device(name, "pose", "a pose sensor", simulated.Pose)

    def force_torque_sensor(self, name: str) -> sensors.ForceTorqueSensor:
        return self._device(name, "force_torque", "a force and torque sensor", simulated.Force)

    def contact_sensor(self, name: str) -> sensors.ContactSensor:
        return self._device(name, "contact", "a bumper", simulated.Bumper)

    def camera(self, name: str) -> sensors.Camera:
        return self._device(name, "camera", "a camera", simulated.Eye)

    def magnetometer(self, name: str) -> sensors.Magnetometer:
        return self._device(name, "magnetometer", "a magnetometer", simulated.Compass)

    def battery(self, name: str) -> sensors.Battery:
        return self._device(name, "battery", "a battery", simulated.Accumulator)

    def joint_motor(self, name: str) -> actuators.JointMotor:
        return self._device(name, "joint_motor", "a joint motor", simulated.Motor)

    def differential_drive(self, name: str) -> actuators.DifferentialDrive:
        return self._device(name, "differential_drive", "a differential drive", simulated.Drive)

    def gripper(self, name: str) -> actuators.Gripper:
        return self._device(name, "gripper", "a gripper", simulated.Hand)

    def digital_line(self, name: str) -> actuators.DigitalLine:
        return self._device(name, "digital_io", "a digital line", simulated.Line)

    def time(self) -> float:
        return self.world.time_ns / _NANOS

    def sleep(self, seconds: float) -> None:
        if not 0 <= seconds < 1e9:
            raise ValueError(f"cannot sleep for {seconds} seconds")
        with self.stopwatch.in_hardware():
            self.simulator.wait(round(seconds * _NANOS))

    def _device(self, name: str, kind: str, article: str, type_: type[D]) -> D:
        entered = time.perf_counter_ns()
        try:
            actual = self.layout.kinds.get(name)
            if actual is None:
                raise ValueError(f"the robot has no device '{name}'; it has {', '.join(sorted(self.layout.kinds))}")
            if actual != kind:
                raise ValueError(f"device '{name}' is of kind {actual}, not {article}")
            return type_(name, _Access(self, name))
        finally:
            self.stopwatch.leave_hardware(entered)


class _Access:
    """Access of one device to its readings and the simulator; measured as hardware time."""

    __slots__ = ("_end", "_hardware", "_name", "_start")

    def __init__(self, hardware: SimulatedHardware, name: str) -> None:
        self._hardware = hardware
        self._name = name
        self._start, self._end = hardware.layout.places[name]

    def number(self, index: int) -> float:
        entered = time.perf_counter_ns()
        value = self._hardware.world.numbers[self._start + index]
        self._hardware.stopwatch.leave_hardware(entered)
        return value

    def numbers(self, start: int, count: int) -> list[float]:
        entered = time.perf_counter_ns()
        first = self._start + start
        values = self._hardware.world.numbers[first : self._end if count < 0 else first + count]
        self._hardware.stopwatch.leave_hardware(entered)
        return list(values)

    def after_commands(self) -> _Access:
        with self._hardware.stopwatch.in_hardware():
            self._hardware.simulator.send_pending()
        return self

    def setting(self) -> Any:
        with self._hardware.stopwatch.in_hardware():
            return self._hardware.settings.get(self._name, pb.Reading())

    def write(self, command: pb.DeviceCommand) -> None:
        # As `in_hardware`, which takes longer than the command.
        entered = time.perf_counter_ns()
        try:
            command.device = self._name
            self._hardware.simulator.write(command)
        finally:
            self._hardware.stopwatch.leave_hardware(entered)

    def look(self) -> pb.Reading:
        with self._hardware.stopwatch.in_hardware():
            return self._hardware.simulator.look(self._name)
