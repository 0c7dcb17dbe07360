"""The servo drive at the other end of Modbus TCP: it turns at the commanded velocity, with a delay of its own.

usage: servo.py PORT

| register | content |
|---|---|
| 0 | 1: turn, 0: stop |
| 1 | commanded velocity, mrad/s, 16 bits with sign |
| 10, 11 | writing sets the position, microradians, 32 bits with sign, high word first |
| 20, 21 | position, likewise |
| 22 | velocity, mrad/s, 16 bits with sign |
"""

import sys
import time

from pymodbus.server import StartTcpServer
from pymodbus.simulator import DataType, SimData, SimDevice

REGISTERS = 32
# Time constant of the velocity in seconds.
LAG_S = 0.02


class Servo:
    """Moves in real time."""

    def __init__(self) -> None:
        self._at = time.monotonic()
        self._position = self._velocity = self._target = 0.0

    async def accessed(self, _function, start, address, _count, registers, values):
        """Bring the registers to the present before they are read, and follow what is written."""
        self._move()
        for offset, value in enumerate(values or ()):
            registers[address - start + offset] = int(value)
        if values is not None:
            words = [registers[n - start] for n in (0, 1, 10, 11)]
            self._target = signed(words[1], 16) / 1e3 if words[0] else 0.0
            if address <= 11 < address + len(values):
                self._position, self._velocity = signed(words[2] << 16 | words[3], 32) / 1e6, 0.0
        position = round(self._position * 1e6) & 0xFFFFFFFF
        registers[20 - start : 23 - start] = [position >> 16, position & 0xFFFF, round(self._velocity * 1e3) & 0xFFFF]

    def _move(self) -> None:
        now = time.monotonic()
        while self._at < now:
            step = min(0.001, now - self._at)
            self._velocity += (self._target - self._velocity) * min(1.0, step / LAG_S)
            self._position += self._velocity * step
            self._at += step


def signed(number: int, bits: int) -> int:
    """A number with sign."""
    return number - (1 << bits) if number >> (bits - 1) else number


if __name__ == "__main__":
    registers = [SimData(0, count=REGISTERS, values=0, datatype=DataType.REGISTERS)]
    StartTcpServer(SimDevice(1, simdata=registers, action=Servo().accessed), address=("127.0.0.1", int(sys.argv[1])))
