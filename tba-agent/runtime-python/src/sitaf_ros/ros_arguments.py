"""Arguments after `--ros-args`: https://docs.ros.org/en/jazzy/How-To-Guides/Node-arguments.html."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sitaf_ros.settings import read_yaml

if TYPE_CHECKING:
    from sitaf_ros.system import RosSystem


def apply(system: RosSystem, args: list[str]) -> None:
    """Apply remappings (`-r`), parameters (`-p`) and parameter files; settings of the case win."""
    inside = False
    rest = iter(args)
    for arg in rest:
        if arg == "--ros-args":
            inside = True
        elif arg == "--":
            inside = False
        elif inside and arg in ("-r", "--remap"):
            source, _, target = next(rest, "").partition(":=")
            system.remapping.rules.setdefault(source, target)
        elif inside and arg in ("-p", "--param"):
            name, _, text = next(rest, "").partition(":=")
            system.overrides.add({name: _value(text)})
        elif inside and arg == "--params-file":
            system.overrides.add(read_yaml(Path(next(rest, ""))))


def _value(text: str) -> Any:
    try:
        return json.loads({"True": "true", "False": "false"}.get(text, text))
    except ValueError:
        return text.strip("'\"")
