"""A navigation server for a base on a track."""

from sitaf_runtime import Hardware

TOLERANCE = 0.02
"""Metres from the goal at which it is reached."""


class NoGoal(Exception):
    """There is no goal to cancel."""


class NavigationServer:
    """Drives the base `base` to one goal at a time."""

    def __init__(self, hardware: Hardware) -> None:
        self._hardware = hardware
        self._base = hardware.joint_motor("base")
        self._number = 0
        self._goal = None

    def send_goal(self, x: float) -> None:
        """Drive to a position; a goal that is active is preempted."""
        self._number += 1
        self._goal = x
        self._base.set_position(x)

    def navigate(self, distance: float) -> str:
        """Drive by a distance until the base is there or another goal counts."""
        goal = self._goal = self._base.position() + distance
        self._number += 1
        mine = self._number
        self._base.set_position(goal)
        while self._number == mine:
            if abs(self._base.position() - goal) <= TOLERANCE:
                self._goal = None
                return "REACHED"
            self._hardware.sleep(0.02)
        return "PREEMPTED"

    def cancel(self) -> None:
        """End the active goal and stop."""
        if self._goal is None:
            raise NoGoal("send a goal first")
        self._number += 1
        self._goal = None
        self._base.set_position(self._base.position())

    def status(self) -> str:
        """The state of the goal; a goal that was reached ends."""
        if self._goal is None:
            return "IDLE"
        if abs(self._base.position() - self._goal) > TOLERANCE:
            return "ACTIVE"
        self._goal = None
        return "REACHED"

    def position(self) -> float:
        """Where the base is."""
        return self._base.position()
