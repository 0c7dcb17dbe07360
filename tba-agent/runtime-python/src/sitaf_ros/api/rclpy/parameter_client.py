"""A client of another node's parameter services."""

from __future__ import annotations

from typing import Any

from sitaf_ros.current import message

from .client import wait_until
from .parameter import Parameter, parameter_dict_from_yaml_file
from .qos import qos_profile_services_default
from .task import Future


class AsyncParameterClient:
    def __init__(
        self,
        node: Any,
        remote_node_name: str,
        qos_profile: Any = qos_profile_services_default,
        callback_group: Any = None,
    ) -> None:
        self.remote_node_name, self.node = remote_node_name, node
        self._clients = {
            name: node.create_client(
                message(f"rcl_interfaces/srv/{kind}"),
                f"{remote_node_name}/{name}",
                qos_profile=qos_profile,
                callback_group=callback_group,
            )
            for name, kind in (
                ("get_parameters", "GetParameters"),
                ("list_parameters", "ListParameters"),
                ("set_parameters", "SetParameters"),
                ("get_parameter_types", "GetParameterTypes"),
                ("describe_parameters", "DescribeParameters"),
                ("set_parameters_atomically", "SetParametersAtomically"),
            )
        }

    def services_are_ready(self) -> bool:
        return all(client.service_is_ready() for client in self._clients.values())

    def wait_for_services(self, timeout_sec: float | None = None) -> bool:
        return wait_until(self.services_are_ready, timeout_sec, self.node.context)

    def _call(self, service: str, callback: Any, **fields: Any) -> Future:
        client = self._clients[service]
        future = client.call_async(client.srv_type.Request(**fields))
        if callback is not None:
            future.add_done_callback(callback)
        return future

    def list_parameters(self, prefixes: Any = None, depth: int | None = None, callback: Any = None) -> Future:
        return self._call("list_parameters", callback, prefixes=prefixes or [], depth=depth or 0)

    def get_parameters(self, names: list[str], callback: Any = None) -> Future:
        return self._call("get_parameters", callback, names=names)

    def set_parameters(self, parameters: Any, callback: Any = None) -> Future:
        return self._call("set_parameters", callback, parameters=[_as_message(p) for p in parameters])

    def describe_parameters(self, names: list[str], callback: Any = None) -> Future:
        return self._call("describe_parameters", callback, names=names)

    def get_parameter_types(self, names: list[str], callback: Any = None) -> Future:
        return self._call("get_parameter_types", callback, names=names)

    def set_parameters_atomically(self, parameters: Any, callback: Any = None) -> Future:
        return self._call("set_parameters_atomically", callback, parameters=[_as_message(p) for p in parameters])

    def delete_parameters(self, names: list[str], callback: Any = None) -> Future:
        return self.set_parameters([Parameter(name) for name in names], callback)

    def load_parameter_file(self, parameter_file: str, use_wildcard: bool = False, callback: Any = None) -> Future:
        found = parameter_dict_from_yaml_file(parameter_file, use_wildcard)
        return self.set_parameters(list(found.values()), callback)

    def load_parameter_file_atomically(
        self, parameter_file: str, use_wildcard: bool = False, callback: Any = None
    ) -> Future:
        found = parameter_dict_from_yaml_file(parameter_file, use_wildcard)
        return self.set_parameters_atomically(list(found.values()), callback)


def _as_message(parameter: Any) -> Any:
    return parameter.to_parameter_msg() if isinstance(parameter, Parameter) else parameter
