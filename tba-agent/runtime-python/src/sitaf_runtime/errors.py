"""Errors that are not those of the component under test."""


class CannotRunError(Exception):
    """The suite cannot run or cannot continue, for example because a class is missing or the simulator is lost.

    The process ends with exit code 3. Failures of the component under test are results of cases and never raise this.
    The message says what is missing and what the user can do.
    """


class CaseDataError(ValueError):
    """A suite or a value of a case cannot be read; the message says which and why."""


class SimulationError(Exception):
    """A call to the simulator failed.

    `lost` is true when the simulator or the session is lost, so that no further case can run. Otherwise the simulator
    rejected one request, and the next may succeed. `diverged` is true when the simulation of the case has diverged.
    """

    def __init__(self, message: str, *, lost: bool = False, diverged: bool = False) -> None:
        super().__init__(message)
        self.lost = lost
        self.diverged = diverged
