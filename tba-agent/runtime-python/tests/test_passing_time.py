"""Simulation time for threads of a component and for nonblocking calls."""

import threading
import time

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


@pytest.mark.parametrize("attempt", range(5))
def test_a_nonblocking_call_acts_before_the_tick_of_the_same_step(attempt):
    world, acted = World(), []

    def call():
        for _ in range(3):
            # A tick that did not wait for this thread would come first.
            time.sleep(0.001)
            acted.append(("call", world.now))
            world.time.let_pass(6 * MS)

    world.time.every(6 * MS, lambda: acted.append(("tick", world.now)))
    NonblockingCall(Stopwatch(), world, call).outcome()
    world.time.let_pass(6 * MS)
    assert acted == [
        ("call", 0),
        ("call", 3),
        ("tick", 3),
        ("call", 6),
        ("tick", 6),
        ("tick", 9),
        ("tick", 12),
    ]


def test_a_tick_that_waits_lets_a_nonblocking_call_continue():
    world, acted = World(), []

    def tick():
        acted.append(("begin", world.now))
        world.time.let_pass(8 * MS)
        acted.append(("end", world.now))

    world.time.every(20 * MS, tick)
    call = NonblockingCall(Stopwatch(), world, lambda: world.act(acted, 5))
    assert call.outcome() == "done"
    assert acted == [0, 3, 6, 9, ("begin", 10), 12, ("end", 14)]


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


def test_followed_threads_continue_in_the_order_of_their_beginning():
    world, acted = World(), []

    def act(name):
        for _ in range(3):
            world.time.let_pass(6 * MS)
            # The others would act meanwhile if they ran at the same time.
            time.sleep(0.001)
            acted.append((name, world.now))
        world.time.leave()

    threads = [threading.Thread(target=act, args=(name,)) for name in "abc"]
    for thread in threads:
        world.time.follow(thread)
        thread.start()
        world.time.await_turn_of(thread)
    for thread in threads:
        world.time.pass_until_leaves(thread)
        thread.join()
    assert acted == [(name, step) for step in (3, 6, 9) for name in "abc"]


def test_a_followed_thread_makes_a_nonblocking_call():
    world, acted = World(), []

    def outer():
        NonblockingCall(Stopwatch(), world, lambda: world.act(acted, 2)).outcome()
        acted.append(-world.now)

    NonblockingCall(Stopwatch(), world, outer).outcome()
    assert acted == [0, 3, -6]


def test_each_overlapping_step_has_its_own_stopwatch():
    whole, own = Stopwatch(), Stopwatch()
    whole.start()
    with whole.separate(own):
        assert whole.of_this_thread is own
    assert whole.of_this_thread is whole
    assert not own.was_started
