"""Out-parameters."""

from typing import Generic, TypeVar

T = TypeVar("T")


class Out(Generic[T]):
    """An out-parameter of a method under test: the component sets the value, the test driver reads it."""

    __slots__ = ("value",)

    def __init__(self, value: T | None = None) -> None:
        self.value: T | None = value

    def get(self) -> T | None:
        """The value that was set last; None when none was set."""
        return self.value

    def set(self, value: T) -> None:
        """Set the value."""
        self.value = value

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.value!r})"


class InOut(Out[T]):
    """An in-out-parameter with its input value."""

    __slots__ = ()
