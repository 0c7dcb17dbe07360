"""One simulation of a world: the only place where time moves and parameters take effect."""

import copy
import enum
import math
from collections.abc import Callable, Iterable, Mapping

import mujoco
import numpy as np

from sitaf_bridge.errors import Cancelled, Diverged, InvalidRequest, LimitReached, UnreachableValue
from sitaf_bridge.world.parameters.settings import INTEGRATION, Setting
from sitaf_bridge.world.state import WorldState
from sitaf_bridge.world.world import World

MAX_STEPS = 10_000_000
# Steps between two looks at whether the caller is still there.
CHUNK = 2_000
FATAL_WARNINGS = tuple(
    int(warning)
    for warning in (
        mujoco.mjtWarning.mjWARN_BADQPOS,
        mujoco.mjtWarning.mjWARN_BADQVEL,
        mujoco.mjtWarning.mjWARN_BADQACC,
        mujoco.mjtWarning.mjWARN_BADCTRL,
    )
)


class ResetScope(enum.Enum):
    """What a reset puts back."""

    ALL = "time, state and parameters"
    TIME = "only the clock"
    STATE = "positions, velocities and controls"


class Simulation:
    """A world in motion. Not for two threads at once: one MjData in two threads ends the process.

    A method that raises anything but Diverged has changed nothing.
    """

    def __init__(self, world: World) -> None:
        self.world = world
        # A copy costs 0.2 ms for a small model; where no parameter writes to the model, all sessions share one.
        self._model = copy.copy(world.model) if world.edits_model else world.model
        self._data = mujoco.MjData(self._model)
        self._defaults = {name: p.default for name, p in world.description.parameters.items()}
        self._values: dict[str, float] = {}
        self._step = 0
        self._frozen: str | None = None
        self._set_back(self._defaults)
        self._state = self._observe()

    @property
    def state(self) -> WorldState:
        """The world at the current step; looking changes nothing. Raises Diverged."""
        self._refuse_if_frozen()
        return self._state

    def parameters(self, names: Iterable[str] = ()) -> dict[str, float]:
        """The values as last set; of all parameters if no names are given. Raises InvalidRequest."""
        names = list(names) or list(self._values)
        self._refuse_unknown(names)
        return {name: self._values[name] for name in names}

    def set(self, values: Mapping[str, float]) -> WorldState:
        """Set parameters without moving time."""
        self._refuse_if_frozen()
        self._check(values)
        return self._all_or_nothing(lambda: self._apply(values))

    def reset(self, scope: ResetScope) -> WorldState:
        """Put back what the scope says; ALL also thaws a simulation that diverged."""
        if scope is ResetScope.ALL:
            return self._all_or_nothing(lambda: self._set_back(self._defaults))
        self._refuse_if_frozen()
        if scope is ResetScope.TIME:
            self._step = 0
            self._data.time = 0.0
            return self._refresh()
        return self._all_or_nothing(self._set_state_back)

    def step(self, steps: int, wanted: Callable[[], bool] = lambda: True) -> WorldState:
        """Move time by whole steps, as long as the caller still wants it. Raises Cancelled, Diverged."""
        self._refuse_if_frozen()
        if steps < 1:
            raise InvalidRequest("steps: must be at least 1")
        _refuse_too_many(steps)
        return self._all_or_nothing(lambda: self._run(steps, wanted))

    def prepare(
        self, values: Mapping[str, float], settle_ns: int, wanted: Callable[[], bool] = lambda: True
    ) -> WorldState:
        """Reset everything, set parameters (the others to their defaults), and let time settle."""
        self._check(values)
        if settle_ns < 0:
            raise InvalidRequest(f"settle_ns: {settle_ns} is negative")
        steps = -(-settle_ns // self.world.timestep_ns)
        _refuse_too_many(steps)

        def prepared() -> None:
            self._set_back({**self._defaults, **values})
            self._run(steps, wanted)

        return self._all_or_nothing(prepared)

    def _check(self, values: Mapping[str, float]) -> None:
        self._refuse_unknown(values)
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

    def _refuse_unknown(self, names: Iterable[str]) -> None:
        unknown = [name for name in names if name not in self._defaults]
        if unknown:
            known = ", ".join(self._defaults) or "none"
            raise InvalidRequest(f"unknown parameter {', '.join(unknown)}; parameters of this world: {known}")

    def _refuse_if_frozen(self) -> None:
        if self._frozen is not None:
            raise Diverged(self._frozen)

    def _all_or_nothing(self, change: Callable[[], None]) -> WorldState:
        """Carry out a change; undo it if it is refused, freeze the simulation if it diverges."""
        before = np.empty(mujoco.mj_stateSize(self._model, INTEGRATION))
        mujoco.mj_getState(self._model, self._data, before, INTEGRATION)
        raw = [(s, s.get(self._model, self._data)) for s in self._model_settings()]
        values, step, frozen = dict(self._values), self._step, self._frozen
        try:
            change()
        except Exception:
            for setting, value in raw:
                setting.put(self._model, self._data, value)
            mujoco.mj_setState(self._model, self._data, before, INTEGRATION)
            self._values, self._step, self._frozen = values, step, frozen
            mujoco.mj_forward(self._model, self._data)
            raise
        return self._refresh()

    def _model_settings(self) -> list[Setting]:
        """The settings that the state of the data does not hold."""
        return [b.setting for binds in self.world.binds.values() for b in binds if b.setting.edits_model]

    def _set_back(self, values: Mapping[str, float]) -> None:
        """Where the session began, with these parameters; edits of the model are undone by setting them anew."""
        mujoco.mj_resetData(self._model, self._data)
        self._step = 0
        self._frozen = None
        self._apply(values)

    def _set_state_back(self) -> None:
        time = self._data.time
        mujoco.mj_resetData(self._model, self._data)
        self._data.time = time
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
        left = steps
        while left > 0 and not self._diverged():
            if not wanted():
                raise Cancelled("the caller went away; the step was undone")
            chunk = min(left, CHUNK)
            mujoco.mj_step(self._model, self._data, chunk)
            left -= chunk
            self._step += chunk

    def _diverged(self) -> bool:
        return any(self._data.warning[warning].number for warning in FATAL_WARNINGS)

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
        by_name = {r.device: r for bank in self.world.banks for r in bank.read(self._model, self._data)}
        return WorldState(
            step=self._step,
            time_ns=self._step * self.world.timestep_ns,
            readings=tuple(by_name[name] for name in self.world.description.devices),
            observations={name: o.measure(self._data) for name, o in self.world.observations.items()},
        )


def _refuse_too_many(steps: int) -> None:
    if steps > MAX_STEPS:
        raise LimitReached(f"{steps} steps in one call; the limit is {MAX_STEPS}")
