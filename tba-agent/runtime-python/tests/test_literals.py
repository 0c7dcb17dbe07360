"""Reading and writing of literals."""

import enum
import types
from dataclasses import dataclass

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sitaf_runtime.errors import CaseDataError
from sitaf_runtime.suite import kinds, literals
from sitaf_runtime.suite.kinds import member


class Mode(enum.Enum):
    IDLE = 0
    BUSY = 1


@dataclass
class Point:
    x: float = member(kinds.FLOAT64)
    name: str = member(kinds.STRING)


POINT = kinds.struct(Point)


@given(st.floats())
def test_every_number_is_read_back_as_it_was_written(number):
    assert literals.real(literals.write(number)) == pytest.approx(number, rel=0, abs=0, nan_ok=True)


@given(st.lists(st.text()))
def test_every_sequence_of_strings_is_read_back(strings):
    written = literals.write(strings)
    assert kinds.sequence(kinds.STRING).parse(written) == strings


@given(st.lists(st.builds(Point, st.floats(allow_nan=False), st.text())))
def test_every_sequence_of_structs_is_read_back(points):
    written = literals.write(points)
    assert kinds.sequence(POINT).parse(written) == points


def test_a_struct_is_written_by_its_members():
    assert literals.write(Point(1, 'a "quoted", one')) == '{x: 1, name: "a \\"quoted\\", one"}'
    assert literals.write(POINT.shaped(Point(1, "a"))) == '{x: 1.0, name: "a"}'


class Way(enum.Enum):
    locals()["None"] = 0
    None_ = 0  # noqa: PIE796 - an alias, as in generated sources
    BACK = 1


@dataclass
class Route:
    from_: float = member(kinds.FLOAT64, "from")
    way: Way = member(kinds.enumeration(Way))  # noqa: RUF009 - a field, as in generated sources


@pytest.mark.parametrize(
    "answer",
    [
        Route(1, Way.None_),
        {"from": 1, "way": "None"},
        {"from_": 1, "way": 0},
        types.SimpleNamespace(from_=1, way=Way["None"]),
    ],
)
def test_names_that_python_does_not_allow_are_those_of_the_document(answer):
    assert literals.write(kinds.struct(Route).shaped(answer)) == "{from: 1.0, way: None}"


def test_names_that_python_does_not_allow_are_read_as_in_the_document():
    assert kinds.struct(Route).parse("{from: 2, way: BACK}") == Route(2, Way.BACK)
    with pytest.raises(CaseDataError, match="unknown member from_; the struct has from, way"):
        kinds.struct(Route).parse("{from_: 2}")
    with pytest.raises(CaseDataError, match="'FORTH' is not one of None, BACK"):
        kinds.struct(Route).parse("{way: FORTH}")


@pytest.mark.parametrize("literal", ["", "1_0", "0x10", "--1", "1e", "one", "1.5.2", "٣", "sNaN", "1e9999999999"])
def test_text_that_is_no_number_is_rejected(literal):
    with pytest.raises(CaseDataError):
        kinds.INT64.parse(literal)
    with pytest.raises(CaseDataError):
        kinds.FLOAT64.parse(literal)


@pytest.mark.parametrize("literal", ["1e300000000", "-1e999999999", "128", "-129", "1.5"])
def test_a_number_out_of_range_is_rejected_without_expansion(literal):
    with pytest.raises(CaseDataError):
        kinds.INT8.parse(literal)


def test_whole_numbers_may_be_written_as_real_ones():
    assert kinds.INT32.parse(" 3.0 ") == 3
    assert kinds.UINT64.parse("18446744073709551615") == 2**64 - 1
    assert kinds.INT8.parse("-1.28e2") == -128


def test_enumerations_are_read_and_written_by_name():
    kind = kinds.enumeration(Mode)
    assert kind.parse("BUSY") is Mode.BUSY
    assert [literals.write(kind.shaped(value)) for value in (Mode.BUSY, "BUSY", 1)] == ["BUSY"] * 3
    with pytest.raises(CaseDataError, match="IDLE, BUSY"):
        kind.parse("ASLEEP")
