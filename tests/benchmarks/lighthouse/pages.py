"""Measures the portal with Lighthouse, in Debian's Chromium on loopback, with a failing result of the paper's sensor.

Each page is measured three times; the median counts. The default is Lighthouse's desktop setting: 10 Mbit/s, 40 ms and
this processor. `--mobile` is its setting for a phone: 1.6 Mbit/s, 150 ms and a quarter of this processor.
"""

import io
import json
import os
import re
import shutil
import signal
import statistics
import subprocess
import sys
import tempfile
import time
import zipfile
from pathlib import Path

from playwright.sync_api import sync_playwright

HOME = Path(os.environ["SITAF_HOME"])
ROUNDS = 3
ATTEMPTS = 3
TARGETS = {"performance": 90, "accessibility": 100, "best-practices": 95}
FLAGS = "--headless --no-sandbox --disable-gpu --disable-background-networking --disable-component-update"
METRICS = {
    "first-contentful-paint": "first paint",
    "largest-contentful-paint": "largest paint",
    "total-blocking-time": "blocking",
    "cumulative-layout-shift": "shift",
}


def archive(folder):
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w") as file:
        for path in sorted(folder.rglob("*")):
            if path.is_file():
                file.write(path, path.relative_to(folder))
    return content.getvalue()


def failing_build(page, root):
    """The id of a finished build of the faulty sensor, requested in the session of a page."""
    token = next(c["value"] for c in page.context.cookies() if c["name"] == "XSRF-TOKEN")

    def call(method, path, data=None, kind="application/json"):
        headers = {"Content-Type": kind, "X-XSRF-TOKEN": token}
        answer = page.request.fetch(root + path, method=method, data=data, headers=headers, timeout=600_000)
        assert answer.ok, f"{method} {path}: {answer.status} {answer.text()}"
        return answer.json()

    example = archive(HOME / "examples" / "ir-sensor-faulty")
    activity = call("POST", "/api/v1/activities", example, "application/zip")["id"]
    suite = call("POST", f"/api/v1/activities/{activity}/models/GetInfraredData/suites", "{}")["id"]
    build = call("POST", "/api/v1/builds", json.dumps({"suiteId": suite}))["id"]
    while (state := call("GET", f"/api/v1/builds/{build}")["state"]) not in ("DONE", "FAILED", "CANCELLED"):
        time.sleep(0.5)
    assert state == "DONE", state
    return build


def session(link):
    """The root of the portal, the cookies of a session, and the id of a build."""
    with sync_playwright() as driver:
        chromium = driver.chromium.launch(executable_path=shutil.which("chromium"), args=["--no-sandbox"])
        page = chromium.new_page()
        page.goto(link)
        page.get_by_role("heading", name="Interface tests").wait_for()
        root = re.match(r"https?://[^/]+", link).group(0)
        build = failing_build(page, root)
        cookies = "; ".join(f"{c['name']}={c['value']}" for c in page.context.cookies())
        chromium.close()
    return root, cookies, build


def report(lighthouse, address, cookies, mobile, folder):
    headers, out = folder / "headers.json", folder / "report.json"
    headers.write_text(json.dumps({"Cookie": cookies}))
    command = [lighthouse, address, "--quiet", "--output=json", f"--output-path={out}"]
    command += [f"--extra-headers={headers}", f"--chrome-flags={FLAGS}", f"--only-categories={','.join(TARGETS)}"]
    command += [] if mobile else ["--preset=desktop"]
    environment = os.environ | {"CHROME_PATH": shutil.which("chromium")}
    # Now and then it finds no beginning of the page in the trace, and asks to be run again.
    for _ in range(ATTEMPTS - 1):
        if subprocess.run(command, env=environment, stderr=subprocess.DEVNULL, timeout=180).returncode == 0:
            break
    else:
        subprocess.run(command, env=environment, check=True, timeout=180)
    found = json.loads(out.read_text())
    # A page that sent to the sign-in would measure that one.
    assert found["finalDisplayedUrl"].rstrip("/") == address.rstrip("/"), found["finalDisplayedUrl"]
    return found


def measure(lighthouse, link, mobile, folder):
    """Prints the scores of each page and returns the names of those that are too low."""
    root, cookies, build = session(link)
    pages = {"home": "/", "result": f"/builds/{build}", "case": f"/builds/{build}/cases/2"}
    short = []
    for name, path in pages.items():
        reports = [report(lighthouse, root + path, cookies, mobile, folder) for _ in range(ROUNDS)]
        for category, target in TARGETS.items():
            scores = [round(100 * r["categories"][category]["score"]) for r in reports]
            value = statistics.median(scores)
            held = value >= target
            text = f"{name + ', ' + category:28} {value:4.0f}  of {scores}  target at least {target}"
            print(f"{text}  {'held' if held else 'SHORT'}")
            if not held:
                short.append(f"{name}, {category}")
        middle = sorted(reports, key=lambda r: r["categories"]["performance"]["score"])[ROUNDS // 2]["audits"]
        print("  " + ", ".join(f"{text} {middle[audit]['displayValue']}" for audit, text in METRICS.items()))
    return short


def main():
    lighthouse, *options = sys.argv[1:]
    if set(options) - {"--mobile"}:
        print(f"unknown option: {' '.join(options)}; there is --mobile", file=sys.stderr)
        return 2
    with tempfile.TemporaryDirectory() as folder:
        system = subprocess.Popen(
            [HOME / "sitaf", "up", "--port", "0", "--grpc-port", "0", "--data", Path(folder) / "data"],
            stdout=subprocess.PIPE,
            stdin=subprocess.PIPE,
            text=True,
        )
        try:
            link = next(m.group(1) for line in system.stdout if (m := re.search(r"valid once: (http\S+)", line)))
            short = measure(lighthouse, link, "--mobile" in options, Path(folder))
        finally:
            system.send_signal(signal.SIGINT)
            system.wait(timeout=60)
    print(f"load of the machine: {os.getloadavg()[0]:.1f} on {os.cpu_count()} processors")
    print("lighthouse: held" if not short else f"lighthouse: short: {'; '.join(short)}")
    return 1 if short else 0


if __name__ == "__main__":
    sys.exit(main())
