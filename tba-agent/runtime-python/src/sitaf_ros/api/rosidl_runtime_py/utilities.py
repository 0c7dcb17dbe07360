"""Classes of interfaces by name."""

from __future__ import annotations

from typing import Any

from sitaf_ros.current import message


def _get(identifier: str, kind: str) -> Any:
    parts = identifier.split("/")
    if len(parts) == 2:
        parts.insert(1, kind)
    if len(parts) != 3 or parts[1] != kind:
        raise ValueError(f"Expected the full name of a {kind}. Got '{identifier}'")
    return message("/".join(parts))


def get_message(identifier: str) -> Any:
    return _get(identifier, "msg")


def get_service(identifier: str) -> Any:
    return _get(identifier, "srv")


def get_action(identifier: str) -> Any:
    return _get(identifier, "action")


def get_interface(identifier: str) -> Any:
    return _get(identifier, identifier.split("/")[1])
