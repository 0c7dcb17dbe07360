"""Transformation of stamped data."""

from __future__ import annotations

from copy import deepcopy
from typing import Any

from rclpy.duration import Duration
from rclpy.time import Time
from tf2_py import TransformException


class TypeException(TransformException):
    pass


class NotImplementedException(TransformException):
    def __init__(self) -> None:
        super().__init__("CanTransform or LookupTransform not implemented")


class TransformRegistration:
    """Functions that transform data, by type."""

    _functions: dict[Any, Any] = {}  # noqa: RUF012
    _to_message: dict[Any, Any] = {}  # noqa: RUF012
    _from_message: dict[Any, Any] = {}  # noqa: RUF012
    _conversions: dict[Any, Any] = {}  # noqa: RUF012

    def print_me(self) -> None:
        print(self._functions)

    def get(self, key: Any) -> Any:
        if key not in self._functions:
            name = key if isinstance(key, str) else getattr(key, "__name__", key)
            raise TypeException(f"Type {name} is not loaded or supported")
        return self._functions[key]

    def add(self, key: Any, callback: Any) -> None:
        self._functions[key] = callback


class ConvertRegistration:
    """Functions that convert data to and from messages."""

    def add_from_msg(self, key: Any, callback: Any) -> None:
        TransformRegistration._from_message[key] = callback

    def add_to_msg(self, key: Any, callback: Any) -> None:
        TransformRegistration._to_message[key] = callback

    def add_convert(self, key: Any, callback: Any) -> None:
        TransformRegistration._conversions[key] = callback

    def get_from_msg(self, key: Any) -> Any:
        return _found(TransformRegistration._from_message, key)

    def get_to_msg(self, key: Any) -> Any:
        return _found(TransformRegistration._to_message, key)

    def get_convert(self, key: Any) -> Any:
        return _found(TransformRegistration._conversions, key)


def _found(table: dict[Any, Any], key: Any) -> Any:
    if key not in table:
        raise TypeException(f"Type {key} is not loaded or supported")
    return table[key]


def convert(a: Any, b_type: Any) -> Any:
    registration = ConvertRegistration()
    if isinstance(a, b_type):
        return deepcopy(a)
    return registration.get_from_msg(b_type)(registration.get_to_msg(type(a))(a))


class Stamped:
    def __init__(self, obj: Any, stamp: Any, frame_id: str) -> None:
        self.header = _header(stamp, frame_id)
        self.obj = obj


def _header(stamp: Any, frame_id: str) -> Any:
    from sitaf_ros.current import message

    return message("std_msgs/msg/Header")(stamp=stamp, frame_id=frame_id)


class BufferInterface:
    def __init__(self) -> None:
        self.registration = TransformRegistration()

    def transform(
        self, object_stamped: Any, target_frame: str, timeout: Duration | None = None, new_type: Any = None
    ) -> Any:
        function = self.registration.get(type(object_stamped))
        header = object_stamped.header
        found = self.lookup_transform(target_frame, header.frame_id, Time.from_msg(header.stamp), timeout or Duration())
        result = function(object_stamped, found)
        return result if new_type is None else convert(result, new_type)

    def transform_full(
        self,
        object_stamped: Any,
        target_frame: str,
        target_time: Time,
        fixed_frame: str,
        timeout: Duration | None = None,
        new_type: Any = None,
    ) -> Any:
        function = self.registration.get(type(object_stamped))
        header = object_stamped.header
        found = self.lookup_transform_full(
            target_frame, target_time, header.frame_id, Time.from_msg(header.stamp), fixed_frame, timeout or Duration()
        )
        result = function(object_stamped, found)
        return result if new_type is None else convert(result, new_type)

    def lookup_transform(self, target_frame: str, source_frame: str, time: Any, timeout: Any = None) -> Any:
        raise NotImplementedException

    def lookup_transform_full(
        self,
        target_frame: str,
        target_time: Any,
        source_frame: str,
        source_time: Any,
        fixed_frame: str,
        timeout: Any = None,
    ) -> Any:
        raise NotImplementedException
