"""The robot's devices: one module per kind, each of which declares, binds and reads its devices."""

from sitaf_bridge.world.devices.kind import Bank, DeviceDeclaration, DeviceKind, Reading
from sitaf_bridge.world.devices.range import RangeKind, RangeReading

KINDS: dict[str, DeviceKind] = {kind.name: kind for kind in (RangeKind(),)}

__all__ = ["KINDS", "Bank", "DeviceDeclaration", "DeviceKind", "RangeReading", "Reading"]
