"""What moved in each case, as files."""

from contextlib import suppress
from pathlib import Path

_MOST_BYTES = 64 << 20


class Recording:
    """A folder with `NO.glb` for each case: binary glTF, complete in itself.

    A full folder takes no more; files that were taken out of it meanwhile make room.

    The folder is made. Raises OSError when it cannot be.
    """

    def __init__(self, folder: Path) -> None:
        folder.mkdir(parents=True, exist_ok=True)
        self._folder = folder
        self._bytes = 0

    @property
    def is_full(self) -> bool:
        """Whether no further case is taken."""
        return self._bytes >= _MOST_BYTES

    def save(self, no: int, motion: bytes) -> None:
        """Save what moved in the case of a number. Raises OSError when it cannot be written."""
        if self._bytes + len(motion) > _MOST_BYTES:
            self._bytes = self._present()
        if self._bytes + len(motion) > _MOST_BYTES:
            self._bytes = _MOST_BYTES
            return
        self._bytes += len(motion)
        (self._folder / f"{no}.glb").write_bytes(motion)

    def _present(self) -> int:
        size = 0
        for file in self._folder.iterdir():
            # One may be taken at this moment.
            with suppress(FileNotFoundError):
                size += file.stat().st_size
        return size
