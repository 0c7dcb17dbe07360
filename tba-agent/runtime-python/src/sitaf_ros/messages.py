"""Generates Python classes of messages, services and actions when they are first used, as rosidl does at build time."""

from __future__ import annotations

import array
from typing import Any, ClassVar

import numpy

from sitaf_ros import fields as field_values
from sitaf_ros.definitions import Definition, DefinitionError, MessageTypes, parse, parts


def snake_case(name: str) -> str:
    """Return the module name of a type, as rosidl makes it: `PointCloud2` is `point_cloud2`."""
    out = ""
    for i, c in enumerate(name):
        after_lower = i > 0 and (name[i - 1].islower() or name[i - 1].isdigit())
        before_lower = i > 0 and i + 1 < len(name) and name[i + 1].islower() and name[i - 1] != "_"
        out += ("_" if c.isupper() and (after_lower or before_lower) else "") + c.lower()
    return out


class Message:
    """Base of all generated message classes."""

    __slots__ = ()
    _definition: ClassVar[Definition]
    _fields_and_field_types: ClassVar[dict[str, str]]
    _defaults: ClassVar[tuple[tuple[str, str, Any], ...]]
    _copiers: ClassVar[tuple[tuple[str, Any], ...]]
    SLOT_TYPES: ClassVar[tuple[Any, ...]]

    def __init__(self, **kwargs: Any) -> None:
        kwargs.pop("check_fields", None)
        unknown = [name for name in kwargs if name not in self._fields_and_field_types]
        if unknown:
            raise AssertionError(f"Invalid arguments passed to constructor: {', '.join(sorted(unknown))}")
        for name, slot, default in self._defaults:
            if name in kwargs:
                setattr(self, name, kwargs[name])
            else:
                object.__setattr__(self, slot, default())

    @classmethod
    def get_fields_and_field_types(cls) -> dict[str, str]:
        """Return the types of the fields by name, in order."""
        return dict(cls._fields_and_field_types)

    def copy_message(self) -> Message:
        """Return a copy that shares nothing that can change."""
        new = object.__new__(type(self))
        for slot, copier in self._copiers:
            value = getattr(self, slot)
            object.__setattr__(new, slot, value if copier is None else copier(value))
        return new

    def __copy__(self) -> Message:
        new = object.__new__(type(self))
        for slot, _ in self._copiers:
            object.__setattr__(new, slot, getattr(self, slot))
        return new

    def __deepcopy__(self, memo: dict[int, Any]) -> Message:
        return self.copy_message()

    def __reduce__(self) -> tuple[Any, ...]:
        return _restore, (self._definition.name, {n: getattr(self, n) for n in self._fields_and_field_types})

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, self.__class__):
            return False
        return all(_equal(getattr(self, slot), getattr(other, slot)) for slot, _ in self._copiers)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        names = [*self.__class__.__module__.split(".")[:-1], self.__class__.__name__]
        values = ", ".join(f"{n}={_shown(getattr(self, n))}" for n in self._fields_and_field_types)
        return f"{'.'.join(names)}({values})"


def _equal(a: Any, b: Any) -> bool:
    if isinstance(a, numpy.ndarray) or isinstance(b, numpy.ndarray):
        return bool(numpy.array_equal(a, b))
    return bool(a == b)


def _shown(value: Any) -> str:
    if isinstance(value, array.array):
        return repr(value.tolist())
    return repr(value)


def _restore(name: str, values: dict[str, Any]) -> Message:
    from sitaf_ros.current import classes

    return classes().message(name)(**values)


class _InterfaceMeta(type):
    def __call__(cls, *args: Any, **kwargs: Any) -> Any:
        raise NotImplementedError("Service and action classes can not be instantiated")


class MessageClasses:
    """The classes of all types; each is made once."""

    def __init__(self, types: MessageTypes) -> None:
        self.types = types
        self._made: dict[str, Any] = {}
        self._names: frozenset[str] = frozenset(types.names())
        self.packages: dict[str, dict[str, list[str]]] = {}
        for name in sorted(self._names):
            package, kind, short = name.split("/")
            self.packages.setdefault(package, {}).setdefault(kind, []).append(short)

    def message(self, name: str) -> Any:
        """Return the class of a full name; parts of services and actions are `pkg/srv/Name_Request` and so on."""
        made = self._made.get(name)
        if made is None:
            made = self._made[name] = self._make(name)
        return made

    interface = message

    def _make(self, name: str) -> Any:
        pieces = name.split("/")
        if len(pieces) != 3:
            raise DefinitionError(f"`{name}` is not a full type name like std_msgs/msg/String")
        package, kind, short = pieces
        if name in self._names:
            text = self.types.text(name) or ""
            if kind == "msg":
                return self._message(parse(name, text, self.types))
            return self._service(name, text) if kind == "srv" else self._action(name, text)
        whole = short.split("_")[0]
        if kind != "msg" and whole != short and f"{package}/{kind}/{whole}" in self._names:
            self.message(f"{package}/{kind}/{whole}")
            if name in self._made:
                return self._made[name]
        raise DefinitionError(f"the type {name} is not known; a .{kind} file of the activity can define it")

    def _message(self, definition: Definition) -> Any:
        package, kind, short = definition.name.split("/")
        namespace: dict[str, Any] = {
            "__slots__": [f"_{field.name}" for field in definition.fields],
            "__module__": f"{package}.{kind}._{snake_case(short.split('_')[0])}",
            "__qualname__": short,
            "__doc__": f"Message class '{short}'.",
            "_definition": definition,
            "_fields_and_field_types": {field.name: str(field.type) for field in definition.fields},
            "_copiers": tuple((f"_{field.name}", field_values.copier(field.type)) for field in definition.fields),
            "SLOT_TYPES": tuple(field.type for field in definition.fields),
        }
        namespace.update(definition.constants)
        for field in definition.fields:
            namespace[field.name] = self._property(
                field.name, field_values.checked(field.name, field.type, self.message)
            )
            if field.default is not None:
                namespace[f"{field.name.upper()}__DEFAULT"] = field.default
        namespace["_defaults"] = tuple(
            (field.name, f"_{field.name}", field_values.default(field, self.message)) for field in definition.fields
        )
        made = self._made[definition.name] = type(short, (Message,), namespace)
        return made

    @staticmethod
    def _property(name: str, checked: Any) -> property:
        slot = f"_{name}"

        def read(self: Any) -> Any:
            return getattr(self, slot)

        def write(self: Any, value: Any) -> None:
            object.__setattr__(self, slot, checked(value))

        return property(read, write, doc=f"Message field '{name}'.")

    def _part(self, name: str, suffix: str, text: str) -> Any:
        return self._message(parse(f"{name}_{suffix}", text, self.types))

    def _service(self, name: str, text: str) -> Any:
        request, response = parts(text, "srv")
        package, kind, short = name.split("/")
        namespace: dict[str, Any] = {
            "__module__": f"{package}.{kind}._{snake_case(short)}",
            "_full_name": name,
            "Request": self._part(name, "Request", request),
            "Response": self._part(name, "Response", response),
        }
        event = f"service_msgs/msg/ServiceEventInfo info\n{name}_Request[<=1] request\n{name}_Response[<=1] response"
        if "service_msgs/msg/ServiceEventInfo" in self._names:
            namespace["Event"] = self._part(name, "Event", event)
        return _InterfaceMeta(short, (), namespace)

    def _action(self, name: str, text: str) -> Any:
        goal, result, feedback = parts(text, "action")
        package, kind, short = name.split("/")
        namespace: dict[str, Any] = {
            "__module__": f"{package}.{kind}._{snake_case(short)}",
            "_full_name": name,
            "Goal": self._part(name, "Goal", goal),
            "Result": self._part(name, "Result", result),
            "Feedback": self._part(name, "Feedback", feedback),
        }
        uuid = "unique_identifier_msgs/msg/UUID goal_id\n"
        stamp = "bool accepted\nbuiltin_interfaces/msg/Time stamp\n"
        # The derived types of https://design.ros2.org/articles/actions.html.
        derived: dict[str, Any] = {
            "SendGoalService": self._service(f"{name}_SendGoal", f"{uuid}{name}_Goal goal\n---\n{stamp}"),
            "GetResultService": self._service(f"{name}_GetResult", f"{uuid}\n---\nint8 status\n{name}_Result result"),
            "FeedbackMessage": self._part(name, "FeedbackMessage", f"{uuid}{name}_Feedback feedback"),
            "CancelGoalService": self.message("action_msgs/srv/CancelGoal"),
            "GoalStatusMessage": self.message("action_msgs/msg/GoalStatusArray"),
        }
        namespace["Impl"] = type("Impl", (), {"__doc__": "Derived types of the action.", **derived})
        for suffix in ("SendGoal", "GetResult"):
            self._made[f"{name}_{suffix}"] = derived[f"{suffix}Service"]
        return _InterfaceMeta(short, (), namespace)
