"""Values of message fields: defaults, checks at assignment, and copies, as rosidl_generator_py defines them.

Unlike rosidl's checks, numbers of a sequence of floats may be integers and numpy arrays may be assigned to sequences:
Jazzy converts both.
"""

from __future__ import annotations

import array
import copy
import math
from collections import UserList, UserString
from collections.abc import Callable, Sequence, Set
from typing import Any

import numpy

from sitaf_ros.definitions import FLOATS, INTEGERS, STRINGS, Field, FieldType

TYPE_CODES = {
    "int8": "b",
    "uint8": "B",
    "int16": "h",
    "uint16": "H",
    "int32": "i",
    "uint32": "I",
    "int64": "q",
    "uint64": "Q",
    "float32": "f",
    "float64": "d",
}
FLOAT32_MAX = 3.402823466e38
PYTHON_TYPES = {"string": str, "wstring": str, "bool": bool, "byte": bytes}


def dtype(base: str) -> Any:
    """Return the numpy type of a number's type."""
    return numpy.dtype(base)


def zero(kind: FieldType, message_class: Callable[[str], Any]) -> Callable[[], Any]:
    """Return a function that makes the value of a field without a default."""
    single: Callable[[], Any]
    if kind.base in INTEGERS:
        single = int
    elif kind.base in FLOATS:
        single = float
    elif kind.base in STRINGS:
        single = str
    elif kind.base == "bool":
        single = bool
    elif kind.base == "byte":
        single = _zero_byte
    else:
        single = message_class(kind.base)
    if kind.array is None:
        return single
    if kind.array == "fixed":
        size = kind.size
        if kind.is_number:
            number = dtype(kind.base)
            return lambda: numpy.zeros(size, dtype=number)
        return lambda: [single() for _ in range(size)]
    if kind.is_number:
        code = TYPE_CODES[kind.base]
        return lambda: array.array(code)
    return list


def _zero_byte() -> bytes:
    return b"\0"


def default(field: Field, message_class: Callable[[str], Any]) -> Callable[[], Any]:
    """Return a function that makes the value of a field that is not named."""
    if field.default is None:
        return zero(field.type, message_class)
    value: Any = field.default
    if field.type.array is None:
        return lambda: value
    if not field.type.is_number:
        return lambda: list(value)
    if field.type.array == "fixed":
        number = dtype(field.type.base)
        return lambda: numpy.array(value, dtype=number)
    code = TYPE_CODES[field.type.base]
    return lambda: array.array(code, value)


def checked(name: str, kind: FieldType, message_class: Callable[[str], Any]) -> Callable[[Any], Any]:
    """Return a function that checks a value for a field and returns what is stored."""
    single = _single(name, kind, message_class)
    return single if kind.array is None else _many(name, kind, single)


def _single(name: str, kind: FieldType, message_class: Callable[[str], Any]) -> Callable[[Any], Any]:
    base, bound = kind.base, kind.string_bound
    if base in INTEGERS:
        low, high = INTEGERS[base]

        def integer(value: Any) -> Any:
            if isinstance(value, numpy.integer):
                value = int(value)  # as Jazzy's conversion to C does
            _require(isinstance(value, int), name, "int", value)
            if not low <= value <= high:
                unsigned = "an unsigned integer" if low == 0 else "an integer"
                raise AssertionError(f"The '{name}' field must be {unsigned} in [{low}, {high}], not {value}")
            return value

        return integer
    if base in FLOATS:

        def real(value: Any) -> Any:
            _require(isinstance(value, float), name, "float", value)
            if base == "float32" and abs(value) > FLOAT32_MAX and not math.isinf(value):
                raise AssertionError(f"The '{name}' field must be a float in [{-FLOAT32_MAX}, {FLOAT32_MAX}]")
            return value

        return real
    if base == "byte":

        def byte(value: Any) -> Any:
            if not (isinstance(value, bytes | bytearray) and len(value) == 1):
                raise AssertionError(f"The '{name}' field must be of type 'bytes' or 'ByteString' of length 1")
            return value

        return byte
    wanted = PYTHON_TYPES.get(base)

    def instance(value: Any) -> Any:
        cls = wanted or message_class(base)
        _require(isinstance(value, cls), name, cls.__name__, value)
        if bound is not None and len(value) > bound:
            raise AssertionError(f"The '{name}' field must be string value not longer than {bound}")
        return value

    return instance


def _require(holds: bool, name: str, wanted: str, value: Any) -> None:
    if not holds:
        raise AssertionError(f"The '{name}' field must be of type '{wanted}', not '{type(value).__name__}'")


def _many(name: str, kind: FieldType, single: Callable[[Any], Any]) -> Callable[[Any], Any]:
    code = TYPE_CODES.get(kind.base)
    number = dtype(kind.base) if kind.is_number else None
    fixed = kind.array == "fixed"

    def length(value: Any) -> None:
        if (fixed and len(value) != kind.size) or (kind.array == "bounded" and len(value) > kind.size):
            must = f"with length {kind.size}" if fixed else f"with at most {kind.size} elements"
            raise AssertionError(f"The '{name}' field must be a set or sequence {must}, not {len(value)}")

    def many(value: Any) -> Any:
        if isinstance(value, array.array) and code is not None and not fixed:
            if value.typecode != code:
                raise AssertionError(f"The '{name}' array.array() must have the type code of '{code}'")
            length(value)
            return value
        if isinstance(value, numpy.ndarray):
            if value.ndim != 1 and fixed:
                raise AssertionError(f"The '{name}' numpy.ndarray() must have one dimension, not {value.ndim}")
            if number is not None and value.dtype == number:
                length(value if fixed else value.reshape(-1))
                return value if fixed else array.array(code or "", value.tobytes())
            value = value.reshape(-1).tolist()
        if not isinstance(value, Sequence | Set | UserList) or isinstance(value, str | UserString):
            raise AssertionError(f"The '{name}' field must be a set or sequence, not '{type(value).__name__}'")
        length(value)
        if code is None:
            return [single(item) for item in value]
        try:
            packed = array.array(code, value)
        except (TypeError, OverflowError) as e:
            wanted = f"an integer in {list(INTEGERS[kind.base])}" if kind.base in INTEGERS else "'float'"
            raise AssertionError(f"The '{name}' field must be a set or sequence and each value {wanted}: {e}") from e
        return numpy.array(packed, dtype=number) if fixed else packed

    return many


def copier(kind: FieldType) -> Callable[[Any], Any] | None:
    """Return a function that copies a field's value; None where values never change."""
    if kind.array is None:
        return None if kind.is_primitive else lambda value: value.copy_message()
    if kind.is_primitive:
        return copy.copy
    return lambda value: [item.copy_message() for item in value]
