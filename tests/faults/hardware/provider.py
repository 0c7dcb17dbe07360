"""A provider whose devices follow the simulation and log what they do: usage: provider.py ADDRESS LOG"""

import sys
import threading
import time

from sitaf_hardware import Device, DeviceError, Limits, serve


class Logged(Device):
    """A device that follows the simulation."""

    follows_simulation = True

    def __init__(self, log, lock):
        self._log, self._lock = log, lock

    def read(self):
        self.write("read", 0.0)
        if len(self.simulated) != len(self.fields):
            raise DeviceError("the client did not say what the simulated device measures")
        return self.simulated

    def set(self, parameters):
        pass

    def command(self, numbers):
        self.write("command", numbers["velocity"])

    def stop(self):
        self.write("stop", 0.0)

    def write(self, what, value):
        with self._lock:
            self._log.write(f"{what} {value!r} {time.monotonic()!r}\n")
            self._log.flush()


class Range(Logged):
    """An infrared sensor."""

    kind = "range"
    fields = {"range": "m"}
    parameters = ("Distance",)


class Motor(Logged):
    """A motor that takes any velocity."""

    kind = "joint_motor"
    fields = {"position": "rad", "velocity": "rad/s", "effort": "N m"}
    commands = {"velocity": Limits("rad/s")}
    parameters = ("StartAngle",)


if __name__ == "__main__":
    with open(sys.argv[2], "a", encoding="utf-8") as log:
        shared = (log, threading.Lock())
        serve({"motor": Motor(*shared), **{f"ir{n}": Range(*shared) for n in range(1, 8)}}, sys.argv[1])
