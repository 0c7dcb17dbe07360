"""Faults of devices."""

import enum
import math
from collections.abc import Callable
from dataclasses import dataclass

from sitaf_bridge.errors import InvalidRequest
from sitaf_bridge.world.description.declaration import MAX_DELAY_S
from sitaf_bridge.world.devices import KINDS, DeviceDeclaration
from sitaf_bridge.world.sensing.noise import gaussian, uniform

MAX_FAULTS = 16


class FaultKind(enum.Enum):
    """The kinds of faults in the protocol."""

    STUCK = "stuck"
    DROPOUT = "dropout"
    OFFSET = "offset"
    SCALE = "scale"
    NOISE = "noise"
    DELAY = "delay"
    INTERMITTENT = "intermittent"
    OUT_OF_RANGE = "out_of_range"


@dataclass(frozen=True)
class Fault:
    """One fault; `held` is the reading of a stuck device."""

    kind: FaultKind
    value: float = 0.0
    held: tuple[float, ...] = ()


def check_fault(device: str, fault: Fault) -> None:
    """Check a fault. Raises InvalidRequest."""
    value, kind = fault.value, fault.kind
    if not math.isfinite(value):
        raise InvalidRequest(f"faults: {device}: {kind.value}: the value {value} is not a finite number")
    if kind is FaultKind.NOISE and value < 0:
        raise InvalidRequest(f"faults: {device}: noise: the standard deviation {value:g} is negative")
    if kind is FaultKind.DELAY and not 0 <= value <= MAX_DELAY_S:
        raise InvalidRequest(f"faults: {device}: delay: {value:g} s is not within 0 to {MAX_DELAY_S:g} s")
    if kind is FaultKind.INTERMITTENT and not 0 <= value <= 1:
        raise InvalidRequest(f"faults: {device}: intermittent: the probability {value:g} is not within 0 to 1")


def apply_fault(
    values: tuple[float, ...], fault: Fault, key: int, device: DeviceDeclaration, step: int
) -> tuple[float, ...]:
    """Apply a fault to a reading; `key` selects the fault's random numbers."""
    return _FAULT_FUNCTIONS[fault.kind](values, fault, key, device, step)


Values = tuple[float, ...]
FaultFunction = Callable[[Values, Fault, int, DeviceDeclaration, int], Values]


def dropped(values: Values, device: DeviceDeclaration) -> Values:
    """The reading of a device that failed."""
    return ((0.0 if KINDS[device.kind].truths else math.nan),) * len(values)


def _stuck(values: Values, fault: Fault, _key: int, _device: DeviceDeclaration, _step: int) -> Values:
    return fault.held


def _dropout(values: Values, _fault: Fault, _key: int, device: DeviceDeclaration, _step: int) -> Values:
    return dropped(values, device)


def _offset(values: Values, fault: Fault, _key: int, _device: DeviceDeclaration, _step: int) -> Values:
    return tuple(v + fault.value for v in values)


def _scale(values: Values, fault: Fault, _key: int, _device: DeviceDeclaration, _step: int) -> Values:
    # "No object in range" (infinity) stays infinity, even if it is scaled by 0.
    return tuple(v * fault.value if math.isfinite(v) else v for v in values)


def _noise(values: Values, fault: Fault, key: int, _device: DeviceDeclaration, step: int) -> Values:
    return tuple((values + fault.value * gaussian(key, step, len(values))).tolist())


def _same(values: Values, _fault: Fault, _key: int, _device: DeviceDeclaration, _step: int) -> Values:
    return values


def _intermittent(values: Values, fault: Fault, key: int, device: DeviceDeclaration, step: int) -> Values:
    return dropped(values, device) if uniform(key, step, 1)[0] <= fault.value else values


def _out_of_range(values: Values, fault: Fault, _key: int, device: DeviceDeclaration, _step: int) -> Values:
    return ((math.inf if device.kind in ("range", "laser_scan") else fault.value),) * len(values)


_FAULT_FUNCTIONS: dict[FaultKind, FaultFunction] = {
    FaultKind.STUCK: _stuck,
    FaultKind.DROPOUT: _dropout,
    FaultKind.OFFSET: _offset,
    FaultKind.SCALE: _scale,
    FaultKind.NOISE: _noise,
    # Delays are applied to the input of the device, before all other faults.
    FaultKind.DELAY: _same,
    FaultKind.INTERMITTENT: _intermittent,
    FaultKind.OUT_OF_RANGE: _out_of_range,
}
