"""The measured models: uniform and mixed ones by name, files, and random ones of published shapes."""

from __future__ import annotations

import itertools
import os
import random
import re
import zlib
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

MODELS = Path(os.environ["SITAF_HOME"]).parent / "shared" / "benchmarks" / "combinatorial"

# Shapes of the constrained models of Cohen, Dwyer and Shi (IEEE TSE 34(5), 2008): five of programs and thirty made
# after them. Levels of the parameters, then numbers of conditions by length; the conditions themselves are random.
SHAPES: dict[str, tuple[str, str]] = {
    "spin-s": ("2^13 4^5", "2^13"),
    "spin-v": ("2^42 3^2 4^11", "2^47 3^2"),
    "gcc": ("2^189 3^10", "2^37 3^3"),
    "apache": ("2^158 3^8 4^4 5^1 6^1", "2^3 3^1 4^2 5^1"),
    "bugzilla": ("2^49 3^1 4^2", "2^4 3^1"),
    "1": ("2^86 3^3 4^1 5^5 6^2", "2^20 3^3 4^1"),
    "2": ("2^86 3^3 4^3 5^1 6^1", "2^19 3^3"),
    "3": ("2^27 4^2", "2^9 3^1"),
    "4": ("2^51 3^4 4^2 5^1", "2^15 3^2"),
    "5": ("2^155 3^7 4^3 5^5 6^4", "2^32 3^6 4^1"),
    "6": ("2^73 4^3 6^1", "2^26 3^4"),
    "7": ("2^29 3^1", "2^13 3^2"),
    "8": ("2^109 3^2 4^2 5^3 6^3", "2^32 3^4 4^1"),
    "9": ("2^57 3^1 4^1 5^1 6^1", "2^30 3^7"),
    "10": ("2^130 3^6 4^5 5^2 6^4", "2^40 3^7"),
    "11": ("2^84 3^4 4^2 5^2 6^4", "2^28 3^4"),
    "12": ("2^136 3^4 4^3 5^1 6^3", "2^23 3^4"),
    "13": ("2^124 3^4 4^1 5^2 6^2", "2^22 3^4"),
    "14": ("2^81 3^5 4^3 6^3", "2^13 3^2"),
    "15": ("2^50 3^4 4^1 5^2 6^1", "2^20 3^2"),
    "16": ("2^81 3^3 4^2 6^1", "2^30 3^4"),
    "17": ("2^128 3^3 4^2 5^1 6^3", "2^25 3^4"),
    "18": ("2^127 3^2 4^4 5^6 6^2", "2^23 3^4 4^1"),
    "19": ("2^172 3^9 4^9 5^3 6^4", "2^38 3^5"),
    "20": ("2^138 3^4 4^5 5^4 6^7", "2^42 3^6"),
    "21": ("2^76 3^3 4^2 5^1 6^3", "2^40 3^6"),
    "22": ("2^72 3^4 4^1 6^2", "2^20 3^2"),
    "23": ("2^25 3^1 6^1", "2^13 3^2"),
    "24": ("2^110 3^2 5^3 6^4", "2^25 3^4"),
    "25": ("2^118 3^6 4^2 5^2 6^6", "2^23 3^3 4^1"),
    "26": ("2^87 3^1 4^3 5^4", "2^28 3^4"),
    "27": ("2^55 3^2 4^2 5^1 6^2", "2^17 3^3"),
    "28": ("2^167 3^16 4^2 5^3 6^6", "2^31 3^6"),
    "29": ("2^134 3^7 5^3", "2^19 3^3"),
    "30": ("2^73 3^3 4^3", "2^31 3^4"),
}

Literal = tuple[int, bool, int]


@dataclass(frozen=True)
class Model:
    """Levels of the parameters, and clauses of literals (parameter, equal, value)."""

    levels: list[int]
    conditions: list[list[Literal]]


def model(name: str) -> Model | None:
    """The model of this name; None if its file is missing."""
    if name.startswith("like "):
        return like(name.removeprefix("like "))
    if name.endswith(".xml"):
        return read(MODELS / name) if (MODELS / name).exists() else None
    return Model(powers(name), [])


def read(path: Path) -> Model:
    """A test model with user values 0, 1, ... and clauses of (in)equalities."""
    root = ElementTree.parse(path).getroot()
    levels = [
        len(e.findall("user_value_list/value")) for e in root.iter("test_element")
    ]
    conditions = []
    for condition in root.iter("pre_condition"):
        literals = re.findall(r"P(\d+) (==|!=) (\d+)", condition.text or "")
        conditions.append([(int(p) - 1, op == "==", int(v)) for p, op, v in literals])
    return Model(levels, conditions)


def like(shape: str) -> Model:
    """A model of a published shape: random forbidden tuples that leave at least one valid row."""
    rng = random.Random(zlib.crc32(shape.encode()))
    levels = powers(SHAPES[shape][0])
    hidden = [rng.randrange(n) for n in levels]
    conditions = []
    for size in powers(SHAPES[shape][1]):
        chosen = rng.sample(range(len(levels)), size)
        free = rng.choice(chosen)
        values = {p: rng.randrange(levels[p]) for p in chosen}
        if all(values[p] == hidden[p] for p in chosen):
            values[free] = (values[free] + 1) % levels[free]
        conditions.append([(p, False, v) for p, v in values.items()])
    return Model(levels, conditions)


def powers(text: str) -> list[int]:
    """The numbers of `2^3 5^1`: 2, 2, 2, 5."""
    numbers = []
    for part in text.split():
        number, count = part.split("^")
        numbers += [int(number)] * int(count)
    return numbers


def forbidden(m: Model) -> str:
    """The conditions as forbidden tuples."""
    tuples = []
    for clause in m.conditions:
        choices = [
            [(p, w) for w in range(m.levels[p]) if (w != v) == equal]
            for p, equal, v in clause
        ]
        for cells in itertools.product(*choices):
            tuples.append("&".join(f"{p}={v}" for p, v in cells))
    return ";".join(tuples)
