"""The tables of tests/compliance that every runtime runs: literals, answers of stubs, texts."""

import enum
import re
from dataclasses import dataclass

import pytest

from sitaf_runtime.errors import CaseDataError
from sitaf_runtime.stub import answer
from sitaf_runtime.suite import kinds, literals
from sitaf_runtime.suite.kinds import member
from sitaf_runtime.suite.result import CaseResult
from sitaf_runtime.suite.test_case import TestCase
from tests.applications import PROJECT


class Mode(enum.Enum):
    SLOW = 0
    FAST = 1


@dataclass
class Point:
    x: float = member(kinds.FLOAT64)
    y: float = member(kinds.FLOAT64)


TYPES = {
    "int8": kinds.INT8,
    "int16": kinds.INT16,
    "int32": kinds.INT32,
    "int64": kinds.INT64,
    "uint64": kinds.UINT64,
    "double": kinds.FLOAT64,
    "float": kinds.FLOAT32,
    "boolean": kinds.BOOLEAN,
    "char": kinds.CHARACTER,
    "string": kinds.STRING,
    "Mode": kinds.enumeration(Mode),
    "Point": kinds.struct(Point),
}


def rows(table):
    lines = (PROJECT / "tests/compliance" / table).read_text("utf-8").split("\n")
    return [line.split("\t") for line in lines if line and not line.startswith("#")]


def kind_of(name):
    if name.startswith("sequence<"):
        return kinds.sequence(kind_of(name.removeprefix("sequence<")[:-1]))
    return TYPES[name]


@pytest.mark.parametrize(("name", "literal", "recorded", "message"), rows("literals.tsv"))
def test_literals_are_read_and_written(name, literal, recorded, message):
    kind = kind_of(name)
    found = ("", "")
    try:
        found = (literals.write(kind.shaped(kind.parse(literal))), "")
    except CaseDataError as e:
        found = ("", str(e))
    assert found == (recorded, message)


@pytest.mark.parametrize(("name", "literal", "delay", "error", "value", "message"), rows("answers.tsv"))
def test_answers_are_read(name, literal, delay, error, value, message):
    kind = kind_of(name)
    try:
        given = answer(kind, {"NoEcho": RuntimeError}).parse(literal)
    except CaseDataError as e:
        assert str(e) == message
        return
    assert given.delay_s == float(delay)
    assert (given.error is RuntimeError) == (error == "NoEcho")
    assert value == ("-" if given.error else literals.write(kind.shaped(given.value)))
    assert not message


@pytest.mark.parametrize(("text", "written"), rows("texts.tsv"))
def test_texts_are_written_to_the_record(text, written):
    result = CaseResult(TestCase(1, True, {}))
    plain = re.sub(r"\\u([0-9A-F]{4})", lambda found: chr(int(found[1], 16)), text)
    result.record("return", plain, kinds.STRING)
    assert result.line().decode() == (
        f'<case_record no="1" outcome="RETURNED"><actual name="return">{written}</actual></case_record>\n'
    )
