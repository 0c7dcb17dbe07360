"""Fixtures that run the launcher."""

import os
import shutil
import signal
import subprocess
from dataclasses import dataclass
from pathlib import Path

import pytest
from terminal import Terminal

ROOT = Path(__file__).resolve().parents[1]
LIMIT_S = 600

# These run for a minute or more each. They begin before the others, so that no worker waits for the last of them alone.
LONGEST = (
    "faults/test_hostile.py",
    "e2e/portal/",
    "e2e/test_languages.py",
    "faults/test_programs.py",
    "e2e/test_examples.py",
    "e2e/test_cpp.py",
    "e2e/test_overlap.py",
    "e2e/test_compare.py",
    "faults/test_full_server_disk.py",
    "faults/test_full_disk.py",
    "e2e/test_libraries.py",
    "e2e/test_server.py",
    "e2e/test_ros2.py",
    "e2e/test_ros2_sequences.py",
    "e2e/test_new.py",
)


@dataclass(frozen=True)
class Sitaf:
    """The launcher of this source tree."""

    root: Path

    def __call__(self, *arguments, env=None, stdin=None, cwd=None):
        """Run a command; return exit code and output."""
        return subprocess.run(
            [str(self.root / "sitaf"), *map(str, arguments)],
            cwd=cwd or self.root,
            capture_output=True,
            text=True,
            timeout=LIMIT_S,
            check=False,
            env={**os.environ, **(env or {})},
            input=stdin,
        )


def pytest_collection_modifyitems(items):
    def rank(item):
        file = item.nodeid.partition("::")[0]
        return next((i for i, begin in enumerate(LONGEST) if file.startswith(begin)), len(LONGEST))

    items.sort(key=rank)


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config, log):
    """Test files run in parallel, except those of the portal, which share a system and its state."""
    from xdist.scheduler import LoadFileScheduling

    class Scheduling(LoadFileScheduling):
        def _split_scope(self, nodeid):
            file = super()._split_scope(nodeid)
            folder = file.rpartition("/")[0]
            return folder if folder == "e2e/portal" else file

    return Scheduling(config, log)


@pytest.fixture(scope="session")
def sitaf():
    return Sitaf(ROOT)


@pytest.fixture(scope="session")
def driver():
    """Playwright, shared by all tests because a process can run only one instance."""
    playwright = pytest.importorskip(
        "playwright.sync_api", reason="the browser's driver is missing: pip install playwright"
    )
    with playwright.sync_playwright() as started:
        yield started


@pytest.fixture
def activity(tmp_path):
    """A copy of the infrared example that a test may modify."""
    folder = tmp_path / "ir-sensor"
    shutil.copytree(ROOT / "examples" / "ir-sensor", folder)
    return folder


@pytest.fixture
def terminal():
    """Starts commands whose output is read while they run; they end with the test."""
    started = []

    def start(*arguments, command=None):
        started.append(Terminal(*arguments, command=command))
        return started[-1]

    yield start
    for each in started:
        if each.process.poll() is None:
            os.killpg(each.process.pid, signal.SIGKILL)
