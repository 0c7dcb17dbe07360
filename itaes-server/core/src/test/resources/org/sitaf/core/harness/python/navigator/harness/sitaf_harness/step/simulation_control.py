"""Simulation control (SC): the activity names no world."""


class SimulationControl:
    """Has nothing to prepare."""

    def prepare(self) -> None:
        """Leave all as it is."""
