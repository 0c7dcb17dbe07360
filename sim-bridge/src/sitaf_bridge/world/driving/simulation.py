"""One simulation of a world: the only place where time moves and parameters take effect."""

import copy
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence

import mujoco
import numpy as np

from sitaf_bridge.errors import Cancelled, Diverged, InvalidRequest, NotNow, UnreachableValue
from sitaf_bridge.world.additions import SpawnedEntity
from sitaf_bridge.world.devices import Command, Reading
from sitaf_bridge.world.devices.camera import CameraBank, Image
from sitaf_bridge.world.driving import entities
from sitaf_bridge.world.driving.checking import check_values, refuse_too_many, refuse_unknown, steps_in
from sitaf_bridge.world.driving.commanding import give
from sitaf_bridge.world.driving.conditions import Condition, bind_condition
from sitaf_bridge.world.driving.divergence import Divergence
from sitaf_bridge.world.driving.entities import Motion
from sitaf_bridge.world.driving.film import Film
from sitaf_bridge.world.driving.keeping import Begun, Kept, digest_of
from sitaf_bridge.world.parameters.settings import INTEGRATION, Setting
from sitaf_bridge.world.scene.drawing import draw
from sitaf_bridge.world.sensing.faults import Fault
from sitaf_bridge.world.sensing.sensing import Sensing
from sitaf_bridge.world.state import ResetScope, WorldState
from sitaf_bridge.world.world import World, load_world

# Steps between two looks at whether the caller is still there.
CHUNK = 2_000


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
        self._film: Film | None = None
        self._sensing = Sensing(world, seed)
        self._enter(world)
        self._set_back(self._defaults)
        self._state = self._observe()
        self._begun = Begun(copy.copy(self._data), self._state, self._settings())

    @property
    def state(self) -> WorldState:
        """The world at the current step; looking changes nothing. Raises Diverged."""
        self._refuse_if_frozen()
        return self._state

    @property
    def model_identity(self) -> int:
        """Equal for simulations that share one compiled model, as long as both are there."""
        return id(self._model)

    @property
    def time_ns(self) -> int:
        """Simulation time."""
        return self._step * self.world.timestep_ns

    def parameters(self, names: Iterable[str] = ()) -> dict[str, float]:
        """The values as last set; of all parameters if no names are given. Raises InvalidRequest."""
        names = list(names) or list(self._values)
        refuse_unknown(self._pristine, names)
        return {name: self._values[name] for name in names}

    def set(self, values: Mapping[str, float]) -> WorldState:
        """Set parameters without moving time."""
        self._refuse_if_frozen()
        check_values(self._pristine, values)
        return self._all_or_nothing(lambda: self._apply(values))

    def write(self, commands: Sequence[Command]) -> WorldState:
        """Command actuators; they act when time moves. Raises InvalidRequest, UnreachableValue."""
        self._refuse_if_frozen()
        return self._all_or_nothing(lambda: give(commands, self.world, self._model, self._data))

    def reset(self, scope: ResetScope) -> WorldState:
        """Put back what the scope says; ALL also thaws a simulation that diverged."""
        if scope is ResetScope.ALL:
            return self._begin_again()
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
        refuse_too_many(steps)
        check_values(self._pristine, values or {})

        def stepped() -> None:
            self._apply(values or {})
            give(commands, self.world, self._model, self._data)
            self._run(steps, wanted)

        return self._all_or_nothing(stepped)

    def prepare(
        self, values: Mapping[str, float], settle_ns: int, wanted: Callable[[], bool] = lambda: True
    ) -> WorldState:
        """Reset everything, set parameters (the others to their defaults), and let time settle."""
        check_values(self._pristine, values)
        steps = steps_in(self._pristine, settle_ns, "settle_ns")

        def prepared() -> None:
            self._set_back({**self._defaults, **values})
            self._run(steps, wanted)

        return self._all_or_nothing(prepared)

    def advance_until(
        self, condition: Condition, limit_ns: int, wanted: Callable[[], bool] = lambda: True
    ) -> tuple[bool, WorldState]:
        """Step until a condition holds or the limit is reached; gives whether it holds."""
        self._refuse_if_frozen()
        steps = steps_in(self._pristine, limit_ns, "limit_ns")
        if steps < 1:
            raise InvalidRequest("limit_ns: must be above 0")
        judge = bind_condition(condition, self.world, self._model)
        met = False

        def advanced() -> None:
            nonlocal met
            met = judge(self._data, self.time_ns, self._read)
            for count in range(steps):
                if met or self._divergence.seen():
                    return
                if count % 500 == 0 and not wanted():
                    raise Cancelled("the caller went away; the advance was undone")
                mujoco.mj_step(self._model, self._data)
                self._step += 1
                mujoco.mj_forward(self._model, self._data)
                if self._sensing.keeps_past(self._data):
                    self._read()
                if self._film is not None and self._film.is_due(self._step):
                    self._observe()
                met = judge(self._data, self.time_ns, self._read)

        state = self._all_or_nothing(advanced)
        return met, state

    def keep(self) -> Kept:
        """The whole state, to be put back later."""
        state = np.empty(self._state_size)
        mujoco.mj_getState(self._model, self._data, state, INTEGRATION)
        return Kept(
            self.world, state, self._settings(), dict(self._values), self._step, self._frozen, self._sensing.memory()
        )

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

    def scene(self) -> bytes:
        """What the world looks like at the current step, as a GLB. Raises LimitReached."""
        self._refuse_if_frozen()
        return draw(self.world, self._model, self._data).content()

    def record_motion(self, interval_ns: int, most: int) -> None:
        """Note frames from now on; an interval of 0 ends that. Raises InvalidRequest."""
        interval = steps_in(self._pristine, interval_ns, "interval_ns")
        if most == 1:
            raise InvalidRequest("max_frames: 1 is no motion; 2 at least, or 0 for the default")
        self._film = Film(interval, most, self.world) if interval else None
        if self._film is not None and self._frozen is None:
            self._film.look(self.world, self._data, self._state)

    def take_motion(self) -> tuple[bytes, int]:
        """What was noted, as a GLB, and the count of its frames. Raises NotNow, LimitReached."""
        self._refuse_if_frozen()
        if self._film is None:
            raise NotNow("no motion is recorded in this session; call RecordMotion first")
        taken = self._film.take(self.world, self._model, self._data, self._state)
        self._film.look(self.world, self._data, self._state)
        return taken

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

    def _refuse_if_frozen(self) -> None:
        if self._frozen is not None:
            raise Diverged(self._frozen)

    def _enter(self, world: World) -> None:
        """Make a model and data of a world this simulation's."""
        self.world = world
        # A copy costs 0.2 ms for a small model; where no parameter writes to the model, all sessions share one.
        self._model = copy.copy(world.model) if world.edits_model else world.model
        self._data = mujoco.MjData(self._model)
        self._divergence = Divergence(self._data)
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
        if self._film is not None:
            self._film.restart()
        self._step = 0
        self._frozen = None
        self._sensing.set_knobs(self._model, self._data)
        self._apply(values)

    def _begin_again(self) -> WorldState:
        """What `_set_back` to the defaults would find anew, from a copy: a ninth of the time for a small world."""
        if self.world is not self._pristine:
            self._enter(self._pristine)
        self._begun.put_back(self._model, self._data, self._model_settings)
        self._sensing.reset()
        self._values = dict(self._defaults)
        self._step, self._frozen, self._state = 0, None, self._begun.state
        if self._film is not None:
            self._film.restart()
            self._film.look(self.world, self._data, self._state)
        return self._state

    def _settings(self) -> tuple[float, ...]:
        return tuple(setting.get(self._model, self._data) for setting in self._model_settings)

    def _set_state_back(self) -> None:
        time = self._data.time
        mujoco.mj_resetData(self._model, self._data)
        self._data.time = time
        self._sensing.forget()
        self._sensing.set_knobs(self._model, self._data)
        self._apply(dict(self._values))

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
        left, film = steps, self._film
        every = left > 0 and self._sensing.keeps_past(self._data)
        # Of what nobody reads meanwhile and no film shows, such as laser scans.
        without = frozenset() if film is None or every else film.leaves_out
        if left > 0 and (every or film is not None):
            self._observe(without)
        while left > 0:
            if not wanted():
                raise Cancelled("the caller went away; the step was undone")
            chunk = min(left, CHUNK, CHUNK if film is None else film.steps_to_next(self._step))
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
            if left > 0 and film is not None:
                self._observe(without)

    def _refresh(self) -> WorldState:
        """Bring derived quantities up to date: after mj_step, sensor data lag by one substep."""
        if self._divergence.seen():
            self._frozen = self._divergence.told(self._step)
            raise Diverged(self._frozen)
        self._state = self._observe()
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
        if self._film is not None:
            self._film.look(self.world, self._data, state)
        return state

    def _read(self, without: Collection[str] = ()) -> tuple[Reading, ...]:
        return self._sensing.read(self._model, self._data, self._step, without)
