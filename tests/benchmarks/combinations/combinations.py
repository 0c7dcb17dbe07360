"""Compares covering arrays with those of PICT and allpairspy in the same run and prints a table."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

from models import MODELS, SHAPES, Model, forbidden, model

HOME = Path(os.environ["SITAF_HOME"])
STATE = Path(os.environ["SITAF_BENCH_STATE"])
PEER_LIMIT_S = 180

# Model, strength, effort, target number of rows; None: the number of rows of PICT.
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
    *((f"like {shape}", 2, "default", None) for shape in SHAPES),
]


@dataclass(frozen=True)
class Answer:
    """Rows, total seconds, findings of the coverage check, and the improvements: rows, seconds."""

    rows: int
    whole_s: float
    findings: int
    improvements: list[tuple[int, float]]

    def reached_s(self, rows: int) -> float | None:
        """Seconds until an array had at most this many rows; None: never."""
        return next((s for n, s in self.improvements if n <= rows), None)


class Ours:
    """The combinator in a running process."""

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

    def ask(self, m: Model, strength: int, effort: str) -> Answer:
        """Combines a model."""
        assert self.process.stdin is not None and self.process.stdout is not None
        levels = ",".join(map(str, m.levels))
        self.process.stdin.write(
            f"{strength}\t{effort.upper()}\t{levels}\t{forbidden(m)}\n"
        )
        self.process.stdin.flush()
        rows, whole, findings, steps = self.process.stdout.readline().split("\t")
        improvements = [step.split("@") for step in steps.split()]
        return Answer(
            int(rows),
            float(whole),
            int(findings),
            [(int(n), float(seconds)) for n, seconds in improvements],
        )

    def close(self) -> None:
        """End the process."""
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
    """Rows and seconds of allpairspy, which supports only pairs without conditions."""
    from allpairspy import AllPairs

    if strength != 2 or m.conditions:
        return None
    began = time.monotonic()
    rows = sum(1 for _ in AllPairs([list(range(n)) for n in m.levels]))
    return rows, time.monotonic() - began


def shown(peer: tuple[int, float] | None) -> str:
    """Format the result of another tool."""
    return "-" if peer is None else f"{peer[0]} {peer[1]:.2f}s"


def seconds_allowed(strength: int, effort: str) -> float:
    """Time limit for the target size."""
    if effort == "best":
        return 120
    return 1.5 if strength == 2 else 20


def shortfalls(
    strength: int,
    effort: str,
    answer: Answer,
    most: int | None,
    peer: tuple[int, float] | None,
) -> list[str]:
    """Describe the missed targets of a row."""
    short = []
    if answer.findings:
        short.append(f"the check has {answer.findings} findings")
    if most is not None:
        reached, allowed = answer.reached_s(most), seconds_allowed(strength, effort)
        if reached is None:
            short.append(f"{answer.rows} rows, target {most}")
        elif reached > allowed:
            short.append(f"{most} rows after {reached:.1f} s, target {allowed} s")
    if peer is not None and effort == "default":
        reached = answer.reached_s(peer[0])
        allowed = 0.3 if strength == 2 else max(0.5, peer[1])
        if reached is None:
            short.append(f"{answer.rows} rows, PICT has {peer[0]}")
        elif reached > allowed:
            short.append(f"PICT's size after {reached:.2f} s, target {allowed:.2f} s")
    return short


def main(arguments: list[str]) -> int:
    """Print the table; the exit code is 0 even if a target is missed."""
    chosen = [
        row
        for row in TARGETS
        if not arguments
        or row[0] in arguments
        or ("--pairs" in arguments and row[1] == 2)
        or ("--constrained" in arguments and row[0].startswith("like "))
    ]
    ours = Ours()
    short = []
    sums = [0, 0]
    print(
        "rows of SITAF, when its target and PICT's size were reached, and its seconds in all"
    )
    print(
        f"{'model':18} t  effort  {'rows':>6} {'target':>13} {'PICT size':>10} {'whole':>8}"
        f" {'PICT':>14} {'allpairspy':>14} {'of PICT':>7}"
    )
    for name, strength, effort, target in chosen:
        m = model(name)
        if m is None:
            print(f"{name:18} {strength}  skipped: {MODELS} is not on this machine")
            continue
        answer = ours.ask(m, strength, effort)
        peer = pict(m, strength)
        misses = shortfalls(strength, effort, answer, target, peer)
        short += [f"{name} at {strength}-way: {miss}" for miss in misses]
        if peer:
            sums = [sums[0] + answer.rows, sums[1] + peer[0]]
        print(
            f"{name:18} {strength}  {effort:7} {answer.rows:6}"
            f" {after(answer, target):>13} {after(answer, peer and peer[0]):>10} {answer.whole_s:7.2f}s"
            f" {shown(peer):>14} {shown(allpairs(m, strength)):>14}"
            f" {f'{answer.rows / peer[0]:.2f}' if peer else '-':>7}{'  short' if misses else ''}",
            flush=True,
        )
    ours.close()
    print(f"rows in all, where PICT has an answer: {sums[0]}, PICT {sums[1]}")
    print("combinations: " + ("short: " + "; ".join(short) if short else "held"))
    return 0


def after(answer: Answer, rows: int | None) -> str:
    """Format a size and the time at which it was reached."""
    if rows is None:
        return "-"
    reached = answer.reached_s(rows)
    return f"{rows} never" if reached is None else f"{rows} {reached:.2f}s"


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
