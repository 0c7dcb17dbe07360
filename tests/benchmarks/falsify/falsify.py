"""Counts the executions until a violation is found, by the search and by uniformly random values, for several seeds.

The activity is one whose 2-way suite passes.
"""

import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(os.environ["SITAF_HOME"])
EXAMPLE = ROOT / "examples" / "joint-scheduling-faulty"


def sitaf(*arguments, exits):
    """Run a command of the launcher; return its exit code."""
    command = [ROOT / "sitaf", *map(str, arguments)]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if run.returncode not in exits:
        sys.exit(f"{' '.join(map(str, command))}:\n{run.stdout}{run.stderr}")
    return run.returncode


def executions(activity, budget, seed, random, file):
    """The number of executions, whether a violation was found, and the seconds that it took."""
    began = time.monotonic()
    options = ["--random"] if random else []
    sitaf("falsify", activity, "--budget", budget, "--seed", seed, "--json", file, *options, exits=(0, 1))
    found = json.loads(file.read_text())
    return found["executions"], found["violated"], time.monotonic() - began


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--activity", type=Path, default=EXAMPLE)
    parser.add_argument("--seeds", type=int, default=10, help="number of seeds, from 1")
    parser.add_argument("--budget", type=int, default=200, help="maximum number of executions of each search")
    arguments = parser.parse_args()
    counts = {"search": [], "random": []}
    missed = dict.fromkeys(counts, 0)
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(1, arguments.seeds + 1):
            suite = sitaf("run", arguments.activity, "--seed", seed, exits=(0, 1))
            print(f"seed {seed}: the suite {'passes' if suite == 0 else 'FAILS'}", flush=True)
            for label, found in counts.items():
                count, violated, seconds = executions(
                    arguments.activity, arguments.budget, seed, label == "random", Path(folder) / "found.json"
                )
                missed[label] += not violated
                # A search that found nothing would have needed more than its budget.
                found.append(count if violated else arguments.budget + 1)
                print(f"  {label}: {'violated' if violated else 'nothing'} after {count} cases, {seconds:.1f} s", flush=True)
    for label, found in counts.items():
        print(f"{label}: median {statistics.median(found)}, largest {max(found)}, nothing found {missed[label]} times")
    ratio = statistics.median(counts["search"]) / statistics.median(counts["random"])
    met = not missed["search"] and ratio < 1
    print(f"medians, search / random: {ratio:.2f} (target: below 1, and the search finds a violation with every seed)")
    return 0 if met else 1


if __name__ == "__main__":
    sys.exit(main())
