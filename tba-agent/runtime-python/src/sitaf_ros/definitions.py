"""Reads interface definitions in ROS's text form: .msg, .srv and .action files.

The grammar is that of https://docs.ros.org/en/jazzy/Concepts/Basic/About-Interfaces.html.
"""

from __future__ import annotations

import ast
import re
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

INTEGERS = {
    "int8": (-(2**7), 2**7 - 1),
    "uint8": (0, 2**8 - 1),
    "int16": (-(2**15), 2**15 - 1),
    "uint16": (0, 2**16 - 1),
    "int32": (-(2**31), 2**31 - 1),
    "uint32": (0, 2**32 - 1),
    "int64": (-(2**63), 2**63 - 1),
    "uint64": (0, 2**64 - 1),
}
FLOATS = ("float32", "float64")
STRINGS = ("string", "wstring")
PRIMITIVES = (*INTEGERS, *FLOATS, *STRINGS, "bool", "byte")
ALIASES = {
    "char": "uint8",
    "time": "builtin_interfaces/msg/Time",
    "duration": "builtin_interfaces/msg/Duration",
    "Header": "std_msgs/msg/Header",
}
# The names of `_fields_and_field_types`, which are those of IDL.
IDL_NAMES = {"float64": "double", "float32": "float", "bool": "boolean", "byte": "octet"}
FIELD = re.compile(
    r"^(?P<type>[\w/]+)(?P<bound><=\d+)?(?P<array>\[(?:<=)?\d*\])?\s+(?P<name>\w+)\s*(?P<rest>.*)$", re.S
)
KINDS = ("msg", "srv", "action")
SEPARATOR = re.compile(r"^---+\s*(?:#.*)?$", re.M)
MAX_FIXED_SIZE = 10_000_000


class DefinitionError(ValueError):
    """An interface definition that cannot be read; the message names the type and the line."""


class MessageTypes(Protocol):
    """Where definitions come from; names are full names like `std_msgs/msg/String`."""

    def names(self) -> list[str]:
        """Return the full names of all types, sorted."""
        ...

    def text(self, name: str) -> str | None:
        """Return the text of a definition, or None if the type is unknown."""
        ...


class TypeFolders:
    """Definitions in folders that hold `PACKAGE/msg/NAME.msg`, `PACKAGE/srv/NAME.srv` and `PACKAGE/action/NAME.action`.

    The first folder that has a type wins.
    """

    def __init__(self, folders: list[Path]) -> None:
        self._files: dict[str, Path] = {}
        for folder in folders:
            for kind in KINDS:
                for file in sorted(folder.glob(f"*/{kind}/*.{kind}")):
                    self._files.setdefault(f"{file.parent.parent.name}/{kind}/{file.stem}", file)

    def names(self) -> list[str]:
        """Return the full names of all types, sorted."""
        return sorted(self._files)

    def text(self, name: str) -> str | None:
        """Return the text of a definition, or None if the type is unknown."""
        file = self._files.get(name)
        return None if file is None else file.read_text(encoding="utf-8-sig")


class LayeredTypes:
    """Several sources; the first that has a type wins."""

    def __init__(self, *layers: MessageTypes) -> None:
        self._layers = layers

    def names(self) -> list[str]:
        """Return the full names of all types, sorted."""
        return sorted({name for layer in self._layers for name in layer.names()})

    def text(self, name: str) -> str | None:
        """Return the text of a definition, or None if the type is unknown."""
        return next((text for layer in self._layers if (text := layer.text(name)) is not None), None)


@dataclass(frozen=True, slots=True)
class FieldType:
    """The type of a field: a primitive's name or a full type name, and what kind of array it is."""

    base: str
    string_bound: int | None = None
    array: str | None = None
    """`fixed`, `bounded`, `unbounded`, or None for a single value."""
    size: int = 0

    @property
    def is_primitive(self) -> bool:
        """True for numbers, strings, booleans and bytes."""
        return self.base in PRIMITIVES

    @property
    def is_number(self) -> bool:
        """True for integers and floating-point numbers."""
        return self.base in INTEGERS or self.base in FLOATS

    def __str__(self) -> str:
        name = IDL_NAMES.get(self.base, self.base)
        if not self.is_primitive:
            package, _, short = self.base.split("/")
            name = f"{package}/{short}"
        if self.string_bound is not None:
            name += f"<{self.string_bound}>"
        if self.array == "fixed":
            return f"{name}[{self.size}]"
        if self.array == "bounded":
            return f"sequence<{name}, {self.size}>"
        return f"sequence<{name}>" if self.array else name


@dataclass(frozen=True, slots=True)
class Field:
    """A field of a message; `default` is None where the definition gives none."""

    name: str
    type: FieldType
    default: object = None


@dataclass(frozen=True, slots=True)
class Definition:
    """One message: its full name, constants in order, fields in order."""

    name: str
    constants: tuple[tuple[str, object], ...]
    fields: tuple[Field, ...]
    constant_types: tuple[FieldType, ...] = ()


def parts(text: str, kind: str) -> list[str]:
    """Split the text of a .srv into request and response, of an .action into goal, result and feedback."""
    wanted = {"msg": 1, "srv": 2, "action": 3}[kind]
    found = SEPARATOR.split(text)
    if len(found) != wanted:
        raise DefinitionError(f"a .{kind} has {wanted - 1} lines `---`, this one has {len(found) - 1}")
    return found


def parse(name: str, text: str, types: MessageTypes | None = None) -> Definition:
    """Read one message; a type without a package is of the same package."""
    constants: list[tuple[str, object]] = []
    fields: list[Field] = []
    constant_types: list[FieldType] = []
    for number, line in enumerate(text.splitlines(), 1):
        stripped = _without_comment(line).strip()
        if not stripped:
            continue
        match = FIELD.match(stripped)
        if match is None:
            raise DefinitionError(f"{name}, line {number}: `{stripped}` is neither a field nor a constant")
        try:
            kind = _type(match["type"], match["bound"], match["array"], name, types)
            rest = match["rest"].strip()
            if rest.startswith("="):
                constants.append((match["name"], _value(rest[1:].strip(), kind)))
                constant_types.append(kind)
            else:
                fields.append(Field(match["name"], kind, _value(rest, kind) if rest else None))
        except (ValueError, SyntaxError) as e:
            raise DefinitionError(f"{name}, line {number}: `{stripped}`: {e}") from e
    if not fields:
        # As rosidl does for empty structures.
        fields.append(Field("structure_needs_at_least_one_member", FieldType("uint8")))
    return Definition(name, tuple(constants), tuple(fields), tuple(constant_types))


def _without_comment(line: str) -> str:
    quote = ""
    for i, c in enumerate(line):
        if quote:
            quote = "" if c == quote else quote
        elif c in "\"'" and line[:i].strip().count(" ") >= 1:
            quote = c
        elif c == "#":
            return line[:i]
    # An apostrophe in a comment-like text: nothing was quoted.
    return line.split("#", 1)[0] if quote else line


def _type(text: str, bound: str | None, array: str | None, owner: str, types: MessageTypes | None) -> FieldType:
    base = text if text in PRIMITIVES else _full_name(text, owner, types)
    string_bound = int(bound[2:]) if bound else None
    if string_bound is not None and base not in STRINGS:
        raise ValueError("only strings have a bound before the array")
    if array is None:
        return FieldType(base, string_bound)
    inside = array[1:-1]
    if not inside:
        return FieldType(base, string_bound, "unbounded")
    if inside.startswith("<="):
        return FieldType(base, string_bound, "bounded", int(inside[2:]))
    if int(inside) > MAX_FIXED_SIZE:
        raise ValueError(f"an array of more than {MAX_FIXED_SIZE} elements")
    return FieldType(base, string_bound, "fixed", int(inside))


def _full_name(text: str, owner: str, types: MessageTypes | None) -> str:
    pieces = text.split("/")
    if len(pieces) == 3:
        return text
    if len(pieces) == 2:
        return f"{pieces[0]}/msg/{pieces[1]}"
    own = f"{owner.split('/', maxsplit=1)[0]}/msg/{text}"
    if text in ALIASES and (types is None or types.text(own) is None):
        return ALIASES[text]
    return own


def _value(text: str, kind: FieldType) -> object:
    if kind.array is not None:
        items = ast.literal_eval(re.sub(r"\b(true|false)\b", lambda m: m[0].capitalize(), text))
        return [_single(item if isinstance(item, str) else repr(item), kind.base) for item in items]
    return _single(text, kind.base)


def _single(text: str, base: str) -> object:
    if base in STRINGS:
        quoted = len(text) >= 2 and text[0] == text[-1] and text[0] in "\"'"
        return text[1:-1].replace("\\" + text[0], text[0]) if quoted else text
    if base == "bool":
        if text.lower() not in ("true", "false", "0", "1"):
            raise ValueError(f"`{text}` is not a boolean")
        return text.lower() in ("true", "1")
    if base in FLOATS:
        return float(text)
    if base == "byte":
        return bytes([int(text, 0)])
    number = int(text, 0)
    low, high = INTEGERS[base]
    if not low <= number <= high:
        raise ValueError(f"{number} does not fit in {base}")
    return number
