"""Compiled worlds by content: each is compiled once for all sessions."""

import threading
from collections import OrderedDict
from concurrent.futures import Future

from sitaf_bridge.errors import BadWorld, Problem, UnreachableValue
from sitaf_bridge.world.description.source import WorldSource
from sitaf_bridge.world.driving.simulation import Simulation
from sitaf_bridge.world.world import World, load_world

MAX_WORLDS = 32
SMALLEST = WorldSource(
    "w.world.yaml",
    {
        "w.world.yaml": b"mjcf: w.xml",
        "w.xml": b'<mujoco><worldbody><body mocap="true"><geom size="1"/></body></worldbody></mujoco>',
    },
)


class Catalog:
    """A cache of the most recently used worlds. Thread-safe."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._worlds: OrderedDict[tuple[str, str], Future[World]] = OrderedDict()

    def world(self, source: WorldSource) -> World:
        """The world of a source. Raises BadWorld or LimitReached; failures are not cached."""
        key = (source.description, source.digest)
        with self._lock:
            future = self._worlds.get(key)
            mine = future is None
            if future is None:
                future = self._worlds[key] = Future()
            self._worlds.move_to_end(key)
            while len(self._worlds) > MAX_WORLDS:
                self._worlds.popitem(last=False)
        if mine:
            try:
                future.set_result(_loaded(source))
            except BaseException as error:
                with self._lock:
                    self._worlds.pop(key, None)
                future.set_exception(error)
        return future.result()

    def warm_up(self) -> None:
        """Start the compiler process and load the simulation code before the first world needs them."""
        _loaded(SMALLEST)


def _loaded(source: WorldSource) -> World:
    world = load_world(source)
    try:
        Simulation(world)
    except UnreachableValue as error:
        message = f"the defaults cannot be set: {error}"
        raise BadWorld([Problem(source.description, None, message)]) from error
    return world
