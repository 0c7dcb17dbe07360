"""Life-cycle methods of components."""

import pytest

from sitaf_runtime.errors import CannotRunError
from sitaf_runtime.hooks import Hooks


class Recorded:
    """Records the methods that are called."""

    def __init__(self):
        self.called = []


def component(*names, parameters=()):
    def method(name):
        body = "lambda self" + "".join(f", {p}" for p in parameters) + f": self.called.append({name!r})"
        return eval(body)

    return type("Component", (Recorded,), {name: method(name) for name in names})()


@pytest.mark.parametrize(
    ("names", "begun", "ended"),
    [
        (("initialise", "start", "stop", "destroy"), ["initialise", "start"], ["stop", "destroy"]),
        (("onInitialize", "onStart", "onStop", "onDestroy"), ["onInitialize", "onStart"], ["onStop", "onDestroy"]),
        (("on_initialize", "on_start", "close"), ["on_initialize", "on_start"], ["close"]),
        (("on_start", "start"), ["start"], []),
    ],
)
def test_the_first_hook_of_each_step_is_called(names, begun, ended):
    made = component(*names)
    Hooks().begin(made)
    assert made.called == begun
    made.called.clear()
    Hooks().end(made)
    assert made.called == ended


def test_a_method_of_an_interface_is_no_hook():
    made = component("start", "Stop", "stop", "on_stop")
    hooks = Hooks(["start", "Stop"])
    hooks.begin(made)
    hooks.end(made)
    assert made.called == ["on_stop"]


def test_a_method_with_parameters_is_no_hook():
    made = component("start", parameters=["mode"])
    Hooks().begin(made)
    assert made.called == []


def test_a_periodic_component_without_an_execute_method_is_reported():
    Hooks().execution(component("execute"))()
    with pytest.raises(CannotRunError, match="execution: periodic"):
        Hooks().execution(component("run"))
