"""Reads the files of a world into a request, so that the simulator never opens files of its host."""

import os
from pathlib import Path

_MAX_BYTES = 64 << 20


def read_world(description: Path) -> tuple[str, dict[str, bytes]]:
    """The name of a world description and all files of its folder, by relative path; symbolic links are ignored.

    Raises OSError when a file cannot be read, or the folder exceeds the limits of a world.
    """
    file = Path(os.path.abspath(description))
    if not file.is_file():
        raise OSError(f"{description} is not a file")
    files: dict[str, bytes] = {}
    total = 0
    for folder, _, names in os.walk(file.parent):
        for name in names:
            path = Path(folder, name)
            if path.is_symlink() or not path.is_file():
                continue
            total += path.stat().st_size
            if total > _MAX_BYTES:
                raise OSError(f"the files of the world are larger than {_MAX_BYTES} bytes")
            files[path.relative_to(file.parent).as_posix()] = path.read_bytes()
    return file.name, files
