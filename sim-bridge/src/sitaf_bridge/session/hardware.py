"""What a session tells its devices that are not simulated."""

from typing import Protocol

from sitaf_bridge.world.sensing.live import LiveDevices
from sitaf_bridge.world.world import World


class SessionHardware(LiveDevices, Protocol):
    """Devices with another backend, and the cases that use them."""

    def attach(self, world: World) -> None:
        """Serve a new session."""
        ...

    def begin(self, no: int) -> None:
        """A case begins."""
        ...

    def settled(self) -> None:
        """The call under test follows."""
        ...

    def stop(self, reason: str) -> None:
        """Stop the devices safely."""
        ...
