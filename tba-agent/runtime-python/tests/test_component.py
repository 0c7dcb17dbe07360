"""Creating components, setting properties and calling methods."""

from typing import Protocol

import pytest

from sitaf_runtime import Out
from sitaf_runtime.component import call_with_outs, create, method_of, part_of, set_property, snake_case
from sitaf_runtime.errors import CannotRunError
from sitaf_runtime.out import InOut


class RangeFinder(Protocol):
    def Range(self) -> float: ...


class Stub(RangeFinder):
    def Range(self) -> float:
        return 1.0


def test_constructor_parameters_are_matched_by_type_or_name():
    class ByType:
        def __init__(self, finder: RangeFinder, gain: float = 2.0) -> None:
            self.finder, self.gain = finder, gain

    class ByName:
        def __init__(self, range_finder, *, verbose=False):
            self.finder = range_finder

    class ByText:
        def __init__(self, finder: "RangeFinder | None") -> None:
            self.finder = finder

    stub = Stub()
    for type_ in (ByType, ByName, ByText):
        assert create(type_, [stub]).finder is stub


def test_unavailable_constructor_parameters_are_reported():
    class Needy:
        def __init__(self, port: int) -> None: ...

    with pytest.raises(CannotRunError, match=r"asks for 'port'.*RangeFinder"):
        create(Needy, [Stub()])


def test_properties_are_set_by_setters_or_attributes():
    class General:
        def set_property(self, name, value):
            self.seen = (name, value)

    class Setters:
        def setSize(self, size: int) -> None:
            self.size_seen = size

    class Attributes:
        max_speed = 1.0
        enabled = False

    general, setters, attributes = General(), Setters(), Attributes()
    set_property(general, "Size", "7")
    set_property(setters, "Size", "7")
    set_property(attributes, "MaxSpeed", "3")
    set_property(attributes, "enabled", "true")
    assert general.seen == ("Size", "7")
    assert setters.size_seen == 7
    assert (attributes.max_speed, attributes.enabled) == (3.0, True)
    with pytest.raises(CannotRunError, match="Color"):
        set_property(attributes, "Color", "red")
    with pytest.raises(CannotRunError, match="'many'"):
        set_property(setters, "Size", "many")


def test_methods_are_found_in_camel_case_and_snake_case():
    class Pythonic:
        def get_infrared_data(self):
            return 1

    assert snake_case("GetInfraredData") == "get_infrared_data"
    assert snake_case("getHTTPCode") == "get_http_code"
    assert method_of(Pythonic(), "GetInfraredData")() == 1
    with pytest.raises(CannotRunError, match="get_speed"):
        method_of(Pythonic(), "GetSpeed")


def test_an_attribute_stands_for_the_methods_that_get_and_set_it():
    class Controller:
        limit = 3.0

        def __init__(self):
            self.auto_mode = True
            self._secret = 1

        @property
        def output(self):
            raise RuntimeError("no output yet")

    controller = Controller()
    assert method_of(controller, "auto_mode")() is True
    assert method_of(controller, "GetAutoMode")() is True
    method_of(controller, "SetAutoMode")(False)
    assert method_of(controller, "AutoMode")() is False
    method_of(controller, "set_limit")(5.0)
    assert controller.limit == 5.0
    assert Controller.limit == 3.0
    with pytest.raises(RuntimeError, match="no output yet"):
        method_of(controller, "output")()
    with pytest.raises(CannotRunError, match="auto_mode is an attribute, but the interface gives it 1 arguments"):
        method_of(controller, "auto_mode")(True)
    with pytest.raises(CannotRunError, match="has no method or attribute _secret: write it"):
        method_of(controller, "_secret")


def test_out_parameters_are_returned_or_set():
    class Tuples:
        def both(self, a):
            return a > 0, a + 1

        def only(self, a):
            return a + 2

    class Holders:
        def both(self, a, b):
            b.set(a + 1)
            return a > 0

        def twice(self, a: Out[int]) -> None:
            a.set(a.value * 2)

    for component in (Tuples(), Holders()):
        out = Out()
        assert call_with_outs(component.both, 1, out, returns=True) is True
        assert out.value == 2
    out = Out()
    assert call_with_outs(Tuples().only, 1, out, returns=False) is None
    assert out.value == 3
    both_ways = InOut(4)
    call_with_outs(Holders().twice, both_ways, returns=False)
    assert both_ways.value == 8
    with pytest.raises(TypeError, match="tuple of 3"):
        call_with_outs(Tuples().both, 1, Out(), Out(), returns=True)


def test_parts_are_found_by_path():
    assert part_of({"path": [type("P", (), {"x": 3})]}, "path", 0, "x") == 3
    assert part_of({"from": 1}, "from_") == part_of({"from_": 1}, "from_") == 1
