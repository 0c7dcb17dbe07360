"""Converts the order of an agent, and the report of a case."""

import math
from collections.abc import Mapping

from sitaf_bridge.errors import InvalidRequest
from sitaf_bridge.hardware.checking import check
from sitaf_bridge.hardware.client import ProviderClient
from sitaf_bridge.hardware.live import Backend, LiveHardware, Report
from sitaf_bridge.hardware.replay import read_recording
from sitaf_bridge.wire import administration_pb2 as pb
from sitaf_bridge.world.devices import KINDS
from sitaf_bridge.world.world import World

__all__ = ["backends_of", "check", "guard_of", "ordered", "report_message"]

# The guard notices the death of a simulator at once; this limit is for one that hangs.
SIMULATOR_TIMEOUT_MS = 500


def guard_of(order: pb.HardwareOrder) -> ProviderClient | None:
    """The client of the guard; None if no device has a provider. The caller closes it."""
    return ProviderClient(order.guard, SIMULATOR_TIMEOUT_MS) if order.guard else None


def backends_of(order: pb.HardwareOrder, world: World) -> Mapping[str, Backend]:
    """The backends by device. Raises InvalidRequest."""
    return {message.device: _backend(message, world) for message in order.devices}


def ordered(order: pb.HardwareOrder) -> LiveHardware:
    """The hardware of an endpoint, whose recordings are read with its world."""
    return LiveHardware(lambda world: backends_of(order, world), guard_of(order))


def report_message(report: Report) -> pb.TakeHardwareReportResponse:
    """Convert a report."""
    return pb.TakeHardwareReportResponse(
        exchanges=report.exchanges,
        mean_jitter_s=report.total_jitter_ns / 1e9 / max(1, report.exchanges),
        max_jitter_s=report.max_jitter_ns / 1e9,
        missed_deadlines=report.missed,
        readings=report.readings,
        max_age_s=report.max_age_s,
        stale_readings=report.stale,
        refused_commands=report.refused,
        safe_stops=report.safe_stops,
        faults=report.faults,
    )


def _backend(message: pb.DeviceBackend, world: World) -> Backend:
    independent = tuple(message.independent_of)
    match message.WhichOneof("backend"):
        case "provider":
            return Backend(message.device, message.provider.max_age_s, independent_of=independent)
        case "shadow":
            return Backend(message.device, message.shadow.max_age_s, shadow=True, independent_of=independent)
        case "replay":
            replay, device = message.replay, world.description.devices.get(message.device)
            fields = () if device is None else KINDS[device.kind].fields(device)
            kind = "" if device is None else device.kind
            if device is None or not fields:
                # The comparison with the world reports it.
                return Backend(message.device, math.inf, independent_of=independent)
            recorded = read_recording(
                replay.file, replay.content, replay.topic, device=device.name, kind=kind, fields=fields
            )
            return Backend(message.device, replay.max_age_s or math.inf, recorded=recorded, independent_of=independent)
        case _:
            raise InvalidRequest(f"hardware.{message.device}: has no backend")
