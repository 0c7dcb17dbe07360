"""Values of output data ports over time."""

import pytest

from sitaf_runtime.ports import MOST_CHANGES, WatchedPorts


def test_only_changes_are_kept_with_the_last_value_of_each_time():
    ports = WatchedPorts()
    values = iter(["0.0", "0.0", "1.0", "2.0", "2.0", "0.0"])
    ports.watch("speed", lambda: next(values), 10)
    for now in (20, 30, 30, 40, 50):
        ports.take(now)
    ports.require_read()
    (speed,) = ports.end(call_ns=30)
    assert (speed.signal, speed.changes, speed.left_out) == ("speed", [(-20, "0.0"), (0, "2.0"), (20, "0.0")], 0)
    ports.take(60)
    assert ports.end(call_ns=0) == []


def test_changes_beyond_the_limit_are_counted():
    ports = WatchedPorts()
    count = iter(range(MOST_CHANGES + 6))
    ports.watch("speed", lambda: str(next(count)), 0)
    for now in range(1, MOST_CHANGES + 6):
        ports.take(now)
    (speed,) = ports.end(call_ns=0)
    assert (len(speed.changes), speed.left_out) == (MOST_CHANGES, 6)
    # The next case begins from zero.
    ports.watch("speed", lambda: "1", 0)
    (speed,) = ports.end(call_ns=0)
    assert (speed.changes, speed.left_out) == ([(0, "1")], 0)


def test_a_port_that_raises_is_reported_at_the_end_of_the_case():
    ports = WatchedPorts()
    values = ["1"]
    ports.watch("speed", values.pop, 0)
    ports.take(1)
    ports.take(2)
    with pytest.raises(IndexError):
        ports.require_read()
    with pytest.raises(IndexError):
        ports.watch("speed", values.pop, 0)


def test_a_port_that_lets_time_pass_is_not_read_meanwhile():
    ports = WatchedPorts()
    depth = []

    def read():
        depth.append(1)
        ports.take(len(depth))
        return str(len(depth))

    ports.watch("speed", read, 0)
    depth.clear()
    ports.take(10)
    assert len(depth) == 1
