"""Simulation time for threads of a component and for nonblocking calls."""

import threading

import pytest

from sitaf_runtime.errors import SimulationError
from sitaf_runtime.nonblocking import NonblockingCall
from sitaf_runtime.simulation.passing_time import PassingTime
from sitaf_runtime.stopwatch import Stopwatch

STEP_NS = 2_000_000
MS = 1_000_000


class World:
    """A simulation that only counts steps, up to `max_steps`."""

    def __init__(self, max_steps=None):
        self.now = 0
        self.max_steps = max_steps
        self.time = PassingTime(STEP_NS, self._move)

    def _move(self, steps):
        if self.max_steps is not None and self.now + steps > self.max_steps:
            raise TimeoutError("too long")
        self.now += steps

    def act(self, acted, times):
        for _ in range(times):
            acted.append(self.now)
            self.time.let_pass(6 * MS)
        return "done"


def test_ticks_run_at_the_first_step_at_or_after_each_period():
    world, ticks = World(), []
    world.time.every(5 * MS, lambda: ticks.append(world.now))
    world.time.let_pass(13 * MS)
    world.time.let_pass(6 * MS)
    assert ticks == [3, 5, 8, 10]


def test_a_nonblocking_call_acts_at_the_same_times_in_every_run():
    world, acted, watch = World(), [], Stopwatch()
    call = NonblockingCall(watch, world, lambda: world.act(acted, 5))
    world.time.let_pass(20 * MS)
    assert acted == [0, 3, 6, 9]
    assert call.outcome() == "done"
    assert (acted, world.now) == ([0, 3, 6, 9, 12], 15)
    assert not watch.is_running


def test_a_call_that_does_not_wait_takes_no_time():
    world = World()
    assert NonblockingCall(Stopwatch(), world, lambda: 7).outcome() == 7
    assert world.now == 0
    assert NonblockingCall(Stopwatch(), None, lambda: 8).outcome() == 8


def test_outcome_raises_the_exception_of_a_nonblocking_call():
    world, watch = World(), Stopwatch()

    def slip():
        world.time.let_pass(6 * MS)
        raise ValueError("slipped")

    with pytest.raises(ValueError, match="slipped"):
        NonblockingCall(watch, world, slip).outcome()
    assert watch.is_running


def test_giving_up_a_call_ends_its_waits():
    world, acted, seen = World(max_steps=10), [], []

    def endless():
        try:
            world.act(acted, 1_000_000)
        except SimulationError as e:
            seen.append(str(e))
            raise

    call = NonblockingCall(Stopwatch(), world, endless)
    with pytest.raises(TimeoutError):
        call.outcome()
    call.give_up()
    assert seen == ["the case has ended, and its simulation time no longer advances"]
    assert acted == [0, 3, 6, 9]
    assert threading.active_count() == 1


def test_a_new_case_ends_waits_of_the_previous_one():
    world, acted = World(), []
    thread = threading.Thread(target=world.act, args=(acted, 1))
    thread.start()
    while not acted:
        pass
    world.time.restart()
    thread.join(10)
    assert not thread.is_alive()
