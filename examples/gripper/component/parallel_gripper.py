"""A gripper with two fingers."""

from sitaf_runtime import Hardware

OPEN_WIDTH = 0.08
"""Metres between the fingers of the open gripper."""

LEAST_WIDTH = 0.01
"""Fingers that are closer have nothing between them."""


class AlreadyClosed(Exception):
    """The gripper cannot grasp while it is closed."""


class NotClosed(Exception):
    """The gripper has nothing to release while it is open."""


class ParallelGripper:
    """The gripper `gripper` of a robot. It starts open."""

    def __init__(self, hardware: Hardware) -> None:
        self._fingers = hardware.gripper("gripper")
        self._closed = False
        self._fingers.move(OPEN_WIDTH)

    def open(self) -> None:
        """Open the fingers."""
        self._closed = False
        self._fingers.move(OPEN_WIDTH)

    def grasp(self) -> None:
        """Close the fingers; they stop at an object."""
        if self._closed:
            raise AlreadyClosed("release the object first")
        self._closed = True
        self._fingers.move(0.0)

    def release(self) -> None:
        """Let go of the object."""
        if not self._closed:
            raise NotClosed("grasp an object first")
        self.open()

    def holding(self) -> bool:
        """Whether an object keeps the closed fingers apart."""
        return self._closed and self._fingers.width() > LEAST_WIDTH
