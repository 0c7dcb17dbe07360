"""Simulation control (SC).

Sets the virtual environment that world/ir.world.yaml describes.
"""

from sitaf_runtime.simulation.session import Simulation

# Simulation time that passes before the call, in seconds.
SETTLE = 0.0


class SimulationControl:
    """Prepares the world of each case."""

    def __init__(self, simulation: Simulation) -> None:
        self._simulation = simulation

    def prepare(self, distance: float) -> None:
        """Put the world into the state of a case and let it settle.

        distance in m, from -1.0 to 20.0.
        """
        parameters = {"Distance": distance}
        self._simulation.prepare(parameters, SETTLE)
