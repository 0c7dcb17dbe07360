"""Recordings of the motion in each case, as files."""

from contextlib import suppress
from pathlib import Path

_MAX_BYTES = 64 << 20


class Recording:
    """A folder with `NO.glb` for each case: self-contained binary glTF.

    When the folder is full, recordings are dropped until files have been removed from it. Creates the folder; raises
    OSError when that fails.
    """

    def __init__(self, folder: Path) -> None:
        folder.mkdir(parents=True, exist_ok=True)
        self._folder = folder
        self._bytes = 0

    @property
    def is_full(self) -> bool:
        """Whether the folder is full."""
        return self._bytes >= _MAX_BYTES

    def save(self, no: int, motion: bytes) -> None:
        """Save the recording of a case. Raises OSError when it cannot be written."""
        if self._bytes + len(motion) > _MAX_BYTES:
            self._bytes = self._present()
        if self._bytes + len(motion) > _MAX_BYTES:
            self._bytes = _MAX_BYTES
            return
        self._bytes += len(motion)
        (self._folder / f"{no}.glb").write_bytes(motion)

    def _present(self) -> int:
        size = 0
        for file in self._folder.iterdir():
            # The agent may remove the file at this moment.
            with suppress(FileNotFoundError):
                size += file.stat().st_size
        return size
