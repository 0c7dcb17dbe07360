"""Where a package's share folder would be after its installation: mostly its source folder, with what setup.py adds."""

from __future__ import annotations

import os
import runpy
import sys
import tempfile
from pathlib import Path
from types import ModuleType
from typing import Any


def share_folder(package: str, source: Path) -> Path:
    """Return the source folder, or a folder of links where `data_files` of setup.py puts files elsewhere."""
    moved = {
        target: file
        for target, file in _installed(package, source).items()
        if not (source / target).exists() and file.is_file()
    }
    if not moved:
        return source
    overlay = Path(tempfile.mkdtemp(prefix=f"{package}-share-"))
    for entry in source.iterdir():
        (overlay / entry.name).symlink_to(entry)
    for target, file in sorted(moved.items()):
        link = overlay / target
        if not link.parent.is_symlink():
            link.parent.mkdir(parents=True, exist_ok=True)
            link.symlink_to(file)
    return overlay


def _installed(package: str, source: Path) -> dict[str, Path]:
    """Return the files below `share/PACKAGE` by their place there."""
    files: dict[str, Path] = {}
    start = f"share/{package}"
    for folder, names in _data_files(source):
        target = str(folder).strip("/")
        if target == start or target.startswith(start + "/"):
            inside = target[len(start) :].strip("/")
            for name in names:
                files[f"{inside}/{Path(name).name}".strip("/")] = source / name
    return files


def _data_files(source: Path) -> list[tuple[str, list[str]]]:
    """Run setup.py with a `setup` that only takes its arguments."""
    script = source / "setup.py"
    if not script.is_file():
        return []
    taken: dict[str, Any] = {}
    stand_in: Any = ModuleType("setuptools")
    stand_in.setup = taken.update
    stand_in.find_packages = stand_in.find_namespace_packages = lambda *_, **__: []
    before, folder = sys.modules.get("setuptools"), Path.cwd()
    sys.modules["setuptools"] = stand_in
    os.chdir(source)
    try:
        runpy.run_path(str(script), run_name="__main__")
    except (Exception, SystemExit):
        return []  # a setup.py that does more is not needed to find files
    finally:
        os.chdir(folder)
        if before is None:
            del sys.modules["setuptools"]
        else:
            sys.modules["setuptools"] = before
    return [(str(target), list(names)) for target, names in taken.get("data_files", [])]
