"""Literals of messages, by the field types that message classes declare.

Such as `double`, `sequence<string<5>, 3>`, `float[36]` and `package/Name`.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

from sitaf_runtime.errors import CaseDataError
from sitaf_runtime.suite import kinds, literals
from sitaf_runtime.suite.kinds import Kind

_BASES: dict[str, Kind[Any]] = {
    "boolean": kinds.BOOLEAN,
    "octet": kinds.UINT8,
    "byte": kinds.UINT8,
    "char": kinds.UINT8,
    "int8": kinds.INT8,
    "uint8": kinds.UINT8,
    "int16": kinds.INT16,
    "uint16": kinds.UINT16,
    "int32": kinds.INT32,
    "uint32": kinds.UINT32,
    "int64": kinds.INT64,
    "uint64": kinds.UINT64,
    "float": kinds.FLOAT32,
    "double": kinds.FLOAT64,
}
_SEQUENCE = re.compile(r"sequence<(.+?)(?:, ?\d+)?>")
_ARRAY = re.compile(r"(.+)\[(\d+)\]")
_PARTS = 2


class Fields:
    """Reads and writes values of message types; `class_of` gives the class of `package/msg/Name`."""

    def __init__(self, class_of: Callable[[str], Any]) -> None:
        self._class_of = class_of

    def members(self, type_: str) -> dict[str, str]:
        """The fields of a message type and their types; empty for any other type."""
        name = _full(type_)
        return dict(self._class_of(name).get_fields_and_field_types()) if name else {}

    def literal(self, type_: str, value: Any) -> str:
        """The literal of a value, a message as a nested dictionary."""
        return literals.write(self._shaped(type_, value))

    def _shaped(self, type_: str, value: Any) -> Any:
        element = _element(type_)
        if element is not None and value is not None:
            return [self._shaped(element[0], item) for item in value]
        if isinstance(value, dict):
            types = self.members(type_)
            return {name: self._shaped(types[name], part) for name, part in value.items() if name in types}
        if isinstance(value, bytes):
            value = value[0]
        kind = _BASES.get(type_)
        return value if kind is None else kind.shaped(value)

    def parse(self, type_: str, literal: str) -> Any:
        """Read a literal; a message becomes a dictionary of the fields that it names. Raises CaseDataError."""
        element = _element(type_)
        if element is not None:
            return [self.parse(element[0], part) for part in literals.elements(literal)]
        kind = _BASES.get(type_)
        if kind is not None:
            return kind.parse(literal)
        if not _full(type_):
            return literal
        types = self.members(type_)
        given = literals.members(literal)
        unknown = [name for name in given if name not in types]
        if unknown:
            raise CaseDataError(f"{type_} has no field {unknown[0]}; it has {', '.join(types)}")
        return {name: self.parse(types[name], part) for name, part in given.items()}

    def put(self, fields: dict[str, Any], type_: str, path: list[str | int], literal: str) -> Any:
        """Set a part of a message and return the whole; arrays are made as long as needed."""
        return self._put(fields, type_, path, literal)

    def _put(self, whole: Any, type_: str, path: list[str | int], literal: str) -> Any:
        if not path:
            return self.parse(type_, literal)
        step, rest = path[0], path[1:]
        element = _element(type_)
        if isinstance(step, int):
            if element is None:
                raise CaseDataError(f"{type_} has no element {step}")
            listed: list[Any] = list(whole or [])
            while len(listed) < max(step + 1, element[1]):
                listed.append(self._zero(element[0]))
            listed[step] = self._put(listed[step], element[0], rest, literal)
            return listed
        types = self.members(type_)
        if step not in types:
            raise CaseDataError(f"{type_} has no field {step}")
        named = dict(whole or {})
        named[step] = self._put(named.get(step), types[step], rest, literal)
        return named

    def _zero(self, type_: str) -> Any:
        kind = _BASES.get(type_)
        if kind is not None:
            return kind.zero()
        return {} if _full(type_) else ""

    def type_of(self, type_: str, path: list[str | int]) -> str:
        """The type of a part. Raises CaseDataError when there is none."""
        for step in path:
            element = _element(type_)
            found = element[0] if isinstance(step, int) and element else self.members(type_).get(str(step))
            if found is None:
                raise CaseDataError(f"{type_} has no part {step}")
            type_ = found
        return type_


def _element(type_: str) -> tuple[str, int] | None:
    """The type of the elements of a sequence or an array, and the length of an array; None for other types."""
    sequence = _SEQUENCE.fullmatch(type_)
    if sequence:
        return sequence[1], 0
    array = _ARRAY.fullmatch(type_)
    return (array[1], int(array[2])) if array else None


def _full(type_: str) -> str:
    """`package/msg/Name` of a message type, empty for other types."""
    parts = type_.split("/")
    if len(parts) < _PARTS:
        return ""
    return type_ if len(parts) > _PARTS else f"{parts[0]}/msg/{parts[1]}"
