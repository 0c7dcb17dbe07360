"""Answers of stubs."""

import pytest

from sitaf_runtime.errors import CaseDataError
from sitaf_runtime.stopwatch import Stopwatch
from sitaf_runtime.stub import StubbedMethod, Stubbing, answer
from sitaf_runtime.suite.kinds import FLOAT64, INT32


def test_an_answer_applies_until_the_next_one():
    calls = Stubbing(Stopwatch())
    method = StubbedMethod(calls, "I.M", FLOAT64, {"bearing": FLOAT64})
    assert method.call(1) == 0.0
    method.reset()
    method.answer(1.5)
    method.answer(2.5, from_call=3)
    assert [method.call(b) for b in (1, 2, 3, 4)] == [1.5, 1.5, 2.5, 2.5]
    assert [c.arguments for c in calls.calls][1:] == [{"bearing": f"{b}.0"} for b in (1, 2, 3, 4)]


def test_replaced_answers_count_the_calls_from_then_on():
    method = StubbedMethod(Stubbing(Stopwatch()), "I.M", INT32, {}, {"left": INT32})
    method.answer(1)
    method.answer(2, from_call=3)
    method.answer(7, out="left")
    assert [method.call() for _ in range(3)] == [(1, 7), (1, 7), (2, 7)]
    method.replace({1: 4, 2: 5})
    assert [method.call() for _ in range(3)] == [(4, 7), (5, 7), (5, 7)]
    method.replace({2: 8}, out="left")
    assert [method.call() for _ in range(2)] == [(5, 0), (5, 8)]
    method.reset()
    assert method.call() == (0, 0)


def test_errors_are_raised_and_delays_count_as_time_in_stubs():
    watch = Stopwatch()
    kind = answer(INT32, {"NoEcho": RuntimeError})
    method = StubbedMethod(Stubbing(watch), "I.M", INT32)
    method.answer(kind.parse("!error:NoEcho"))
    with pytest.raises(RuntimeError, match=r"I\.M"):
        method.call()
    method.reset()
    method.answer(kind.parse("!delay:0.01 5"))
    watch.start()
    assert method.call() == 5
    watch.stop()
    assert watch.stub_us >= 10_000
    for literal in ("!delay:x", "!error:Unknown", "5.5"):
        with pytest.raises(CaseDataError):
            kind.parse(literal)


def test_out_parameters_follow_the_return_value():
    method = StubbedMethod(Stubbing(Stopwatch()), "I.M", INT32, {}, {"left": FLOAT64, "right": FLOAT64})
    method.answer(1)
    method.answer(0.5, out="right")
    assert method.call() == (1, 0.0, 0.5)


def test_calls_beyond_the_limit_are_only_counted():
    calls = Stubbing(Stopwatch())
    method = StubbedMethod(calls, "I.M", None)
    for _ in range(Stubbing.MOST + 5):
        method.call()
    assert (len(calls.calls), calls.left_out) == (Stubbing.MOST, 5)
