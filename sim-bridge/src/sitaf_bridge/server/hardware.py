"""The service VirtualHardware."""

import threading

import grpc

from sitaf_bridge.errors import LimitReached
from sitaf_bridge.server.operations import operate
from sitaf_bridge.server.packing import state_message
from sitaf_bridge.server.status import answering
from sitaf_bridge.session.registry import Registry
from sitaf_bridge.wire import simulation_pb2 as pb
from sitaf_bridge.wire import simulation_pb2_grpc as pb_grpc


class VirtualHardware(pb_grpc.VirtualHardwareServicer):
    """The devices as a component under test sees them. At most `waiting` calls may wait for time."""

    def __init__(self, registry: Registry, waiting: int) -> None:
        self._registry = registry
        self._waiting = threading.BoundedSemaphore(waiting)
        self._limit = waiting

    @answering
    def ReadDevices(self, request: pb.ReadDevicesRequest, context: grpc.ServicerContext) -> pb.ReadDevicesResponse:
        """The readings at the current step."""
        with self._registry.use(request.session_id) as session, session.simulation() as simulation:
            return operate(session, simulation, "ReadDevices", request, context.is_active)

    @answering
    def WriteDevices(self, request: pb.WriteDevicesRequest, context: grpc.ServicerContext) -> pb.WriteDevicesResponse:
        """Command actuators."""
        with self._registry.use(request.session_id) as session, session.simulation() as simulation:
            return operate(session, simulation, "WriteDevices", request, context.is_active)

    @answering
    def WaitUntil(self, request: pb.WaitUntilRequest, context: grpc.ServicerContext) -> pb.WaitUntilResponse:
        """Wait for a simulation time, without the simulation's lock and without blocking all threads."""
        with self._registry.use(request.session_id) as session:
            if not self._waiting.acquire(blocking=False):
                raise LimitReached(
                    f"{self._limit} calls of WaitUntil are waiting, which is the limit (half of --threads)"
                )
            try:
                session.wait_until(request.time_ns, context.is_active)
            finally:
                self._waiting.release()
            with session.simulation() as simulation:
                return pb.WaitUntilResponse(state=state_message(simulation.state))
