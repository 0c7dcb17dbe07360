"""Values between documents and Python."""

import enum
import math
from dataclasses import dataclass

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sitaf_runtime.errors import CaseDataError
from sitaf_runtime.suite import kinds, literals
from sitaf_runtime.suite.comparison import difference
from sitaf_runtime.suite.kinds import member
from sitaf_runtime.suite.tolerance import EXACT, Tolerance


class Mode(enum.Enum):
    IDLE = 0
    BUSY = 1


@dataclass
class Point:
    x: float = member(kinds.FLOAT64)
    name: str = member(kinds.STRING)


POINT = kinds.struct(Point)


@given(st.floats())
def test_every_number_is_read_back_as_it_was_spelled(number):
    assert literals.real(literals.spell(number)) == pytest.approx(number, rel=0, abs=0, nan_ok=True)
    assert difference(literals.spell(number), number, EXACT) is None


@given(st.lists(st.text()))
def test_every_sequence_of_strings_is_read_back(strings):
    spelled = literals.spell(strings)
    assert kinds.sequence(kinds.STRING).parse(spelled) == strings
    assert difference(spelled, strings, EXACT) is None


@given(st.lists(st.builds(Point, st.floats(allow_nan=False), st.text())))
def test_every_sequence_of_structs_is_read_back(points):
    spelled = literals.spell(points)
    assert kinds.sequence(POINT).parse(spelled) == points
    assert difference(spelled, [vars(p) for p in points], EXACT) is None


def test_a_struct_is_spelled_by_its_members():
    assert literals.spell(Point(1, 'a "quoted", one')) == '{x: 1, name: "a \\"quoted\\", one"}'
    assert literals.spell(POINT.shaped(Point(1, "a"))) == '{x: 1.0, name: "a"}'


@pytest.mark.parametrize("literal", ["", "1_0", "0x10", "--1", "1e", "one", "1.5.2", "٣", "sNaN", "1e9999999999"])
def test_what_is_no_number_is_refused(literal):
    with pytest.raises(CaseDataError):
        kinds.INT64.parse(literal)
    with pytest.raises(CaseDataError):
        kinds.FLOAT64.parse(literal)


@pytest.mark.parametrize("literal", ["1e300000000", "-1e999999999", "128", "-129", "1.5"])
def test_a_number_that_does_not_fit_is_refused_at_once(literal):
    with pytest.raises(CaseDataError):
        kinds.INT8.parse(literal)


def test_whole_numbers_may_be_written_as_real_ones():
    assert kinds.INT32.parse(" 3.0 ") == 3
    assert kinds.UINT64.parse("18446744073709551615") == 2**64 - 1
    assert kinds.INT8.parse("-1.28e2") == -128


def test_enumerations_go_by_their_literals():
    kind = kinds.enumeration(Mode)
    assert kind.parse("BUSY") is Mode.BUSY
    assert [literals.spell(kind.shaped(value)) for value in (Mode.BUSY, "BUSY", 1)] == ["BUSY"] * 3
    assert difference("IDLE", Mode.BUSY, EXACT) == "expected 'IDLE', but was 'BUSY'"
    with pytest.raises(CaseDataError, match="IDLE, BUSY"):
        kind.parse("ASLEEP")


def test_numbers_compare_within_the_tolerance():
    assert difference("-1", -1.0, EXACT) is None
    assert difference("NaN", math.nan, EXACT) is None
    assert difference("1.0", 1.05, Tolerance(absolute=0.1)) is None
    assert difference("10", 10.9, Tolerance(relative=0.1)) is None
    assert difference("Infinity", 1e308, Tolerance(absolute=1e308)) == "expected Infinity, but was 1e+308"
    assert difference("1", 3, EXACT) == "expected 1, but was 3"
    assert difference("9007199254740993", 9007199254740992, EXACT) is not None
    assert difference("1.0", math.nextafter(1.0, 2), Tolerance(ulp=1)) is None
    assert difference("1.0", math.nextafter(math.nextafter(1.0, 2), 2), Tolerance(ulp=1)) is not None
    assert difference("1.0", math.nextafter(math.nextafter(1.0, 2), 2), Tolerance(ulp=2.5)) is None
    assert difference("1.0", math.nextafter(math.nextafter(1.0, 2), 2), Tolerance(absolute=2.3e-16, ulp=1)) is None


def test_a_float_is_expected_as_a_float():
    assert difference("0.1", kinds.FLOAT32.shaped(0.1), EXACT) is None
    assert difference("0.1", kinds.FLOAT32.shaped(0.1000001), EXACT) is not None


def test_the_first_difference_says_where_it_is():
    assert difference("[1, 2, 3]", [1, 2, 4], EXACT) == "[2]: expected 3, but was 4"
    assert difference("[1]", [1, 2], EXACT) == "expected 1 elements, but there are 2"
    assert difference("[{x: 1}]", [{"x": 2.0}], EXACT) == "[0].x: expected 1, but was 2.0"


def test_another_type_is_a_difference_and_no_error():
    assert difference("1", None, EXACT) == "expected 1, but was null"
    assert difference("5.0", "5", EXACT) == "expected '5.0', but was '5'"
