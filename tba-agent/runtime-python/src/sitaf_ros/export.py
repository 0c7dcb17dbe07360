"""Writes the message definitions of PyPI's `rosbags` as .msg files: `python -m sitaf_ros.export FOLDER`.

Run once, at set-up time; the rest of the package does not need `rosbags`.
"""

from __future__ import annotations

import importlib
import sys
from pathlib import Path
from typing import Any

NODE_ARRAY, NODE_SEQUENCE = 3, 4


def export(folder: Path, release: str = "ROS2_JAZZY") -> int:
    """Write `PACKAGE/msg/NAME.msg` for each type of the release's store; return how many."""
    typesys: Any = importlib.import_module("rosbags.typesys")
    store = typesys.get_typestore(typesys.Stores[release])
    for name, (constants, fields) in sorted(store.fielddefs.items()):
        lines = [f"{kind} {constant}={_literal(value)}" for constant, kind, value in constants]
        lines += [f"{_type(kind)} {field}" for field, kind in fields if field != "structure_needs_at_least_one_member"]
        file = folder / f"{name}.msg"
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text("".join(f"{line}\n" for line in lines), encoding="utf-8")
    return len(store.fielddefs)


def _literal(value: object) -> str:
    return f"{value!r}" if isinstance(value, str) else str(value).lower() if isinstance(value, bool) else str(value)


def _type(node: Any) -> str:
    kind, detail = node
    if kind in (NODE_ARRAY, NODE_SEQUENCE):
        item, size = detail
        bound = str(size) if kind == NODE_ARRAY else f"<={size}" if size else ""
        return f"{_type(item)}[{bound}]"
    if isinstance(detail, str):
        return detail
    name, bound = detail
    return f"{name}<={bound}" if bound else name


if __name__ == "__main__":
    print(export(Path(sys.argv[1])))
