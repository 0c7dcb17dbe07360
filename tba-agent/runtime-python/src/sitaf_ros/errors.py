"""Errors that the test application sees."""

from __future__ import annotations


class RosLoadError(Exception):
    """The sources of a node use what is not available, or cannot be loaded; one line for each problem."""

    def __init__(self, problems: list[str]) -> None:
        super().__init__("\n".join(problems))
        self.problems = tuple(problems)


class NodeError(Exception):
    """A node failed: `callback NAME: TYPE: TEXT`, or `main` or `thread NAME` in place of the callback."""

    def __init__(self, where: str, cause: BaseException) -> None:
        text = str(cause)
        super().__init__(f"{where}: {type(cause).__name__}" + (f": {text}" if text else ""))
        self.callback = where
        self.cause = cause


def is_regular_end(e: BaseException) -> bool:
    """Tell whether a spin ended because the node itself shut its context down."""
    return type(e).__name__ in ("ExternalShutdownException", "ROSInterruptException")
