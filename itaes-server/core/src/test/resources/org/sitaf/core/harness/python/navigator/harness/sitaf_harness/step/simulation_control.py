"""Simulation control (SC): not used, because the activity has no world."""


class SimulationControl:
    """Does nothing."""

    def prepare(self) -> None:
        """Do nothing."""
