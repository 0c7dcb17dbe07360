"""Kind `contact`: a bumper, which detects forces on its geom."""

from collections.abc import Sequence
from dataclasses import dataclass

import mujoco
import numpy as np

from sitaf_bridge.world.description.yaml_block import Block, Problems
from sitaf_bridge.world.devices.binding import find, find_all
from sitaf_bridge.world.devices.kind import DeviceDeclaration, DeviceKind, Reading


@dataclass(frozen=True)
class ContactDeclaration(DeviceDeclaration):
    """`threshold` is the force in newtons above which the bumper counts as pressed."""

    geom: str
    threshold: float


class ContactKind(DeviceKind):
    """Kind `contact`."""

    name = "contact"
    truths = True

    def declare(self, name: str, block: Block) -> ContactDeclaration | None:
        """Keys `geom`, `threshold`."""
        geom, threshold = block.text("geom"), block.optional_number("threshold", 0.0)
        if geom is None or threshold is None:
            return None
        if threshold < 0:
            block.problem(f"{block.path}.threshold: {threshold:g} N is negative", "threshold")
            return None
        return ContactDeclaration(name, self.name, block.line, geom, threshold)

    def bind(
        self, model: mujoco.MjModel, declarations: Sequence[DeviceDeclaration], problems: Problems
    ) -> "ContactBank":
        """Find the geoms."""

        def geom_of(declaration: DeviceDeclaration) -> int:
            assert isinstance(declaration, ContactDeclaration)  # noqa: S101
            return find(model, "geom", declaration.geom)

        return ContactBank(find_all(declarations, problems, geom_of))

    def fields(self, declaration: DeviceDeclaration) -> tuple[str, ...]:
        """Whether it is pressed, and the force."""
        return ("pressed", "force")


class ContactBank:
    """All bumpers of a world."""

    def __init__(self, devices: Sequence[tuple[DeviceDeclaration, int]]) -> None:
        self._devices = tuple(devices)

    def read(self, model: mujoco.MjModel, data: mujoco.MjData) -> Sequence[Reading]:
        """The normal forces at the current step."""
        return [Reading(d, _pressed(d, contact_force(model, data, geom))) for d, geom in self._devices]


def _pressed(declaration: DeviceDeclaration, force: float) -> tuple[float, ...]:
    assert isinstance(declaration, ContactDeclaration)  # noqa: S101
    return (1.0 if force > declaration.threshold else 0.0, force)


def contact_force(model: mujoco.MjModel, data: mujoco.MjData, geom: int) -> float:
    """The sum of the normal forces on a geom, in newtons."""
    total, force = 0.0, np.empty(6)
    if data.ncon:
        pairs = data.contact.geom
        for contact in np.flatnonzero((pairs == geom).any(axis=1)).tolist():
            mujoco.mj_contactForce(model, data, contact, force)
            total += float(force[0])
    return total
