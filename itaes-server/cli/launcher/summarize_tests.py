"""Lists the skipped and the failed tests of a run; exits with 1 if one failed. usage: summarize_tests.py HOME REPORTS

HOME is the source tree, whose Maven modules have reports of Surefire. REPORTS is the folder of the other reports. Its file
`begun` was written when the tests began: older reports are those of an earlier run.
"""

import sys
import xml.etree.ElementTree as ElementTree
from collections import Counter
from pathlib import Path

WIDTH = 240


def main():
    home, reports = map(Path, sys.argv[1:])
    begun = (reports / "begun").stat().st_mtime
    surefire = [*home.glob("*/target/surefire-reports/TEST-*.xml"), *home.glob("*/*/target/surefire-reports/TEST-*.xml")]
    files = [file for file in surefire if file.stat().st_mtime >= begun] + sorted(reports.glob("*.xml"))
    tests, skipped, failed = 0, Counter(), []
    for file in sorted(files):
        try:
            cases = list(ElementTree.parse(file).getroot().iter("testcase"))
        except ElementTree.ParseError as e:
            failed.append(f"{file}: the report is not complete: {e}")
            continue
        tests += len(cases)
        for case in cases:
            name = f"{case.get('classname')}: {case.get('name')}"
            for problem in case.findall("failure") + case.findall("error"):
                failed.append(f"{name}: {first_line(problem)}")
            for skip in case.findall("skipped"):
                skipped[first_line(skip)] += 1
    print(f"{tests} tests, {len(failed)} failed, {skipped.total()} skipped")
    for reason, count in skipped.most_common():
        print(f"  skipped {count}: {reason}")
    for test in failed:
        print(f"  failed: {test}")
    return 1 if failed else 0


def first_line(problem):
    text = problem.get("message") or problem.text or problem.get("type") or "no reason"
    return text.strip().partition("\n")[0][:WIDTH]


sys.exit(main())
