"""Counts which planted components `./sitaf run --repeat` finds unstable, and whether it names the right cause.

Each component runs once and three further times. An unstable one counts as attributed rightly if cases are listed and
each of them has the expected cause; a stable one for which a case is listed is a false alarm.

Not planted: a simulator that is unstable, because its states follow from the seed and the commands, and no component
can change them otherwise; the number of the process and files of an earlier run, because the sandbox hides them.
"""

import argparse
import dataclasses
import math
import os
import re
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import activities
import cpp_components
import java_components
import python_components

SITAF = Path(os.environ["SITAF_HOME"]) / "sitaf"
LANGUAGES = {"python": python_components, "java": java_components, "cpp": cpp_components}
RUNS = 4
PLANTED = 40
RIGHT, FALSE_ALARMS, FURTHER_RUNS = 36, 1, 3
NONE = "stable"
HEADER = re.compile(r"^not reproducible in (\d+) runs:$|^in (\d+) runs each case had the same verdict", re.MULTILINE)
CASE = re.compile(r"^  case \d+: [A-Z ]+; ([a-z ]+): ", re.MULTILINE)
# Each language and each cause at least once.
SHORT = {
    "python": ("motor-jitter", "lost-connection", "error-with-address", "noisy-encoder"),
    "java": ("lost-updates", "error-with-object"),
    "cpp": ("uninitialised-heap", "string-hash-map"),
}


@dataclasses.dataclass(frozen=True)
class Found:
    """What the output says about a component."""

    component: activities.Component
    causes: frozenset
    runs: int
    output: str

    @property
    def is_right(self):
        expected = {self.component.cause} if self.component.cause else set()
        return self.causes == expected

    def row(self):
        each = self.component
        return (
            f"{each.name:22} {each.language:8} {each.cause or NONE:14} {' and '.join(sorted(self.causes)) or NONE:14} "
            f"{'right' if self.is_right else 'WRONG'}"
        )


def planted():
    """All components, the unstable ones first."""
    unstable = [
        dataclasses.replace(each, language=language, cause=each.cause or "the component")
        for language, module in LANGUAGES.items()
        for each in module.UNSTABLE
    ]
    stable = [
        dataclasses.replace(each, language=language) for language, module in LANGUAGES.items() for each in module.STABLE
    ]
    return unstable + stable


def find(component):
    """Run the component several times and read what is said about its cases."""
    with tempfile.TemporaryDirectory() as folder:
        activity = activities.write(component, Path(folder) / component.name)
        command = [SITAF, "run", activity, "--repeat", str(RUNS), "--no-coverage"]
        run = subprocess.run(command, capture_output=True, text=True, check=False)
    header = HEADER.search(run.stdout)
    if header is None:
        raise RuntimeError(f"{component.name} ({component.language}) was not repeated:\n{run.stdout}{run.stderr}")
    causes = frozenset(CASE.findall(run.stdout))
    if bool(header[1]) != bool(causes):
        raise RuntimeError(f"{component.name} ({component.language}): cannot read the cases of\n{run.stdout}")
    return Found(component, causes, int(header[1] or header[2]), run.stdout)


def target(label, reached, of, bound, is_met):
    print(f"{label}: {reached}{of} (target: {bound}) {'met' if is_met else 'MISSED'}")
    return is_met


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--jobs", type=int, default=1, choices=(1, 2), help="number of components at once")
    parser.add_argument("--short", action="store_true", help="four unstable and four stable components")
    parser.add_argument("--only", metavar="NAME", help="the components of this name")
    parser.add_argument("--output", action="store_true", help="print what SITAF prints about each component")
    arguments = parser.parse_args()
    components = planted()
    if arguments.short:
        components = [each for each in components if each.name in SHORT[each.language]]
    if arguments.only:
        components = [each for each in components if each.name == arguments.only]
    if not components:
        sys.exit(f"no component {arguments.only}; these exist: {', '.join(each.name for each in planted())}")
    began = time.monotonic()
    found = []
    print(f"{'name':22} {'language':8} {'expected':14} {'found':14} result")
    with ThreadPoolExecutor(arguments.jobs) as pool:
        for each in pool.map(find, components):
            found.append(each)
            print(each.row(), flush=True)
            if arguments.output or not each.is_right:
                print(each.output, flush=True)
    unstable = [each for each in found if each.component.cause]
    stable = [each for each in found if not each.component.cause]
    right = sum(each.is_right for each in unstable)
    alarms = sum(not each.is_right for each in stable)
    further = max(each.runs for each in found) - 1
    # The shares of the whole also hold for a part.
    least = math.ceil(len(unstable) * RIGHT / PLANTED)
    most = len(stable) * FALSE_ALARMS // PLANTED
    print(f"{len(found)} components in {time.monotonic() - began:.0f} s")
    met = [
        target("attributed rightly", right, f" of {len(unstable)}", f"at least {least}", right >= least),
        target("false alarms", alarms, f" of {len(stable)}", f"at most {most}", alarms <= most),
        target("further runs each", further, "", f"at most {FURTHER_RUNS}", further <= FURTHER_RUNS),
    ]
    return 0 if all(met) else 1


if __name__ == "__main__":
    sys.exit(main())
