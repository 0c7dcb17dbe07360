"""One session: a simulation, one caller at a time."""

import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from sitaf_bridge.errors import Cancelled, InvalidRequest, LimitReached, NoSuchSession, TimeWentBack
from sitaf_bridge.session.recording import Recorder
from sitaf_bridge.session.statistics import Statistics
from sitaf_bridge.world.driving.keeping import Kept
from sitaf_bridge.world.driving.simulation import Simulation
from sitaf_bridge.world.world import World

MAX_SNAPSHOTS = 64
# Seconds between two looks at whether the one who waits is still there.
LOOK_S = 0.25


class Session:
    """A simulation with a lock, its snapshots, and the length of its lease in seconds.

    `seed` is of everything random in the session.
    """

    def __init__(
        self, session_id: str, world: World, seed: int, lease_s: float, statistics: Statistics | None = None
    ) -> None:
        self.id = session_id
        self.world = world
        self.seed = seed
        self.lease_s = lease_s
        self.recorder: Recorder | None = None
        self.statistics = statistics or Statistics()
        self._simulation = Simulation(world, seed)
        self._changed = threading.Condition(threading.Lock())
        self._snapshots: dict[str, Kept] = {}
        self._taken = 0
        self._closed = False

    @property
    def model_identity(self) -> int:
        """Equal for sessions that share one compiled model."""
        return self._simulation.model_identity

    @contextmanager
    def simulation(self) -> Iterator[Simulation]:
        """The simulation, for this thread alone."""
        with self._changed:
            try:
                yield self._simulation
            finally:
                self._changed.notify_all()

    def wait_until(self, time_ns: int, wanted: Callable[[], bool]) -> None:
        """Wait until others have moved simulation time so far. Raises TimeWentBack, NoSuchSession, Cancelled."""
        with self._changed:
            seen = self._simulation.time_ns
            while not self._closed and self._simulation.time_ns < time_ns:
                if not wanted():
                    raise Cancelled("the caller went away")
                self._changed.wait(LOOK_S)
                if self._simulation.time_ns < seen:
                    raise TimeWentBack("simulation time was put back by a reset or a snapshot; wait anew if you must")
                seen = self._simulation.time_ns
            if self._closed:
                raise NoSuchSession(f"the session {self.id} was deleted meanwhile")

    def close(self) -> None:
        """End all waiting."""
        with self._changed:
            self._closed = True
            self._changed.notify_all()

    # The methods below are for the thread that has the simulation.

    def keep_snapshot(self, kept: Kept) -> str:
        """Keep a state; gives its id. Raises LimitReached."""
        if len(self._snapshots) >= MAX_SNAPSHOTS:
            raise LimitReached(f"{MAX_SNAPSHOTS} snapshots are kept, the limit for a session; open another session")
        self._taken += 1
        self._snapshots[str(self._taken)] = kept
        return str(self._taken)

    def snapshot(self, snapshot_id: str) -> Kept:
        """A state that was kept. Raises InvalidRequest."""
        if snapshot_id not in self._snapshots:
            raise InvalidRequest(f"snapshot_id: no snapshot {snapshot_id!r} in this session")
        return self._snapshots[snapshot_id]

    def forget_snapshots(self) -> None:
        """Begin to count anew."""
        self._snapshots.clear()
        self._taken = 0
