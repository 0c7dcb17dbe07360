"""The types of interfaces: reading of literals, and the default value of each type."""

import dataclasses
import enum
from collections.abc import Callable
from typing import Any, Generic, TypeVar

from sitaf_runtime.errors import CaseDataError
from sitaf_runtime.suite import literals

T = TypeVar("T")


class Kind(Generic[T]):
    """A type of an interface.

    `parse` reads a literal and raises CaseDataError when the type cannot hold it. `zero` creates the default value.
    `shaped` converts a component's value to the type where it can, and returns anything else unchanged. `part` returns
    the kind of a member or an element; None where the type has no parts.
    """

    __slots__ = ("parse", "part", "shaped", "zero")

    def __init__(
        self,
        parse: Callable[[str], T],
        zero: Callable[[], T],
        shaped: Callable[[Any], Any] = literals.plain,
        part: Callable[[str | int], "Kind[Any]"] | None = None,
    ) -> None:
        self.parse = parse
        self.zero = zero
        self.shaped = shaped
        self.part = part


def _integer(bits: int, *, signed: bool) -> Kind[int]:
    low = -(1 << bits - 1) if signed else 0
    high = (1 << bits - 1) - 1 if signed else (1 << bits) - 1

    def parse(literal: str) -> int:
        return literals.whole(literal, low, high)

    return Kind(parse, int)


def _as_real(value: Any) -> Any:
    value = literals.plain(value)
    return float(value) if isinstance(value, int) and not isinstance(value, bool) and abs(value) < 1 << 53 else value


def _as_single(value: Any) -> Any:
    value = _as_real(value)
    return literals.Single(literals.single(value)) if isinstance(value, float) else value


INT8 = _integer(8, signed=True)
UINT8 = _integer(8, signed=False)
INT16 = _integer(16, signed=True)
UINT16 = _integer(16, signed=False)
INT32 = _integer(32, signed=True)
UINT32 = _integer(32, signed=False)
INT64 = _integer(64, signed=True)
UINT64 = _integer(64, signed=False)
FLOAT64: Kind[float] = Kind(literals.real, float, _as_real)
FLOAT32: Kind[float] = Kind(lambda literal: literals.single(literals.real(literal)), float, _as_single)
BOOLEAN: Kind[bool] = Kind(literals.boolean, bool)
CHARACTER: Kind[str] = Kind(literals.character, lambda: "\0")
STRING: Kind[str] = Kind(lambda literal: literal, str)


def sequence(element: Kind[T], length: int = 0) -> Kind[list[T]]:
    """A sequence of elements of one type; with a length, an array."""

    def parse(literal: str) -> list[T]:
        parts = literals.elements(literal)
        if length and len(parts) != length:
            raise CaseDataError(f"'{literal}' has {len(parts)} elements, not {length}")
        return [element.parse(part) for part in parts]

    def shaped(value: Any) -> Any:
        listed = literals.elements_of(literals.plain(value))
        return value if listed is None else [element.shaped(part) for part in listed]

    return Kind(parse, lambda: [element.zero() for _ in range(length)], shaped, lambda _: element)


E = TypeVar("E", bound=enum.Enum)


def enumeration(type_: type[E]) -> Kind[E]:
    """An enumeration; a component may also return the name or the value of a literal."""
    first = next(iter(type_))

    def parse(literal: str) -> E:
        try:
            return type_[literal.strip()]
        except KeyError as e:
            raise CaseDataError(f"'{literal}' is not one of {', '.join(known.name for known in type_)}") from e

    def shaped(value: Any) -> Any:
        value = literals.plain(value)
        if isinstance(value, str) and value in type_.__members__:
            return type_[value]
        try:
            return value if isinstance(value, enum.Enum | bool) else type_(value)
        except ValueError:
            return value

    return Kind(parse, lambda: first, shaped)


def member(kind: Kind[T], name: str = "") -> T:
    """Declares a member of a struct as a field of a dataclass.

    `name` is its name in documents where Python does not allow it: the member `from` is the field `from_`.
    """
    metadata = {"kind": kind, literals.NAME: name} if name else {"kind": kind}
    return dataclasses.field(default_factory=kind.zero, metadata=metadata)


_STRUCTS: dict[type, Kind[Any]] = {}


def struct(type_: type[T]) -> Kind[T]:
    """A struct: a dataclass whose fields are declared with `member`."""
    known = _STRUCTS.get(type_)
    if known is not None:
        return known
    fields = {
        literals.name_of(field): field
        for field in dataclasses.fields(type_)  # pyright: ignore[reportArgumentType]
    }
    kinds: dict[str, Kind[Any]] = {name: field.metadata["kind"] for name, field in fields.items()}
    attributes = {name: field.name for name, field in fields.items()}

    def parse(literal: str) -> T:
        given = literals.members(literal)
        unknown = [name for name in given if name not in kinds]
        if unknown:
            raise CaseDataError(f"'{literal}' has an unknown member {unknown[0]}; the struct has {', '.join(kinds)}")
        return type_(**{attributes[name]: kinds[name].parse(value) for name, value in given.items()})

    def shaped(value: Any) -> Any:
        named = literals.members_of(value)
        if named is None and all(hasattr(value, name) for name in attributes.values()):
            named = {name: getattr(value, name) for name in attributes.values()}
        if named is None:
            return value
        # A class of the component itself has the attribute's name, a dictionary rather the document's.
        given = {name: name if name in named else attribute for name, attribute in attributes.items()}
        return {name: kinds[name].shaped(named[key]) for name, key in given.items() if key in named}

    by_attribute = {attributes[name]: kind for name, kind in kinds.items()}
    kind = Kind(parse, type_, shaped, lambda name: by_attribute[str(name)])
    _STRUCTS[type_] = kind
    return kind
