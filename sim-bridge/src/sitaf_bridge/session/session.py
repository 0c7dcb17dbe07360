"""One session: a simulation, one caller at a time."""

import threading
from collections.abc import Iterator
from contextlib import contextmanager

from sitaf_bridge.world.simulation import Simulation
from sitaf_bridge.world.world import World


class Session:
    """A simulation with a lock and the length of its lease in seconds.

    `seed` is of everything random in the session.
    """

    def __init__(self, session_id: str, world: World, seed: int, lease_s: float) -> None:
        self.id = session_id
        self.world = world
        self.seed = seed
        self.lease_s = lease_s
        self._simulation = Simulation(world)
        self._lock = threading.Lock()

    @contextmanager
    def simulation(self) -> Iterator[Simulation]:
        """The simulation, for this thread alone."""
        with self._lock:
            yield self._simulation
