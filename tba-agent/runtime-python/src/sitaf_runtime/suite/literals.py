"""Literals of values (docs/test-application.md, Values).

Numbers in decimal, `NaN`, `Infinity` and `-Infinity`, `true` and `false`, strings without quotes, sequences as
`[1.0, 2.5]` and structs as `{x: 1.0, y: 2.5}`, with nested strings in double quotes.
"""

import dataclasses
import enum
import math
import re
import struct as binary
from collections.abc import Iterable, Mapping
from decimal import Decimal
from typing import Any

from sitaf_runtime.errors import CaseDataError

_NUMBER = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]{1,9})?", re.ASCII)
_SPECIAL = {
    **dict.fromkeys(("nan", ".nan"), math.nan),
    **dict.fromkeys(("infinity", "+infinity", "inf", "+inf", ".inf"), math.inf),
    **dict.fromkeys(("-infinity", "-inf", "-.inf"), -math.inf),
}
_FEW_DIGITS = 30


def real(literal: str) -> float:
    """A floating-point number."""
    text = literal.strip()
    if _NUMBER.fullmatch(text):
        return float(text)
    special = _SPECIAL.get(text.lower())
    if special is None:
        raise CaseDataError(f"'{literal}' is not a number")
    return special


def whole(literal: str, low: int, high: int) -> int:
    """An integer within bounds, both inclusive."""
    text = literal.strip()
    if text.isascii() and text.isdigit() and len(text) < _FEW_DIGITS:
        number = int(text)
    elif _NUMBER.fullmatch(text):
        # A Decimal, because expanding 1e999999999 would exhaust memory.
        number = Decimal(text)
        if number != number.to_integral_value():
            raise CaseDataError(f"'{literal}' is not a whole number")
    else:
        raise CaseDataError(f"'{literal}' is not a number")
    if not low <= number <= high:
        raise CaseDataError(f"{literal} is outside of {low} to {high}")
    return int(number)


def boolean(literal: str) -> bool:
    """`true` or `false`."""
    text = literal.strip()
    if text in ("true", "1"):
        return True
    if text in ("false", "0"):
        return False
    raise CaseDataError(f"'{literal}' is neither true nor false")


def character(literal: str) -> str:
    """One character."""
    if len(literal) != 1:
        raise CaseDataError(f"'{literal}' is not one character")
    return literal


def elements(literal: str) -> list[str]:
    """The elements of `[a, b]`, strings without their quotes."""
    return _parts(literal, "[", "]", "a sequence such as [1, 2]")


def members(literal: str) -> dict[str, str]:
    """The members of `{x: 1, y: 2}` by name."""
    found: dict[str, str] = {}
    for part in _parts(literal, "{", "}", "a struct such as {x: 1.0, y: 2.0}", whole=True):
        name, colon, value = part.partition(":")
        if not colon:
            raise CaseDataError(f"'{literal}' has a member without a name")
        found[name.strip()] = _unquoted(value.strip())
    return found


def _parts(literal: str, opening: str, closing: str, what: str, *, whole: bool = False) -> list[str]:
    """Split at the commas that are not within quotes or brackets; `whole` keeps the quotes."""
    text = literal.strip()
    if len(text) < 2 or text[0] != opening or text[-1] != closing:
        raise CaseDataError(f"'{literal}' is not {what}")
    inner = text[1:-1]
    parts: list[str] = []
    start = depth = at = 0
    quoted = False
    while at < len(inner):
        c = inner[at]
        if quoted and c == "\\":
            at += 1
        elif c == '"':
            quoted = not quoted
        elif not quoted and c in "[{":
            depth += 1
        elif not quoted and c in "]}":
            depth -= 1
        elif not quoted and depth == 0 and c == ",":
            parts.append(inner[start:at])
            start = at + 1
        at += 1
    if quoted:
        raise CaseDataError(f"'{literal}' has a quote that is not closed")
    if parts or inner[start:].strip():
        parts.append(inner[start:])
    return [part.strip() if whole else _unquoted(part.strip()) for part in parts]


def _unquoted(part: str) -> str:
    if len(part) >= 2 and part[0] == part[-1] == '"':
        return re.sub(r"\\(.)", r"\1", part[1:-1], flags=re.DOTALL)
    return part


def write(value: Any) -> str:
    """The literal of a value."""
    value = plain(value)
    if value is None:
        return "null"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, enum.Enum):
        return value.name
    if isinstance(value, float):
        return _write_real(value)
    if isinstance(value, str):
        return value
    members = members_of(value)
    if members is not None:
        return "{" + ", ".join(f"{name}: {_write_nested(member)}" for name, member in members.items()) + "}"
    listed = elements_of(value)
    if listed is not None:
        return "[" + ", ".join(map(_write_nested, listed)) + "]"
    return str(value)


class Single(float):
    """A number of 32 bits."""

    __slots__ = ()


def single(value: float) -> float:
    """The nearest number of 32 bits."""
    try:
        return binary.unpack("<f", binary.pack("<f", value))[0]
    except OverflowError:
        return math.inf if value > 0 else -math.inf


def _write_real(value: float) -> str:
    """The shortest text that is read back as the same number.

    In decimal notation from 1e-3 to below 1e7, otherwise with an exponent: `100000.0`, `1.0E7`.
    """
    if math.isnan(value):
        return "NaN"
    if math.isinf(value):
        return "Infinity" if value > 0 else "-Infinity"
    text = _shortest_single(value) if isinstance(value, Single) else repr(float(value))
    if value == 0 or 1e-3 <= abs(value) < 1e7:
        return text
    sign, digits, exponent = Decimal(text).normalize().as_tuple()
    fraction = "".join(map(str, digits[1:])) or "0"
    return f"{'-' if sign else ''}{digits[0]}.{fraction}E{int(exponent) + len(digits) - 1}"


def _shortest_single(value: float) -> str:
    for precision in range(6, 9):
        text = repr(float(f"{value:.{precision}g}"))
        if single(float(text)) == value:
            return text
    return repr(float(f"{value:.9g}"))


def _write_nested(value: Any) -> str:
    if isinstance(value, str) and not isinstance(value, enum.Enum):
        return '"' + value.replace("\\", "\\\\").replace('"', '\\"') + '"'
    return write(value)


def plain(value: Any) -> Any:
    """A value of numpy converted to one of Python; anything else unchanged."""
    return value.tolist() if hasattr(value, "tolist") and hasattr(value, "dtype") else value


NAME = "document_name"
"""The key of a field's name in documents, in its metadata; present where the field has another name."""


def name_of(field: dataclasses.Field[Any]) -> str:
    """The name of a dataclass's field in documents."""
    name = field.metadata.get(NAME)
    return name if isinstance(name, str) else field.name


def members_of(value: Any) -> Mapping[str, Any] | None:
    """The members of a struct: of a dataclass, a mapping or a named tuple; None for anything else."""
    if isinstance(value, Mapping):
        return {str(name): part for name, part in value.items()}
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        return {name_of(field): getattr(value, field.name) for field in dataclasses.fields(value)}
    if isinstance(value, tuple) and hasattr(value, "_asdict"):
        return value._asdict()  # pyright: ignore[reportAttributeAccessIssue]
    return None


def elements_of(value: Any) -> list[Any] | None:
    """The elements of an iterable; None for strings, structs and anything else."""
    if isinstance(value, str) or not isinstance(value, Iterable) or members_of(value) is not None:
        return None
    return list(value)
