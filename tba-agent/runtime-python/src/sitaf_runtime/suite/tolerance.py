"""How far an actual number may lie from the expected one."""

import math
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Tolerance:
    """`|actual - expected| <= absolute + relative * |expected|`, or at most `ulps` representable numbers apart.

    `absolute` is in the unit of the output; all are 0 or more.
    """

    absolute: float = 0.0
    relative: float = 0.0
    ulps: int = 0

    def __post_init__(self) -> None:
        if not (self.absolute >= 0 and self.relative >= 0 and self.ulps >= 0):
            raise ValueError(f"a tolerance is 0 or more, not {self}")

    @property
    def is_exact(self) -> bool:
        """Whether no difference is tolerated."""
        return self.absolute == 0 and self.relative == 0 and self.ulps == 0

    def allowed(self, expected: float, *, single: bool = False) -> float:
        """The largest difference from an expected value that passes; `single` for numbers of 32 bits."""
        allowed = self.absolute + self.relative * abs(expected)
        if not self.ulps:
            return allowed
        return max(allowed, self.ulps * (_ulp_of_single(expected) if single else math.ulp(expected)))


EXACT = Tolerance()


def _ulp_of_single(value: float) -> float:
    """The distance to the next number of 32 bits, away from 0."""
    exponent = max(math.frexp(abs(value))[1], -125)
    return math.ldexp(1.0, exponent - 24)
