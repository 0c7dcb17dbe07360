"""All sessions of the bridge; deletes sessions whose lease has expired."""

import math
import secrets
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass

from sitaf_bridge.errors import InvalidRequest, LimitReached, NoSuchSession
from sitaf_bridge.session.session import Session
from sitaf_bridge.session.statistics import Statistics
from sitaf_bridge.world.world import World

MAX_LEASE_S = 24 * 3600.0


@dataclass
class _Entry:
    session: Session
    # Monotonic seconds; ignored while a call runs in the session.
    ends: float
    calls: int = 0


class Registry:
    """Sessions by id, each with a lease that every call renews. Thread-safe.

    A background thread deletes sessions whose lease has expired; close() stops it.
    """

    def __init__(
        self, *, default_lease_s: float, max_sessions: int, clock: Callable[[], float] = time.monotonic
    ) -> None:
        self._default_lease_s = default_lease_s
        self._max_sessions = max_sessions
        self._clock = clock
        self.statistics = Statistics()
        self._entries: dict[str, _Entry] = {}
        # Its lock is reentrant.
        self._changed = threading.Condition()
        self._closed = False
        # When the background thread will check next.
        self._looks_at = math.inf
        self._reaper = threading.Thread(target=self._reap, name="session-reaper", daemon=True)
        self._reaper.start()

    def create(self, world: World, seed: int, lease_s: float | None) -> Session:
        """Create a session. Raises InvalidRequest for an invalid lease, LimitReached."""
        lease = self._default_lease_s if lease_s is None else lease_s
        if not lease > 0:
            raise InvalidRequest(f"lease: {lease:g} s must be positive")
        if lease > MAX_LEASE_S:
            raise LimitReached(f"lease: {lease:g} s; the limit is {MAX_LEASE_S:g} s")
        self._check_limit()
        session = Session(secrets.token_hex(8), world, seed, lease, self.statistics)
        with self._changed:
            self._check_limit()
            self._entries[session.id] = _Entry(session, self._clock() + lease)
            self._changed.notify()
        return session

    @contextmanager
    def use(self, session_id: str) -> Iterator[Session]:
        """Use a session for one call, which renews its lease. Raises InvalidRequest, NoSuchSession."""
        entry = self._enter(session_id)
        try:
            yield entry.session
        finally:
            with self._changed:
                entry.calls -= 1
                entry.ends = self._clock() + entry.session.lease_s
                # Waking the background thread at every call would cost more than many calls.
                if entry.ends < self._looks_at:
                    self._changed.notify()

    def newest(self) -> Session | None:
        """The newest session, without a call in it: its lease is not renewed."""
        with self._changed:
            return next((e.session for e in reversed(self._entries.values()) if not self._has_ended(e)), None)

    def delete(self, session_id: str) -> None:
        """Delete a session; a running call in it completes."""
        entry = self._enter(session_id)
        with self._changed:
            self._entries.pop(session_id, None)
        entry.session.close()

    def __len__(self) -> int:
        """The number of sessions."""
        with self._changed:
            return len(self._entries)

    def models(self) -> int:
        """The number of compiled models of the sessions."""
        with self._changed:
            return len({entry.session.model_identity for entry in self._entries.values()})

    def close(self) -> None:
        """Delete all sessions."""
        with self._changed:
            self._closed = True
            self._entries.clear()
            self._changed.notify()
        self._reaper.join()

    def _check_limit(self) -> None:
        with self._changed:
            if len(self._entries) >= self._max_sessions:
                raise LimitReached(
                    f"{self._max_sessions} sessions are open, which is the limit (--max-sessions); delete one first"
                )

    def _enter(self, session_id: str) -> _Entry:
        if not session_id:
            raise InvalidRequest("session_id is empty")
        with self._changed:
            entry = self._entries.get(session_id)
            if entry is None or self._has_ended(entry):
                raise NoSuchSession(
                    f"no session {session_id!r}: it was deleted, its lease expired, or the bridge was restarted; "
                    "create a new one"
                )
            entry.calls += 1
            return entry

    def _has_ended(self, entry: _Entry) -> bool:
        return entry.calls == 0 and self._clock() >= entry.ends

    def _reap(self) -> None:
        with self._changed:
            while not self._closed:
                for session_id in [i for i, entry in self._entries.items() if self._has_ended(entry)]:
                    del self._entries[session_id]
                now = self._clock()
                # The lease of a session with a running call expires after the call at the earliest. Ignoring it
                # here would wake this thread at the end of each call, which costs more than the call itself.
                ends = [e.ends if e.calls == 0 else now + e.session.lease_s for e in self._entries.values()]
                self._looks_at = min(ends, default=math.inf)
                self._changed.wait(max(0.0, self._looks_at - now) if ends else None)
