"""A world with its time: advances it, and observes it at each step."""

import copy
from collections.abc import Callable, Collection, Mapping, Sequence

import mujoco

from sitaf_bridge.errors import Cancelled, Diverged
from sitaf_bridge.world.devices import Command, Reading
from sitaf_bridge.world.driving.commanding import Commanding, Moment
from sitaf_bridge.world.driving.divergence import Divergence
from sitaf_bridge.world.driving.integration import integration_of
from sitaf_bridge.world.driving.motion import MotionRecording
from sitaf_bridge.world.driving.signals import SignalRecording
from sitaf_bridge.world.parameters.settings import INTEGRATION, Setting
from sitaf_bridge.world.sensing.fault_names import is_fault
from sitaf_bridge.world.sensing.fault_schedule import FaultSchedule
from sitaf_bridge.world.sensing.live import LiveDevices
from sitaf_bridge.world.sensing.sensing import Sensing
from sitaf_bridge.world.state import WorldState
from sitaf_bridge.world.world import World

# Steps between checks whether the caller is still connected.
CHUNK = 2_000


class RunningWorld:
    """A model with its data, sensors and recordings. `seed` initializes all random numbers."""

    _state: WorldState

    def __init__(self, world: World, seed: int) -> None:
        self._step = 0
        self._frozen: str | None = None
        self._motion: MotionRecording | None = None
        self._signals: SignalRecording | None = None
        self._sensing = Sensing(world, seed)
        self._commanding = Commanding()
        self._enter(world)

    @property
    def time_ns(self) -> int:
        """Simulation time."""
        return self._step * self.world.timestep_ns

    def _enter(self, world: World) -> None:
        """Switch to a world and create its model and data."""
        self.world = world
        # A copy costs 0.2 ms for a small model; if no parameter edits the model, all sessions share one.
        self._model = copy.copy(world.model) if world.edits_model else world.model
        self._data = mujoco.MjData(self._model)
        self._divergence = Divergence(self._data)
        self._state_size = mujoco.mj_stateSize(self._model, INTEGRATION)
        self._sensing.world = world
        if self._signals is not None:
            self._signals.bind(world)
        # Settings that are not part of the data's state.
        self._model_settings: list[Setting] = [
            b.setting for binds in world.binds.values() for b in binds if b.setting.edits_model
        ]

    def attach(self, live: LiveDevices) -> WorldState:
        """Use real or recorded devices; call it before the first case and before `record_signals`."""
        self._sensing.live = live
        self._state = self._observe()
        return self._state

    def _give(self, commands: Sequence[Command]) -> None:
        followed = self._commanding.give(commands, self._now())
        if self._sensing.live is not None and followed:
            self._sensing.live.command(followed)
        if self._signals is not None:
            self._signals.give(commands)

    def _set_live(self, values: Mapping[str, float]) -> None:
        """Set the parameters of the environment of real devices, last, because this cannot be undone."""
        live = self._sensing.live
        if live is not None:
            live.set({name: value for name, value in values.items() if not is_fault(name)})

    def _settings(self) -> tuple[float, ...]:
        return tuple(setting.get(self._model, self._data) for setting in self._model_settings)

    def _sample(self) -> None:
        """Sample the signals, from data after `mj_forward`."""
        if self._signals is not None:
            self._signals.sample(self._model, self._data, self._step, self._sensing)

    def _run_sampled(self, signals: SignalRecording, steps: int, is_active: Callable[[], bool]) -> None:
        """Advance time with a sample before each step but the first one, whose state was sampled before."""
        every = self._sensing.keeps_past(self._data, self._step)
        if every or self._motion is not None or self._step == 0:
            self._observe()
            if self._step == 0:
                self._sample()
        model, data, sensing = self._model, self._data, self._sensing
        changes = sensing.schedule.changes
        integrate = integration_of(model)
        for count in range(steps):
            if count % 500 == 0:
                if not is_active():
                    raise Cancelled("the caller disconnected; the step was undone")
                if self._divergence.seen():
                    return
            mujoco.mj_checkPos(model, data)
            mujoco.mj_checkVel(model, data)
            if self._step in changes:
                self._refresh_commands()
            mujoco.mj_forward(model, data)
            if count:
                signals.sample(model, data, self._step, sensing)
                # Delayed devices need the readings of every step, a stuck device the one at which it sticks.
                if every or self._step in changes:
                    self._read()
                if self._motion is not None and self._motion.is_due(self._step):
                    self._observe()
            integrate(model, data)
            self._step += 1

    def _run_live(
        self, live: LiveDevices, steps: int, is_active: Callable[[], bool], signals: SignalRecording | None
    ) -> None:
        """Advance time step by step with the wall clock."""
        if steps == 0:
            return
        if signals is not None and self._step == 0:
            self._observe()
            self._sample()
        every = self._sensing.keeps_past(self._data, self._step)
        changes = self._sensing.schedule.changes
        live.begin_run(self._step)
        for count in range(steps):
            if count % 50 == 0 and not is_active():
                raise Cancelled("the caller disconnected; the step was undone")
            if self._step in changes:
                self._refresh_commands()
            mujoco.mj_step(self._model, self._data)
            self._step += 1
            if self._divergence.seen():
                return
            live.pace(self._step)
            if count == steps - 1:
                break
            if signals is not None or every or self._step in changes or self._motion is not None:
                mujoco.mj_forward(self._model, self._data)
                if signals is not None:
                    signals.sample(self._model, self._data, self._step, self._sensing)
                if every or self._step in changes:
                    self._read()
                if self._motion is not None and self._motion.is_due(self._step):
                    self._observe()
        live.end_run(self._step)

    def _run(self, steps: int, is_active: Callable[[], bool], settles: bool = False) -> None:
        signals = self._signals if self._signals is not None and (self._signals.settling or not settles) else None
        if self._sensing.live is not None:
            self._run_live(self._sensing.live, steps, is_active, signals)
        elif signals is not None and steps > 0:
            self._run_sampled(signals, steps, is_active)
        else:
            self._run_unsampled(steps, is_active)

    def _run_unsampled(self, steps: int, is_active: Callable[[], bool]) -> None:
        left, motion = steps, self._motion
        every = left > 0 and self._sensing.keeps_past(self._data, self._step)
        schedule = self._sensing.schedule
        # Devices that nobody reads during the run and that are not recorded, such as laser scans.
        without = frozenset() if motion is None or every else motion.omitted_kinds
        if left > 0 and (every or (motion is not None and motion.is_due(self._step))):
            self._observe(without)
        if self._step in schedule.changes:
            self._refresh_commands()
        while left > 0:
            if not is_active():
                raise Cancelled("the caller disconnected; the step was undone")
            chunk = min(left, CHUNK, CHUNK if motion is None else motion.steps_to_next(self._step))
            if schedule.changes:
                chunk = min(chunk, schedule.steps_to_change(self._step) or chunk)
            if every:
                for _ in range(chunk):
                    mujoco.mj_step(self._model, self._data)
                    mujoco.mj_forward(self._model, self._data)
                    self._step += 1
                    self._read()
            else:
                mujoco.mj_step(self._model, self._data, chunk)
                self._step += chunk
            left -= chunk
            if left > 0 and self._divergence.seen():
                return
            if left > 0 and self._step in schedule.changes:
                self._refresh_commands()
                # A stuck device holds its reading at the step at which it sticks.
                mujoco.mj_forward(self._model, self._data)
                self._read()
            if left > 0 and motion is not None:
                self._observe(without)

    def _pass(self) -> bool:
        """Between two runs of one request, whose state nobody reads; False after a divergence.

        What a refresh would have left behind is left behind here, too.
        """
        if self._divergence.seen():
            return False
        signals = self._signals
        sampled = signals is not None and signals.next_step == self._step
        # As in a run: a delayed device needs every step, a stuck one that at which it sticks.
        sensed = self._step in self._sensing.schedule.changes or self._sensing.keeps_past(self._data, self._step)
        if sampled or sensed:
            mujoco.mj_forward(self._model, self._data)
        if sensed:
            self._read()
        if sampled:
            self._sample()
        return True

    def _refresh_commands(self, before: FaultSchedule | None = None) -> None:
        """Let commands follow the faults that begin or end at this step, or are no longer in the schedule."""
        schedule = self._sensing.schedule
        devices = dict.fromkeys((*(before or schedule).of_commands, *schedule.of_commands))
        self._commanding.refresh(devices, self._now())

    def _now(self) -> Moment:
        return Moment(self.world, self._model, self._data, self._sensing.schedule, self._step)

    def _refresh(self) -> WorldState:
        """Update derived quantities: after mj_step, sensor data lag by one substep."""
        if self._divergence.seen():
            self._frozen = self._divergence.message(self._step)
            raise Diverged(self._frozen)
        self._state = self._observe()
        if self._signals is not None and self._signals.next_step == self._step:
            self._sample()
        return self._state

    def _observe(self, without: Collection[str] = ()) -> WorldState:
        mujoco.mj_forward(self._model, self._data)
        readings = self._read(without)
        state = WorldState(
            declared=self.world.description,
            step=self._step,
            time_ns=self.time_ns,
            readings=readings,
            observations={
                name: o.measure(self._model, self._data, readings) for name, o in self.world.observations.items()
            },
        )
        if self._motion is not None:
            self._motion.record(self.world, self._data, state)
        return state

    def _read(self, without: Collection[str] = ()) -> tuple[Reading, ...]:
        return self._sensing.read(self._model, self._data, self._step, without)
