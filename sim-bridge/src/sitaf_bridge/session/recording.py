"""Records the operations of a session, with a digest after each operation."""

from dataclasses import dataclass, field

from sitaf_bridge.errors import LimitReached

MAX_OPERATIONS = 100_000
MAX_BYTES = 32 * 1024 * 1024


@dataclass
class Recorder:
    """Recorded operations in order: the name of the rpc, the encoded request, and the chained digest after it."""

    digest: bytes
    operations: list[tuple[str, bytes, bytes]] = field(default_factory=list)
    size: int = 0

    def check_not_full(self) -> None:
        """Raises LimitReached."""
        if len(self.operations) >= MAX_OPERATIONS or self.size > MAX_BYTES:
            raise LimitReached(f"the recording has {len(self.operations)} operations, which is the limit; stop it")

    def add(self, rpc: str, request: bytes, digest: bytes) -> None:
        """Add an operation that succeeded."""
        self.operations.append((rpc, request, digest))
        self.size += len(request) + len(rpc) + len(digest)
        self.digest = digest
