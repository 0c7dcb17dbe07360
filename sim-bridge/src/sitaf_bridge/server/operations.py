"""The operations of a session by the name of their rpc, shared by unary calls, streams and replays."""

from collections.abc import Callable
from dataclasses import dataclass
from time import perf_counter_ns
from typing import Any

from google.protobuf.message import DecodeError, Message

from sitaf_bridge.errors import BridgeError, Diverged, InvalidRequest, WrongState
from sitaf_bridge.server.packing import state_message, with_state
from sitaf_bridge.server.readings import (
    commands_of,
    faults_of,
    image_message,
    motion_message,
    motion_of,
    reading_message,
    wxyz,
    xyz,
)
from sitaf_bridge.server.wire import condition_of, scope_of
from sitaf_bridge.session.recording import Recorder
from sitaf_bridge.session.session import Session
from sitaf_bridge.wire import simulation_pb2 as pb
from sitaf_bridge.world.additions import SpawnedEntity
from sitaf_bridge.world.devices import KINDS
from sitaf_bridge.world.driving.simulation import Simulation
from sitaf_bridge.world.state import ResetScope

IsActive = Callable[[], bool]
SHAPES = {pb.SHAPE_BOX: "box", pb.SHAPE_SPHERE: "sphere", pb.SHAPE_CYLINDER: "cylinder", pb.SHAPE_CAPSULE: "capsule"}
GREY = (0.5, 0.5, 0.5, 1.0)


@dataclass(frozen=True)
class Operation:
    """Runs a request in a simulation that this thread has locked; `changes`: recordings must contain it."""

    carry_out: Callable[[Session, Simulation, Any, IsActive], Any]
    request: type[Message]
    changes: bool


def operate(session: Session, simulation: Simulation, rpc: str, request: Message, is_active: IsActive) -> Any:
    """Run one operation and record it if the session is recording. Raises BridgeError."""
    began = perf_counter_ns()
    try:
        return _operate(session, simulation, rpc, request, is_active)
    finally:
        session.statistics.add(rpc, perf_counter_ns() - began)


def _operate(session: Session, simulation: Simulation, rpc: str, request: Message, is_active: IsActive) -> Any:
    operation = OPERATIONS[rpc]
    recorder = session.recorder
    if recorder is None or not operation.changes:
        return operation.carry_out(session, simulation, request, is_active)
    recorder.check_not_full()
    try:
        response = operation.carry_out(session, simulation, request, is_active)
    except Diverged:
        _record(recorder, simulation, rpc, request)
        raise
    _record(recorder, simulation, rpc, request)
    return response


def _record(recorder: Recorder, simulation: Simulation, rpc: str, request: Message) -> None:
    kept = type(request)()
    kept.CopyFrom(request)
    kept.ClearField("session_id")
    recorder.add(rpc, kept.SerializeToString(deterministic=True), simulation.digest(recorder.digest))


def replay(session: Session, simulation: Simulation, recording: pb.Recording, is_active: IsActive) -> tuple[int, bytes]:
    """Replay a recording; return the index of the first operation with another result (or -1), and the digest.

    Raises WrongState, InvalidRequest.
    """
    session.check_simulated("replaying a recording")
    if session.recorder is not None:
        raise WrongState("this session is recording; stop the recording first")
    if (recording.world_digest, recording.seed) != (session.world.digest, session.seed):
        raise WrongState("the recording has another world or seed than this session")
    session.delete_snapshots()
    session.preparations.reset()
    simulation.reset(ResetScope.ALL)
    digest, different = simulation.digest(), -1
    for index, entry in enumerate(recording.operations):
        operation = OPERATIONS.get(entry.rpc)
        if operation is None or not operation.changes:
            raise InvalidRequest(f"recording.operations[{index}].rpc: {entry.rpc!r} cannot be replayed")
        try:
            request = operation.request.FromString(entry.request)
        except DecodeError as error:
            raise InvalidRequest(f"recording.operations[{index}].request is not a {entry.rpc} request") from error
        try:
            operation.carry_out(session, simulation, request, is_active)
        except Diverged:
            pass
        except BridgeError as error:
            # It succeeded in the recording.
            raise InvalidRequest(f"recording.operations[{index}]: {error}") from error
        digest = simulation.digest(digest)
        if different < 0 and digest != entry.digest:
            different = index
    return different, digest


def _prepare(
    session: Session, simulation: Simulation, request: pb.PrepareRequest, is_active: IsActive
) -> pb.PrepareResponse:
    session.preparations.prepared(request.case_no)
    if session.hardware is not None:
        session.hardware.begin(request.case_no)
    state = simulation.prepare(dict(request.parameters), request.settle_ns, is_active, request.call_after_ns)
    if session.hardware is not None:
        session.hardware.settled()
    return with_state(pb.PrepareResponse, state)


def _set(
    _: Session, simulation: Simulation, request: pb.SetParametersRequest, _wanted: IsActive
) -> pb.SetParametersResponse:
    return with_state(pb.SetParametersResponse, simulation.set(dict(request.values)))


def _get(
    _: Session, simulation: Simulation, request: pb.GetParametersRequest, _wanted: IsActive
) -> pb.GetParametersResponse:
    return pb.GetParametersResponse(values=simulation.parameters(request.names))


def _reset(
    session: Session, simulation: Simulation, request: pb.ResetSimulationRequest, _wanted: IsActive
) -> pb.ResetSimulationResponse:
    session.preparations.reset()
    return with_state(pb.ResetSimulationResponse, simulation.reset(scope_of(request.scope)))


def _step(
    _: Session, simulation: Simulation, request: pb.StepSimulationRequest, is_active: IsActive
) -> pb.StepSimulationResponse:
    later = [(each.steps, commands_of(each.commands)) for each in request.later]
    commands = commands_of(request.commands)
    state = simulation.step(request.steps, is_active, dict(request.parameters), commands, later)
    return with_state(pb.StepSimulationResponse, state)


def _read(
    session: Session, simulation: Simulation, request: pb.ReadDevicesRequest, _wanted: IsActive
) -> pb.ReadDevicesResponse:
    state = simulation.state
    if not request.devices:
        return pb.ReadDevicesResponse(state=state_message(state))
    by_name = {reading.device.name: reading for reading in state.readings}
    readings: list[pb.Reading] = []
    for name in dict.fromkeys(request.devices):
        device = session.world.description.devices.get(name)
        if device is None:
            known = ", ".join(session.world.description.devices) or "none"
            raise InvalidRequest(f"devices: no device {name!r}; devices of this world: {known}")
        image = KINDS[device.kind].image
        readings.append(image_message(simulation.image(name)) if image else reading_message(by_name[name]))
    whole = pb.WorldState(step=state.step, time_ns=state.time_ns, readings=readings)
    return pb.ReadDevicesResponse(state=whole)


def _write(
    _: Session, simulation: Simulation, request: pb.WriteDevicesRequest, _wanted: IsActive
) -> pb.WriteDevicesResponse:
    return with_state(pb.WriteDevicesResponse, simulation.write(commands_of(request.commands)))


def _advance(
    _: Session, simulation: Simulation, request: pb.AdvanceUntilRequest, is_active: IsActive
) -> pb.AdvanceUntilResponse:
    met, state = simulation.advance_until(condition_of(request.condition), request.limit_ns, is_active)
    return pb.AdvanceUntilResponse(met=met, state=state_message(state))


def _snapshot(
    session: Session, simulation: Simulation, _request: pb.TakeSnapshotRequest, _wanted: IsActive
) -> pb.TakeSnapshotResponse:
    # A diverged state must not be saved.
    _ = simulation.state
    identity = session.keep_snapshot(simulation.save())
    return pb.TakeSnapshotResponse(snapshot_id=identity, digest=simulation.digest().hex())


def _restore(
    session: Session, simulation: Simulation, request: pb.RestoreSnapshotRequest, _wanted: IsActive
) -> pb.RestoreSnapshotResponse:
    session.check_simulated("restoring a snapshot")
    state = simulation.restore(session.snapshot(request.snapshot_id))
    session.preparations.reset()
    return pb.RestoreSnapshotResponse(state=state_message(state))


def _scene(_: Session, simulation: Simulation, _request: pb.GetSceneRequest, _wanted: IsActive) -> pb.GetSceneResponse:
    return pb.GetSceneResponse(gltf=simulation.scene())


def _record_motion(
    _: Session, simulation: Simulation, request: pb.RecordMotionRequest, _wanted: IsActive
) -> pb.RecordMotionResponse:
    simulation.record_motion(request.interval_ns, request.max_frames)
    return pb.RecordMotionResponse()


def _motion(
    _: Session, simulation: Simulation, _request: pb.TakeMotionRequest, _wanted: IsActive
) -> pb.TakeMotionResponse:
    gltf, frames = simulation.take_motion()
    return pb.TakeMotionResponse(gltf=gltf, frames=frames)


def _entity(
    _: Session, simulation: Simulation, request: pb.GetEntityStateRequest, _wanted: IsActive
) -> pb.GetEntityStateResponse:
    return pb.GetEntityStateResponse(state=motion_message(simulation.entity(request.entity)))


def _put_entity(
    _: Session, simulation: Simulation, request: pb.SetEntityStateRequest, _wanted: IsActive
) -> pb.SetEntityStateResponse:
    state = simulation.put_entity(request.entity, motion_of(request.state))
    return pb.SetEntityStateResponse(state=state_message(state))


def _spawn(
    _: Session, simulation: Simulation, request: pb.SpawnEntityRequest, _wanted: IsActive
) -> pb.SpawnEntityResponse:
    if request.shape not in SHAPES:
        raise InvalidRequest(f"shape: {request.shape} is not a shape")
    quat = wxyz(request.pose.orientation) if request.pose.HasField("orientation") else (1.0, 0.0, 0.0, 0.0)
    r, g, b, a = request.rgba if len(request.rgba) == 4 else (GREY if not request.rgba else (-1.0,) * 4)
    entity = SpawnedEntity(
        request.entity,
        SHAPES[request.shape],
        tuple(request.size_m),
        xyz(request.pose.position),
        quat,
        request.mass_kg,
        (r, g, b, a),
    )
    return pb.SpawnEntityResponse(state=state_message(simulation.spawn(entity)))


def _delete(
    _: Session, simulation: Simulation, request: pb.DeleteEntityRequest, _wanted: IsActive
) -> pb.DeleteEntityResponse:
    return pb.DeleteEntityResponse(state=state_message(simulation.delete(request.entity)))


def _push(
    _: Session, simulation: Simulation, request: pb.ApplyWrenchRequest, _wanted: IsActive
) -> pb.ApplyWrenchResponse:
    wrench = request.wrench
    state = simulation.push(request.entity, xyz(wrench.force), xyz(wrench.torque))
    return pb.ApplyWrenchResponse(state=state_message(state))


def _fault(
    _: Session, simulation: Simulation, request: pb.SetDeviceFaultRequest, _wanted: IsActive
) -> pb.SetDeviceFaultResponse:
    state = simulation.set_faults(request.device, faults_of(request.faults))
    return pb.SetDeviceFaultResponse(state=state_message(state))


OPERATIONS: dict[str, Operation] = {
    "GetParameters": Operation(_get, pb.GetParametersRequest, changes=False),
    "SetParameters": Operation(_set, pb.SetParametersRequest, changes=True),
    "ResetSimulation": Operation(_reset, pb.ResetSimulationRequest, changes=True),
    "StepSimulation": Operation(_step, pb.StepSimulationRequest, changes=True),
    "Prepare": Operation(_prepare, pb.PrepareRequest, changes=True),
    "AdvanceUntil": Operation(_advance, pb.AdvanceUntilRequest, changes=True),
    "TakeSnapshot": Operation(_snapshot, pb.TakeSnapshotRequest, changes=True),
    "RestoreSnapshot": Operation(_restore, pb.RestoreSnapshotRequest, changes=True),
    "GetScene": Operation(_scene, pb.GetSceneRequest, changes=False),
    "RecordMotion": Operation(_record_motion, pb.RecordMotionRequest, changes=False),
    "TakeMotion": Operation(_motion, pb.TakeMotionRequest, changes=False),
    "GetEntityState": Operation(_entity, pb.GetEntityStateRequest, changes=False),
    "SetEntityState": Operation(_put_entity, pb.SetEntityStateRequest, changes=True),
    "SpawnEntity": Operation(_spawn, pb.SpawnEntityRequest, changes=True),
    "DeleteEntity": Operation(_delete, pb.DeleteEntityRequest, changes=True),
    "ApplyWrench": Operation(_push, pb.ApplyWrenchRequest, changes=True),
    "SetDeviceFault": Operation(_fault, pb.SetDeviceFaultRequest, changes=True),
    "ReadDevices": Operation(_read, pb.ReadDevicesRequest, changes=False),
    "WriteDevices": Operation(_write, pb.WriteDevicesRequest, changes=True),
}
