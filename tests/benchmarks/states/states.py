"""Tests packages of PyPI with a known fault in their state, and the release that fixed it, with sequences of calls.

Each model states the documented contract, with at most 6 calls in a case and at most 100 cases. The release with the
fault must fail at a step that is named, the other one must pass. The rival is a state machine of Hypothesis with the
same contract, 6 steps in an example, and as many calls, from ten seeds.
"""

import argparse
import dataclasses
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from pathlib import Path

HOME = Path(os.environ["SITAF_HOME"])
HERE = Path(__file__).parent
STEPS, CASES, SEEDS = 6, 100, 10
SHORT = ("pyee", "transitions-may")


@dataclasses.dataclass(frozen=True)
class Fault:
    """A package, the release with the fault, the one that fixed it, and the step at which it shows."""

    folder: str
    package: str
    faulty: str
    fixed: str
    step: str
    kind: str


FAULTS = (
    Fault("py-trees", "py_trees", "2.1.1", "2.1.2", "Resume", "behaviour tree"),
    Fault("simple-pid", "simple-pid", "0.1.5", "0.2.0", "Update", "PID controller"),
    Fault("transitions-again", "transitions", "0.8.11", "0.9.0", "Again", "state machine"),
    Fault("transitions-may", "transitions", "0.9.0", "0.9.1", "MayNote", "state machine"),
    Fault("python-statemachine", "python-statemachine", "1.0.2", "1.0.3", "SwitchFirst", "state machine"),
    Fault("pyee", "pyee", "4.0.1", "5.0.0", "RemoveOnce", "bus"),
)


def activity_of(fault, release, folder):
    """A copy of the activity with a release of the package."""
    example = HOME / "examples" / fault.folder
    own = HERE / "packages" / fault.folder
    shutil.copytree(own if (own / "activity.yaml").exists() else example, folder)
    profile = folder / "activity.yaml"
    profile.write_text(re.sub(r"(?m)^( +package: [^=]+==).*$", rf"\g<1>{release}", profile.read_text()))
    return folder


def run(activity, result):
    """The exit code, the cases, and the first step of each case that did not pass."""
    done = subprocess.run(
        [HOME / "sitaf", "run", activity, "--result", result], capture_output=True, text=True, timeout=300
    )
    files = sorted(result.glob("*.xml")) if result.is_dir() else [result]
    if not files or not all(file.exists() for file in files):
        sys.exit(f"{activity}: {done.stdout}{done.stderr}")
    cases = [case for file in files for case in ElementTree.parse(file).getroot().iter("test_result")]
    failed = [
        next(step.get("name") for step in case.findall("step") if step.get("verdict") != "PASS")
        for case in cases
        if case.get("verdict") in ("FAIL", "ERROR")
    ]
    return done.returncode, cases, failed


def rival(fault, examples, folder):
    """With how many seeds Hypothesis finds the fault."""
    packages = folder / "packages"
    subprocess.run(
        [sys.executable, "-m", "pip", "install", "-q", "--target", packages, f"{fault.package}=={fault.faulty}"],
        check=True,
        capture_output=True,
        timeout=300,
    )
    path = [HERE / "packages" / fault.folder, folder / "faulty" / "adapter", packages]
    environment = dict(os.environ, PYTHONPATH=os.pathsep.join(map(str, path)), PYTHONDONTWRITEBYTECODE="1")
    found = 0
    for seed in range(1, SEEDS + 1):
        done = subprocess.run(
            [sys.executable, HERE / "rival.py", str(seed), str(examples)],
            env=environment,
            capture_output=True,
            text=True,
            timeout=300,
            cwd=folder,
        )
        if done.returncode not in (0, 1) or (done.returncode == 1 and not done.stdout):
            sys.exit(done.stderr)
        found += done.returncode
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--short", action="store_true", help="only " + " and ".join(SHORT))
    short = parser.parse_args().short
    print(f"{'package':20} {'releases':16} {'kind':15} {'cases':>5} {'calls':>5} {'failed':>6}  {'first steps':17} Hypothesis")
    met = True
    for fault in FAULTS:
        if short and fault.folder not in SHORT:
            continue
        with tempfile.TemporaryDirectory(prefix="sitaf-states-") as temporary:
            folder = Path(temporary)
            code, cases, failed = run(activity_of(fault, fault.faulty, folder / "faulty"), folder / "faulty-result")
            passed, _, _ = run(activity_of(fault, fault.fixed, folder / "fixed"), folder / "fixed-result")
            lengths = [len(case.findall("step")) for case in cases]
            found = rival(fault, math.ceil(sum(lengths) / STEPS), folder)
        named = sorted(set(failed))
        holds = code == 1 and passed == 0 and fault.step in named and len(cases) <= CASES and max(lengths) <= STEPS
        met = met and holds
        print(
            f"{fault.package:20} {fault.faulty + ', ' + fault.fixed:16} {fault.kind:15} {len(cases):5} {sum(lengths):5}"
            f" {len(failed):6}  {', '.join(named):17} {found} of {SEEDS} seeds{'' if holds else '   MISSED'}"
            f"{'' if passed == 0 else f'; {fault.fixed} ends with {passed}'}",
            flush=True,
        )
    print("every fault found, and its step named" if met else "a target is missed")
    return 0 if met else 1


if __name__ == "__main__":
    sys.exit(main())
