"""The installed classes of messages, services and actions by the names that the contract uses."""

from __future__ import annotations

import importlib
import sys
from typing import Any

# Parts of an action: what `rclpy.action` calls them.
_OF_ACTIONS = {"SendGoal": "SendGoalService", "GetResult": "GetResultService", "FeedbackMessage": "FeedbackMessage"}


class NotInstalledError(Exception):
    """An interface package is not installed."""


def installed(type_name: str) -> Any:
    """Return the class of `PACKAGE/msg/NAME` and its like, or of a part of an action. Raises NotInstalledError."""
    package, _, rest = type_name.partition("/")
    kind, _, name = rest.rpartition("/")
    name, _, part = name.partition("_") if kind == "action" else (name, "", "")
    try:
        found: Any = getattr(importlib.import_module(f"{package}.{kind or 'msg'}"), name)
        return getattr(found.Impl, _OF_ACTIONS[part]) if part else found
    except (ImportError, AttributeError, KeyError) as e:
        raise NotInstalledError(
            f"{type_name} is not installed in the ROS 2 of this machine for Python {sys.version_info.major}."
            f"{sys.version_info.minor}: {e}; build the package {package}, and put its prefix into AMENT_PREFIX_PATH"
        ) from e
