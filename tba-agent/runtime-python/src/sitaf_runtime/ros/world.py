"""The simulated world, as the process of a node has it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from sitaf_runtime.ros.lines import unpacked

if TYPE_CHECKING:
    from collections.abc import Collection

    from sitaf_runtime.ros.lines import Lines


class World:
    """The simulated world, which the process of the test driver advances."""

    def __init__(self, lines: Lines, begun: dict[str, Any]) -> None:
        self._lines = lines
        self.timestep_ns: int = begun["timestep_ns"]
        self.readings: dict[str, dict[str, Any]] = begun["readings"]
        self.commands: dict[str, list[float]] = {}
        # Whether the time of the node is measured, so that it must not run while the world advances.
        self.measured = False

    def step(self, steps: int, devices: Collection[str]) -> None:
        """Send the commands since the last step, advance, and read these devices."""
        if not devices and not self.measured:
            # The world catches up when its state is needed.
            self._lines.send({"unread": steps, "commands": self.commands})
            self.commands = {}
            return
        answer = self._lines.ask({"step": steps, "commands": self.commands, "read": sorted(devices)})
        self.commands = {}
        for device, numbers in answer["readings"].items():
            self.readings[device]["numbers"] = unpacked(numbers)

    def look(self, device: str) -> None:
        """Take an image of a camera."""
        self.readings[device]["image"] = self._lines.ask({"look": device})["image"]
