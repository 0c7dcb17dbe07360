"""A compiled world: the model that sessions share, and the bound parameters, devices and observations."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from functools import cached_property

import mujoco

from sitaf_bridge.errors import BadWorld, Problem, UnreachableValue
from sitaf_bridge.world.additions import Additions, SpawnedEntity
from sitaf_bridge.world.compiler import compile_mjcf
from sitaf_bridge.world.description.declaration import START, Bind, Description, Parameter, read_description
from sitaf_bridge.world.description.mjcf_guard import check_mjcf
from sitaf_bridge.world.description.mjcf_limits import MAX_TIMESTEP_S, MIN_TIMESTEP_S
from sitaf_bridge.world.description.model_format import format_of
from sitaf_bridge.world.description.source import WorldSource
from sitaf_bridge.world.description.yaml_block import Problems
from sitaf_bridge.world.devices import KINDS, KNOBS, Bank, DeviceDeclaration
from sitaf_bridge.world.devices.camera import CameraDeclaration
from sitaf_bridge.world.observing import BoundObservation, find_observation
from sitaf_bridge.world.parameters.gap import BoundGap, find_gap
from sitaf_bridge.world.parameters.paths import find_setting
from sitaf_bridge.world.parameters.settings import NoSuchSetting, Setting
from sitaf_bridge.world.parameters.start import find_start, start_setting
from sitaf_bridge.world.robots.loading import SDF, load_robot


@dataclass(frozen=True)
class BoundBind:
    """A quantity that a parameter sets, and the gap that defines its value, if any."""

    setting: Setting
    gap: BoundGap | None


@dataclass(frozen=True)
class World:
    """Immutable and shared by sessions; `model` must not be modified.

    `banks` are keyed by kind of device. `entities` were spawned in addition to `source`.
    """

    source: WorldSource
    entities: tuple[SpawnedEntity, ...]
    description: Description
    digest: str
    model: mujoco.MjModel
    timestep_ns: int
    binds: Mapping[str, tuple[BoundBind, ...]]
    banks: Mapping[str, Bank]
    observations: Mapping[str, BoundObservation]
    # The keyframe in which a session begins; None for the model's initial state.
    start: int | None

    @property
    def edits_model(self) -> bool:
        """Whether a session needs its own copy of the model."""
        return any(bind.setting.edits_model for binds in self.binds.values() for bind in binds)

    @cached_property
    def bodies(self) -> tuple[str, ...]:
        """The names of all named bodies except the world itself."""
        names = (mujoco.mj_id2name(self.model, mujoco.mjtObj.mjOBJ_BODY, b) for b in range(1, self.model.nbody))
        return tuple(name for name in names if name)

    @cached_property
    def places_of_readings(self) -> tuple[int, ...]:
        """Where each device is in the readings of one bank after the other, in the order of declaration.

        Cameras have images instead.
        """
        devices = [d for d in self.description.devices.values() if not KINDS[d.kind].image]
        by_bank = sorted(devices, key=lambda device: list(self.banks).index(device.kind))
        return tuple(by_bank.index(device) for device in devices)

    def apply(self, model: mujoco.MjModel, data: mujoco.MjData, values: Mapping[str, float]) -> None:
        """Set direct parameters first, then solved ones, which depend on them; each in the order of declaration.

        Raises UnreachableValue.
        """
        ordered = [name for name in self.binds if name in values]
        for name in ordered:
            for bind in self.binds[name]:
                if bind.gap is None:
                    bind.setting.put(model, data, values[name])
        for name in ordered:
            for bind in self.binds[name]:
                if bind.gap is not None:
                    try:
                        bind.gap.solve(model, data, bind.setting, values[name])
                    except UnreachableValue as error:
                        raise UnreachableValue(f"parameter {name}: {values[name]:g}: {error}") from error


def load_world(source: WorldSource, entities: tuple[SpawnedEntity, ...] = ()) -> World:
    """Parse, check and compile a world. Raises BadWorld with every problem found, or LimitReached."""
    description = read_description(source)
    files = source.files_of_folder()
    shown = source.folder + description.mjcf
    additions = _additions(description, entities, files, source.folder)
    if description.whole is not None:
        model = compile_mjcf(description.mjcf, _whole(additions, description.mjcf), shown, additions)
    else:
        if format_of(description.mjcf, files[description.mjcf]) == "sdf":
            raise BadWorld([Problem(shown, None, SDF)])
        check_mjcf(description.mjcf, files, source.folder)
        model = compile_mjcf(description.mjcf, files, shown, additions)
    problems = Problems(source.description)
    world = World(
        source=source,
        entities=entities,
        description=description,
        digest=source.digest,
        model=model,
        timestep_ns=_timestep_ns(model, shown),
        binds=_binds(model, description, problems),
        start=find_start(model, description, problems),
        banks=bind_devices(model, description.devices.values(), problems),
        observations=_observations(model, description, problems),
    )
    problems.raise_if_any()
    return world


def _whole(additions: Additions, main: str) -> dict[str, bytes]:
    """The files of a world that consists of a URDF robot."""
    (model,) = (robot for robot in additions.robots if not robot.robot.name)
    return {main: model.text.encode()}


def _binds(model: mujoco.MjModel, description: Description, problems: Problems) -> dict[str, tuple[BoundBind, ...]]:
    """What parameters set. A start state comes first, because it would overwrite what other parameters set."""
    parameters = sorted(description.parameters.values(), key=lambda p: all(b.path != START for b in p.binds))
    return {p.name: _bind(model, description, p, problems) for p in parameters}


def _additions(
    description: Description, entities: tuple[SpawnedEntity, ...], files: Mapping[str, bytes], folder: str
) -> Additions:
    robots = [description.whole, *description.robots.values()] if description.whole else description.robots.values()
    cameras = [d for d in description.devices.values() if isinstance(d, CameraDeclaration)]
    return Additions(
        userdata=len(KNOBS) * len(description.devices),
        image=(max((c.width for c in cameras), default=0), max((c.height for c in cameras), default=0)),
        robots=tuple(load_robot(robot, files, folder, description.file) for robot in robots),
        entities=entities,
    )


def _timestep_ns(model: mujoco.MjModel, shown: str) -> int:
    timestep = float(model.opt.timestep)
    if not MIN_TIMESTEP_S <= timestep <= MAX_TIMESTEP_S:
        message = f"the timestep {timestep!r} s must be {MIN_TIMESTEP_S:g} to {MAX_TIMESTEP_S:g} s"
        raise BadWorld([Problem(shown, None, message)])
    nanoseconds = round(timestep * 1e9)
    if nanoseconds < 1 or nanoseconds / 1e9 != timestep:
        message = f"the timestep {timestep!r} s must be a whole number of nanoseconds, such as 0.002"
        raise BadWorld([Problem(shown, None, message)])
    return nanoseconds


def _bind(
    model: mujoco.MjModel, description: Description, parameter: Parameter, problems: Problems
) -> tuple[BoundBind, ...]:
    found: list[BoundBind] = []
    for bind in parameter.binds:
        where = f"parameters.{parameter.name}.bind: set: {bind.path}"
        try:
            bound = _bound(model, description, bind)
        except NoSuchSetting as error:
            problems.add(bind.line, f"{where}: {error}")
            continue
        if bound.gap is None and parameter.low < bound.setting.lowest:
            problems.add(
                bind.line,
                f"{where}: cannot be less than {bound.setting.lowest:g}, "
                f"but the range of {parameter.name} starts at {parameter.low:g}",
            )
        found.append(bound)
    return tuple(found)


def _bound(model: mujoco.MjModel, description: Description, bind: Bind) -> BoundBind:
    if bind.path == START:
        return BoundBind(start_setting(model, bind.choices), None)
    setting = find_setting(model, bind.path, description.devices)
    return BoundBind(setting, None if bind.gap is None else find_gap(model, bind.gap, setting))


def bind_devices(model: mujoco.MjModel, devices: Collection[DeviceDeclaration], problems: Problems) -> dict[str, Bank]:
    """The banks of these devices by kind."""
    return {
        name: kind.bind(model, [d for d in devices if d.kind == name], problems)
        for name, kind in KINDS.items()
        if any(d.kind == name for d in devices)
    }


def _observations(model: mujoco.MjModel, description: Description, problems: Problems) -> dict[str, BoundObservation]:
    found: dict[str, BoundObservation] = {}
    for name, observation in description.observations.items():
        try:
            found[name] = find_observation(model, description, observation)
        except NoSuchSetting as error:
            problems.add(observation.line, f"observations.{name}: {error}")
    return found
