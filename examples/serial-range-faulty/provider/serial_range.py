"""Provides a range finder on a serial line to tests.

usage: serial_range.py TTY ADDRESS
"""

import os
import select
import sys
import time
import tty
from functools import reduce

from sitaf_hardware import Device, DeviceError, Reading, serve

ANSWER_S = 0.1
STAGE_S = 10.0


class SerialRangeFinder(Device):
    """A range finder whose target a linear stage moves; see instrument.py for the protocol."""

    kind = "range"
    fields = {"range": "m"}
    parameters = ("Distance",)

    def __init__(self, path: str) -> None:
        self._line = os.open(path, os.O_RDWR | os.O_NOCTTY)
        tty.setraw(self._line)

    def read(self) -> Reading:
        """Measure the distance."""
        taken = time.monotonic()
        word, _, number = self._ask("D?", ANSWER_S).partition(" ")
        if word != "D" or not number.isdecimal():
            raise DeviceError(f"the range finder answered {word} {number}")
        return Reading([int(number) / 1000], taken)

    def set(self, parameters: dict[str, float]) -> None:
        """Move the target."""
        millimetres = round(parameters["Distance"] * 1000)
        if millimetres < 0 or self._ask(f"S {millimetres}", STAGE_S) != "OK":
            raise ValueError(f"Distance: the stage cannot move to {parameters['Distance']:g} m")

    def fault(self) -> str:
        """Whether it answers."""
        self.read()
        return ""

    def _ask(self, request: str, limit_s: float) -> str:
        """Send a request; the answer without its checksum."""
        # The rest of an answer that came too late.
        while select.select([self._line], [], [], 0)[0] and os.read(self._line, 256):
            pass
        os.write(self._line, f"{request}\n".encode())
        answer, end = b"", time.monotonic() + limit_s
        while not answer.endswith(b"\n"):
            if not select.select([self._line], [], [], max(0, end - time.monotonic()))[0]:
                raise DeviceError(f"the range finder did not answer within {limit_s:g} s")
            chunk = os.read(self._line, 256)
            if not chunk:
                raise DeviceError("the serial line was closed")
            answer += chunk
        text, _, checksum = answer.decode("ascii", "replace").strip().rpartition(" ")
        if checksum != f"{reduce(lambda a, b: a ^ b, text.encode(), 0):02X}":
            raise DeviceError("the checksum of the range finder's answer is wrong")
        return text


if __name__ == "__main__":
    serve({"front": SerialRangeFinder(sys.argv[1])}, sys.argv[2], "serial-range")
