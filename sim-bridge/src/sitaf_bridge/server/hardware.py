"""The service VirtualHardware."""

import grpc

from sitaf_bridge.server.status import answering
from sitaf_bridge.server.wire import state_message
from sitaf_bridge.session.registry import Registry
from sitaf_bridge.wire import simulation_pb2 as pb
from sitaf_bridge.wire import simulation_pb2_grpc as pb_grpc


class VirtualHardware(pb_grpc.VirtualHardwareServicer):
    """What a component under test sees of the robot."""

    def __init__(self, registry: Registry) -> None:
        self._registry = registry

    @answering
    def ReadDevices(self, request: pb.ReadDevicesRequest, context: grpc.ServicerContext) -> pb.ReadDevicesResponse:
        """The readings at the current step."""
        with self._registry.use(request.session_id) as session, session.simulation() as simulation:
            return pb.ReadDevicesResponse(state=state_message(simulation.state))
