"""Literals of messages and times of publication, without a node."""

import itertools

import pytest

from sitaf_runtime.errors import CaseDataError
from sitaf_runtime.ros.fields import Fields
from sitaf_runtime.ros.schedule import Publishing, Schedule
from sitaf_runtime.ros.stub import results_of


class Vector:
    @staticmethod
    def get_fields_and_field_types():
        return {"x": "double", "y": "double"}


class Joy:
    @staticmethod
    def get_fields_and_field_types():
        return {
            "axes": "sequence<float>",
            "points": "sequence<test_msgs/Vector, 3>",
            "matrix": "double[4]",
            "name": "string",
        }


CLASSES = {"test_msgs/msg/Vector": Vector, "test_msgs/msg/Joy": Joy}
FIELDS = Fields(CLASSES.__getitem__)
JOY = "test_msgs/msg/Joy"


def test_an_array_is_as_long_as_its_highest_named_index():
    fields = FIELDS.put({}, JOY, ["axes", 2], "0.5")
    fields = FIELDS.put(fields, JOY, ["points", 1, "y"], "2")
    assert fields == {"axes": [0.0, 0.0, 0.5], "points": [{}, {"y": 2.0}]}


def test_a_fixed_array_keeps_its_length():
    assert FIELDS.put({}, JOY, ["matrix", 1], "3") == {"matrix": [0.0, 3.0, 0.0, 0.0]}


def test_a_whole_message_names_only_some_fields():
    assert FIELDS.put({}, JOY, [], '{points: [{x: 1.5}], name: "a, b"}') == {"points": [{"x": 1.5}], "name": "a, b"}


def test_an_unknown_field_is_named():
    with pytest.raises(CaseDataError, match="no field button"):
        FIELDS.put({}, JOY, ["button"], "1")
    with pytest.raises(CaseDataError, match="no field z; it has x, y"):
        FIELDS.parse("test_msgs/Vector", "{z: 1}")


def test_a_number_of_32_bits_is_written_as_such():
    value = {"axes": [0.10000000149011612], "points": [{"x": 1, "y": 2.0}], "name": "n"}
    assert FIELDS.literal(JOY, value) == '{axes: [0.1], points: [{x: 1.0, y: 2.0}], name: "n"}'


def test_the_type_of_a_part():
    assert FIELDS.type_of(JOY, ["points", 0, "x"]) == "double"
    with pytest.raises(CaseDataError):
        FIELDS.type_of(JOY, ["name", 0])


@pytest.mark.parametrize(
    ("values", "times"),
    [
        ({}, [100]),
        ({"publish.a": "false"}, []),
        ({"publish.a.at": "2e-9"}, [102]),
        ({"publish.a.rate_hz": "100000", "publish.a.for": "0.00003"}, [100, 10100, 20100]),
        ({"publish.a.rate_hz": "100000", "publish.a.for": "0"}, [100]),
    ],
)
def test_times_of_publication(values, times):
    assert list(itertools.islice(Publishing.of(values, "a").times_ns(100), 10)) == times


def test_a_wrong_time_is_refused():
    with pytest.raises(ValueError, match=r"publish[.]a"):
        Publishing.of({"publish.a.at": "-1"}, "a")


def test_inputs_of_one_instant_are_published_in_their_order():
    schedule = Schedule()
    schedule.add(1, iter([5, 7]))
    schedule.add(0, iter([5, 9]))
    assert schedule.next_ns() == 5
    assert list(schedule.due(7)) == [0, 1, 1]
    assert schedule.next_ns() == 9
    assert list(schedule.due(9)) == [0]
    assert schedule.next_ns() is None


def test_outputs_of_a_service_are_named_as_its_interface_does():
    assert results_of(["sum"], {"a"}) == {"": "sum"}
    assert results_of(["name", "success"], {"name"}) == {"result_name": "name", "success": "success"}
