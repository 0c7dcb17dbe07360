"""Generates C++ headers of messages, services and actions, as rosidl does at build time."""

from __future__ import annotations

import math
from collections.abc import Iterable
from pathlib import Path

from sitaf_ros.definitions import Definition, DefinitionError, FieldType, MessageTypes, parse, parts
from sitaf_ros.messages import snake_case

_NUMBERS = {"float32": "float", "float64": "double", "bool": "bool", "byte": "std::uint8_t"}
_TEXTS = {"string": "std::string", "wstring": "std::u16string"}


# The parts of a header that rosidl generates as files of their own.
_DETAILS = ("struct", "traits", "builder", "type_support")


class CppHeaders:
    """The headers of a set of types."""

    def __init__(self, types: MessageTypes) -> None:
        self._types = types
        self.with_builders = False
        """Whether messages can be made with `build<T>()`; each header gets longer."""
        self._by_header: dict[str, str] = {}
        for name in types.names():
            package, kind, short = name.split("/")
            snake = snake_case(short)
            self._by_header[f"{package}/{kind}/{snake}.hpp"] = name
            for part in _DETAILS:
                self._by_header[f"{package}/{kind}/detail/{snake}__{part}.hpp"] = name

    @property
    def packages(self) -> set[str]:
        """Return the packages that have types."""
        return {name.split("/", 1)[0] for name in self._by_header.values()}

    def type_of(self, header: str) -> str | None:
        """Return the type of a header such as `std_msgs/msg/string.hpp`; None if there is none."""
        return self._by_header.get(header)

    def write(self, names: Iterable[str], folder: Path) -> None:
        """Write the headers of types and of all types that these use."""
        pending, seen = list(names), set()
        while pending:
            name = pending.pop()
            if name in seen:
                continue
            seen.add(name)
            text, used, structs = self._header(name)
            pending += used
            file = folder / header_of(name)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8")
            short = name.rpartition("/")[2]
            details = file.parent / "detail"
            details.mkdir(exist_ok=True)
            for part in _DETAILS:
                whole = f'#pragma once\n\n#include "{header_of(name)}"\n'
                if part == "builder" and self.with_builders:
                    whole += "\n" + "".join(_builder(definition) for definition in structs)
                (details / f"{snake_case(short)}__{part}.hpp").write_text(whole, encoding="utf-8")

    def _header(self, name: str) -> tuple[str, list[str], list[Definition]]:
        text = self._types.text(name)
        if text is None:
            raise DefinitionError(f"the type {name} is not known; a .{name.split('/')[1]} file can define it")
        package, kind, short = name.split("/")
        structs: list[Definition] = []
        after = ""
        used: list[str] = []
        if kind == "msg":
            structs.append(parse(name, text, self._types))
        elif kind == "srv":
            structs += self._service(name, text)
            after = _service(short, name)
        else:
            goal, result, feedback = parts(text, "action")
            structs += [
                parse(f"{name}_{suffix}", part, self._types)
                for suffix, part in (("Goal", goal), ("Result", result), ("Feedback", feedback))
            ]
            uuid = "unique_identifier_msgs/msg/UUID goal_id\n"
            stamp = "bool accepted\nbuiltin_interfaces/msg/Time stamp\n"
            structs += self._service(f"{name}_SendGoal", f"{uuid}{name}_Goal goal\n---\n{stamp}")
            structs += self._service(f"{name}_GetResult", f"{uuid}\n---\nint8 status\n{name}_Result result")
            structs.append(parse(f"{name}_FeedbackMessage", f"{uuid}{name}_Feedback feedback", self._types))
            after = "".join(_service(f"{short}_{s}", f"{name}_{s}") for s in ("SendGoal", "GetResult"))
            after += _action(short, name)
            used += ["action_msgs/srv/CancelGoal", "action_msgs/msg/GoalStatusArray"]
        own = {definition.name for definition in structs}
        for definition in structs:
            for field in definition.fields:
                if not field.type.is_primitive and field.type.base not in own and field.type.base not in used:
                    used.append(field.type.base)
        guard = f"SITAF__{package}__{kind}__{snake_case(short)}__HPP_".upper()
        includes = "".join(f'#include "{header_of(other)}"\n' for other in sorted(used))
        body = "".join(_struct(definition) for definition in structs) + after
        # Behind the guard: a precompiled header may hold the message without its builders.
        detail = f"{package}/{kind}/detail/{snake_case(short)}__builder.hpp"
        builders = f'#include "{detail}"\n' if self.with_builders else ""
        return (
            f"#ifndef {guard}\n#define {guard}\n\n#include <array>\n#include <cstdint>\n#include <limits>\n"
            f"#include <memory>\n#include <string>\n#include <vector>\n\n"
            f'#include "rosidl_runtime_cpp/bounded_vector.hpp"\n'
            f'#include "rosidl_runtime_cpp/message_initialization.hpp"\n{includes}\n'
            f"namespace {package} {{\nnamespace {kind} {{\n\n{body}"
            f"}}  // namespace {kind}\n}}  // namespace {package}\n\n"
            f"#endif\n{builders}",
            used,
            structs,
        )

    def _service(self, name: str, text: str) -> list[Definition]:
        request, response = parts(text, "srv")
        return [parse(f"{name}_Request", request, self._types), parse(f"{name}_Response", response, self._types)]


def header_of(name: str) -> str:
    """Return the path of the header of a type."""
    package, kind, short = name.split("/")
    return f"{package}/{kind}/{snake_case(short)}.hpp"


def _cpp(kind: FieldType) -> str:
    if kind.base in _TEXTS:
        base = _TEXTS[kind.base]
    elif kind.is_primitive:
        base = _NUMBERS.get(kind.base, f"std::{kind.base}_t")
    else:
        base = "::" + kind.base.replace("/", "::")
    if kind.array == "fixed":
        return f"std::array<{base}, {kind.size}>"
    if kind.array == "bounded":
        return f"rosidl_runtime_cpp::BoundedVector<{base}, {kind.size}>"
    return f"std::vector<{base}>" if kind.array else base


def _value(value: object, kind: FieldType) -> str:
    if isinstance(value, list):
        return "{" + ", ".join(_value(item, FieldType(kind.base)) for item in value) + "}"
    if isinstance(value, bytes):
        return str(value[0])
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return ("u" if kind.base == "wstring" else "") + _quoted(value)
    if isinstance(value, float):
        cpp = _NUMBERS[kind.base]
        if math.isnan(value):
            return f"std::numeric_limits<{cpp}>::quiet_NaN()"
        if math.isinf(value):
            return f"{'-' if value < 0 else ''}std::numeric_limits<{cpp}>::infinity()"
        return f"static_cast<{cpp}>({value!r})"
    suffix = "ull" if kind.base == "uint64" else ""
    if value == -(2**63):
        return "(-9223372036854775807ll - 1)"
    return f"{value}{suffix}"


def _quoted(text: str) -> str:
    out = ""
    for byte in text.encode():
        plain = 0x20 <= byte < 0x7F and chr(byte) not in '"\\?'
        out += chr(byte) if plain else f"\\{byte:03o}"
    return f'"{out}"'


def _struct(definition: Definition) -> str:
    short = definition.name.rpartition("/")[2]
    lines = [f"struct {short}", "{"]
    lines += [
        f"  using Type = {short};",
        f"  using RawPtr = {short} *;",
        f"  using ConstRawPtr = const {short} *;",
        f"  using SharedPtr = std::shared_ptr<{short}>;",
        f"  using ConstSharedPtr = std::shared_ptr<const {short}>;",
        f"  using WeakPtr = std::weak_ptr<{short}>;",
        f"  using ConstWeakPtr = std::weak_ptr<const {short}>;",
        f"  using UniquePtr = std::unique_ptr<{short}>;",
        f"  using ConstUniquePtr = std::unique_ptr<const {short}>;",
        f'  static constexpr const char * sitaf_name = "{definition.name}";',
        "",
        f"  {short}() = default;",
        f"  explicit {short}(rosidl_runtime_cpp::MessageInitialization) {{}}",
        "",
    ]
    for (name, value), kind in zip(definition.constants, definition.constant_types, strict=True):
        lines.append(_constant(name, value, kind))
    for field in definition.fields:
        default = f" = {_value(field.default, field.type)}" if field.default is not None else "{}"
        lines.append(f"  {_cpp(field.type)} {field.name}{default};")
    lines.append("")
    for field in definition.fields:
        lines.append(f"  using _{field.name}_type = {_cpp(field.type)};")
        lines.append(
            f"  {short} & set__{field.name}(const {_cpp(field.type)} & _arg) {{{field.name} = _arg; return *this;}}"
        )
    visits = " ".join(f"visit(self.{field.name});" for field in definition.fields)
    equal = " && ".join(f"{field.name} == other.{field.name}" for field in definition.fields)
    lines += [
        "",
        f"  template<class S, class V>\n  static void sitaf_each(S & self, V & visit) {{{visits}}}",
        f"  bool operator==(const {short} & other) const {{return {equal};}}",
        f"  bool operator!=(const {short} & other) const {{return !(*this == other);}}",
        "};",
        f"template<class>\nusing {short}_ = {short};",
        "",
        "",
    ]
    return "\n".join(lines)


def _builder(definition: Definition) -> str:
    """What sets the fields one after the other: `build<Point>().x(1).y(2).z(3)`."""
    package, kind, short = definition.name.split("/")
    full = f"::{package}::{kind}::{short}"
    if not definition.fields:
        return ""
    steps = ""
    for field, following in reversed(list(zip(definition.fields, [*definition.fields[1:], None], strict=True))):
        result = f"Init_{short}_{following.name}" if following else full
        steps += (
            f"struct Init_{short}_{field.name}\n{{\n  {full} sitaf_made{{}};\n"
            f"  {result} {field.name}({full}::_{field.name}_type value)\n"
            f"  {{\n    sitaf_made.{field.name} = std::move(value);\n"
            f"    return {'{std::move(sitaf_made)}' if following else 'std::move(sitaf_made)'};\n  }}\n}};\n"
        )
    return (
        f"namespace {package} {{\nnamespace {kind} {{\nnamespace builder {{\n\n{steps}\n"
        f"}}  // namespace builder\n}}  // namespace {kind}\n\n"
        f"template<class M>\nauto build();\n"
        f"template<>\ninline auto build<{full}>()\n"
        f"{{\n  return {kind}::builder::Init_{short}_{definition.fields[0].name}{{}};\n}}\n\n"
        f"}}  // namespace {package}\n\n"
    )


def _constant(name: str, value: object, kind: FieldType) -> str:
    constant = "inline static const" if kind.base in _TEXTS else "static constexpr"
    return f"  {constant} {_cpp(kind)} {name} = {_value(value, kind)};"


def _service(short: str, name: str) -> str:
    return (
        f"struct {short}\n{{\n  using Request = {short}_Request;\n  using Response = {short}_Response;\n"
        f"  using SharedPtr = std::shared_ptr<{short}>;\n"
        f'  static constexpr const char * sitaf_name = "{name}";\n}};\n\n'
    )


def _action(short: str, name: str) -> str:
    return (
        f"struct {short}\n{{\n  using Goal = {short}_Goal;\n  using Result = {short}_Result;\n"
        f"  using Feedback = {short}_Feedback;\n"
        f'  static constexpr const char * sitaf_name = "{name}";\n'
        f"  struct Impl\n  {{\n    using SendGoalService = {short}_SendGoal;\n"
        f"    using GetResultService = {short}_GetResult;\n"
        f"    using FeedbackMessage = {short}_FeedbackMessage;\n"
        f"    using CancelGoalService = ::action_msgs::srv::CancelGoal;\n"
        f"    using GoalStatusMessage = ::action_msgs::msg::GoalStatusArray;\n  }};\n}};\n\n"
    )
