"""The parameter services of a node."""

from __future__ import annotations

from typing import Any

from sitaf_ros.current import message

from .exceptions import ParameterNotDeclaredException, ParameterUninitializedException
from .parameter import PARAMETER_SEPARATOR_STRING, Parameter
from .qos import qos_profile_parameters

_SERVICES = {
    "describe_parameters": "DescribeParameters",
    "get_parameters": "GetParameters",
    "get_parameter_types": "GetParameterTypes",
    "list_parameters": "ListParameters",
    "set_parameters": "SetParameters",
    "set_parameters_atomically": "SetParametersAtomically",
}


class ParameterService:
    def __init__(self, node: Any) -> None:
        self._node = node
        for name, kind in _SERVICES.items():
            node._ros_create_own_service(
                message(f"rcl_interfaces/srv/{kind}"), f"~/{name}", getattr(self, f"_{name}"), qos_profile_parameters
            )

    def _describe_parameters(self, request: Any, response: Any) -> Any:
        for name in request.names:
            try:
                response.descriptors.append(self._node.describe_parameter(name))
            except ParameterNotDeclaredException:
                response.descriptors = []
                return response
        return response

    def _value(self, name: str) -> Any:
        try:
            return self._node.get_parameter(name).get_parameter_value()
        except ParameterUninitializedException:
            return Parameter(name).get_parameter_value()

    def _get_parameters(self, request: Any, response: Any) -> Any:
        try:
            response.values = [self._value(name) for name in request.names]
        except ParameterNotDeclaredException:
            response.values = []
        return response

    def _get_parameter_types(self, request: Any, response: Any) -> Any:
        try:
            response.types = [self._value(name).type for name in request.names]
        except ParameterNotDeclaredException:
            response.types = []
        return response

    def _list_parameters(self, request: Any, response: Any) -> Any:
        response.result = self._node.list_parameters(list(request.prefixes), request.depth)
        return response

    def _set_parameters(self, request: Any, response: Any) -> Any:
        for one in request.parameters:
            try:
                result = self._node.set_parameters_atomically([Parameter.from_parameter_msg(one)])
            except ParameterNotDeclaredException as e:
                result = self._node._ros_parameter_result(False, str(e))
            response.results.append(result)
        return response

    def _set_parameters_atomically(self, request: Any, response: Any) -> Any:
        try:
            wanted = [Parameter.from_parameter_msg(one) for one in request.parameters]
            response.result = self._node.set_parameters_atomically(wanted)
        except ParameterNotDeclaredException as e:
            response.result = self._node._ros_parameter_result(False, str(e))
        return response


def listed(names: list[str], prefixes: list[str], depth: int) -> tuple[list[str], list[str]]:
    """Return the parameters below the prefixes and their prefixes; depth 0 is any."""
    found: list[str] = []
    for name in names:
        for prefix in prefixes or [""]:
            inside = not prefix or name == prefix or name.startswith(prefix + PARAMETER_SEPARATOR_STRING)
            rest = name[len(prefix) :].lstrip(PARAMETER_SEPARATOR_STRING) if prefix else name
            if inside and (depth == 0 or rest.count(PARAMETER_SEPARATOR_STRING) < depth):
                found.append(name)
                break
    above = {name.rpartition(PARAMETER_SEPARATOR_STRING)[0] for name in found}
    return found, sorted(prefix for prefix in above if prefix)
