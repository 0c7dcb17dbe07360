"""Serialization of messages."""

from __future__ import annotations

from typing import Any

from sitaf_ros.current import classes
from sitaf_ros.serialization import Reader, serialize


def serialize_message(message: Any) -> bytes:
    return serialize(message)


def deserialize_message(serialized_message: bytes, message_type: Any) -> Any:
    return Reader(serialized_message, classes().message).message(message_type)
