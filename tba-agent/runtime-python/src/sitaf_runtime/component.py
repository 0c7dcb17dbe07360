"""Creates a component, sets its properties and finds its methods by reflection on its class."""

from __future__ import annotations

import functools
import inspect
import re
import typing
from collections.abc import Callable, Sequence
from typing import Any, TypeVar

from sitaf_runtime.errors import CannotRunError, CaseDataError
from sitaf_runtime.out import InOut, Out
from sitaf_runtime.robot.hardware import Hardware
from sitaf_runtime.suite import literals

C = TypeVar("C")
_WORD = re.compile(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])")
_POSITIONAL = (inspect.Parameter.POSITIONAL_ONLY, inspect.Parameter.POSITIONAL_OR_KEYWORD)


def snake_case(name: str) -> str:
    """A name in the style of PEP 8: `get_infrared_data` for `GetInfraredData`, `get_hp` for `getHP`."""
    return _WORD.sub("_", name).lower()


def create(type_: type[C], available: Sequence[Any], inputs: dict[str, Any] | None = None) -> C:
    """Create a component; its constructor gets the available objects that it needs.

    A parameter is matched by its annotation (`Hardware`, a required interface), otherwise by its name (`hardware`, or
    the name of the interface, ignoring case and underscores). A parameter with the name of an input gets its value, and
    the input is removed from `inputs`. Other parameters keep their default. Raises CannotRunError when such a parameter
    has none, and what the constructor raises.
    """
    lacking: frozenset[str] = getattr(type_, "__abstractmethods__", frozenset())
    if lacking:
        missing = ", ".join(sorted(lacking))
        raise CannotRunError(f"{_named(type_)} is abstract (it lacks {missing}): name a class that can be made")
    positional: list[Any] = []
    named: dict[str, Any] = {}
    for parameter in _parameters(type_):
        offered = [o for o in available if _asks_for(parameter, _hints(type_), o)]
        same = [n for n in inputs or () if _plain(n) == _plain(parameter.name)]
        if same and inputs:
            offered = [inputs.pop(same[0])]
        if offered and parameter.kind is inspect.Parameter.POSITIONAL_ONLY:
            positional.append(offered[0])
        elif offered:
            named[parameter.name] = offered[0]
        elif parameter.default is inspect.Parameter.empty:
            has = "nothing (the activity has neither a world nor required interfaces)"
            if available:
                has = ", ".join(_roles(o)[0] for o in available)
            raise CannotRunError(
                f"{_named(type_)} asks for '{parameter.name}', which no test can give: it has {has}."
                " Give it a default, annotate it with its type, or write an adapter"
            )
    return type_(*positional, **named)


def _plain(name: str) -> str:
    """A name without underscores and in lower case."""
    return name.replace("_", "").lower()


def _parameters(type_: type) -> list[inspect.Parameter]:
    try:
        parameters = inspect.signature(type_).parameters.values()
    except (TypeError, ValueError):
        return []  # A class of an extension module may not say.
    variable = (inspect.Parameter.VAR_POSITIONAL, inspect.Parameter.VAR_KEYWORD)
    return [p for p in parameters if p.kind not in variable]


@functools.cache
def _hints(type_: type) -> dict[str, Any]:
    try:
        return typing.get_type_hints(type_.__init__)
    except Exception:
        return {}  # A name that only type checkers import; the annotation's text is looked at instead.


def _asks_for(parameter: inspect.Parameter, hints: dict[str, Any], offered: Any) -> bool:
    hint = hints.get(parameter.name, parameter.annotation)
    if hint is not inspect.Parameter.empty:
        choices = typing.get_args(hint) or (hint,)
        roles = _roles(offered)
        for choice in choices:
            if isinstance(choice, str) and any(re.search(rf"\b{re.escape(role)}\b", choice) for role in roles):
                return True
            if isinstance(choice, type) and choice is not object and choice in type(offered).__mro__:
                return True
        if any(isinstance(choice, type) and choice is not type(None) for choice in choices):
            return False
    wanted = parameter.name.replace("_", "").lower()
    return any(role.replace("_", "").lower() == wanted for role in _roles(offered))


def _roles(offered: Any) -> list[str]:
    """The names of the types that an object implements."""
    if isinstance(offered, Hardware):
        return ["Hardware"]
    skipped = ("object", "Protocol", "Generic", "ABC", type(offered).__name__)
    return [base.__name__ for base in type(offered).__mro__ if base.__name__ not in skipped] or [type(offered).__name__]


def set_property(component: object, name: str, value: str) -> None:
    """Set a property with `set_property(name, value)`, else with the setter of its name, else as an attribute.

    The value is converted to the annotated type of the setter or to the current type of the attribute. Raises
    CannotRunError when the class has none of them or the value cannot be converted, and what the component raises.
    """
    for general in ("set_property", "setProperty"):
        method = getattr(component, general, None)
        if callable(method):
            method(name, value)
            return
    camel = name[:1].upper() + name[1:]
    for setter in (f"set_{snake_case(name)}", f"set{camel}", f"Set{camel}", f"set_{name}"):
        method = getattr(component, setter, None)
        if callable(method):
            method(_converted(component, name, value, _setter_type(method)))
            return
    for attribute in (name, snake_case(name), name[:1].lower() + name[1:]):
        if attribute.isidentifier() and not attribute.startswith("_") and hasattr(component, attribute):
            current = getattr(component, attribute)
            if not callable(current):
                hint = None if current is None else type(current)
                setattr(component, attribute, _converted(component, name, value, hint))
                return
    raise CannotRunError(
        f"{_named(type(component))} has neither set_property(name, value) nor set_{snake_case(name)}(value) nor an"
        f" attribute {snake_case(name)} for the property '{name}' of activity.yaml"
    )


def set_input(component: object, name: str, value: Any) -> None:
    """Set a property to a value of its own type; see `set_property`."""
    camel = name[:1].upper() + name[1:]
    for setter in (f"set_{snake_case(name)}", f"set{camel}", f"Set{camel}", f"set_{name}"):
        method = getattr(component, setter, None)
        if callable(method):
            method(value)
            return
    for attribute in (name, snake_case(name), name[:1].lower() + name[1:]):
        if attribute.isidentifier() and not attribute.startswith("_") and hasattr(component, attribute):
            setattr(component, attribute, value)
            return
    raise CannotRunError(
        f"{_named(type(component))} has neither a constructor parameter {name} nor set_{snake_case(name)}(value) nor an"
        f" attribute {snake_case(name)} for the input '{name}' of the test model"
    )


def _setter_type(method: Callable[..., Any]) -> Any:
    try:
        hints = typing.get_type_hints(method)
    except Exception:
        return None
    hints.pop("return", None)
    return next(iter(hints.values()), None)


def _converted(component: object, name: str, value: str, hint: Any) -> Any:
    """Convert a value to a type; without a known type, to a number or a boolean if it has that form."""
    text = value.strip()
    try:
        if hint is str:
            return value
        if hint is bool:
            return literals.boolean(text)
        if hint is int:
            return int(text)
        if hint is float:
            return literals.real(text)
    except ValueError as e:
        raise CannotRunError(
            f"{_named(type(component))}: the property '{name}' of activity.yaml is '{value}', but it takes a"
            f" {hint.__name__}"
        ) from e
    return _guessed(value)


def _guessed(value: str) -> Any:
    text = value.strip()
    if text in ("true", "false"):
        return text == "true"
    for read in (int, literals.real):
        try:
            return read(text)
        except (ValueError, CaseDataError):
            continue
    return value


@functools.cache
def _attribute(type_: type, name: str) -> str | None:
    variants = (name, snake_case(name), name[:1].lower() + name[1:])
    return next((s for s in variants if callable(getattr(type_, s, None))), None)


def method_of(component: object, name: str) -> Callable[..., Any]:
    """Find a method by its name in the interface or in snake_case.

    A public attribute stands for a method of its name, or of its name after `get`, that returns it, and for a method
    `set` that sets it. Raises CannotRunError when there is none of them.
    """
    found = _attribute(type(component), name)
    if found is not None:
        return getattr(component, found)
    for variant in (name, snake_case(name)):
        method = getattr(component, variant, None)
        if callable(method):
            return method
    snake = snake_case(name)
    for attribute in (name, snake, snake.removeprefix("get_")):
        if _is_attribute(component, attribute):
            return functools.partial(_get, component, attribute)
    if snake.startswith("set_") and _is_attribute(component, snake.removeprefix("set_")):
        return functools.partial(setattr, component, snake.removeprefix("set_"))
    variants = " or ".join(dict.fromkeys((name, snake)))
    raise CannotRunError(
        f"{_named(type(component))} has no method or attribute {variants}: write it, or write an adapter"
    )


def _is_attribute(component: object, name: str) -> bool:
    """Whether a component has a public attribute or property; one that raises an exception counts, too."""
    if not name.isidentifier() or name.startswith("_"):
        return False
    return name in getattr(component, "__dict__", ()) or hasattr(type(component), name)


def _get(component: object, name: str, *arguments: Any) -> Any:
    if arguments:
        raise CannotRunError(
            f"{_named(type(component))}.{name} is an attribute, but the interface gives it {len(arguments)} arguments:"
            " write a method, or write an adapter"
        )
    return getattr(component, name)


@functools.cache
def _takes_holders(function: Any, arguments: int, inputs: int) -> bool:
    """Whether a method takes its out-parameters as `Out`, instead of returning them."""
    try:
        parameters = [p for p in inspect.signature(function).parameters.values() if p.kind in _POSITIONAL]
    except (TypeError, ValueError):
        return False
    if any("Out" in str(p.annotation) for p in parameters):
        return True
    needed = sum(p.default is inspect.Parameter.empty for p in parameters)
    return arguments != inputs and needed >= arguments


def call_with_outs(method: Callable[..., Any], *arguments: Any, returns: bool) -> Any:
    """Call a method with out-parameters and return its return value; the values of the out-parameters are set.

    The arguments contain an `Out` for each out-parameter. A method that is annotated with `Out`, or takes as many
    arguments as the interface has parameters, gets these objects. Any other method gets only the inputs and returns a
    tuple: the return value, if there is one, then the out-parameters in order; a single value is returned as it is.
    """
    outs = [a for a in arguments if isinstance(a, Out)]
    inputs = [
        a.value if isinstance(a, InOut) else a for a in arguments if isinstance(a, InOut) or not isinstance(a, Out)
    ]
    function = getattr(method, "__func__", None)
    bound = function is not None
    if _takes_holders(function or method, len(arguments) + bound, len(inputs) + bound):
        return method(*arguments)
    given = method(*inputs)
    count = len(outs) + returns
    parts = (given,) if count == 1 else given
    if not isinstance(parts, tuple | list) or len(parts) != count:
        raise TypeError(
            f"expected a tuple of {count}"
            f" ({'the return value and ' if returns else ''}{len(outs)} out-parameters), but got {given!r}"
        )
    for out, value in zip(outs, parts[1:] if returns else parts, strict=True):
        out.set(value)
    return parts[0] if returns else None


def part_of(value: Any, *path: str | int) -> Any:
    """Get a nested member of a struct or element of a sequence: `part_of(pose, "position", "x")`.

    None when the value has no such part.
    """
    for step in path:
        try:
            if isinstance(value, dict) and isinstance(step, str):
                # `step` is the name of an attribute; a dictionary may have the document's name, such as `from`.
                value = value[step] if step in value else value[step.removesuffix("_")]
            else:
                value = value[step] if isinstance(step, int) else getattr(value, step)
        except (LookupError, TypeError, AttributeError):
            return None
    return value


def port_of(component: object, name: str) -> Any:
    """Get the last value of an output data port, from the method or attribute with its name, or from its getter.

    Raises CannotRunError when the class has none of them.
    """
    camel = name[:1].upper() + name[1:]
    for variant in (name, snake_case(name), f"get{camel}", f"get_{snake_case(name)}"):
        if hasattr(component, variant):
            value = getattr(component, variant)
            return value() if callable(value) else value
    raise CannotRunError(
        f"{_named(type(component))} has neither a method or an attribute {name} or {snake_case(name)} nor a method"
        f" get_{snake_case(name)} for the data port that the model observes"
    )


def _named(type_: type) -> str:
    return f"{type_.__module__}.{type_.__qualname__}"
