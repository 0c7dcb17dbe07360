"""One session: a simulation that one caller uses at a time."""

import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from sitaf_bridge.errors import Cancelled, InvalidRequest, LimitReached, NoSuchSession, TimeReset, WrongState
from sitaf_bridge.session.hardware import SessionHardware
from sitaf_bridge.session.preparations import Preparations
from sitaf_bridge.session.recording import Recorder
from sitaf_bridge.session.statistics import Statistics
from sitaf_bridge.world.driving.saved_state import SavedState
from sitaf_bridge.world.driving.simulation import Simulation
from sitaf_bridge.world.world import World

MAX_SNAPSHOTS = 64
# Seconds between checks whether the waiting caller is still connected.
POLL_S = 0.25


class Session:
    """A simulation with a lock, its snapshots, and the duration of its lease in seconds.

    `seed` initializes all random numbers of the session.
    """

    def __init__(
        self, session_id: str, world: World, seed: int, lease_s: float, statistics: Statistics | None = None
    ) -> None:
        self.id = session_id
        self.world = world
        self.seed = seed
        self.lease_s = lease_s
        self.recorder: Recorder | None = None
        # Of an endpoint with devices that are not simulated.
        self.hardware: SessionHardware | None = None
        self.preparations = Preparations()
        self.statistics = statistics or Statistics()
        self._simulation = Simulation(world, seed)
        self._changed = threading.Condition(threading.Lock())
        self._snapshots: dict[str, SavedState] = {}
        self._taken = 0
        self._closed = False

    @property
    def model_identity(self) -> int:
        """Equal for sessions that share a compiled model."""
        return self._simulation.model_identity

    @contextmanager
    def simulation(self) -> Iterator[Simulation]:
        """Lock the simulation for this thread."""
        with self._changed:
            try:
                yield self._simulation
            finally:
                self._changed.notify_all()

    def wait_until(self, time_ns: int, is_active: Callable[[], bool]) -> None:
        """Wait until other calls have advanced the simulation time. Raises TimeReset, NoSuchSession, Cancelled."""
        with self._changed:
            seen = self._simulation.time_ns
            while not self._closed and self._simulation.time_ns < time_ns:
                if not is_active():
                    raise Cancelled("the caller disconnected")
                self._changed.wait(POLL_S)
                if self._simulation.time_ns < seen:
                    raise TimeReset("simulation time was reset or restored from a snapshot; wait again if necessary")
                seen = self._simulation.time_ns
            if self._closed:
                raise NoSuchSession(f"the session {self.id} was deleted")

    def close(self) -> None:
        """Wake all waiting callers."""
        with self._changed:
            self._closed = True
            self._changed.notify_all()

    def check_simulated(self, what: str) -> None:
        """Raise WrongState if a device is not simulated."""
        if self.hardware is not None:
            raise WrongState(f"{what} needs simulated devices only, but this session has real or recorded ones")

    # The methods below require the simulation's lock.

    def keep_snapshot(self, kept: SavedState) -> str:
        """Store a state and return its id. Raises LimitReached."""
        if len(self._snapshots) >= MAX_SNAPSHOTS:
            raise LimitReached(f"the session has {MAX_SNAPSHOTS} snapshots, which is the limit; create another session")
        self._taken += 1
        self._snapshots[str(self._taken)] = kept
        return str(self._taken)

    def snapshot(self, snapshot_id: str) -> SavedState:
        """Return a stored state. Raises InvalidRequest."""
        if snapshot_id not in self._snapshots:
            raise InvalidRequest(f"snapshot_id: no snapshot {snapshot_id!r} in this session")
        return self._snapshots[snapshot_id]

    def delete_snapshots(self) -> None:
        """Delete all snapshots and restart their numbering."""
        self._snapshots.clear()
        self._taken = 0
