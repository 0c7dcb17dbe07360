"""Compares the value of an output with the literal that is expected.

- Numbers compare as numbers within the tolerance: `-1` equals `-1.0`. NaN equals NaN, an infinity only itself, and a
  tolerance never makes an infinity of a finite number.
- For a `float` of 32 bits the expected number is first rounded to one.
- Sequences compare element by element, structs member by member; strings and truth values have no tolerance.
"""

import enum
import math
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from sitaf_runtime.suite import literals
from sitaf_runtime.suite.kinds import FLOAT32, Single
from sitaf_runtime.suite.tolerance import Tolerance


def difference(expected: str, actual: Any, tolerance: Tolerance) -> str | None:
    """The first difference in words, such as `[3]: expected 1.0, but was 1.1`; None when all is as expected.

    Raises CaseDataError.
    """
    if actual is None:
        return None if expected == "null" else f"expected {expected}, but was null"
    if isinstance(actual, bool):
        return None if literals.truth(expected) == actual else _unequal(expected, actual)
    if isinstance(actual, float):
        return _real(expected, actual, tolerance)
    if isinstance(actual, int) and not isinstance(actual, enum.Enum):
        return _whole(expected, actual, tolerance)
    members = literals.members_of(actual)
    if members is not None:
        return _struct(literals.members(expected), members, tolerance)
    elements = literals.elements_of(actual)
    if elements is not None:
        return _sequence(literals.elements(expected), elements, tolerance)
    return None if literals.spell(actual) == expected else _unequal(expected, actual)


def _sequence(expected: list[str], actual: list[Any], tolerance: Tolerance) -> str | None:
    for i, (wanted, got) in enumerate(zip(expected, actual, strict=False)):
        apart = difference(wanted, got, tolerance)
        if apart:
            return _within(f"[{i}]", apart)
    if len(expected) == len(actual):
        return None
    return f"expected {len(expected)} elements, but there are {len(actual)}"


def _struct(expected: dict[str, str], actual: Mapping[str, Any], tolerance: Tolerance) -> str | None:
    for name, wanted in expected.items():
        if name not in actual:
            return _within(f".{name}", f"expected {wanted}, but there is none")
        apart = difference(wanted, actual[name], tolerance)
        if apart:
            return _within(f".{name}", apart)
    return None


def _within(step: str, apart: str) -> str:
    return step + apart if apart.startswith((".", "[")) else f"{step}: {apart}"


def _real(literal: str, actual: float, tolerance: Tolerance) -> str | None:
    single = isinstance(actual, Single)
    expected = FLOAT32.parse(literal) if single else literals.real(literal)
    if expected == actual or (math.isnan(expected) and math.isnan(actual)):
        return None
    if not (math.isfinite(expected) and math.isfinite(actual)):
        return _unequal(literal, actual)
    allowed = tolerance.allowed(expected, single=single)
    apart = abs(actual - expected)
    return None if apart <= allowed else _outside(literal, actual, apart, allowed, tolerance)


def _whole(literal: str, actual: int, tolerance: Tolerance) -> str | None:
    if not math.isfinite(literals.real(literal)):
        return _unequal(literal, actual)
    expected = literals.exact(literal)
    apart = abs(actual - expected)
    allowed = Fraction(tolerance.absolute) + Fraction(tolerance.relative) * abs(expected)
    return None if apart <= allowed else _outside(literal, actual, float(apart), float(allowed), tolerance)


def _outside(literal: str, actual: float, apart: float, allowed: float, tolerance: Tolerance) -> str:
    text = f"expected {literal}, but was {literals.spell(actual)}"
    return text if tolerance.is_exact else f"{text} (differs by {apart}, allowed {allowed})"


def _unequal(expected: str, actual: Any) -> str:
    bare = isinstance(actual, bool | int | float) and not isinstance(actual, enum.Enum)
    spelled = literals.spell(actual)
    return f"expected {expected}, but was {spelled}" if bare else f"expected '{expected}', but was '{spelled}'"
