"""Simulation control (SC).

Sets up the virtual environment world/ir.world.yaml.
"""

from sitaf_runtime.simulation.session import Simulation

# Simulation time before the call, in seconds.
SETTLE = 0.0


class SimulationControl:
    """Sets up the world of each case."""

    def __init__(self, simulation: Simulation) -> None:
        self._simulation = simulation

    def prepare(self, distance: float) -> None:
        """Reset the world, set the parameters of a case, and let the world settle.

        distance in m, from -1.0 to 20.0.
        """
        parameters = {"Distance": distance}
        self._simulation.prepare(parameters, SETTLE)
