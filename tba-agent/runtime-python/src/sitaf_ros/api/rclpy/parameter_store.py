"""Declares, gets and sets the parameters of a node: https://docs.ros.org/en/jazzy/Concepts/Basic/About-Parameters.html."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from sitaf_ros.callback_names import callback_name, is_of_user
from sitaf_ros.current import message, system

from .exceptions import (
    InvalidParameterException,
    InvalidParameterTypeException,
    InvalidParameterValueException,
    ParameterAlreadyDeclaredException,
    ParameterImmutableException,
    ParameterNotDeclaredException,
    ParameterUninitializedException,
)
from .parameter import Parameter

EPSILON = 1e-6


class ParameterStore:
    """The parameters of one node; `changed` gets lists of new, changed and deleted ones."""

    def __init__(self, node: Any, undeclared: bool, changed: Callable[[list[Any], list[Any], list[Any]], None]) -> None:
        self._node = node
        self.undeclared = undeclared
        self._changed = changed
        self.values: dict[str, Parameter] = {}
        self.descriptors: dict[str, Any] = {}
        self.overrides: dict[str, Parameter] = {}
        self.callbacks: dict[str, list[Any]] = {"pre": [], "on": [], "post": []}

    def result(self, successful: bool, reason: str = "") -> Any:
        """Return a SetParametersResult."""
        return message("rcl_interfaces/msg/SetParametersResult")(successful=successful, reason=reason)

    def add_callback(self, kind: str, callback: Any, first: bool) -> None:
        """Add a callback before or after setting."""
        if is_of_user(callback):
            system().unobserved.callback(callback_name(callback))
        self.callbacks[kind].insert(0 if first else len(self.callbacks[kind]), callback)

    def _call(self, callback: Any, parameters: list[Parameter]) -> Any:
        name = callback_name(callback)
        system().unobserved.called(name)
        try:
            return callback(parameters)
        except Exception as e:
            system().failed(f"callback {name}", e)
            raise

    def declare(self, name: str, value: Any, descriptor: Any, ignore_override: bool) -> Parameter:
        """Declare one parameter; `value` is a value, a type, or None."""
        if not name or not isinstance(name, str):
            raise InvalidParameterException(name)
        if name in self.descriptors:
            raise ParameterAlreadyDeclaredException([name])
        descriptor = (
            message("rcl_interfaces/msg/ParameterDescriptor")() if descriptor is None else descriptor.copy_message()
        )
        descriptor.name = name
        kind = self._kind(value, descriptor)
        descriptor.type = kind.value
        initial = None if isinstance(value, Parameter.Type) else value
        if not ignore_override and name in self.overrides:
            initial = self.overrides[name].value
        if initial is None:
            parameter = Parameter(name, Parameter.Type.NOT_SET, None)
        elif kind.name.endswith("_ARRAY") and not len(initial):
            parameter = Parameter(name, kind, initial)
        else:
            parameter = Parameter(name, value=initial)
        if not descriptor.dynamic_typing and parameter.type_ not in (kind, Parameter.Type.NOT_SET):
            raise InvalidParameterTypeException(parameter, kind.name)
        self.descriptors[name] = descriptor
        system().unobserved.declared(name)
        result = self._apply([parameter], declaring=True)
        if not result.successful:
            del self.descriptors[name]
            raise InvalidParameterValueException(name, parameter.value, result.reason)
        return self.values[name]

    @staticmethod
    def _kind(value: Any, descriptor: Any) -> Parameter.Type:
        if isinstance(value, Parameter.Type):
            if value is Parameter.Type.NOT_SET:
                raise ValueError("Cannot declare parameter of type NOT_SET")
            return value
        if value is not None:
            return Parameter.Type.from_parameter_value(value)
        if descriptor.type == 0:
            # A name alone: rclpy warns and declares a parameter of any type.
            descriptor.dynamic_typing = True
        return Parameter.Type(descriptor.type)

    def get(self, name: str) -> Parameter:
        """Return a declared parameter."""
        if name in self.values:
            parameter = self.values[name]
            descriptor = self.descriptors.get(name)
            if parameter.type_ is Parameter.Type.NOT_SET and descriptor is not None and not descriptor.dynamic_typing:
                raise ParameterUninitializedException(name)
            return parameter
        if self.undeclared:
            return Parameter(name, Parameter.Type.NOT_SET, None)
        raise ParameterNotDeclaredException(name)

    def undeclare(self, name: str) -> None:
        """Remove a parameter."""
        if name not in self.values:
            raise ParameterNotDeclaredException(name)
        if self.descriptors[name].read_only:
            raise ParameterImmutableException(name)
        parameter = self.values.pop(name)
        del self.descriptors[name]
        self._changed([], [], [Parameter(parameter.name, Parameter.Type.NOT_SET, None)])

    def set(self, parameters: list[Parameter], atomically: bool) -> list[Any]:
        """Set parameters; return a result for each, or one for all."""
        if not self.undeclared:
            missing = [p.name for p in parameters if p.name not in self.descriptors]
            if missing:
                raise ParameterNotDeclaredException(missing)
        if atomically:
            return [self._set(list(parameters))]
        return [self._set([parameter]) for parameter in parameters]

    def _set(self, parameters: list[Parameter]) -> Any:
        for callback in list(self.callbacks["pre"]):
            parameters = self._call(callback, parameters)
            if not parameters:
                return self.result(
                    False, "parameter list cannot be empty, this might be due to pre set parameters callback"
                )
        for parameter in parameters:
            if parameter.name not in self.descriptors and not self.undeclared:
                return self.result(False, f"parameter '{parameter.name}' has not been declared before")
        return self._apply(parameters, declaring=False)

    def _apply(self, parameters: list[Parameter], declaring: bool) -> Any:
        for parameter in parameters:
            reason = self._refused(parameter, declaring)
            if reason:
                return self.result(False, reason)
        for callback in list(self.callbacks["on"]):
            result = self._call(callback, parameters)
            if not isinstance(result, message("rcl_interfaces/msg/SetParametersResult")):
                raise TypeError(f"{callback_name(callback)} must return a SetParametersResult, not {result!r}")
            if not result.successful:
                return result
        new, changed, deleted = [], [], []
        for parameter in parameters:
            if parameter.type_ is Parameter.Type.NOT_SET and not declaring:
                deleted.append(parameter)
                self.values.pop(parameter.name, None)
                self.descriptors.pop(parameter.name, None)
                continue
            (changed if parameter.name in self.values else new).append(parameter)
            if parameter.name not in self.descriptors:
                self.descriptors[parameter.name] = message("rcl_interfaces/msg/ParameterDescriptor")(
                    name=parameter.name, dynamic_typing=True, type=parameter.type_.value
                )
            self.values[parameter.name] = parameter
        self._changed(new, changed, deleted)
        for callback in list(self.callbacks["post"]):
            self._call(callback, parameters)
        return self.result(True)

    def _refused(self, parameter: Parameter, declaring: bool) -> str:
        descriptor = self.descriptors.get(parameter.name)
        if descriptor is None:
            return ""
        if descriptor.read_only and not declaring:
            return f"Trying to set a read-only parameter: {parameter.name}."
        if parameter.type_ is Parameter.Type.NOT_SET:
            if declaring:
                return ""
            if not descriptor.dynamic_typing:
                return "Static parameter cannot be undeclared" if parameter.name in self.values else "not declared"
            return ""
        wanted = descriptor.type
        if not descriptor.dynamic_typing and wanted != parameter.type_.value and wanted != 0:
            return f"Wrong parameter type, expected '{Parameter.Type(wanted)}' got '{parameter.type_}'"
        if parameter.type_ is Parameter.Type.INTEGER and descriptor.integer_range:
            return out_of_range(parameter, descriptor.integer_range[0], 0)
        if parameter.type_ is Parameter.Type.DOUBLE and descriptor.floating_point_range:
            return out_of_range(parameter, descriptor.floating_point_range[0], EPSILON)
        return ""


def out_of_range(parameter: Parameter, limits: Any, epsilon: float) -> str:
    """Return why a number is outside of a range, or an empty text; `step` counts from the lower end."""
    low, high, step, value = limits.from_value, limits.to_value, limits.step, parameter.value
    if abs(value - low) <= epsilon * max(1, abs(low)) or abs(value - high) <= epsilon * max(1, abs(high)):
        return ""
    if not min(low, high) <= value <= max(low, high):
        # The texts of rclpy differ by a full stop.
        stop = "." if isinstance(value, int) else ""
        return f"Parameter {parameter.name} out of range{stop} Min: {low}, Max: {high}, value: {value}"
    if step and abs((value - low) / step - round((value - low) / step)) * step > epsilon * max(1, abs(value)):
        return (
            f"The parameter value for {parameter.name} is not a valid step. Min: {low}, max: {high}, "
            f"value: {value}, step: {step}"
        )
    return ""
