"""Compares devices that are not simulated with the world, before a test runs."""

from collections.abc import Collection, Mapping, Sequence
from difflib import get_close_matches
from typing import cast

from sitaf_hardware.wire import hardware_pb2 as pb

from sitaf_bridge.errors import InvalidRequest, Unavailable
from sitaf_bridge.hardware.client import CommandRefused, ProviderClient, ProviderLost
from sitaf_bridge.hardware.live import Backend
from sitaf_bridge.world.devices import KINDS, DeviceDeclaration
from sitaf_bridge.world.devices.kind import ActuatorBank, Limits
from sitaf_bridge.world.devices.units import unit_of
from sitaf_bridge.world.sensing.fault_names import is_fault, split
from sitaf_bridge.world.world import World

# What parameters set that only cameras can measure, or that acts between a device and the component.
WITHOUT_EFFECT = ("light.", "device.")
LEVEL = ".level"
# The numbers of a command by its form, where the world does not limit each.
COMMANDS = {"drive": ("linear", "angular"), "gripper": ("width",), "level": ("level",)}


def check(
    world: World, backends: Mapping[str, Backend], guard: ProviderClient | None, parameters: Collection[str]
) -> Sequence[str]:
    """What serves each device. Raises InvalidRequest with one line for each problem, Unavailable."""
    described: dict[str, pb.DeviceDescription] = {}
    provider = ""
    if guard is not None:
        try:
            answer = guard.describe()
        except (ProviderLost, CommandRefused) as error:
            raise Unavailable(str(error)) from error
        described = {device.name: device for device in answer.devices}
        provider = guard.address
    problems: list[str] = []
    texts: list[str] = []
    for name, backend in backends.items():
        device = world.description.devices.get(name)
        if device is None:
            near = get_close_matches(name, world.description.devices, 1)
            hint = f"; did you mean {near[0]}?" if near else ""
            problems.append(f"hardware.{name}: the world has no such device{hint}")
            continue
        if KINDS[device.kind].image:
            problems.append(f"hardware.{name}: is a camera, which can only be simulated")
            continue
        settable: Sequence[str] = ()
        if backend.recorded is None:
            found = described.get(name)
            if found is None:
                problems.append(f"hardware.{name}: the provider at {provider} has no such device")
                continue
            problems += [f"hardware.{name}: {problem}" for problem in _differences(world, device, found)]
            settable = found.parameters
        problems += _parameters(world, backend, parameters, settable)
        what = (
            "a recording"
            if backend.recorded is not None
            else "a real device" + (" as shadow" if backend.shadow else "")
        )
        texts.append(f"{name}: {what}")
    if problems:
        raise InvalidRequest("\n".join(problems))
    return texts


def _differences(world: World, device: DeviceDeclaration, found: pb.DeviceDescription) -> list[str]:
    """How a device of a provider differs from the world's."""
    if found.kind != device.kind:
        return [f"the provider's device is of the kind {found.kind or 'none'}, but the world declares a {device.kind}"]
    fields = KINDS[device.kind].fields(device)
    names = [field.name for field in found.fields]
    if names != list(fields):
        return [f"the provider's readings have {_list(names)}, but those of the world have {_list(fields)}"]
    problems = [_unit(world, device, number) for number in found.fields]
    wanted = commands_of(world, device)
    if wanted:
        taken = {number.name for number in found.commands}
        missing = [name for name in wanted if name not in taken]
        if missing:
            problems.append(f"the provider's device takes {_list(sorted(taken))}, but the world sends {_list(missing)}")
        problems += [_unit(world, device, number) for number in found.commands if number.name in wanted]
    return [problem for problem in problems if problem]


def commands_of(world: World, device: DeviceDeclaration) -> Mapping[str, Limits]:
    """The numbers in a command of a device of a world, with their limits; none for a sensor."""
    form = KINDS[device.kind].takes
    if form is None:
        return {}
    bank = cast(ActuatorBank, world.banks[device.kind])
    return bank.accepts(world.model, device.name).numbers


def _unit(world: World, device: DeviceDeclaration, number: pb.Number) -> str:
    unit = unit_of(world.model, device, number.name)
    if number.unit == unit:
        return ""
    return f"the provider gives {number.name} in {number.unit or 'no unit'}, but the world in {unit}"


def _list(names: Sequence[str]) -> str:
    shown = ", ".join(names[:20]) or "no numbers"
    return shown + (f" and {len(names) - 20} more" if len(names) > 20 else "")


def _parameters(world: World, backend: Backend, parameters: Collection[str], settable: Sequence[str]) -> list[str]:
    """Parameters that the test sets, but that this device would not follow."""
    problems: list[str] = []
    for unknown in backend.independent_of:
        if unknown not in world.description.parameters:
            known = ", ".join(world.description.parameters) or "none"
            problems.append(
                f"hardware.{backend.device}.independent_of: the world has no parameter {unknown!r}; it has {known}"
            )
    for name in parameters:
        if is_fault(name):
            fault = split(name)
            if fault.device == backend.device and fault.kind == "saturated" and not backend.shadow:
                problems.append(
                    f"hardware.{backend.device}: a test sets {name}, which only a simulated actuator can have"
                )
            continue
        if name in settable or name in backend.independent_of or name not in world.description.parameters:
            continue
        paths = [bind.path for bind in world.description.parameters[name].binds]
        own_level = f"device.{backend.device}{LEVEL}"
        if all(path.startswith(WITHOUT_EFFECT) and path != own_level for path in paths):
            continue
        problems.append(
            f"hardware.{backend.device}: a test sets {name}, which the device cannot follow, because its "
            + ("recording does not change" if backend.recorded is not None else f"provider declares no set for {name}")
            + f"; write independent_of: [{name}] if the readings do not depend on it"
        )
    return problems
