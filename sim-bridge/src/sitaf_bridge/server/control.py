"""The service SimulationControl."""

from collections.abc import Callable, Iterator
from typing import Any

import grpc

from sitaf_bridge import __version__
from sitaf_bridge.errors import BridgeError, InvalidRequest, WrongState
from sitaf_bridge.server.many import prepare_many_response
from sitaf_bridge.server.operations import OPERATIONS, IsActive, operate, replay
from sitaf_bridge.server.packing import state_message
from sitaf_bridge.server.status import answering, code_of, message_of
from sitaf_bridge.server.wire import duration, seconds_of, source_of, world_message
from sitaf_bridge.session.hardware import SessionHardware
from sitaf_bridge.session.recording import Recorder
from sitaf_bridge.session.registry import Registry
from sitaf_bridge.session.signals import SignalStore
from sitaf_bridge.wire import simulation_pb2 as pb
from sitaf_bridge.wire import simulation_pb2_grpc as pb_grpc
from sitaf_bridge.world.catalog import Catalog
from sitaf_bridge.world.driving.checking import check_names
from sitaf_bridge.world.engine import DEVICE_KINDS, ENGINE, ENGINE_VERSION
from sitaf_bridge.world.state import ResetScope

# The fields of OperateRequest, and the rpc of each.
STREAMED = {
    "set_parameters": "SetParameters",
    "reset": "ResetSimulation",
    "step": "StepSimulation",
    "prepare": "Prepare",
    "read": "ReadDevices",
    "write": "WriteDevices",
}


class SimulationControl(pb_grpc.SimulationControlServicer):
    """Implements the service as specified in simulation.proto.

    The methods that only run an operation in a session are added below.
    """

    def __init__(
        self,
        catalog: Catalog,
        registry: Registry,
        signals: SignalStore | None = None,
        hardware: SessionHardware | None = None,
        *,
        operation_socket: bool = False,
    ) -> None:
        self._operation_socket = operation_socket
        self._catalog = catalog
        self._registry = registry
        self._signals = signals
        self._hardware = hardware

    @answering
    def GetSimulatorFeatures(
        self, request: pb.GetSimulatorFeaturesRequest, context: grpc.ServicerContext
    ) -> pb.GetSimulatorFeaturesResponse:
        """Return version and capabilities."""
        return pb.GetSimulatorFeaturesResponse(
            bridge_version=__version__,
            engine=ENGINE,
            engine_version=ENGINE_VERSION,
            device_kinds=DEVICE_KINDS,
        )

    @answering
    def GetStatistics(
        self, request: pb.GetStatisticsRequest, context: grpc.ServicerContext
    ) -> pb.GetStatisticsResponse:
        """Return counters of this process."""
        return pb.GetStatisticsResponse(
            sessions=len(self._registry),
            models=self._registry.models(),
            operations=[
                pb.OperationStatistics(rpc=rpc, count=took.count, total_ns=took.total_ns, shortest_ns=took.shortest_ns)
                for rpc, took in self._registry.statistics.seen().items()
            ],
        )

    @answering
    def DescribeWorld(
        self, request: pb.DescribeWorldRequest, context: grpc.ServicerContext
    ) -> pb.DescribeWorldResponse:
        """Compile a world without a session."""
        world = self._catalog.world(source_of(request.world))
        check_names(world, request.parameters)
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
            if self._hardware is not None:
                self._hardware.attach(world)
                session.hardware = self._hardware
                simulation.attach(self._hardware)
            if self._signals is not None:
                simulation.record_signals(self._signals.order.names, self._signals.order.settling)
            return pb.CreateSessionResponse(
                session_id=session.id,
                world=world_message(world),
                lease=duration(session.lease_s),
                state=state_message(simulation.state),
                keeps_signals=self._signals is not None or self._hardware is not None,
                real_time=self._hardware is not None,
                operation_socket=self._operation_socket,
            )

    @answering
    def KeepSignals(self, request: pb.KeepSignalsRequest, context: grpc.ServicerContext) -> pb.KeepSignalsResponse:
        """Keep the signals of a case for the agent."""
        signals = self._signals
        if self._hardware is not None:
            self._hardware.stop("the case ended")
        if signals is None:
            if self._hardware is not None:
                return pb.KeepSignalsResponse()
            raise WrongState("this endpoint records no signals")
        with self._registry.use(request.session_id) as session, session.simulation() as simulation:
            try:
                session.preparations.check(request.case_no)
                trace = simulation.signals(request.call_time_ns)
            except BridgeError as error:
                # Otherwise the case could get signals that a component simulated in another session.
                signals.keep(request.case_no, error)
            else:
                signals.keep(request.case_no, trace)
        return pb.KeepSignalsResponse()

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
        if self._hardware is not None:
            self._hardware.stop("the session ended")
        return pb.DeleteSessionResponse()

    @answering
    def PrepareMany(self, request: pb.PrepareManyRequest, context: grpc.ServicerContext) -> pb.PrepareManyResponse:
        """Prepare many cases; does not use the session's state, so other calls can run at the same time."""
        with self._registry.use(request.session_id) as session:
            session.check_simulated("PrepareMany")
            return prepare_many_response(session.world, session.seed, request, context.is_active)

    def Operate(
        self, request_iterator: Iterator[pb.OperateRequest], context: grpc.ServicerContext
    ) -> Iterator[pb.OperateResponse]:
        """Run a stream of operations in order."""
        for request in request_iterator:
            yield pb.OperateResponse.FromString(self.operated(request, context.is_active))

    def operated(self, request: pb.OperateRequest, is_active: IsActive) -> bytes:
        """Run one operation of a stream; returns an encoded OperateResponse, with a refusal for a rejected one."""
        part = request.WhichOneof("operation")
        try:
            if part == "ping":
                return b""
            if part is None:
                raise InvalidRequest("operation is missing")
            message = getattr(request, part)
            with self._registry.use(message.session_id) as session, session.simulation() as simulation:
                answer = operate(session, simulation, STREAMED[part], message, is_active)
                # An OperateResponse has its state in the same field as the response of each of these operations.
                return answer.SerializeToString()
        except BridgeError as error:
            refusal = pb.Refusal(code=code_of(error).value[0], message=message_of(error))
            return pb.OperateResponse(refusal=refusal).SerializeToString()

    @answering
    def StartRecording(
        self, request: pb.StartRecordingRequest, context: grpc.ServicerContext
    ) -> pb.StartRecordingResponse:
        """Reset the session and start a recording."""
        with self._registry.use(request.session_id) as session, session.simulation() as simulation:
            if session.recorder is not None:
                raise WrongState("this session is recording already; stop the recording first")
            session.delete_snapshots()
            session.preparations.reset()
            state = simulation.reset(ResetScope.ALL)
            session.recorder = Recorder(simulation.digest())
            return pb.StartRecordingResponse(state=state_message(state))

    @answering
    def StopRecording(
        self, request: pb.StopRecordingRequest, context: grpc.ServicerContext
    ) -> pb.StopRecordingResponse:
        """Stop and return the recording."""
        with self._registry.use(request.session_id) as session, session.simulation():
            recorder = session.recorder
            if recorder is None:
                raise WrongState("this session is not recording; start a recording first")
            session.recorder = None
            recording = pb.Recording(
                world_digest=session.world.digest,
                seed=session.seed,
                operations=[
                    pb.RecordedOperation(rpc=rpc, request=message, digest=digest)
                    for rpc, message, digest in recorder.operations
                ],
                digest=recorder.digest.hex(),
            )
            return pb.StopRecordingResponse(recording=recording)

    @answering
    def ReplayRecording(
        self, request: pb.ReplayRecordingRequest, context: grpc.ServicerContext
    ) -> pb.ReplayRecordingResponse:
        """Repeat the operations of a recording."""
        with self._registry.use(request.session_id) as session, session.simulation() as simulation:
            different, digest = replay(session, simulation, request.recording, context.is_active)
            return pb.ReplayRecordingResponse(
                identical=different < 0 and digest.hex() == request.recording.digest,
                digest=digest.hex(),
                first_difference=different,
                state=state_message(simulation.state),
            )


def operation(rpc: str) -> Callable[[Any, Any, grpc.ServicerContext], Any]:
    """Create the servicer method of an operation."""

    @answering
    def method(self: Any, request: Any, context: grpc.ServicerContext) -> Any:
        with self._registry.use(request.session_id) as session, session.simulation() as simulation:
            return operate(session, simulation, rpc, request, context.is_active)

    return method


for _rpc in OPERATIONS:
    if hasattr(pb_grpc.SimulationControlServicer, _rpc):
        setattr(SimulationControl, _rpc, operation(_rpc))
