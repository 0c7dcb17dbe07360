"""How far an actual number may lie from the expected one."""

import math
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Tolerance:
    """`|actual - expected| <= absolute + relative * |expected| + ulp * u`, `u` from `expected` to the next number.

    `absolute` is in the unit of the output; all are 0 or more. A whole number has no units in the last place.
    """

    absolute: float = 0.0
    relative: float = 0.0
    ulp: float = 0.0

    def __post_init__(self) -> None:
        if not (self.absolute >= 0 and self.relative >= 0 and self.ulp >= 0):
            raise ValueError(f"a tolerance is 0 or more, not {self}")

    @property
    def is_exact(self) -> bool:
        """Whether no difference is tolerated."""
        return self.absolute == 0 and self.relative == 0 and self.ulp == 0

    def allowed(self, expected: float, *, single: bool = False) -> float:
        """The largest difference from an expected value that passes; `single` for numbers of 32 bits."""
        unit = _ulp_of_single(expected) if single else math.ulp(expected)
        return self.absolute + self.relative * abs(expected) + self.ulp * unit


EXACT = Tolerance()


def _ulp_of_single(value: float) -> float:
    """The distance to the next number of 32 bits, away from 0."""
    exponent = max(math.frexp(abs(value))[1], -125)
    return math.ldexp(1.0, exponent - 24)
