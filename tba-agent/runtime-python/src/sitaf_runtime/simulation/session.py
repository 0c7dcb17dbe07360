"""A session with the robot simulator."""

from __future__ import annotations

import os
import sys
import threading
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

os.environ.setdefault("GRPC_VERBOSITY", "NONE")

import grpc

from sitaf_runtime.errors import SimulationError
from sitaf_runtime.robot.hardware import Hardware
from sitaf_runtime.simulation.ahead import Preparation
from sitaf_runtime.simulation.frozen import Layout
from sitaf_runtime.simulation.hardware import SimulatedHardware
from sitaf_runtime.simulation.passing_time import PassingTime
from sitaf_runtime.simulation.pending import PendingCommands
from sitaf_runtime.simulation.recording import Recording
from sitaf_runtime.simulation.wire.connection import CALL_TIMEOUT_S, Connection
from sitaf_runtime.simulation.wire.sitaf.sim.v1 import simulation_pb2 as pb
from sitaf_runtime.simulation.world_files import read_world
from sitaf_runtime.stopwatch import Stopwatch
from sitaf_runtime.suite.test_case import TestCase

_NANOS = 1_000_000_000
# Simulation time between two frames of a recording: 50 frames per second.
_FRAME_NS = 20_000_000
# Steps that nobody reads are sent when there are so many.
_MAX_UNREAD = 100


class Simulation:
    """A session: prepares cases, advances time, and reads observations.

    `target` is the address of the simulator: `127.0.0.1:PORT` or `unix:/absolute/path`. All files of the description's
    folder belong to the world. Raises OSError when they cannot be read, SimulationError when they are rejected.
    """

    def __init__(
        self,
        target: str,
        world_description: Path,
        seed: int,
        stopwatch: Stopwatch,
        upcoming: Callable[[int], Sequence[TestCase]] = lambda _: (),
        limit_s: float | None = None,
    ) -> None:
        description, files = read_world(world_description)
        self._connection = Connection(target)
        self._control, self._devices = self._connection.control, self._connection.devices
        request = pb.CreateSessionRequest(world=pb.WorldSource(description=description, files=files), seed=seed)
        try:
            created = self._connection.ask(f"opening the world {description}", self._control.CreateSession, request)
        except SimulationError:
            self._connection.close()
            raise
        if created.operation_socket:
            self._connection.use_operation_socket()
        self._session: str = created.session_id
        self._timestep_ns: int = created.world.timestep_ns
        if self._timestep_ns <= 0:
            raise SimulationError("the simulator reported no timestep", lost=True)
        self._layout = Layout(created.world)
        self._hardware = SimulatedHardware(
            self._layout,
            {reading.device: reading for reading in created.state.readings},
            stopwatch,
            self._layout.freeze(created.state),
            self,
        )
        self._pending = PendingCommands(created.world)
        # Steps that the simulator gets with the next exchange, each with its commands.
        self._unread: list[tuple[int, list[pb.DeviceCommand]]] = []
        self._keeps_back = False
        # Commands to real devices are not kept back.
        self._real_time: bool = created.real_time
        self._ahead = Preparation(self._layout, upcoming, self._prepare_many)
        # The case that the session itself still has to prepare; set while readings come in bulk.
        self._pending_preparation: pb.PrepareRequest | None = None
        self._recording: Recording | None = None
        # Whether the simulator samples signals for the agent; worlds that are prepared in bulk have none.
        self._keeps_signals: bool = created.keeps_signals
        self._call_ns = 0
        self._called = False
        self._case_no = 0
        self._before_time_passes: Callable[[int], None] = lambda _: None
        if self._keeps_signals:
            self._ahead.stop()
        self._limit_ns = None if limit_s is None else round(limit_s * _NANOS)
        self._passed_ns = 0
        self._time = PassingTime(self._timestep_ns, self._step)
        self._ended = threading.Event()
        self._lease_s = max(0.1, (created.lease.seconds + created.lease.nanos / _NANOS) / 3)
        threading.Thread(target=self._renew, name="sitaf-lease", daemon=True).start()

    @property
    def hardware(self) -> Hardware:
        """The hardware for the component under test."""
        return self._hardware

    @property
    def device_kinds(self) -> Mapping[str, str]:
        """The kind of each device by name."""
        return self._layout.kinds

    def numbers(self, device: str) -> list[float]:
        """The numbers of a device's reading at the current step, in the order of its fields."""
        self.send_pending()
        start, end = self._layout.places[device]
        return list(self._hardware.world.numbers[start:end])

    @property
    def took_too_long(self) -> str | None:
        """The message when the case exceeded its limit of simulation time; otherwise None."""
        if self._limit_ns is None or self._passed_ns <= self._limit_ns:
            return None
        return f"the case took more than {self._limit_ns / _NANOS:g} s of simulation time"

    def prepare(self, parameters: Mapping[str, float], settle_s: float = 0.0, *, call_after_s: float = 0.0) -> None:
        """Prepare a case from a reset, and let it settle.

        `parameters` are in the unit of each parameter of the world; others get their default. The onsets of faults
        count from the call under test, which begins `call_after_s` later.
        """
        self._passed_ns = 0
        # The reset would undo them.
        self._pending.take()
        self._unread = []
        self._time.restart()
        settle_ns = round(settle_s * _NANOS)
        settled_ns = self._time.steps_in(settle_ns) * self._timestep_ns
        call_after_ns = round(call_after_s * _NANOS)
        request = pb.PrepareRequest(
            session_id=self._session,
            parameters=parameters,
            settle_ns=settle_ns,
            case_no=self._case_no,
            call_after_ns=call_after_ns,
        )
        # Worlds in bulk show faults as if the call began now.
        known = None if call_after_ns > 0 else self._ahead.world(parameters, settle_ns, settled_ns)
        if known is not None:
            self._pending_preparation = request
            self._hardware.world = known
        else:
            self._prepare(request)
        self._spend(settled_ns)

    def every(self, period_s: float, tick: Callable[[], object]) -> None:
        """Call a periodic component in each period from now, until the next case is prepared.

        Ticks run on the first step at or after each period, during `advance` and during the component's own sleep, but
        not during another tick. `advance` raises the exceptions of ticks.
        """
        self._time.every(round(period_s * _NANOS), tick)

    @property
    def time(self) -> PassingTime:
        """The simulation time of this session."""
        return self._time

    def advance(self, seconds: float) -> None:
        """Let simulation time pass, rounded up to whole steps."""
        self.wait(round(seconds * _NANOS))

    def observation(self, name: str) -> float:
        """The value of an observation at the current step, in the unit that the world declares."""
        at = self._layout.observations.get(name)
        if at is None:
            names = ", ".join(self._layout.observations)
            raise SimulationError(f"the world has no observation '{name}'; it has {names or 'none'}")
        self.send_pending()
        return self._hardware.world.numbers[at]

    def record(self, folder: Path) -> None:
        """Start to record motion for `save_motion`. Raises OSError when the folder cannot be created."""
        self._recording = Recording(folder)
        # A session that only reads prepared worlds does not move, so it could not be recorded.
        self._ahead.stop()
        request = pb.RecordMotionRequest(session_id=self._session, interval_ns=_FRAME_NS)
        self._connection.ask("recording", self._control.RecordMotion, request)

    def require_not_lost(self) -> None:
        """Raise SimulationError when an earlier call found the simulator or the session lost."""
        self._connection.require_not_lost()

    def save_motion(self, no: int) -> None:
        """Save the motion since the case was prepared, unless nothing is recorded or the simulation diverged."""
        if self._recording is None or self._recording.is_full:
            return
        request = pb.TakeMotionRequest(session_id=self._session)
        try:
            taken = self._ask_at_end(f"taking the recording of case {no}", self._control.TakeMotion, request)
        except SimulationError as e:
            if e.diverged:
                return
            raise
        self._recording.save(no, taken.gltf)

    def case_begins(self, no: int) -> None:
        """A case begins, which the simulator notes when it is prepared."""
        self._case_no = no
        self._called = False

    def call_begins(self) -> None:
        """The call under test begins now. Only the first one of a case counts."""
        if not self._called:
            self._called = True
            self._call_ns = self._hardware.world.time_ns

    def before_time_passes(self, look: Callable[[int], None]) -> None:
        """Call `look` with the simulation time whenever it is about to pass."""
        self._before_time_passes = look

    @property
    def now_ns(self) -> int:
        """Simulation time, also of the settling."""
        return self._hardware.world.time_ns

    @property
    def call_ns(self) -> int:
        """When the first call of the case began, in the time of `now_ns`."""
        return self._call_ns

    @property
    def since_call_ns(self) -> int:
        """Simulation time since the first call of the case."""
        return self._hardware.world.time_ns - self._call_ns

    def set(self, parameter: str, value: float) -> None:
        """Set a parameter of the world in the running case, in its unit."""
        self._update_session()
        self.send_pending()
        request = pb.SetParametersRequest(session_id=self._session, values={parameter: value})
        what = f"setting {parameter} to {value:g}"
        self._hardware.world = self._layout.freeze(self._connection.ask(what, self._connection.set, request).state)

    def keep_signals(self, no: int) -> None:
        """Let the simulator keep the signals of the current case for the agent, if the agent wants signals.

        A failure is reported by the agent, which misses the signals.
        """
        if not self._keeps_signals:
            return
        request = pb.KeepSignalsRequest(session_id=self._session, case_no=no, call_time_ns=self._call_ns)
        try:
            self._ask_at_end(f"keeping the signals of case {no}", self._control.KeepSignals, request)
        except SimulationError as e:
            print(f"sitaf: {e}", file=sys.stderr)

    def _ask_at_end(self, what: str, call: Callable[..., Any], request: object) -> Any:
        """Make a call at the end of a case, after what waits for the next step. Raises SimulationError."""
        try:
            self.send_pending()
        except ValueError as e:
            # The case has ended, so this is no error of the component.
            raise SimulationError(f"simulator: {what}: {e}") from None
        return self._connection.ask(what, call, request)

    def close(self) -> None:
        """Delete the session, unless the simulator is lost."""
        self._ended.set()
        self._time.end()
        try:
            self._control.DeleteSession(pb.DeleteSessionRequest(session_id=self._session), timeout=5)
        except grpc.RpcError:
            pass  # The session is no longer needed; its lease expires.
        finally:
            self._connection.close()

    # Calls of devices to the simulator.

    def write(self, command: pb.DeviceCommand) -> None:
        """Command a device: with the next step, or now if the device may reject the command.

        Raises ValueError, an error of the component, when the device rejects it.
        """
        self._update_session()
        if self._pending.is_acceptable(command):
            if self._pending.is_full:
                self.send_pending()
            self._pending.add(command)
            return
        self.send_pending()
        self._give([command], f"commanding {command.device}")

    def send_pending(self) -> None:
        """Send the commands that wait for the next step, so that readings show their effect."""
        self.catch_up()
        if self._pending:
            self._give(self._pending.take(), "commanding devices")

    def _give(self, commands: list[pb.DeviceCommand], what: str) -> None:
        request = pb.WriteDevicesRequest(session_id=self._session, commands=commands)
        self._hardware.world = self._layout.freeze(
            self._connection.command(what, self._connection.write, request).state
        )

    def look(self, camera: str) -> pb.Reading:
        """Get the current image of a camera."""
        self._update_session()
        self.send_pending()
        request = pb.ReadDevicesRequest(session_id=self._session, devices=[camera])
        state = self._connection.ask(f"reading the camera {camera}", self._devices.ReadDevices, request).state
        return state.readings[0]

    def wait(self, time_ns: int) -> None:
        """Let simulation time pass, also for a sleep of the component."""
        self._time.let_pass(time_ns)

    def pass_unread(self, steps: int) -> None:
        """Let time pass by whole steps, in the driver's thread, after which nobody reads the world.

        The simulator gets many such steps in one exchange: `catch_up` must be called before anything is read.
        """
        self._keeps_back = not self._real_time
        try:
            self._time.pass_steps(steps)
        finally:
            self._keeps_back = False

    def _step(self, steps: int) -> None:
        self._before_time_passes(self.now_ns)
        self._update_session()
        self._spend(steps * self._timestep_ns)
        self._unread.append((steps, self._pending.take()))
        if not self._keeps_back or len(self._unread) >= _MAX_UNREAD:
            self.catch_up()

    def catch_up(self) -> None:
        """Send the steps that nobody read, and get the state after them."""
        if not self._unread:
            return
        unread, self._unread = self._unread, []
        (steps, commands), *later = unread
        request = pb.StepSimulationRequest(
            session_id=self._session,
            steps=steps,
            commands=commands,
            later=[pb.LaterSteps(steps=count, commands=given) for count, given in later],
        )
        what = f"advancing by {sum(count for count, _ in unread) * self._timestep_ns / _NANOS:g} s"
        commanded = any(given for _, given in unread)
        call = self._connection.command if commanded else self._connection.ask
        self._hardware.world = self._layout.freeze(call(what, self._connection.step, request).state)

    def _spend(self, time_ns: int) -> None:
        self._passed_ns += time_ns
        too_long = self.took_too_long
        if too_long:
            raise TimeoutError(too_long)

    def _update_session(self) -> None:
        """Bring the session to the current case, and stop preparing cases in bulk."""
        if self._pending_preparation is not None:
            self._ahead.stop()
            self._prepare(self._pending_preparation)

    def _prepare(self, request: pb.PrepareRequest) -> None:
        self._pending_preparation = None
        what = "setting " + ", ".join(f"{name} = {value:g}" for name, value in request.parameters.items())
        self._hardware.world = self._layout.freeze(self._connection.ask(what, self._connection.prepare, request).state)

    def _prepare_many(self, request: pb.PrepareManyRequest) -> pb.PrepareManyResponse | None:
        request.session_id = self._session
        try:
            return self._connection.ask("preparing cases", self._control.PrepareMany, request)
        except SimulationError as e:
            if e.lost:
                raise
            return None

    def _renew(self) -> None:
        """Renew the lease three times per length, so that it does not expire during a long call of the component."""
        while not self._ended.wait(self._lease_s):
            try:
                self._control.RenewSession(pb.RenewSessionRequest(session_id=self._session), timeout=CALL_TIMEOUT_S)
            except (grpc.RpcError, ValueError):
                continue  # The next call of the test driver fails in the same way and reports it.
