"""Errors outside of the component under test."""


class CannotRunError(Exception):
    """The suite cannot be run at all, or cannot continue: a class is missing, the simulator is lost.

    The process ends with exit code 3; nothing that a component under test does wrong belongs here. The message says
    what is missing and what to do, for a person.
    """


class CaseDataError(ValueError):
    """A suite or a value of a case cannot be read; the message says which and why."""


class SimulationError(Exception):
    """The simulator did not do what it was asked to.

    `lost` tells whether the simulator or the session is gone, so that no further case can run; otherwise it refused one
    request, and the next may succeed.
    """

    def __init__(self, message: str, *, lost: bool = False) -> None:
        super().__init__(message)
        self.lost = lost
