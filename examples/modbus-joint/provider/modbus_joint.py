"""Provides a servo drive on Modbus TCP to tests, as a motor and an encoder.

usage: modbus_joint.py PORT ADDRESS
"""

import sys
import threading
import time

from pymodbus.client import ModbusTcpClient
from pymodbus.exceptions import ModbusException
from sitaf_hardware import Device, DeviceError, Limits, Reading, serve

CONTROL, PRESET, POSITION = 0, 10, 20
FASTEST = 3.0


class Drive:
    """The registers of the drive; see servo.py."""

    def __init__(self, port: int) -> None:
        self._client = ModbusTcpClient("127.0.0.1", port=port, timeout=0.3, retries=0)
        self._lock = threading.Lock()

    def state(self) -> tuple[float, float, float]:
        """Position in radians, velocity in radians per second, and when they were measured."""
        taken = time.monotonic()
        high, low, velocity = self._call(lambda: self._client.read_holding_registers(POSITION, count=3))
        return _signed(high << 16 | low, 32) / 1e6, _signed(velocity, 16) / 1e3, taken

    def turn(self, velocity: float, run: bool = True) -> None:
        """Turn at a velocity."""
        self._call(lambda: self._client.write_registers(CONTROL, [int(run), round(velocity * 1e3) & 0xFFFF]))

    def preset(self, position: float) -> None:
        """Stop at a position."""
        self.turn(0.0, run=False)
        number = round(position * 1e6) & 0xFFFFFFFF
        self._call(lambda: self._client.write_registers(PRESET, [number >> 16, number & 0xFFFF]))

    def _call(self, request):
        with self._lock:
            try:
                if not self._client.connected and not self._client.connect():
                    raise DeviceError("the drive does not accept a connection")
                answer = request()
            except ModbusException as error:
                raise DeviceError(f"the drive does not answer: {error}") from error
            if answer.isError():
                raise DeviceError(f"the drive refuses a request: {answer}")
            return answer.registers


def _signed(number: int, bits: int) -> int:
    return number - (1 << bits) if number >> (bits - 1) else number


class Motor(Device):
    """The drive as a motor."""

    kind = "joint_motor"
    fields = {"position": "rad", "velocity": "rad/s", "effort": "N m"}
    commands = {"velocity": Limits("rad/s", -FASTEST, FASTEST)}
    parameters = ("StartAngle",)

    def __init__(self, drive: Drive) -> None:
        self._drive = drive

    def read(self) -> Reading:
        """The drive does not measure its torque."""
        position, velocity, taken = self._drive.state()
        return Reading([position, velocity, float("nan")], taken)

    def command(self, numbers: dict[str, float]) -> None:
        """Turn."""
        self._drive.turn(numbers["velocity"])

    def set(self, parameters: dict[str, float]) -> None:
        """Start at an angle."""
        self._drive.preset(parameters["StartAngle"])

    def stop(self) -> None:
        """Stop turning."""
        self._drive.turn(0.0, run=False)

    def fault(self) -> str:
        """Whether it answers."""
        self._drive.state()
        return ""


class Encoder(Device):
    """The drive as an encoder."""

    kind = "joint_encoder"
    fields = {"position": "rad", "velocity": "rad/s"}
    parameters = ("StartAngle",)

    def __init__(self, drive: Drive) -> None:
        self._drive = drive

    def read(self) -> Reading:
        """Position and velocity."""
        position, velocity, taken = self._drive.state()
        return Reading([position, velocity], taken)

    def set(self, parameters: dict[str, float]) -> None:
        """The motor sets it."""


if __name__ == "__main__":
    drive = Drive(int(sys.argv[1]))
    serve({"motor": Motor(drive), "encoder": Encoder(drive)}, sys.argv[2], "modbus-joint")
