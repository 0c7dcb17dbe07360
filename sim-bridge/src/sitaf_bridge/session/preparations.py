"""Notices when a component resets its own world, so that it cannot replace the signals of its case."""

from sitaf_bridge.errors import InvalidRequest, LimitReached

MAX_CASES = 100_000


class Preparations:
    """How often a session was prepared for each case. A test application prepares each of its cases once."""

    def __init__(self) -> None:
        self._current = 0
        self._counts: dict[int, int] = {}

    def prepared(self, no: int) -> None:
        """The world was prepared for a case; 0 if the caller has no cases. Raises LimitReached."""
        if no not in self._counts and len(self._counts) >= MAX_CASES:
            raise LimitReached(f"case_no: the session was prepared for {MAX_CASES} cases, which is the limit")
        self._current = no
        self._counts[no] = self._counts.get(no, 0) + 1

    def reset(self) -> None:
        """The world was reset or restored in another way."""
        self._counts[self._current] = self._counts.get(self._current, 0) + 1

    def check(self, no: int) -> None:
        """Raise InvalidRequest unless the world was prepared for this case, once, and not reset since."""
        if self._current != no:
            raise InvalidRequest(
                f"case_no: the world was prepared for case {self._current}, not for case {no}; "
                "the component may have reset the simulation"
            )
        count = self._counts.get(no, 0)
        if count != 1:
            raise InvalidRequest(
                f"case_no: the world was reset {count} times in case {no} instead of once; "
                "the component may have reset the simulation"
            )
