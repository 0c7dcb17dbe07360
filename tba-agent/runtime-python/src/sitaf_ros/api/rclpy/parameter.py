"""Parameters."""

from __future__ import annotations

import array
from enum import Enum
from pathlib import Path
from typing import Any

from sitaf_ros.current import message
from sitaf_ros.settings import ROS_PARAMETERS, flat, read_yaml

PARAMETER_SEPARATOR_STRING = "."
_FIELDS = {
    1: "bool_value",
    2: "integer_value",
    3: "double_value",
    4: "string_value",
    5: "byte_array_value",
    6: "bool_array_value",
    7: "integer_array_value",
    8: "double_array_value",
    9: "string_array_value",
}


class Parameter:
    def __class_getitem__(cls, item: Any) -> Any:
        return cls

    class Type(Enum):
        NOT_SET = 0
        BOOL = 1
        INTEGER = 2
        DOUBLE = 3
        STRING = 4
        BYTE_ARRAY = 5
        BOOL_ARRAY = 6
        INTEGER_ARRAY = 7
        DOUBLE_ARRAY = 8
        STRING_ARRAY = 9

        @classmethod
        def from_parameter_value(cls, parameter_value: Any) -> Any:
            if parameter_value is None:
                return cls.NOT_SET
            if isinstance(parameter_value, bool):
                return cls.BOOL
            if isinstance(parameter_value, int):
                return cls.INTEGER
            if isinstance(parameter_value, float):
                return cls.DOUBLE
            if isinstance(parameter_value, str):
                return cls.STRING
            if isinstance(parameter_value, list | tuple | array.array):
                return cls._of_elements(parameter_value)
            raise TypeError(f"The given value is not one of the allowed types '{parameter_value}'.")

        @classmethod
        def _of_elements(cls, values: Any) -> Any:
            if all(isinstance(v, bytes) for v in values):
                return cls.BYTE_ARRAY
            if all(isinstance(v, bool) for v in values):
                return cls.BOOL_ARRAY
            if all(isinstance(v, int) and not isinstance(v, bool) for v in values):
                return cls.INTEGER_ARRAY
            if all(isinstance(v, float) for v in values):
                return cls.DOUBLE_ARRAY
            if all(isinstance(v, str) for v in values):
                return cls.STRING_ARRAY
            raise TypeError(f"The given value is not one of the allowed types '{values}'.")

        def check(self, parameter_value: Any) -> bool:
            if self is Parameter.Type.NOT_SET:
                return parameter_value is None
            try:
                found = Parameter.Type.from_parameter_value(parameter_value)
            except TypeError:
                return False
            empty = isinstance(parameter_value, list | tuple | array.array) and not len(parameter_value)
            return found is self or (empty and self.name.endswith("_ARRAY"))

    @classmethod
    def from_parameter_msg(cls, param_msg: Any) -> Parameter:
        kind = cls.Type(param_msg.value.type)
        return cls(param_msg.name, kind, parameter_value_to_python(param_msg.value))

    def __init__(self, name: str, type_: Any = None, value: Any = None) -> None:
        if type_ is None:
            type_ = Parameter.Type.from_parameter_value(value)
        if not isinstance(type_, Parameter.Type):
            raise TypeError(f"type must be an instance of '{Parameter.Type!r}'")
        if not type_.check(value):
            raise ValueError(f"Type '{type_}' and value '{value}' do not agree")
        self._type_, self._name, self._value = type_, name, value

    @property
    def name(self) -> str:
        return self._name

    @property
    def type_(self) -> Parameter.Type:
        return self._type_

    @property
    def value(self) -> Any:
        return self._value

    def get_parameter_value(self) -> Any:
        made = message("rcl_interfaces/msg/ParameterValue")(type=self.type_.value)
        if self.type_.value:
            setattr(made, _FIELDS[self.type_.value], list(self.value) if isinstance(self.value, tuple) else self.value)
        return made

    def to_parameter_msg(self) -> Any:
        return message("rcl_interfaces/msg/Parameter")(name=self.name, value=self.get_parameter_value())

    def __repr__(self) -> str:
        return f"Parameter(name={self.name!r}, type_={self.type_}, value={self.value!r})"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Parameter):
            return False
        return (self.name, self.type_, self.value) == (other.name, other.type_, other.value)

    __hash__ = None  # type: ignore[assignment]


def parameter_value_to_python(parameter_value: Any) -> Any:
    if parameter_value.type == 0:
        return None
    field = _FIELDS.get(parameter_value.type)
    if field is None:
        raise RuntimeError(f"unexpected parameter type {parameter_value.type}")
    value = getattr(parameter_value, field)
    return value.tolist() if isinstance(value, array.array) else value


def get_parameter_value(string_value: str) -> Any:
    """Return a ParameterValue message of a YAML text."""
    import json

    try:
        value = json.loads({"True": "true", "False": "false"}.get(string_value, string_value))
    except ValueError:
        value = string_value
    if isinstance(value, list) and any(isinstance(v, float) for v in value):
        value = [float(v) for v in value]
    return Parameter("value", value=value if not isinstance(value, dict) else string_value).get_parameter_value()


def parameter_dict_from_yaml_file(
    parameter_file: str,
    use_wildcard: bool = False,
    target_nodes: Any = None,
    namespace: str = "",
) -> dict[str, Any]:
    content = read_yaml(Path(parameter_file))
    names = list(content) if target_nodes is None else [n for n in target_nodes if n in content]
    if use_wildcard and "/**" in content and "/**" not in names:
        names.insert(0, "/**")
    found: dict[str, Any] = {}
    for name in names:
        if not use_wildcard and name == "/**":
            continue
        if not isinstance(content[name], dict) or ROS_PARAMETERS not in content[name]:
            raise RuntimeError(f"YAML file is not a valid ROS parameter file for node {name}")
        for key, value in flat(content[name][ROS_PARAMETERS], namespace).items():
            found[key] = Parameter(key, value=value).to_parameter_msg()
    if not found:
        raise RuntimeError("Param file does not contain any valid parameters")
    return found
