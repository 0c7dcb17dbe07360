"""Messages as dictionaries."""

from __future__ import annotations

from collections import OrderedDict
from typing import Any

from sitaf_ros.conversion import to_fields


def message_to_ordereddict(msg: Any, **_: Any) -> OrderedDict[str, Any]:
    return _ordered(to_fields(msg))


def _ordered(value: Any) -> Any:
    if isinstance(value, dict):
        return OrderedDict((key, _ordered(item)) for key, item in value.items())
    return [_ordered(item) for item in value] if isinstance(value, list) else value


def message_to_yaml(msg: Any, **_: Any) -> str:
    import importlib

    yaml: Any = importlib.import_module("yaml")
    return yaml.safe_dump(to_fields(msg), sort_keys=False)
