"""Readings of all devices and observations at one step, as a row of numbers."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from sitaf_runtime.simulation.wire.sitaf.sim.v1 import simulation_pb2 as pb


@dataclass(frozen=True, slots=True)
class FrozenWorld:
    """Numbers at one step, in the order of a layout."""

    time_ns: int
    numbers: Sequence[float]


class Layout:
    """The columns of a row of numbers.

    The order is that of PrepareMany: `device.field` for each number of each device, then the observations, so that its
    rows need no conversion.
    """

    def __init__(self, world: pb.WorldDescription) -> None:
        self.kinds = {device.name: device.kind for device in world.devices}
        self.columns = [f"{d.name}.{field}" for d in world.devices for field in d.fields]
        self.places: dict[str, tuple[int, int]] = {}
        at = 0
        for device in world.devices:
            self.places[device.name] = (at, at + len(device.fields))
            at += len(device.fields)
        self.observations = {o.name: at + i for i, o in enumerate(world.observations)}
        self.columns += self.observations
        self._order = list(self.places)

    def freeze(self, state: pb.WorldState) -> FrozenWorld:
        """The numbers of a message; NaN for devices that it does not contain."""
        numbers = [float("nan")] * len(self.columns)
        for reading in state.readings:
            part: str | None = reading.WhichOneof("value")
            place = self.places.get(reading.device)
            if part is not None and part in _NUMBERS and place is not None:
                start, end = place
                numbers[start:end] = _NUMBERS[part](getattr(reading, part))[: end - start]
        for observation in state.observations:
            at = self.observations.get(observation.name)
            if at is not None:
                numbers[at] = observation.value
        return FrozenWorld(state.time_ns, numbers)

    def order_of(self, columns: Sequence[str]) -> list[int] | None:
        """The index of each number in a bulk row; None for the same order. Raises ValueError if a number is missing."""
        if list(columns) == self.columns:
            return None
        return [list(columns).index(column) for column in self.columns]


def _xyz(v: pb.Vector3) -> tuple[float, ...]:
    return v.x, v.y, v.z


def _xyzw(q: pb.Quaternion) -> tuple[float, ...]:
    return q.x, q.y, q.z, q.w


# In the order of the fields that the simulator names for each kind of device.
_NUMBERS: dict[str, Callable[..., tuple[float, ...]]] = {
    "range": lambda r: (r.range_m,),
    "laser_scan": lambda r: tuple(r.ranges_m),
    "imu": lambda r: (*_xyzw(r.orientation), *_xyz(r.angular_velocity), *_xyz(r.linear_acceleration)),
    "joint": lambda r: (r.position, r.velocity, r.effort),
    "pose": lambda r: (*_xyz(r.position), *_xyzw(r.orientation)),
    "wrench": lambda r: (*_xyz(r.force), *_xyz(r.torque)),
    "contact": lambda r: (float(r.pressed), r.force_n),
    "drive": lambda r: (r.linear, r.angular, r.left_position, r.right_position),
    "gripper": lambda r: (r.width_m, r.effort_n),
    "magnetic_field": lambda r: _xyz(r.field),
    "battery": lambda r: (r.voltage_v, r.current_a, r.charge_ah, r.percentage),
    "level": lambda r: (float(r),),
}
