"""The parameters of a node."""

from __future__ import annotations

from typing import Any

from sitaf_ros.current import message, system

from .exceptions import ParameterNotDeclaredException, ParameterUninitializedException
from .parameter import Parameter
from .parameter_service import listed
from .parameter_store import ParameterStore
from .qos import qos_profile_parameter_events

USE_SIM_TIME = "use_sim_time"


class NodeParameters:
    """Part of `Node`."""

    _clock: Any

    def get_name(self) -> str:
        raise NotImplementedError

    def get_namespace(self) -> str:
        raise NotImplementedError

    create_publisher: Any

    def _ros_parameter_event(self, new: list[Any], changed: list[Any], deleted: list[Any]) -> None:
        raise NotImplementedError

    def _ros_begin_parameters(self, overrides: list[Parameter], undeclared: bool, automatically: bool) -> None:
        event_type = message("rcl_interfaces/msg/ParameterEvent")
        self._ros_parameter_events = self.create_publisher(
            event_type, "/parameter_events", qos_profile_parameter_events
        )
        self._ros_store = ParameterStore(self, undeclared, self._ros_parameter_event)
        self._ros_store.overrides = {parameter.name: parameter for parameter in overrides}
        case = system().overrides.of(self.get_name(), self.get_namespace())
        for name, value in case.items():
            self._ros_store.overrides[name] = Parameter(name, value=value)
        system().unobserved.overridden(set(case) - {USE_SIM_TIME})
        simulated = self._ros_store.declare(
            USE_SIM_TIME, system().settings.use_sim_time, None, ignore_override=False
        ).value
        self._clock._set_ros_time_is_active(bool(simulated))
        self._ros_store.callbacks["post"].append(self._ros_follow_sim_time)
        if automatically:
            for name, parameter in self._ros_store.overrides.items():
                if name != USE_SIM_TIME:
                    self._ros_store.declare(name, parameter.value, None, ignore_override=True)

    def _ros_follow_sim_time(self, parameters: list[Parameter]) -> None:
        for parameter in parameters:
            if parameter.name == USE_SIM_TIME:
                self._clock._set_ros_time_is_active(bool(parameter.value))

    def _ros_parameter_result(self, successful: bool, reason: str = "") -> Any:
        """Return a SetParametersResult."""
        return self._ros_store.result(successful, reason)

    @property
    def _parameters(self) -> dict[str, Parameter]:
        return self._ros_store.values

    @property
    def _parameter_overrides(self) -> dict[str, Parameter]:
        return self._ros_store.overrides

    @property
    def _descriptors(self) -> dict[str, Any]:
        return self._ros_store.descriptors

    def declare_parameter(
        self, name: str, value: Any = None, descriptor: Any = None, ignore_override: bool = False
    ) -> Parameter:
        return self._ros_store.declare(name, value, descriptor, ignore_override)

    def declare_parameters(self, namespace: str, parameters: Any, ignore_override: bool = False) -> list[Parameter]:
        prefix = f"{namespace}." if namespace else ""
        declared: list[Parameter] = []
        for entry in parameters:
            if not 1 <= len(entry) <= 3:
                raise TypeError(f"Invalid parameter tuple length at index {len(declared)} in parameters list: {entry}")
            name, value, descriptor = [*entry, None, None][:3]
            if value is not None and not isinstance(value, Parameter.Type) and hasattr(value, "floating_point_range"):
                value, descriptor = None, value
            declared.append(self._ros_store.declare(prefix + name, value, descriptor, ignore_override))
        return declared

    def undeclare_parameter(self, name: str) -> None:
        self._ros_store.undeclare(name)

    def has_parameter(self, name: str) -> bool:
        return name in self._ros_store.values

    def get_parameter(self, name: str) -> Parameter:
        return self._ros_store.get(name)

    def get_parameters(self, names: list[str]) -> list[Parameter]:
        if not all(isinstance(name, str) for name in names):
            raise TypeError("All names must be instances of type str")
        return [self._ros_store.get(name) for name in names]

    def get_parameter_types(self, names: list[str]) -> list[Any]:
        return [self.get_parameter_type(name) for name in names]

    def get_parameter_type(self, name: str) -> Any:
        if name in self._ros_store.values:
            return self._ros_store.values[name].type_
        return self._ros_store.get(name).type_

    def get_parameter_or(self, name: str, alternative_value: Parameter | None = None) -> Parameter:
        try:
            found = self._ros_store.get(name)
        except (ParameterNotDeclaredException, ParameterUninitializedException):
            return Parameter(name) if alternative_value is None else alternative_value
        unset = found.type_ is Parameter.Type.NOT_SET and alternative_value is not None
        return alternative_value if unset and alternative_value is not None else found

    def get_parameters_by_prefix(self, prefix: str) -> dict[str, Parameter]:
        start = f"{prefix}." if prefix else ""
        return {name[len(start) :]: p for name, p in self._ros_store.values.items() if name.startswith(start)}

    def list_parameters(self, prefixes: list[str], depth: int) -> Any:
        names, above = listed(sorted(self._ros_store.values), prefixes, depth)
        return message("rcl_interfaces/msg/ListParametersResult")(names=names, prefixes=above)

    def set_parameters(self, parameter_list: list[Parameter]) -> list[Any]:
        _check(parameter_list)
        return self._ros_store.set(parameter_list, atomically=False)

    def set_parameters_atomically(self, parameter_list: list[Parameter]) -> Any:
        _check(parameter_list)
        return self._ros_store.set(parameter_list, atomically=True)[0]

    def describe_parameter(self, name: str) -> Any:
        if name in self._ros_store.descriptors:
            descriptor = self._ros_store.descriptors[name].copy_message()
            descriptor.type = self._ros_store.values[name].type_.value
            return descriptor
        if self._ros_store.undeclared:
            return message("rcl_interfaces/msg/ParameterDescriptor")(name=name)
        raise ParameterNotDeclaredException(name)

    def describe_parameters(self, names: list[str]) -> list[Any]:
        return [self.describe_parameter(name) for name in names]

    def set_descriptor(self, name: str, descriptor: Any, alternative_value: Any = None) -> Any:
        if name not in self._ros_store.descriptors:
            raise ParameterNotDeclaredException(name)
        new = descriptor.copy_message()
        new.name, new.type = name, self._ros_store.descriptors[name].type
        self._ros_store.descriptors[name] = new
        if alternative_value is not None:
            self.set_parameters([Parameter.from_parameter_msg(_named(name, alternative_value))])
        return self.get_parameter(name).get_parameter_value()

    def add_pre_set_parameters_callback(self, callback: Any) -> None:
        self._ros_store.add_callback("pre", callback, first=True)

    def add_on_set_parameters_callback(self, callback: Any) -> None:
        self._ros_store.add_callback("on", callback, first=True)

    def add_post_set_parameters_callback(self, callback: Any) -> None:
        self._ros_store.add_callback("post", callback, first=True)

    def remove_pre_set_parameters_callback(self, callback: Any) -> None:
        self._ros_store.callbacks["pre"].remove(callback)

    def remove_on_set_parameters_callback(self, callback: Any) -> None:
        self._ros_store.callbacks["on"].remove(callback)

    def remove_post_set_parameters_callback(self, callback: Any) -> None:
        self._ros_store.callbacks["post"].remove(callback)


def _named(name: str, value: Any) -> Any:
    return message("rcl_interfaces/msg/Parameter")(name=name, value=value)


def _check(parameters: list[Parameter]) -> None:
    if not all(isinstance(parameter, Parameter) for parameter in parameters):
        raise TypeError("parameter must be instance of type 'rclpy.parameter.Parameter'")
