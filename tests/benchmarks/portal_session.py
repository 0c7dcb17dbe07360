"""A system that runs for a measurement, and requests in the session of a page that is signed in to it."""

import io
import os
import re
import shutil
import signal
import subprocess
import time
import zipfile
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple

from playwright.sync_api import sync_playwright

HOME = Path(os.environ["SITAF_HOME"])
INTERVAL_S = 0.5


class Built(NamedTuple):
    """The ids of an activity, its suite, and a build that is done."""

    activity: str
    suite: str
    build: str


def example(name):
    """The files of an example by their paths."""
    folder = HOME / "examples" / name
    return {str(p.relative_to(folder)): p.read_bytes() for p in sorted(folder.rglob("*")) if p.is_file()}


def zipped(files):
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w") as file:
        for path, data in files.items():
            file.writestr(path, data)
    return content.getvalue()


class Session:
    """Requests of the portal's own session. `root` is the beginning of its addresses."""

    def __init__(self, page, root):
        self.page = page
        self.root = root

    def _fetch(self, method, path, data, kind):
        token = next((c["value"] for c in self.page.context.cookies() if c["name"] == "XSRF-TOKEN"), "")
        answer = self.page.request.fetch(
            self.root + path,
            method=method,
            data=data,
            headers={"Content-Type": kind, "X-XSRF-TOKEN": token},
            timeout=600_000,
        )
        assert answer.ok, f"{method} {path}: {answer.status} {answer.text()}"
        return answer

    def post(self, path, data="{}", kind="application/json"):
        return self._fetch("POST", path, data, kind).json()

    def get(self, path):
        return self._fetch("GET", path, None, "application/json").json()

    def bytes(self, path):
        return self._fetch("GET", path, None, "application/json").body()

    def wait(self, path, patience_s=600):
        """Waits until a build or an analysis is done; whether it was in time. Another end is an error."""
        deadline = time.monotonic() + patience_s
        while (found := self.get(path))["state"] not in ("DONE", "FAILED", "CANCELLED"):
            if time.monotonic() > deadline:
                return False
            time.sleep(INTERVAL_S)
        assert found["state"] == "DONE", found
        return True

    def build(self, files, model):
        """Uploads an activity and builds a model."""
        activity = self.post("/api/v1/activities", zipped(files), "application/zip")["id"]
        suite = self.post(f"/api/v1/activities/{activity}/models/{model}/suites")["id"]
        build = self.post("/api/v1/builds", f'{{"suiteId":"{suite}"}}')["id"]
        assert self.wait(f"/api/v1/builds/{build}"), f"{model} is not done"
        return Built(activity, suite, build)


@contextmanager
def signed_in(data):
    """The session of a page of a system with a data folder; both end after the block."""
    system = subprocess.Popen(
        [HOME / "sitaf", "up", "--port", "0", "--grpc-port", "0", "--data", data],
        stdout=subprocess.PIPE,
        stdin=subprocess.PIPE,
        text=True,
    )
    try:
        link = next(m.group(1) for line in system.stdout if (m := re.search(r"valid once: (http\S+)", line)))
        with sync_playwright() as driver:
            chromium = driver.chromium.launch(executable_path=shutil.which("chromium"), args=["--no-sandbox"])
            page = chromium.new_page(viewport={"width": 1280, "height": 900})
            page.goto(link)
            page.get_by_role("heading", name="Interface tests").wait_for()
            yield Session(page, re.match(r"https?://[^/]+", link).group(0))
            chromium.close()
    finally:
        system.send_signal(signal.SIGINT)
        system.wait(timeout=120)
