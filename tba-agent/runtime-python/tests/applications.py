"""Runs test applications in separate processes."""

import os
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

PROJECT = Path(__file__).parents[3]
GOLDENS = PROJECT / "itaes-server/core/src/test/resources/org/sitaf/core/harness/python"


def run(entry, suite, results, path, *arguments):
    """Run an application; return the process and the results by case number."""
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(map(str, path))}
    command = [sys.executable, "-m", "sitaf_runtime", entry, "--suite", suite, "--results", results, *arguments]
    ended = subprocess.run([str(word) for word in command], env=environment, capture_output=True, text=True, timeout=60)
    lines = results.read_text().splitlines() if results.exists() else []
    elements = [ElementTree.fromstring(line) for line in lines if line]
    return ended, {int(element.attrib["no"]): element for element in elements}
