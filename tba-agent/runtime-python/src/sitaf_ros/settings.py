"""What a case sets for its nodes."""

from __future__ import annotations

import importlib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

Log = Callable[[str, str, str, int], None]
ROS_PARAMETERS = "ros__parameters"


@dataclass(frozen=True)
class RosSettings:
    """Settings of a case; `parameters` are overrides by name, or the content of a parameter file."""

    parameters: Mapping[str, Any] = field(default_factory=dict)
    parameter_files: tuple[Path, ...] | list[Path] = ()
    remap: Mapping[str, str] = field(default_factory=dict)
    callback_order: int = 0
    use_sim_time: bool = False
    stdin: tuple[str, ...] | list[str] = ()
    environment: Mapping[str, str] = field(default_factory=dict)
    arguments: tuple[str, ...] | list[str] = ()
    node_name: str | None = None
    namespace: str = ""
    seed: int = 1
    log: Log | None = None
    """Called with level, logger, text and time in ns; None writes to stderr."""


class Overrides:
    """Overrides of parameters by node."""

    def __init__(self, settings: RosSettings) -> None:
        self._layers = [read_yaml(file) for file in settings.parameter_files]
        self._layers.append(dict(settings.parameters))

    def add(self, layer: dict[str, Any]) -> None:
        """Add overrides that all others win against."""
        self._layers.insert(0, layer)

    def of(self, name: str, namespace: str) -> dict[str, Any]:
        """Return the overrides of a node; later layers and more special entries win."""
        found: dict[str, Any] = {}
        for layer in self._layers:
            if is_parameter_file(layer):
                for value in _matching(layer, [p for p in namespace.split("/") if p], name):
                    found.update(flat(value))
            else:
                found.update(flat(layer))
        return found


def is_parameter_file(content: Mapping[str, Any]) -> bool:
    """Tell whether a mapping has nodes at its top, as a ROS parameter file does."""
    return any(isinstance(v, Mapping) and (ROS_PARAMETERS in v or is_parameter_file(v)) for v in content.values())


def _matching(content: Mapping[str, Any], namespace: list[str], name: str) -> list[Mapping[str, Any]]:
    """Return what applies to a node, wildcards first; keys may hold several parts, `**` or `*`."""
    found: list[Mapping[str, Any]] = []
    path = [*namespace, name]
    for key, value in sorted(content.items(), key=lambda item: "*" not in item[0]):
        parts = [part for part in str(key).split("/") if part]
        if not isinstance(value, Mapping):
            continue
        if ROS_PARAMETERS in value and _fits(parts, path):
            found.append(value[ROS_PARAMETERS] or {})
        elif ROS_PARAMETERS not in value and parts and _fits(parts, namespace[: len(parts)]):
            found += _matching(value, namespace[len(parts) :], name)
    return found


def _fits(pattern: list[str], path: list[str]) -> bool:
    if not pattern:
        return not path
    if pattern[0] == "**":
        return any(_fits(pattern[1:], path[i:]) for i in range(len(path) + 1)) or len(pattern) == 1
    return bool(path) and pattern[0] in ("*", path[0]) and _fits(pattern[1:], path[1:])


def flat(values: Mapping[str, Any], prefix: str = "") -> dict[str, Any]:
    """Return nested values by dotted names."""
    found: dict[str, Any] = {}
    for key, value in values.items():
        if isinstance(value, Mapping):
            found.update(flat(value, f"{prefix}{key}."))
        else:
            found[f"{prefix}{key}"] = value
    return found


def read_yaml(file: Path) -> dict[str, Any]:
    """Read a YAML file, with PyYAML, which is needed for parameter files only."""
    try:
        yaml: Any = importlib.import_module("yaml")
    except ImportError as e:
        raise ValueError(f"{file}: reading a parameter file needs the package PyYAML") from e
    return yaml.safe_load(Path(file).read_text(encoding="utf-8")) or {}
