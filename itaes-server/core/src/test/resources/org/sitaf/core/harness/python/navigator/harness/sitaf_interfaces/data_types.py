"""The structs and enumerations of the interfaces."""

from dataclasses import dataclass
from enum import Enum

from sitaf_runtime.suite.kinds import (
    FLOAT64,
    STRING,
    enumeration,
    member,
    sequence,
    struct,
)


@dataclass
class Point:
    """The struct nav::Point."""

    x: float = member(FLOAT64)
    y: float = member(FLOAT64)


class Mode(Enum):
    """The enumeration nav::Mode."""

    IDLE = 0
    BUSY = 1


@dataclass
class Route:
    """The struct nav::Route."""

    points: list[Point] = member(sequence(struct(Point)))
    mode: Mode = member(enumeration(Mode))
    name: str = member(STRING)
