"""Begins an activity for each interface file of the fixtures, in each language, and runs it.

usage: ./sitaf bench beginning [--languages python,java,cpp] [FILE-OR-FOLDER...]
A file without an interface must be refused as such. Any other must give an activity that runs with exit code 0.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

HOME = Path(os.environ["SITAF_HOME"])
COMMAND = os.environ.get("SITAF_COMMAND", str(HOME / "sitaf")).split()
FOLDERS = (
    HOME / "itaes-server/core/src/test/resources",
    HOME / "itaes-server/cli/src/test/resources",
    HOME / "examples",
    HOME / ".sitaf/ros2",
    HOME.parent / "shared/opros-profiles",
    HOME.parent / "shared/idl",
)
NO_INTERFACE = "contains no interface with a method"


def fixtures(places: list[Path]) -> Iterator[Path]:
    for place in places:
        for path in sorted(place.rglob("*")) if place.is_dir() else [place]:
            if path.suffix in (".srv", ".action", ".idl", ".proto"):
                yield path
            elif path.suffix == ".xml" and b"<service_port_type" in path.read_bytes()[:10_000]:
                yield path


def sitaf(*arguments: str | Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run([*COMMAND, *map(str, arguments)], stdin=subprocess.DEVNULL, capture_output=True, text=True)


def outcome(interface: Path, language: str, folder: Path) -> tuple[str, str]:
    begun = sitaf("new", folder, "--language", language, "--interface", interface)
    if begun.returncode:
        return ("no interface" if NO_INTERFACE in begun.stderr else "refused"), begun.stderr
    ran = sitaf("run", folder, "--no-coverage")
    return ("green" if ran.returncode == 0 else f"exit code {ran.returncode}"), ran.stdout + ran.stderr


def main() -> int:
    parser = argparse.ArgumentParser(prog="./sitaf bench beginning")
    parser.add_argument("--languages", default="python,java,cpp")
    parser.add_argument("places", nargs="*", type=Path, default=[f for f in FOLDERS if f.exists()])
    options = parser.parse_args()
    counts: dict[str, Counter[str]] = {language: Counter() for language in options.languages.split(",")}
    with tempfile.TemporaryDirectory() as temporary:
        for number, interface in enumerate(fixtures(options.places)):
            for language, counted in counts.items():
                result, text = outcome(interface, language, Path(temporary) / f"{number}-{language}")
                counted[result] += 1
                if result == "no interface":
                    break
                if result != "green":
                    print(f"{interface} in {language}: {result}: {' | '.join(text.splitlines()[-4:])}", flush=True)
    short = []
    print(f"{'language':10} {'green':>6} {'of':>6}   target: all")
    for language, counted in counts.items():
        total = sum(counted.values()) - counted["no interface"]
        print(f"{language:10} {counted['green']:6} {total:6}")
        if counted["green"] < total:
            short.append(f"{total - counted['green']} in {language}")
    print("beginning: held" if not short else f"beginning: short: {', '.join(short)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
