"""Generated classes of messages, services and actions."""

import array
import copy
import math
import pickle

import numpy
import pytest

from sitaf_ros.conversion import from_fields, to_fields
from sitaf_ros.definitions import DefinitionError, parse
from sitaf_ros.messages import MessageClasses, snake_case
from sitaf_ros.serialization import Reader, serialize


class Texts:
    def __init__(self, **texts):
        self._texts = {name.replace("__", "/"): text for name, text in texts.items()}

    def names(self):
        return sorted(self._texts)

    def text(self, name):
        return self._texts.get(name)


PROBE = """
# A comment
int8 LOW=-5
string NAME = "a # b"   # behind
float64 x 1.5
uint8 level 3
bool on true
string<=4 word "ab"
float64[3] fixed [1, 2.5, 3]
int32[] many
uint8[<=3] few
Part part
my_msgs/Part[] parts
byte raw
string[] words ["p", "q"]
"""
TYPES = Texts(
    my_msgs__msg__Probe=PROBE,
    my_msgs__msg__Part="float32 value\nint64 count\n",
    my_msgs__msg__Nothing="",
    my_msgs__srv__Ask="int32 question\n---\nint32 MAX=9\nPart answer\n",
)


@pytest.fixture
def classes():
    return MessageClasses(TYPES)


def test_defaults_constants_and_types_of_fields(classes):
    probe = classes.message("my_msgs/msg/Probe")()
    assert (probe.LOW, probe.NAME) == (-5, "a # b")
    assert (probe.x, probe.level, probe.on, probe.word, probe.raw) == (1.5, 3, True, "ab", b"\0")
    assert isinstance(probe.fixed, numpy.ndarray)
    assert probe.fixed.tolist() == [1.0, 2.5, 3.0]
    assert probe.many == array.array("i")
    assert (probe.parts, probe.words) == ([], ["p", "q"])
    assert list(probe.get_fields_and_field_types().items())[:6] == [
        ("x", "double"),
        ("level", "uint8"),
        ("on", "boolean"),
        ("word", "string<4>"),
        ("fixed", "double[3]"),
        ("many", "sequence<int32>"),
    ]
    assert probe.get_fields_and_field_types()["few"] == "sequence<uint8, 3>"
    assert probe.get_fields_and_field_types()["parts"] == "sequence<my_msgs/Part>"
    assert list(classes.message("my_msgs/msg/Nothing")().get_fields_and_field_types()) == [
        "structure_needs_at_least_one_member"
    ]


@pytest.mark.parametrize(
    ("name", "wrong", "text"),
    [
        ("x", 1, "must be of type 'float', not 'int'"),
        ("level", 256, "unsigned integer in [0, 255]"),
        ("level", 1.0, "must be of type 'int'"),
        ("on", 1, "must be of type 'bool'"),
        ("word", "abcde", "not longer than 4"),
        ("fixed", [1.0], "with length 3, not 1"),
        ("many", "12", "set or sequence"),
        ("many", [2**31], "[-2147483648, 2147483647]"),
        ("few", [1, 2, 3, 4], "at most 3 elements"),
        ("part", None, "must be of type 'Part'"),
        ("parts", [1], "must be of type 'Part'"),
        ("raw", b"ab", "length 1"),
    ],
)
def test_a_value_that_does_not_fit_is_refused_at_assignment(classes, name, wrong, text):
    probe = classes.message("my_msgs/msg/Probe")()
    with pytest.raises(AssertionError) as e:
        setattr(probe, name, wrong)
    assert text in str(e.value)
    assert f"'{name}'" in str(e.value)


def test_an_unknown_field_is_refused(classes):
    with pytest.raises(AssertionError, match="Invalid arguments passed to constructor: y"):
        classes.message("my_msgs/msg/Probe")(y=1.0)
    with pytest.raises(AttributeError):
        classes.message("my_msgs/msg/Probe")().y = 1.0


def test_copies_equality_text_and_bytes(classes):
    kind, part = classes.message("my_msgs/msg/Probe"), classes.message("my_msgs/msg/Part")
    probe = kind(many=[1, 2], parts=[part(value=0.5, count=-3)], few=numpy.array([4, 5]), words=["ä", ""], x=math.pi)
    for same in (copy.deepcopy(probe), Reader(serialize(probe), classes.message).message(kind)):
        assert same == probe
        same.parts[0].count = 9
        same.many.append(3)
        same.fixed[0] = 7
        assert same != probe
    assert probe.parts[0].count == -3
    assert repr(part(value=0.5)) == "my_msgs.msg.Part(value=0.5, count=0)"
    assert "few=[4, 5]" in repr(probe)
    with pytest.raises(ValueError, match="too short"):
        Reader(serialize(probe)[:-3], classes.message).message(kind)


def test_services_and_modules(classes):
    ask = classes.message("my_msgs/srv/Ask")
    assert ask.Response.MAX == 9
    assert ask.Request(question=4).question == 4
    assert (ask.Request.__name__, ask.Request.__module__) == ("Ask_Request", "my_msgs.srv._ask")
    assert classes.message("my_msgs/srv/Ask_Response") is ask.Response
    with pytest.raises(NotImplementedError):
        ask()
    assert [snake_case(n) for n in ("PointCloud2", "UInt8", "TFMessage", "AddTwoInts")] == [
        "point_cloud2",
        "u_int8",
        "tf_message",
        "add_two_ints",
    ]


def test_messages_from_and_to_plain_values(classes):
    fields = {"x": 2, "fixed": [1], "parts": [{"count": 5}], "few": b"\1\2"}
    probe = from_fields(classes, "my_msgs/msg/Probe", fields)
    plain = to_fields(probe)
    assert (plain["x"], plain["fixed"], plain["parts"], plain["few"]) == (
        2.0,
        [1.0, 0.0, 0.0],
        [{"value": 0.0, "count": 5}],
        [1, 2],
    )
    with pytest.raises(ValueError, match="has no field `z`; it has x, level"):
        from_fields(classes, "my_msgs/msg/Probe", {"z": 1})


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("float64", "line 1: `float64` is neither a field nor a constant"),
        ("\nuint8 a 300", "line 2: `uint8 a 300`: 300 does not fit in uint8"),
        ("bool b perhaps", "is not a boolean"),
        ("int32[99999999] a", "more than 10000000 elements"),
    ],
)
def test_a_wrong_definition_names_type_and_line(text, problem):
    with pytest.raises(DefinitionError) as e:
        parse("my_msgs/msg/Wrong", text)
    assert problem in str(e.value)
    assert "my_msgs/msg/Wrong" in str(e.value)


def test_an_unknown_type_is_named(classes):
    with pytest.raises(DefinitionError, match="the type my_msgs/msg/Missing is not known"):
        classes.message("my_msgs/msg/Missing")


def test_constants_of_the_fields_type_survive_pickling_of_plain_values(classes):
    probe = classes.message("my_msgs/msg/Probe")()
    assert pickle.loads(pickle.dumps(to_fields(probe))) == to_fields(probe)
