"""Out-parameters."""

from typing import Generic, TypeVar

T = TypeVar("T")


class Out(Generic[T]):
    """An out-parameter of a method under test: the component puts the value in, the test driver takes it out."""

    __slots__ = ("value",)

    def __init__(self, value: T | None = None) -> None:
        self.value: T | None = value

    def get(self) -> T | None:
        """What was put in last; None when nothing was."""
        return self.value

    def set(self, value: T) -> None:
        """Put a value in."""
        self.value = value

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.value!r})"


class InOut(Out[T]):
    """A parameter that carries data both ways."""

    __slots__ = ()
