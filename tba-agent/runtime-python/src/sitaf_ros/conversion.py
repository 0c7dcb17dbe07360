"""Messages from and to plain values: nested dictionaries, lists, numbers and strings."""

from __future__ import annotations

import array
from collections.abc import Mapping
from typing import Any

import numpy

from sitaf_ros.definitions import FLOATS, INTEGERS, STRINGS, FieldType
from sitaf_ros.messages import Message, MessageClasses


def from_fields(classes: MessageClasses, name: str, fields: Mapping[str, Any] | Message) -> Any:
    """Make a message; fields that are not named have their defaults, numbers are converted to the field's type."""
    if isinstance(fields, Message):
        return fields.copy_message()
    cls = classes.message(name)
    known = {field.name: field.type for field in cls._definition.fields}
    for field in fields:
        if field not in known:
            raise ValueError(f"{name} has no field `{field}`; it has {', '.join(known)}")
    try:
        return cls(**{field: _value(classes, known[field], value) for field, value in fields.items()})
    except (AssertionError, TypeError, OverflowError) as e:
        raise ValueError(f"{name}: {e}") from e


def _value(classes: MessageClasses, kind: FieldType, value: Any) -> Any:
    if kind.array is None:
        return _single(classes, kind, value)
    if isinstance(value, array.array | numpy.ndarray):
        return value
    if isinstance(value, bytes | bytearray) and kind.base != "byte":
        return bytes(value)
    items = [_single(classes, kind, item) for item in value]
    if kind.array == "fixed" and len(items) < kind.size:
        zero = [0] * (kind.size - len(items)) if kind.is_number else []
        items += zero
    return items


def _single(classes: MessageClasses, kind: FieldType, value: Any) -> Any:
    if kind.base in FLOATS:
        return float(value)
    if kind.base in INTEGERS:
        return int(value)
    if kind.base in STRINGS:
        return str(value)
    if kind.base == "bool":
        return bool(value)
    if kind.base == "byte":
        return value if isinstance(value, bytes) else bytes([int(value)])
    return from_fields(classes, kind.base, value)


def to_fields(message: Message, raw: bool = False) -> dict[str, Any]:
    """Return the fields as plain values; with `raw`, number arrays stay arrays."""
    return {name: _plain(getattr(message, name), raw) for name in message.get_fields_and_field_types()}


def _plain(value: Any, raw: bool) -> Any:
    if isinstance(value, Message):
        return to_fields(value, raw)
    if isinstance(value, array.array | numpy.ndarray):
        return value if raw else value.tolist()
    if isinstance(value, list):
        return [_plain(item, raw) for item in value]
    if isinstance(value, bytes | bytearray):
        return value[0] if len(value) == 1 else list(value)
    if isinstance(value, numpy.generic):
        return value.item()
    return value
