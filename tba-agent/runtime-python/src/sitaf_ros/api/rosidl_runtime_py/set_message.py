"""Sets fields of messages from dictionaries."""

from __future__ import annotations

from typing import Any

from sitaf_ros.conversion import from_fields
from sitaf_ros.current import classes
from sitaf_ros.messages import Message


def set_message_fields(msg: Any, values: dict[str, Any], **_: Any) -> list[Any]:
    for name, value in values.items():
        current = getattr(msg, name)
        if isinstance(current, Message) and isinstance(value, dict):
            set_message_fields(current, value)
        else:
            made = from_fields(classes(), msg._definition.name, {name: value})
            setattr(msg, name, getattr(made, name))
    return []
