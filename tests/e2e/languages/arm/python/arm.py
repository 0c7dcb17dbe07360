"""The arm in Python."""

from sitaf_interfaces import ArmState, Clock
from sitaf_runtime import Hardware


class TooStrong(Exception):
    """Beyond what the arm can exert."""


class Arm:
    """Named as Python names things, where it can be."""

    def __init__(self, hardware: Hardware, clock: Clock) -> None:
        self._hardware = hardware
        self._motor = hardware.joint_motor("motor")
        self._encoder = hardware.joint_encoder("encoder")
        self._clock = clock
        self.strongest = 1.0
        self.angles: list[float] = []
        self._most = 0.0
        self._starts = 0
        self._swings = 0
        self._initialised = False

    def on_initialize(self) -> None:
        self._initialised = True

    def swing(self, effort: float) -> float:
        begun = self._hardware.time()
        now = self._clock.Now(self._swings)
        self._swings += 1
        self._motor.set_effort(min(effort, self._most))
        steps = 0
        while effort == 0 or steps < 10:
            self._hardware.sleep(0.05)
            self.angles.append(self._encoder.position())
            steps += 1
        self._motor.set_effort(0)
        return self._hardware.time() - begun + now

    def watch(self, effort: float) -> None:
        self.swing(effort)

    def limit(self, bound: float) -> None:
        if not self._initialised:
            raise RuntimeError("not initialised")
        if not 0 <= bound <= self.strongest:
            raise TooStrong
        self._most = bound

    def start(self) -> int:
        self._starts += 1
        return self._starts

    def state(self) -> ArmState:
        return ArmState(self._encoder.position(), self._swings)

    def get_most(self) -> float:
        return self._most
