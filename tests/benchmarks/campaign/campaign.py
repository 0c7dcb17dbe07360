"""Runs campaigns against controllers with planted faults, and as many random single faults.

A planted fault is found when the controller fails with a fault of a device with which the reference does not.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from controllers import PLANTED, write

ROOT = Path(os.environ["SITAF_HOME"])
FAILURES = ("broke a condition", "crashed")
TARGET = 4


def failures(activity, cases, seed, random):
    """The faults alone with which the controller fails."""
    found = activity / "campaign.json"
    command = [
        ROOT / "sitaf",
        "campaign",
        activity,
        "--max-cases",
        str(cases),
        "--seed",
        str(seed),
        "--json",
        found,
    ]
    run = subprocess.run(
        [*command, *(["--random"] if random else [])],
        capture_output=True,
        text=True,
        check=False,
    )
    if run.returncode not in (0, 1):
        sys.exit(f"{' '.join(map(str, command))}:\n{run.stdout}{run.stderr}")
    result = json.loads(found.read_text())
    assert result["cases"] <= cases
    return {
        (row["device"], row["fault"]): row["case"]
        for row in result["table"]
        if row["behaviour"] in FAILURES
    }


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--cases", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", choices=[*PLANTED], help="one planted fault")
    arguments = parser.parse_args()
    chosen = [arguments.only] if arguments.only else [*PLANTED]
    counts = {"campaign": 0, "random": 0}
    with tempfile.TemporaryDirectory() as folder:
        for label in counts:
            began = time.monotonic()
            reference = write(ROOT, Path(folder) / f"{label}-reference")
            healthy = failures(
                reference, arguments.cases, arguments.seed, label == "random"
            )
            print(
                f"{label}: the reference fails with {len(healthy)} faults {sorted('.'.join(cell) for cell in healthy)}",
                flush=True,
            )
            for index, planted in enumerate(chosen):
                activity = write(ROOT, Path(folder) / f"{label}-{index}", planted)
                new = {
                    c: no
                    for c, no in failures(
                        activity, arguments.cases, arguments.seed, label == "random"
                    ).items()
                    if c not in healthy
                }
                counts[label] += bool(new)
                shown = ", ".join(
                    f"{device}.{fault} (case {no})"
                    for (device, fault), no in sorted(new.items())
                )
                print(f"{label:9} {planted:40} {shown or 'not found'}", flush=True)
            print(
                f"{label}: {counts[label]} of {len(chosen)} found, {time.monotonic() - began:.0f} s",
                flush=True,
            )
    target = min(TARGET, len(chosen))
    print(
        f"target: at least {target} of {len(chosen)} with at most {arguments.cases} cases"
    )
    print(
        "campaign: held"
        if counts["campaign"] >= target
        else f"campaign: short: {counts['campaign']} found"
    )


if __name__ == "__main__":
    main()
