"""The interface of devices that are not simulated, or not only."""

from collections.abc import Mapping, Sequence
from typing import Protocol

from sitaf_bridge.world.devices import Command, Reading

SHADOW_ERROR = "shadow_error"


class LiveDevices(Protocol):
    """Devices of one simulation that have another backend, and the wall clock that they need."""

    def perceived(self, step: int, simulated: Sequence[Reading]) -> Sequence[Reading]:
        """The readings with those of real and recorded devices. The readings of one step do not change."""
        ...

    def forget(self) -> None:
        """Read the devices again at this step."""
        ...

    def command(self, commands: Sequence[Command]) -> None:
        """Send commands that the simulated devices accepted. Raises UnreachableValue."""
        ...

    def set(self, parameters: Mapping[str, float]) -> None:
        """Set parameters of the environment of the real devices. Raises UnreachableValue."""
        ...

    def shadows(self) -> Sequence[str]:
        """The devices of which a real one is compared with the simulated one."""
        ...

    def shadow_error(self, device: str) -> float:
        """The greatest difference between a real and a simulated reading at the last step that was read."""
        ...

    def begin_run(self, step: int) -> None:
        """Simulation time advances from this step."""
        ...

    def pace(self, step: int) -> None:
        """Wait until the wall clock has reached a step."""
        ...

    def end_run(self, step: int) -> None:
        """Simulation time has advanced to this step."""
        ...
