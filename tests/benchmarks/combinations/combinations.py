"""Measures covering arrays beside PICT and allpairspy, in the same run, and prints a table."""

from __future__ import annotations

import itertools
import json
import os
import random
import re
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

HOME = Path(os.environ["SITAF_HOME"])
STATE = Path(os.environ["SITAF_BENCH_STATE"])
MODELS = HOME.parent / "shared" / "benchmarks" / "combinatorial"
PEER_LIMIT_S = 180

# Model, strength, effort, the most rows that hold; None: no more than PICT has.
TARGETS: list[tuple[str, int, str, int | None]] = [
    ("3^4", 2, "default", 9),
    ("3^13", 2, "default", 15),
    ("7^3", 2, "default", 49),
    ("4^10", 2, "default", 24),
    ("5^10", 2, "default", 38),
    ("4^15 3^17 2^29", 2, "default", 29),
    ("4^1 3^39 2^35", 2, "default", 21),
    ("2^100", 2, "default", 10),
    ("10^20", 2, "default", 180),
    ("10^2 4^1 3^2 2^7", 2, "default", 100),
    ("spins.xml", 2, "default", 19),
    ("gcc.xml", 2, "default", 17),
    ("apache-like", 2, "default", None),
    ("3^13", 3, "default", 63),
    ("4^10", 3, "default", 132),
    ("5^10", 3, "best", 262),
    ("4^1 3^39 2^35", 3, "best", 109),
    ("2^100", 3, "best", 38),
    ("10^20", 3, "default", 3097),
    ("spins.xml", 3, "default", 80),
    ("gcc.xml", 3, "best", 108),
    ("10^2 4^1 3^2 2^7", 4, "default", 1200),
    ("10^2 4^1 3^2 2^7", 5, "default", 3600),
    ("10^2 4^1 3^2 2^7", 6, "best", 9600),
]

Literal = tuple[int, bool, int]


@dataclass(frozen=True)
class Model:
    """Levels of the parameters, and clauses of literals (parameter, equal, value)."""

    levels: list[int]
    conditions: list[list[Literal]]


def model(name: str) -> Model | None:
    """The model of this name; None when its file is not on this machine."""
    if name == "apache-like":
        return apache_like(random.Random(1))
    if name.endswith(".xml"):
        return read(MODELS / name) if (MODELS / name).exists() else None
    levels = []
    for part in name.split():
        value, count = part.split("^")
        levels += [int(value)] * int(count)
    return Model(levels, [])


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


def apache_like(dice: random.Random) -> Model:
    """172 parameters and clauses of two to four literals, which the all-zero row satisfies."""
    levels = [2] * 158 + [3] * 8 + [4] * 4 + [5, 6]
    conditions = []
    for size in [2] * 3 + [3] * 2 + [4] * 2 + [2] * 20:
        chosen = dice.sample(range(len(levels)), size)
        literals = [(p, False, dice.randrange(levels[p])) for p in chosen[1:]]
        conditions.append(
            [*literals, (chosen[0], False, dice.randrange(1, levels[chosen[0]]))]
        )
    return Model(levels, conditions)


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


class Ours:
    """The combinator, in a process that stays warm."""

    def __init__(self) -> None:
        classpath = f"{HOME}/.sitaf/dist/cli/lib/*"
        source = str(Path(__file__).with_name("Ours.java"))
        self.process = subprocess.Popen(
            ["java", "-Xmx1g", "-cp", classpath, source],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        for name in ("4^15 3^17 2^29", "3^13", "2^20"):
            warm = model(name)
            assert warm is not None
            self.ask(warm, 2, "default")

    def ask(self, m: Model, strength: int, effort: str) -> list[float]:
        """First rows, their seconds, best rows, their seconds, seconds in all, findings."""
        assert self.process.stdin is not None and self.process.stdout is not None
        levels = ",".join(map(str, m.levels))
        self.process.stdin.write(
            f"{strength}\t{effort.upper()}\t{levels}\t{forbidden(m)}\n"
        )
        self.process.stdin.flush()
        return [float(cell) for cell in self.process.stdout.readline().split("\t")]

    def close(self) -> None:
        """Ends the process."""
        assert self.process.stdin is not None
        self.process.stdin.close()
        self.process.wait()


def pict(m: Model, strength: int) -> tuple[int, float] | None:
    """Rows and seconds of PICT; None when it fails or takes too long."""
    asked = json.dumps(
        {"levels": m.levels, "strength": strength, "conditions": m.conditions}
    )
    try:
        done = subprocess.run(
            ["node", str(STATE / "pict.mjs")],
            input=asked,
            capture_output=True,
            text=True,
            timeout=PEER_LIMIT_S,
            check=True,
        )
    except (subprocess.TimeoutExpired, subprocess.CalledProcessError):
        return None
    answer = json.loads(done.stdout)
    return answer["rows"], answer["seconds"]


def allpairs(m: Model, strength: int) -> tuple[int, float] | None:
    """Rows and seconds of allpairspy, which is only asked for pairs without conditions."""
    from allpairspy import AllPairs

    if strength != 2 or m.conditions:
        return None
    began = time.monotonic()
    rows = sum(1 for _ in AllPairs([list(range(n)) for n in m.levels]))
    return rows, time.monotonic() - began


def shown(peer: tuple[int, float] | None) -> str:
    """A peer's cell of the table."""
    return "-" if peer is None else f"{peer[0]} {peer[1]:.2f}s"


def main(arguments: list[str]) -> int:
    """Prints the table; the exit code is 0 also when a row is short."""
    chosen = [
        row
        for row in TARGETS
        if (
            not arguments
            or row[0] in arguments
            or ("--pairs" in arguments and row[1] == 2)
        )
    ]
    ours = Ours()
    short = []
    print(
        f"{'model':18} t  effort  {'first':>14} {'rows':>6} {'after':>8} {'whole':>8}"
        f" {'target':>6} {'PICT':>14} {'allpairspy':>14} {'of PICT':>7}"
    )
    for name, strength, effort, target in chosen:
        m = model(name)
        if m is None:
            print(f"{name:18} {strength}  skipped: {MODELS} is not on this machine")
            continue
        first, first_s, rows, rows_s, whole_s, findings = ours.ask(m, strength, effort)
        peer = pict(m, strength)
        most = target if target is not None else (peer[0] if peer else None)
        held = not findings and (most is None or rows <= most)
        if not held:
            short.append(f"{name} at {strength}-way has {rows:.0f} rows, target {most}")
        ratio = f"{rows / peer[0]:.2f}" if peer else "-"
        print(
            f"{name:18} {strength}  {effort:7} {f'{first:.0f} {first_s:.2f}s':>14} {rows:6.0f}"
            f" {rows_s:7.2f}s {whole_s:7.2f}s {most or '-':>6} {shown(peer):>14}"
            f" {shown(allpairs(m, strength)):>14} {ratio:>7}{'' if held else '  short'}",
            flush=True,
        )
    ours.close()
    print("combinations: " + ("short: " + "; ".join(short) if short else "held"))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
