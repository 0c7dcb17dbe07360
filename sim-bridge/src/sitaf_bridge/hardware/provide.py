"""The devices of a world as a hardware provider: they measure what the simulation of the test says."""

from collections.abc import Mapping, Sequence

from sitaf_hardware import Device, DeviceError, Limits, serve

from sitaf_bridge.errors import InvalidRequest
from sitaf_bridge.hardware.checking import commands_of
from sitaf_bridge.world.devices import KINDS, DeviceDeclaration
from sitaf_bridge.world.devices.units import unit_of
from sitaf_bridge.world.world import World

__all__ = ["devices_of", "serve"]


class SimulatedDevice(Device):
    """A device that follows the simulation of its client. Its commands act there."""

    follows_simulation = True

    def __init__(self, world: World, declaration: DeviceDeclaration) -> None:
        self.kind = declaration.kind
        self.fields = {
            field: unit_of(world.model, declaration, field) for field in KINDS[declaration.kind].fields(declaration)
        }
        self.commands = {
            name: Limits(unit_of(world.model, declaration, name), low, high)
            for name, (low, high) in commands_of(world, declaration).items()
        }
        self.parameters = list(world.description.parameters)
        self._commanded: dict[str, float] = {}

    def read(self) -> Sequence[float]:
        """What the simulation says."""
        if len(self.simulated) != len(self.fields):
            raise DeviceError("the client did not say what the simulated device measures")
        return self.simulated

    def command(self, numbers: Mapping[str, float]) -> None:
        """Keep the command; the simulation follows it."""
        self._commanded.update(numbers)

    def set(self, parameters: Mapping[str, float]) -> None:
        """Nothing: the simulation has these parameters."""

    def stop(self) -> None:
        """Forget the commands."""
        self._commanded.clear()


def devices_of(world: World, names: Sequence[str] | None) -> Mapping[str, Device]:
    """The named devices of a world, or all except cameras. Raises InvalidRequest."""
    declared = {d.name: d for d in world.description.devices.values() if not KINDS[d.kind].image}
    unknown = [name for name in names or () if name not in declared]
    if unknown:
        raise InvalidRequest(
            f"the world has no device {unknown[0]!r} that can be provided; it has {', '.join(declared)}"
        )
    return {name: SimulatedDevice(world, declared[name]) for name in names or declared}
