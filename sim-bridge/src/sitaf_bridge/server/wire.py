"""Converts between gRPC messages and Python objects."""

from typing import cast

from google.protobuf.duration_pb2 import Duration

from sitaf_bridge.errors import InvalidRequest
from sitaf_bridge.wire import simulation_pb2 as pb
from sitaf_bridge.world.description.source import WorldSource
from sitaf_bridge.world.devices import KINDS, DeviceDeclaration
from sitaf_bridge.world.devices.kind import ActuatorBank
from sitaf_bridge.world.driving.conditions import AtTime, Beyond, Condition, Near, Touching
from sitaf_bridge.world.state import ResetScope
from sitaf_bridge.world.world import World

SCOPES: dict[int, ResetScope] = {
    pb.RESET_SCOPE_UNSPECIFIED: ResetScope.ALL,
    pb.RESET_SCOPE_ALL: ResetScope.ALL,
    pb.RESET_SCOPE_TIME: ResetScope.TIME,
    pb.RESET_SCOPE_STATE: ResetScope.STATE,
}


def source_of(message: pb.WorldSource) -> WorldSource:
    """Convert the files of a world. Raises InvalidRequest or LimitReached."""
    return WorldSource(message.description, message.files)


def scope_of(number: int) -> ResetScope:
    """Convert a reset scope. Raises InvalidRequest for an unknown number."""
    scope = SCOPES.get(number)
    if scope is None:
        raise InvalidRequest(f"scope: {number} is not a reset scope")
    return scope


def condition_of(message: pb.Condition) -> Condition:
    """Convert a condition. Raises InvalidRequest for an empty one."""
    match message.WhichOneof("condition"):
        case "contact":
            return Touching(message.contact.geom1, message.contact.geom2)
        case "device":
            bound = message.device.WhichOneof("bound")
            if bound is None:
                raise InvalidRequest("condition.device: set `above` or `below`")
            value = getattr(message.device, bound)
            return Beyond(message.device.device, message.device.field, value, above=bound == "above")
        case "distance":
            return Near(message.distance.body1, message.distance.body2, message.distance.within_m)
        case "time_ns":
            return AtTime(message.time_ns)
        case _:
            raise InvalidRequest("condition is missing")


def seconds_of(duration: Duration) -> float:
    """Seconds."""
    return duration.seconds + duration.nanos / 1e9


def duration(seconds: float) -> Duration:
    """A duration, rounded to nanoseconds."""
    whole, nanos = divmod(round(seconds * 1e9), 1_000_000_000)
    return Duration(seconds=whole, nanos=nanos)


def world_message(world: World) -> pb.WorldDescription:
    """Describe a world, in the order of declaration."""
    description = world.description
    return pb.WorldDescription(
        digest=world.digest,
        timestep_ns=world.timestep_ns,
        parameters=[
            pb.ParameterDescription(name=p.name, unit=p.unit, min=p.low, max=p.high, default_value=p.default)
            for p in description.parameters.values()
        ],
        devices=[_device_message(world, device) for device in description.devices.values()],
        observations=[pb.ObservationDescription(name=o.name, unit=o.unit) for o in description.observations.values()],
        entities=world.bodies,
    )


def _device_message(world: World, device: DeviceDeclaration) -> pb.DeviceDescription:
    """A device with the commands that it accepts."""
    kind = KINDS[device.kind]
    message = pb.DeviceDescription(name=device.name, kind=device.kind, fields=kind.fields(device))
    if kind.takes is None:
        return message
    accepted = cast(ActuatorBank, world.banks[device.kind]).accepts(world.model, device.name)
    for name, (low, high) in accepted.numbers.items():
        message.commands.add(name=name, min=low, max=high)
    for bound in accepted.bounds:
        message.bounds.add(factors=bound.factors, min=bound.limits[0], max=bound.limits[1])
    return message
