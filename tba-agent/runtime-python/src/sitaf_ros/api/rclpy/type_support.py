"""Checks of types."""

from __future__ import annotations

from typing import Any

from sitaf_ros.messages import Message

from .exceptions import NoTypeSupportImportedException


def check_is_valid_msg_type(msg_type: Any) -> None:
    if not (isinstance(msg_type, type) and issubclass(msg_type, Message)):
        raise NoTypeSupportImportedException(f"{msg_type!r} is not a message type")


def check_is_valid_srv_type(srv_type: Any) -> None:
    if not (hasattr(srv_type, "Request") and hasattr(srv_type, "Response")):
        raise NoTypeSupportImportedException(f"{srv_type!r} is not a service type")


def check_for_type_support(msg_or_srv_type: Any) -> None:
    if not (hasattr(msg_or_srv_type, "Goal") or hasattr(msg_or_srv_type, "Request")):
        check_is_valid_msg_type(msg_or_srv_type)
