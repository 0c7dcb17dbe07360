"""Fixtures that run the launcher."""

import os
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
LIMIT_S = 600


@dataclass(frozen=True)
class Sitaf:
    """The launcher of this source tree."""

    root: Path

    def __call__(self, *arguments, env=None, stdin=None):
        """Run a command; return exit code and output."""
        return subprocess.run(
            [str(self.root / "sitaf"), *map(str, arguments)],
            cwd=self.root,
            capture_output=True,
            text=True,
            timeout=LIMIT_S,
            check=False,
            env={**os.environ, **(env or {})},
            input=stdin,
        )


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
