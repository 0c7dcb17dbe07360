"""The service SimulationControl."""

import grpc

from sitaf_bridge import __version__
from sitaf_bridge.server.status import answering
from sitaf_bridge.server.wire import duration, scope_of, seconds_of, source_of, state_message, world_message
from sitaf_bridge.session.registry import Registry
from sitaf_bridge.wire import simulation_pb2 as pb
from sitaf_bridge.wire import simulation_pb2_grpc as pb_grpc
from sitaf_bridge.world.catalog import Catalog
from sitaf_bridge.world.engine import DEVICE_KINDS, ENGINE, ENGINE_VERSION


class SimulationControl(pb_grpc.SimulationControlServicer):
    """Sets the virtual environment; what each method promises stands in simulation.proto."""

    def __init__(self, catalog: Catalog, registry: Registry) -> None:
        self._catalog = catalog
        self._registry = registry

    @answering
    def GetSimulatorFeatures(
        self, request: pb.GetSimulatorFeaturesRequest, context: grpc.ServicerContext
    ) -> pb.GetSimulatorFeaturesResponse:
        """What this simulator is."""
        return pb.GetSimulatorFeaturesResponse(
            bridge_version=__version__,
            engine=ENGINE,
            engine_version=ENGINE_VERSION,
            device_kinds=DEVICE_KINDS,
        )

    @answering
    def DescribeWorld(
        self, request: pb.DescribeWorldRequest, context: grpc.ServicerContext
    ) -> pb.DescribeWorldResponse:
        """Compile without a session."""
        world = self._catalog.world(source_of(request.world))
        return pb.DescribeWorldResponse(world=world_message(world))

    @answering
    def CreateSession(
        self, request: pb.CreateSessionRequest, context: grpc.ServicerContext
    ) -> pb.CreateSessionResponse:
        """Open a session."""
        lease = seconds_of(request.lease) if request.HasField("lease") else None
        world = self._catalog.world(source_of(request.world))
        session = self._registry.create(world, request.seed, lease)
        with session.simulation() as simulation:
            return pb.CreateSessionResponse(
                session_id=session.id,
                world=world_message(world),
                lease=duration(session.lease_s),
                state=state_message(simulation.state),
            )

    @answering
    def RenewSession(self, request: pb.RenewSessionRequest, context: grpc.ServicerContext) -> pb.RenewSessionResponse:
        """Extend the lease."""
        with self._registry.use(request.session_id) as session:
            return pb.RenewSessionResponse(lease=duration(session.lease_s))

    @answering
    def DeleteSession(
        self, request: pb.DeleteSessionRequest, context: grpc.ServicerContext
    ) -> pb.DeleteSessionResponse:
        """Free a session."""
        self._registry.delete(request.session_id)
        return pb.DeleteSessionResponse()

    @answering
    def GetParameters(
        self, request: pb.GetParametersRequest, context: grpc.ServicerContext
    ) -> pb.GetParametersResponse:
        """Read parameters as last set."""
        with self._registry.use(request.session_id) as session, session.simulation() as simulation:
            return pb.GetParametersResponse(values=simulation.parameters(request.names))

    @answering
    def SetParameters(
        self, request: pb.SetParametersRequest, context: grpc.ServicerContext
    ) -> pb.SetParametersResponse:
        """Set parameters."""
        with self._registry.use(request.session_id) as session, session.simulation() as simulation:
            return pb.SetParametersResponse(state=state_message(simulation.set(request.values)))

    @answering
    def ResetSimulation(
        self, request: pb.ResetSimulationRequest, context: grpc.ServicerContext
    ) -> pb.ResetSimulationResponse:
        """Put the world back."""
        scope = scope_of(request.scope)
        with self._registry.use(request.session_id) as session, session.simulation() as simulation:
            return pb.ResetSimulationResponse(state=state_message(simulation.reset(scope)))

    @answering
    def StepSimulation(
        self, request: pb.StepSimulationRequest, context: grpc.ServicerContext
    ) -> pb.StepSimulationResponse:
        """Move time."""
        with self._registry.use(request.session_id) as session, session.simulation() as simulation:
            state = simulation.step(request.steps, context.is_active)
            return pb.StepSimulationResponse(state=state_message(state))

    @answering
    def Prepare(self, request: pb.PrepareRequest, context: grpc.ServicerContext) -> pb.PrepareResponse:
        """Prepare one test case."""
        with self._registry.use(request.session_id) as session, session.simulation() as simulation:
            state = simulation.prepare(request.parameters, request.settle_ns, context.is_active)
            return pb.PrepareResponse(state=state_message(state))
