"""One simulation of a world: the only place where time moves and parameters take effect."""

import copy
import math
from collections.abc import Callable, Iterable, Mapping, Sequence

import mujoco
import numpy as np

from sitaf_bridge.errors import Cancelled, Diverged, InvalidRequest, LimitReached, UnreachableValue
from sitaf_bridge.world.additions import SpawnedEntity
from sitaf_bridge.world.devices import KNOBS, Command, Reading
from sitaf_bridge.world.devices.camera import CameraBank, Image
from sitaf_bridge.world.driving import entities
from sitaf_bridge.world.driving.commanding import give
from sitaf_bridge.world.driving.conditions import Condition, bind_condition
from sitaf_bridge.world.driving.entities import Motion
from sitaf_bridge.world.driving.keeping import Kept, digest_of
from sitaf_bridge.world.parameters.settings import INTEGRATION, Setting
from sitaf_bridge.world.sensing.faults import Fault
from sitaf_bridge.world.sensing.sensing import Sensing
from sitaf_bridge.world.state import ResetScope, WorldState
from sitaf_bridge.world.world import World, load_world

MAX_STEPS = 10_000_000
# Steps between two looks at whether the caller is still there.
CHUNK = 2_000
FATAL = np.array(
    [
        int(warning)
        for warning in (
            mujoco.mjtWarning.mjWARN_BADQPOS,
            mujoco.mjtWarning.mjWARN_BADQVEL,
            mujoco.mjtWarning.mjWARN_BADQACC,
            mujoco.mjtWarning.mjWARN_BADCTRL,
        )
    ]
)


class Simulation:
    """A world in motion. Not for two threads at once: one MjData in two threads ends the process.

    `seed` is of everything random in it. A method that raises anything but Diverged has changed nothing.
    """

    def __init__(self, world: World, seed: int = 1) -> None:
        self._pristine = world
        self._defaults = {name: p.default for name, p in world.description.parameters.items()}
        self._values: dict[str, float] = {}
        self._step = 0
        self._frozen: str | None = None
        self._sensing = Sensing(world, seed)
        self._enter(world)
        self._set_back(self._defaults)
        self._state = self._observe()

    @property
    def state(self) -> WorldState:
        """The world at the current step; looking changes nothing. Raises Diverged."""
        self._refuse_if_frozen()
        return self._state

    @property
    def time_ns(self) -> int:
        """Simulation time."""
        return self._step * self.world.timestep_ns

    def parameters(self, names: Iterable[str] = ()) -> dict[str, float]:
        """The values as last set; of all parameters if no names are given. Raises InvalidRequest."""
        names = list(names) or list(self._values)
        self.refuse_unknown(names)
        return {name: self._values[name] for name in names}

    def set(self, values: Mapping[str, float]) -> WorldState:
        """Set parameters without moving time."""
        self._refuse_if_frozen()
        self.check(values)
        return self._all_or_nothing(lambda: self._apply(values))

    def write(self, commands: Sequence[Command]) -> WorldState:
        """Command actuators; they act when time moves. Raises InvalidRequest, UnreachableValue."""
        self._refuse_if_frozen()
        return self._all_or_nothing(lambda: give(commands, self.world, self._model, self._data))

    def reset(self, scope: ResetScope) -> WorldState:
        """Put back what the scope says; ALL also thaws a simulation that diverged."""
        if scope is ResetScope.ALL:
            return self._all_or_nothing(lambda: self._set_back(self._defaults))
        self._refuse_if_frozen()
        if scope is ResetScope.TIME:
            self._step = 0
            self._data.time = 0.0
            self._sensing.forget()
            return self._refresh()
        return self._all_or_nothing(self._set_state_back)

    def step(
        self,
        steps: int,
        wanted: Callable[[], bool] = lambda: True,
        values: Mapping[str, float] | None = None,
        commands: Sequence[Command] = (),
    ) -> WorldState:
        """Set and command what is given, then move time by whole steps. Raises Cancelled, Diverged."""
        self._refuse_if_frozen()
        if steps < 1:
            raise InvalidRequest("steps: must be at least 1")
        _refuse_too_many(steps)
        self.check(values or {})

        def stepped() -> None:
            self._apply(values or {})
            give(commands, self.world, self._model, self._data)
            self._run(steps, wanted)

        return self._all_or_nothing(stepped)

    def prepare(
        self, values: Mapping[str, float], settle_ns: int, wanted: Callable[[], bool] = lambda: True
    ) -> WorldState:
        """Reset everything, set parameters (the others to their defaults), and let time settle."""
        self.check(values)
        steps = self.steps_in(settle_ns, "settle_ns")

        def prepared() -> None:
            self._set_back({**self._defaults, **values})
            self._run(steps, wanted)

        return self._all_or_nothing(prepared)

    def advance_until(
        self, condition: Condition, limit_ns: int, wanted: Callable[[], bool] = lambda: True
    ) -> tuple[bool, WorldState]:
        """Step until a condition holds or the limit is reached; gives whether it holds."""
        self._refuse_if_frozen()
        steps = self.steps_in(limit_ns, "limit_ns")
        if steps < 1:
            raise InvalidRequest("limit_ns: must be above 0")
        judge = bind_condition(condition, self.world, self._model)
        met = False

        def advanced() -> None:
            nonlocal met
            met = judge(self._data, self.time_ns, self._read)
            for count in range(steps):
                if met or self._diverged():
                    return
                if count % 500 == 0 and not wanted():
                    raise Cancelled("the caller went away; the advance was undone")
                mujoco.mj_step(self._model, self._data)
                self._step += 1
                mujoco.mj_forward(self._model, self._data)
                if self._sensing.keeps_past(self._data):
                    self._read()
                met = judge(self._data, self.time_ns, self._read)

        state = self._all_or_nothing(advanced)
        return met, state

    def keep(self) -> Kept:
        """The whole state, to be put back later."""
        state = np.empty(self._state_size)
        mujoco.mj_getState(self._model, self._data, state, INTEGRATION)
        settings = tuple(s.get(self._model, self._data) for s in self._model_settings)
        return Kept(self.world, state, settings, dict(self._values), self._step, self._frozen, self._sensing.memory())

    def put_back(self, kept: Kept) -> WorldState:
        """Put a kept state of this session back."""
        self._put_back(kept)
        return self._refresh()

    def digest(self, before: bytes = b"") -> bytes:
        """SHA-256 over the state and the readings, chained to an earlier digest."""
        return digest_of(self.keep(), self._state, before)

    def set_faults(self, device: str, faults: Sequence[Fault]) -> WorldState:
        """Replace the faults of a device. Raises InvalidRequest."""
        self._refuse_if_frozen()
        now = next((reading.values for reading in self._state.readings if reading.device.name == device), ())
        return self._all_or_nothing(lambda: self._sensing.set_faults(device, faults, now))

    def image(self, device: str) -> Image:
        """What a camera sees at the current step. Raises InvalidRequest, Unavailable."""
        self._refuse_if_frozen()
        bank = self.world.banks.get("camera")
        if not isinstance(bank, CameraBank):
            raise InvalidRequest(f"devices: {device} is not a camera of this world")
        return bank.look(self._model, self._data, device)

    def entity(self, name: str) -> Motion:
        """Where a body is, and how it moves. Raises InvalidRequest."""
        self._refuse_if_frozen()
        return entities.motion_of(self._model, self._data, name)

    def put_entity(self, name: str, motion: Motion) -> WorldState:
        """Put a body somewhere. Raises InvalidRequest."""
        self._refuse_if_frozen()
        return self._all_or_nothing(lambda: entities.put_motion(self._model, self._data, name, motion))

    def push(self, name: str, force: Sequence[float], torque: Sequence[float]) -> WorldState:
        """Apply a wrench to a body from now on. Raises InvalidRequest."""
        self._refuse_if_frozen()
        return self._all_or_nothing(lambda: entities.push(self._model, self._data, name, force, torque))

    def spawn(self, entity: SpawnedEntity) -> WorldState:
        """Add a solid to this session's world. Raises InvalidRequest, LimitReached."""
        self._refuse_if_frozen()
        world = load_world(self.world.source, (*self.world.entities, entities.checked(entity, self.world)))
        return self._all_or_nothing(lambda: self._move_to(world))

    def delete(self, name: str) -> WorldState:
        """Remove a solid that was spawned. Raises InvalidRequest."""
        self._refuse_if_frozen()
        left = tuple(entity for entity in self.world.entities if entity.name != name)
        if len(left) == len(self.world.entities):
            there = ", ".join(entity.name for entity in self.world.entities) or "none"
            raise InvalidRequest(f"entity: {name!r} was not spawned; spawned entities: {there}")
        world = load_world(self.world.source, left) if left else self._pristine
        return self._all_or_nothing(lambda: self._move_to(world))

    def steps_in(self, duration_ns: int, shown: str) -> int:
        """Nanoseconds as steps, rounded up. Raises InvalidRequest, LimitReached."""
        if duration_ns < 0:
            raise InvalidRequest(f"{shown}: {duration_ns} is negative")
        steps = -(-duration_ns // self.world.timestep_ns)
        _refuse_too_many(steps)
        return steps

    def check(self, values: Mapping[str, float]) -> None:
        """Raises InvalidRequest, UnreachableValue for values that cannot be set."""
        self.refuse_unknown(values)
        for name, value in values.items():
            if not math.isfinite(value):
                raise InvalidRequest(f"parameter {name}: {value} is not a finite number")
        for name, value in values.items():
            parameter = self.world.description.parameters[name]
            if not parameter.low <= value <= parameter.high:
                raise UnreachableValue(
                    f"parameter {name}: {value:g} {parameter.unit} is outside its range "
                    f"[{parameter.low:g}, {parameter.high:g}]"
                )

    def refuse_unknown(self, names: Iterable[str]) -> None:
        """Raises InvalidRequest for names that are not parameters."""
        unknown = [name for name in names if name not in self._defaults]
        if unknown:
            known = ", ".join(self._defaults) or "none"
            raise InvalidRequest(f"unknown parameter {', '.join(unknown)}; parameters of this world: {known}")

    def _refuse_if_frozen(self) -> None:
        if self._frozen is not None:
            raise Diverged(self._frozen)

    def _enter(self, world: World) -> None:
        """Make a model and data of a world this simulation's."""
        self.world = world
        # A copy costs 0.2 ms for a small model; where no parameter writes to the model, all sessions share one.
        self._model = copy.copy(world.model) if world.edits_model else world.model
        self._data = mujoco.MjData(self._model)
        # A view: looking it up costs more than looking at it.
        self._warnings = self._data.warning.number
        self._state_size = mujoco.mj_stateSize(self._model, INTEGRATION)
        self._sensing.world = world
        # The settings that the state of the data does not hold.
        self._model_settings: list[Setting] = [
            b.setting for binds in world.binds.values() for b in binds if b.setting.edits_model
        ]

    def _move_to(self, world: World) -> None:
        """Go on in a world that has other entities; bodies keep their state by name."""
        old_model, old_data, values = self._model, self._data, self._values
        self._enter(world)
        mujoco.mj_resetData(self._model, self._data)
        self._apply(dict(values))
        entities.carry_over(old_model, old_data, self._model, self._data)

    def _put_back(self, kept: Kept) -> None:
        if kept.world is not self.world:
            self._enter(kept.world)
        else:
            # Warnings of a divergence are not part of the state.
            mujoco.mj_resetData(self._model, self._data)
        for setting, value in zip(self._model_settings, kept.settings, strict=True):
            setting.put(self._model, self._data, value)
        mujoco.mj_setState(self._model, self._data, kept.state, INTEGRATION)
        self._values, self._step, self._frozen = dict(kept.values), kept.step, kept.frozen
        self._sensing.remember(kept.memory)

    def _all_or_nothing(self, change: Callable[[], None]) -> WorldState:
        """Carry out a change; undo it if it is refused, freeze the simulation if it diverges."""
        before = self.keep()
        try:
            change()
        except Exception:
            self._put_back(before)
            mujoco.mj_forward(self._model, self._data)
            raise
        return self._refresh()

    def _set_back(self, values: Mapping[str, float]) -> None:
        """Where the session began, with these parameters; edits of the model are undone by setting them anew."""
        if self.world is not self._pristine:
            self._enter(self._pristine)
        mujoco.mj_resetData(self._model, self._data)
        self._sensing.reset()
        self._step = 0
        self._frozen = None
        self._set_knobs()
        self._apply(values)

    def _set_state_back(self) -> None:
        time = self._data.time
        mujoco.mj_resetData(self._model, self._data)
        self._data.time = time
        self._sensing.forget()
        self._set_knobs()
        self._apply(dict(self._values))

    def _set_knobs(self) -> None:
        """Noise, delay and level of the devices as declared."""
        for device in self.world.description.devices.values():
            for knob in KNOBS:
                value = getattr(device, knob)
                if value:
                    self._data.userdata[device.address(self._model, knob)] = value

    def _apply(self, values: Mapping[str, float]) -> None:
        """Direct settings first, then the solved ones, which depend on them; each in the order of declaration."""
        ordered = [name for name in self.world.binds if name in values]
        for name in ordered:
            for bind in self.world.binds[name]:
                if bind.gap is None:
                    bind.setting.put(self._model, self._data, values[name])
        for name in ordered:
            for bind in self.world.binds[name]:
                if bind.gap is not None:
                    try:
                        bind.gap.solve(self._model, self._data, bind.setting, values[name])
                    except UnreachableValue as error:
                        raise UnreachableValue(f"parameter {name}: {values[name]:g}: {error}") from error
        self._values.update(values)

    def _run(self, steps: int, wanted: Callable[[], bool]) -> None:
        left = steps
        every = left > 0 and self._sensing.keeps_past(self._data)
        if every:
            mujoco.mj_forward(self._model, self._data)
            self._read()
        while left > 0:
            if not wanted():
                raise Cancelled("the caller went away; the step was undone")
            for _ in range(min(left, CHUNK)) if every else ():
                mujoco.mj_step(self._model, self._data)
                mujoco.mj_forward(self._model, self._data)
                self._step += 1
                self._read()
            chunk = min(left, CHUNK)
            if not every:
                mujoco.mj_step(self._model, self._data, chunk)
                self._step += chunk
            left -= chunk
            if left > 0 and self._diverged():
                return

    def _diverged(self) -> bool:
        return any(self._warnings.take(FATAL).tolist())

    def _refresh(self) -> WorldState:
        """Bring derived quantities up to date: after mj_step, sensor data lag by one substep."""
        if self._diverged():
            self._frozen = (
                f"the simulation diverged at or before step {self._step} (NaN, infinity or a huge value); "
                "reset it with RESET_SCOPE_ALL or delete the session; a smaller timestep or softer contacts may help"
            )
            raise Diverged(self._frozen)
        self._state = self._observe()
        return self._state

    def _observe(self) -> WorldState:
        mujoco.mj_forward(self._model, self._data)
        return WorldState(
            declared=self.world.description,
            step=self._step,
            time_ns=self.time_ns,
            readings=self._read(),
            observations={name: o.measure(self._data) for name, o in self.world.observations.items()},
        )

    def _read(self) -> tuple[Reading, ...]:
        return self._sensing.read(self._model, self._data, self._step)


def _refuse_too_many(steps: int) -> None:
    if steps > MAX_STEPS:
        raise LimitReached(f"{steps} steps in one call; the limit is {MAX_STEPS}")
