"""Compares five unstable components with themselves: `./sitaf compare` must call them unstable, not different.

Their values depend on the order of threads, the order of a hash table, the time of day, memory that nobody
initialised, and random numbers without a seed. The alternative in the same run is what a comparison without further
runs would report: each case in which BASE and NEW disagree.
"""

import argparse
import dataclasses
import itertools
import json
import os
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent / "flaky"))
import activities
import flaky

SITAF = Path(os.environ["SITAF_HOME"]) / "sitaf"
PLANTED = {
    "thread order": ("python", "thread-order"),
    "hash order": ("python", "string-set"),
    "time of day": ("java", "clock-of-message"),
    "uninitialised memory": ("cpp", "uninitialised-heap"),
    "random without seed": ("java", "monte-carlo"),
}
MOST_DIFFERENCES = 1
SHOWN_EVERY = 100


@dataclasses.dataclass
class Counts:
    """What the comparisons of one component reported."""

    runs: int = 0
    differences: int = 0
    named: int = 0  # runs in which the component is unstable
    cases: int = 0  # of all runs, in which versions or runs of a version disagree

    def add(self, found):
        """Count what one comparison found."""
        self.runs += 1
        self.differences += len(found["differences"])
        self.named += bool(found["unstable"])
        self.cases += len(found["unstable"]) + len(found["differences"])


def compare(folder, no):
    """What `./sitaf compare` finds between an activity and itself."""
    output = folder.parent / f"{folder.name}-{no}.json"
    command = [SITAF, "compare", folder, folder, "--json", output]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if run.returncode not in (0, 1):
        raise RuntimeError(f"{' '.join(map(str, command))}:\n{run.stdout}{run.stderr}")
    found = json.loads(output.read_text())
    output.unlink()
    return found


def show(counts):
    print(f"{'depends on':22} {'runs':>6} {'unstable':>9} {'differences':>12} {'cases that disagree':>20}")
    for what, each in counts.items():
        print(f"{what:22} {each.runs:6} {each.named:9} {each.differences:12} {each.cases:20}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=1000, help="of all components together")
    parser.add_argument("--jobs", type=int, default=1, choices=(1, 2), help="number of comparisons at once")
    arguments = parser.parse_args()
    components = {(each.language, each.name): each for each in flaky.planted()}
    counts = {what: Counts() for what in PLANTED}
    began = time.monotonic()
    with tempfile.TemporaryDirectory() as root, ThreadPoolExecutor(arguments.jobs) as pool:
        folders = {what: activities.write(components[key], Path(root) / key[1]) for what, key in PLANTED.items()}
        turns = list(itertools.islice(itertools.cycle(PLANTED), arguments.runs))
        comparisons = pool.map(compare, (folders[what] for what in turns), itertools.count())
        for done, (what, found) in enumerate(zip(turns, comparisons), 1):
            counts[what].add(found)
            if found["differences"]:
                print(f"{what}: {json.dumps(found['differences'])}", flush=True)
            if done % SHOWN_EVERY == 0 or done == len(turns):
                show(counts)
    differences = sum(each.differences for each in counts.values())
    disagreeing = sum(each.cases for each in counts.values())
    unnamed = [what for what, each in counts.items() if not each.named]
    print(f"{sum(each.runs for each in counts.values())} comparisons in {time.monotonic() - began:.0f} s")
    print(f"ratio: differences to those without further runs: {differences / max(1, disagreeing):.6f}")
    held = differences <= MOST_DIFFERENCES and not unnamed
    print(f"differences: {differences} (target: at most {MOST_DIFFERENCES}); not called unstable: {unnamed or 'none'}")
    print("unstable: held" if held else "unstable: short")
    return 0 if held else 1


if __name__ == "__main__":
    sys.exit(main())
