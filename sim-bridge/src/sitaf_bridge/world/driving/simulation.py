"""The simulation of a world: advances time and applies parameters."""

import copy
from collections.abc import Callable, Iterable, Mapping, Sequence

import mujoco
import numpy as np

from sitaf_bridge.errors import Cancelled, Diverged, InvalidRequest, WrongState
from sitaf_bridge.world.additions import SpawnedEntity
from sitaf_bridge.world.devices import Command
from sitaf_bridge.world.devices.camera import CameraBank, Image
from sitaf_bridge.world.driving import entities
from sitaf_bridge.world.driving.checking import check_names, check_runs, check_values, steps_in
from sitaf_bridge.world.driving.conditions import Condition, bind_condition
from sitaf_bridge.world.driving.entities import Motion
from sitaf_bridge.world.driving.motion import MotionRecording
from sitaf_bridge.world.driving.running_world import RunningWorld
from sitaf_bridge.world.driving.saved_state import InitialState, SavedState, digest_of
from sitaf_bridge.world.driving.signals import SignalRecording, Trace
from sitaf_bridge.world.parameters.settings import INTEGRATION
from sitaf_bridge.world.parameters.start import enter
from sitaf_bridge.world.scene.drawing import draw
from sitaf_bridge.world.sensing.fault_names import is_fault, split
from sitaf_bridge.world.sensing.faults import Fault
from sitaf_bridge.world.state import ResetScope, WorldState
from sitaf_bridge.world.world import World, load_world


class Simulation(RunningWorld):
    """A running world. Not thread-safe: using one MjData in two threads crashes the process.

    `seed` initializes all random numbers. A method that raises an error other than Diverged has changed nothing.
    """

    def __init__(self, world: World, seed: int = 1) -> None:
        self._pristine = world
        self._defaults = {name: p.default for name, p in world.description.parameters.items()}
        self._values: dict[str, float] = {}
        super().__init__(world, seed)
        self._restore_initial(self._defaults)
        self._state = self._observe()
        self._begun = InitialState(copy.copy(self._data), self._state, self._settings())

    @property
    def state(self) -> WorldState:
        """The state at the current step. Raises Diverged."""
        self._check_not_frozen()
        return self._state

    @property
    def model_identity(self) -> int:
        """Equal for simulations that share a compiled model."""
        return id(self._model)

    def parameters(self, names: Iterable[str] = ()) -> dict[str, float]:
        """The current values of the named parameters, or of all. Raises InvalidRequest."""
        names = list(names) or list(self._values)
        check_names(self._pristine, names)
        return {name: self._values[name] if name in self._values else split(name).default for name in names}

    def set(self, values: Mapping[str, float]) -> WorldState:
        """Set parameters without advancing time."""
        self._check_not_frozen()
        check_values(self._pristine, values)

        def changed() -> None:
            self._apply(values)
            self._schedule(values, self._step)
            self._set_live(values)

        return self._all_or_nothing(changed)

    def write(self, commands: Sequence[Command]) -> WorldState:
        """Set actuator commands, which act when time advances. Raises InvalidRequest, UnreachableValue."""
        self._check_not_frozen()

        def written() -> None:
            self._give(commands)

        return self._all_or_nothing(written)

    def reset(self, scope: ResetScope) -> WorldState:
        """Reset the scope; ALL also resets a diverged simulation."""
        if scope is ResetScope.ALL:
            return self._restore_defaults()
        self._check_not_frozen()
        if scope is ResetScope.TIME:
            self._sensing.schedule = self._sensing.schedule.shifted(-self._step)
            self._step = 0
            self._data.time = 0.0
            self._sensing.clear_history()
            return self._refresh()
        return self._all_or_nothing(self._restore_state)

    def step(
        self,
        steps: int,
        is_active: Callable[[], bool] = lambda: True,
        values: Mapping[str, float] | None = None,
        commands: Sequence[Command] = (),
        later: Sequence[tuple[int, Sequence[Command]]] = (),
    ) -> WorldState:
        """Set parameters and commands, then advance time by whole steps. Raises Cancelled, Diverged.

        `later` are further steps with their commands; the state is that after the last of them.
        """
        self._check_not_frozen()
        check_runs([steps, *(count for count, _ in later)])
        check_values(self._pristine, values or {})

        def stepped() -> None:
            self._apply(values or {})
            self._schedule(values or {}, self._step)
            if values:
                self._set_live(values)
            self._give(commands)
            self._run(steps, is_active)
            for more, given in later:
                if not self._pass():
                    return
                self._give(given)
                self._run(more, is_active)

        return self._all_or_nothing(stepped)

    def prepare(
        self,
        values: Mapping[str, float],
        settle_ns: int,
        is_active: Callable[[], bool] = lambda: True,
        call_after_ns: int = 0,
    ) -> WorldState:
        """Reset everything, set parameters (others to their defaults), and advance the settling time.

        The onsets of faults count from the call under test, which begins `call_after_ns` after that.
        """
        check_values(self._pristine, values)
        steps = steps_in(self._pristine, settle_ns, "settle_ns")
        call = steps + steps_in(self._pristine, call_after_ns, "call_after_ns")

        def prepared() -> None:
            self._restore_initial({**self._defaults, **values})
            self._schedule(values, call)
            self._set_live({**self._defaults, **values})
            self._run(steps, is_active, settles=True)

        state = self._all_or_nothing(prepared)
        self._sample()
        return state

    def advance_until(
        self, condition: Condition, limit_ns: int, is_active: Callable[[], bool] = lambda: True
    ) -> tuple[bool, WorldState]:
        """Step until a condition holds or the limit is reached; returns whether it holds."""
        self._check_not_frozen()
        steps = steps_in(self._pristine, limit_ns, "limit_ns")
        if steps < 1:
            raise InvalidRequest("limit_ns must be positive")
        judge = bind_condition(condition, self.world, self._model)
        met = False
        live = self._sensing.live

        def advanced() -> None:
            nonlocal met
            if live is not None:
                live.begin_run(self._step)
            met = judge(self._data, self.time_ns, self._read)
            for count in range(steps):
                if met or self._divergence.seen():
                    return
                if count % 500 == 0 and not is_active():
                    raise Cancelled("the caller disconnected; the advance was undone")
                if self._step in self._sensing.schedule.changes:
                    self._refresh_commands()
                mujoco.mj_step(self._model, self._data)
                self._step += 1
                if live is not None:
                    live.pace(self._step)
                mujoco.mj_forward(self._model, self._data)
                self._sample()
                if self._sensing.keeps_past(self._data, self._step) or self._step in self._sensing.schedule.changes:
                    self._read()
                if self._motion is not None and self._motion.is_due(self._step):
                    self._observe()
                met = judge(self._data, self.time_ns, self._read)

        state = self._all_or_nothing(advanced)
        return met, state

    def save(self) -> SavedState:
        """Save the complete state."""
        state = np.empty(self._state_size)
        mujoco.mj_getState(self._model, self._data, state, INTEGRATION)
        return SavedState(
            self.world,
            state,
            self._settings(),
            dict(self._values),
            self._step,
            self._frozen,
            self._sensing.memory(),
            self._commanding.memory(),
        )

    def restore(self, kept: SavedState) -> WorldState:
        """Restore a saved state of this session."""
        self._restore(kept)
        return self._refresh()

    def digest(self, before: bytes = b"") -> bytes:
        """SHA-256 over the state and the readings, chained to an earlier digest."""
        return digest_of(self.save(), self._state, before)

    def set_faults(self, device: str, faults: Sequence[Fault]) -> WorldState:
        """Replace the faults of a device. Raises InvalidRequest."""
        self._check_not_frozen()
        now = next((reading.values for reading in self._state.readings if reading.device.name == device), ())
        return self._all_or_nothing(lambda: self._sensing.set_faults(device, faults, now))

    def image(self, device: str) -> Image:
        """Render the image of a camera. Raises InvalidRequest, Unavailable."""
        self._check_not_frozen()
        bank = self.world.banks.get("camera")
        if not isinstance(bank, CameraBank):
            raise InvalidRequest(f"devices: {device} is not a camera of this world")
        return bank.look(self._model, self._data, device)

    def scene(self) -> bytes:
        """The scene at the current step as GLB. Raises LimitReached."""
        self._check_not_frozen()
        return draw(self.world, self._model, self._data).content()

    def record_motion(self, interval_ns: int, most: int) -> None:
        """Start to record motion; an interval of 0 stops it. Raises InvalidRequest."""
        interval = steps_in(self._pristine, interval_ns, "interval_ns")
        if most == 1:
            raise InvalidRequest("max_frames: must be at least 2, or 0 for the default")
        self._motion = MotionRecording(interval, most, self.world) if interval else None
        if self._motion is not None and self._frozen is None:
            self._motion.record(self.world, self._data, self._state)

    def take_motion(self) -> tuple[bytes, int]:
        """The recorded motion as GLB, and its number of frames; it starts again. Raises WrongState, LimitReached."""
        return self._recorded().take(self.world, self._model, self._data, self._state)

    def show_motion(self) -> bytes:
        """The motion so far as GLB; the recording goes on. Raises WrongState, LimitReached."""
        return self._recorded().export(self.world, self._model, self._data, self._state)[0]

    def _recorded(self) -> MotionRecording:
        self._check_not_frozen()
        if self._motion is None:
            raise WrongState("this session does not record motion; call RecordMotion first")
        return self._motion

    def record_signals(self, names: Sequence[str], settling: bool) -> None:
        """Start to sample signals in each step, also while the world settles if `settling`. Raises InvalidRequest."""
        live = self._sensing.live
        self._signals = SignalRecording(names, settling, self.world, live=live)

    def signals(self, call_ns: int) -> Trace:
        """The samples of the current case, whose call began at this time. Raises InvalidRequest, LimitReached."""
        self._check_not_frozen()
        if self._signals is None:
            raise WrongState("this session records no signals; its endpoint was opened without signals")
        # The last sample is the state at the end.
        self._sample()
        return self._signals.trace(call_ns, self.world.timestep_ns)

    def entity(self, name: str) -> Motion:
        """The pose and velocity of a body. Raises InvalidRequest."""
        self._check_not_frozen()
        return entities.motion_of(self._model, self._data, name)

    def put_entity(self, name: str, motion: Motion) -> WorldState:
        """Move a body. Raises InvalidRequest."""
        self._check_not_frozen()
        return self._all_or_nothing(lambda: entities.put_motion(self._model, self._data, name, motion))

    def push(self, name: str, force: Sequence[float], torque: Sequence[float]) -> WorldState:
        """Apply a wrench to a body until the next call. Raises InvalidRequest."""
        self._check_not_frozen()
        return self._all_or_nothing(lambda: entities.push(self._model, self._data, name, force, torque))

    def spawn(self, entity: SpawnedEntity) -> WorldState:
        """Add a solid to this session's world. Raises InvalidRequest, LimitReached."""
        self._check_not_frozen()
        world = load_world(self.world.source, (*self.world.entities, entities.checked(entity, self.world)))
        return self._all_or_nothing(lambda: self._move_to(world))

    def delete(self, name: str) -> WorldState:
        """Remove a spawned solid. Raises InvalidRequest."""
        self._check_not_frozen()
        left = tuple(entity for entity in self.world.entities if entity.name != name)
        if len(left) == len(self.world.entities):
            there = ", ".join(entity.name for entity in self.world.entities) or "none"
            raise InvalidRequest(f"entity: {name!r} was not spawned; spawned entities: {there}")
        world = load_world(self.world.source, left) if left else self._pristine
        return self._all_or_nothing(lambda: self._move_to(world))

    def _check_not_frozen(self) -> None:
        if self._frozen is not None:
            raise Diverged(self._frozen)

    def _move_to(self, world: World) -> None:
        """Switch to a world with other entities; bodies keep their state by name."""
        old_model, old_data, values = self._model, self._data, self._values
        self._enter(world)
        self._reset_data()
        self._apply(dict(values))
        entities.carry_over(old_model, old_data, self._model, self._data)

    def _restore(self, kept: SavedState) -> None:
        if kept.world is not self.world:
            self._enter(kept.world)
        else:
            # Divergence warnings are not part of the state.
            mujoco.mj_resetData(self._model, self._data)
        for setting, value in zip(self._model_settings, kept.settings, strict=True):
            setting.put(self._model, self._data, value)
        mujoco.mj_setState(self._model, self._data, kept.state, INTEGRATION)
        self._values, self._step, self._frozen = dict(kept.values), kept.step, kept.frozen
        self._sensing.remember(kept.memory)
        self._commanding.remember(kept.followed)

    def _all_or_nothing(self, change: Callable[[], None]) -> WorldState:
        """Apply a change; undo it if it is rejected, freeze the simulation if it diverges."""
        before = self.save()
        try:
            change()
        except Exception:
            self._restore(before)
            mujoco.mj_forward(self._model, self._data)
            raise
        return self._refresh()

    def _schedule(self, values: Mapping[str, float], step: int) -> None:
        """Let the faults among parameters begin, counted from a step."""
        faults = {name: value for name, value in values.items() if is_fault(name)}
        if faults:
            self._values.update(faults)
            before = self._sensing.schedule
            self._sensing.follow(before.updated(self._pristine, self._values, faults, step))
            self._refresh_commands(before)

    def _restore_initial(self, values: Mapping[str, float]) -> None:
        """Restore the initial state with these parameters; model edits are undone by setting their values."""
        if self.world is not self._pristine:
            self._enter(self._pristine)
        self._reset_data()
        self._sensing.reset()
        self._commanding.reset()
        if self._motion is not None:
            self._motion.restart()
        if self._signals is not None:
            self._signals.restart()
        self._step = 0
        self._frozen = None
        self._values = {}
        self._sensing.set_knobs(self._model, self._data)
        self._apply(values)

    def _restore_defaults(self) -> WorldState:
        """Restore the initial state with default values from a copy, nine times as fast for a small world."""
        if self._sensing.live is not None:
            return self._all_or_nothing(lambda: self._restore_initial(self._defaults))
        if self.world is not self._pristine:
            self._enter(self._pristine)
        self._begun.restore(self._model, self._data, self._model_settings)
        self._sensing.reset()
        self._commanding.reset()
        self._values = dict(self._defaults)
        self._step, self._frozen, self._state = 0, None, self._begun.state
        if self._signals is not None:
            self._signals.restart()
            self._sample()
        if self._motion is not None:
            self._motion.restart()
            self._motion.record(self.world, self._data, self._state)
        return self._state

    def _reset_data(self) -> None:
        mujoco.mj_resetData(self._model, self._data)
        if self.world.start is not None:
            enter(self._model, self._data, self.world.start)

    def _restore_state(self) -> None:
        time = self._data.time
        self._reset_data()
        self._data.time = time
        self._sensing.clear_history()
        self._sensing.set_knobs(self._model, self._data)
        self._apply(dict(self._values))

    def _apply(self, values: Mapping[str, float]) -> None:
        self.world.apply(self._model, self._data, values)
        self._values.update(values)
