"""Messages as bytes: plain CDR, little endian, with the encapsulation header (OMG DDS-RTPS, 10.2)."""

from __future__ import annotations

import struct
from typing import Any

import numpy

from sitaf_ros.definitions import STRINGS, FieldType
from sitaf_ros.fields import TYPE_CODES, dtype
from sitaf_ros.messages import Message

HEADER = b"\x00\x01\x00\x00"
FORMATS = {**TYPE_CODES, "bool": "?"}


def serialize(message: Message) -> bytes:
    """Return the bytes of a message."""
    out = bytearray()
    _write(out, message)
    return HEADER + bytes(out)


def _align(out: bytearray, size: int) -> None:
    out.extend(b"\0" * (-len(out) % size))


def _number(out: bytearray, code: str, value: Any) -> None:
    data = struct.pack("<" + code, value)
    _align(out, len(data))
    out.extend(data)


def _write(out: bytearray, message: Message) -> None:
    for field in message._definition.fields:
        value = getattr(message, field.name)
        if field.type.array is None:
            _write_single(out, field.type, value)
            continue
        if field.type.array != "fixed":
            _number(out, "I", len(value))
        if field.type.is_number:
            if len(value):
                _align(out, dtype(field.type.base).itemsize)
                out.extend(numpy.asarray(value, dtype=dtype(field.type.base)).tobytes())
        else:
            for item in value:
                _write_single(out, field.type, item)


def _write_single(out: bytearray, kind: FieldType, value: Any) -> None:
    if kind.base == "string":
        data = value.encode()
        _number(out, "I", len(data) + 1)
        out.extend(data + b"\0")
    elif kind.base == "wstring":
        data = value.encode("utf-16-le")
        _number(out, "I", len(data) // 2)
        out.extend(data)
    elif kind.base == "byte":
        out.extend(value)
    elif kind.base in FORMATS:
        _number(out, FORMATS[kind.base], value)
    else:
        _write(out, value)


class Reader:
    """Reads values one after the other."""

    def __init__(self, data: bytes, message_class: Any) -> None:
        # The last two bytes are options without a meaning for plain CDR.
        if data[:2] != HEADER[:2]:
            raise ValueError("only little-endian CDR is read")
        self._data, self._at, self._class = data[4:], 0, message_class

    def message(self, cls: Any) -> Message:
        """Read a message of a class."""
        new = cls()
        for field in cls._definition.fields:
            setattr(new, field.name, self._field(field.type))
        return new

    def _field(self, kind: FieldType) -> Any:
        if kind.array is None:
            return self._single(kind)
        size = kind.size if kind.array == "fixed" else self._number("I")
        if not kind.is_number:
            return [self._single(kind) for _ in range(size)]
        number = dtype(kind.base)
        if size:
            self._at += -self._at % number.itemsize
        return numpy.frombuffer(self._take(size * number.itemsize), dtype=number).copy()

    def _take(self, size: int) -> bytes:
        if self._at + size > len(self._data):
            raise ValueError("the serialized message is too short")
        data = self._data[self._at : self._at + size]
        self._at += size
        return data

    def _number(self, code: str) -> Any:
        size = struct.calcsize("<" + code)
        self._at += -self._at % size
        return struct.unpack("<" + code, self._take(size))[0]

    def _single(self, kind: FieldType) -> Any:
        if kind.base in STRINGS:
            size = self._number("I")
            return self._take(size)[:-1].decode() if kind.base == "string" else self._take(2 * size).decode("utf-16-le")
        if kind.base == "byte":
            return self._take(1)
        if kind.base in FORMATS:
            return self._number(FORMATS[kind.base])
        return self.message(self._class(kind.base))
