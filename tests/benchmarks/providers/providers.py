"""Runs the infrared example with sensors behind a provider, and compares each verdict with the simulated one.

The provider serves the devices of the same world. A run in which the machine was too busy has cases that are
DONT (infrastructure); it is counted by itself. A case that is FAIL or ERROR, or has another value, breaks the target.
"""

import argparse
import os
import shutil
import statistics
import sys
import subprocess
import tempfile
import time
import xml.etree.ElementTree as ElementTree
from pathlib import Path

ROOT = Path(os.environ["SITAF_HOME"])
sys.path.insert(0, str(ROOT / "tests" / "contract"))

from provider_contract import running, simulated  # noqa: E402

SENSORS = (1, 3, 7)
MODEL = "GetInfraredData.xml"


def run(activity, results):
    """Run an activity. Returns {case: (verdict, actual values)} and the seconds that it took."""
    began = time.monotonic()
    ended = subprocess.run(
        [ROOT / "sitaf", "run", activity, "--result", results], capture_output=True, text=True, check=False
    )
    took = time.monotonic() - began
    if ended.returncode not in (0, 1, 2) or not (results / MODEL).exists():
        sys.exit(f"the run ended with exit code {ended.returncode}:\n{ended.stdout}{ended.stderr}")
    cases = {}
    for case in ElementTree.parse(results / MODEL).getroot().iter("test_result"):
        cases[case.get("no")] = (case.get("verdict"), *(item.text for item in case.iter("actual")))
    return cases, took


def behind_provider(folder, address, count):
    """A copy of the example of which only activity.yaml changes."""
    activity = shutil.copytree(ROOT / "examples" / "ir-sensor", folder / f"behind-{count}")
    profile = activity / "activity.yaml"
    entry = f'{{backend: provider, address: "{address}", max_age_s: 5}}'
    devices = "".join(f"  ir{n}: {entry}\n" for n in range(1, count + 1))
    lines = [line for line in profile.read_text().splitlines(keepends=True) if not line.startswith("limits:")]
    profile.write_text(f"{''.join(lines)}hardware:\n{devices}limits: {{jitter_ms: 2000}}\n")
    return activity


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=100)
    runs = parser.parse_args().runs
    equal = late = broken = 0
    times = {count: [] for count in SENSORS}
    with tempfile.TemporaryDirectory(prefix="sitaf-v") as name:
        folder = Path(name)
        expected, _ = run(ROOT / "examples" / "ir-sensor", folder / "simulated")
        simulations = [run(ROOT / "examples" / "ir-sensor", folder / "simulated")[1] for _ in range(3)]
        verdicts = sorted({verdict for verdict, *_ in expected.values()})
        print(f"simulated: {len(expected)} cases, {', '.join(verdicts)}", flush=True)
        with running(lambda address: simulated("ir-sensor/world/ir.world.yaml", address)) as (_, address):
            activities = {count: behind_provider(folder, address, count) for count in SENSORS}
            for index in range(runs):
                count = SENSORS[index % len(SENSORS)]
                actual, took = run(activities[count], folder / "result")
                times[count].append(took)
                different = {no: actual.get(no) for no in expected if actual.get(no) != expected[no]}
                not_run = [no for no, case in different.items() if case and case[0] == "DONT"]
                equal += not different
                late += bool(different) and len(not_run) == len(different)
                broken += len(not_run) < len(different)
                if different:
                    shown = ", ".join(f"case {no}: {case}" for no, case in sorted(different.items())[:3])
                    print(f"run {index + 1}, {count} behind the provider: {len(different)} differ: {shown}", flush=True)
    for count, seconds in times.items():
        if seconds:
            ratio = statistics.median(seconds) / statistics.median(simulations)
            print(f"{count} behind the provider: {statistics.median(seconds):.1f} s, {ratio:.2f} x simulated")
    print(f"{equal} of {runs} runs equal, {late} with cases that were late (DONT), {broken} with other verdicts")
    print("providers: held" if equal + late == runs and equal >= 0.95 * runs else "providers: short")


if __name__ == "__main__":
    main()
