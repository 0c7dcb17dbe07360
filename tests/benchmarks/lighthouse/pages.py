"""Measures the portal with Lighthouse, in Debian's Chromium on loopback, with a failing result of the paper's sensor.

Each page is measured three times; the median counts. The default is Lighthouse's desktop setting: 10 Mbit/s, 40 ms and
this processor. `--mobile` is its setting for a phone: 1.6 Mbit/s, 150 ms and a quarter of this processor.
"""

import json
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

from portal_session import example, signed_in

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


def measure(lighthouse, session, mobile, folder):
    """Prints the scores of each page and returns the names of those that are too low."""
    build = session.build(example("ir-sensor-faulty"), "GetInfraredData").build
    cookies = "; ".join(f"{c['name']}={c['value']}" for c in session.page.context.cookies())
    # The page listens to the server.
    session.page.goto("about:blank")
    pages = {"home": "/", "result": f"/builds/{build}", "case": f"/builds/{build}/cases/2"}
    short = []
    for name, path in pages.items():
        reports = [report(lighthouse, session.root + path, cookies, mobile, folder) for _ in range(ROUNDS)]
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
        with signed_in(Path(folder) / "data") as session:
            short = measure(lighthouse, session, "--mobile" in options, Path(folder))
    print(f"load of the machine: {os.getloadavg()[0]:.1f} on {os.cpu_count()} processors")
    print("lighthouse: held" if not short else f"lighthouse: short: {'; '.join(short)}")
    return 1 if short else 0


if __name__ == "__main__":
    sys.exit(main())
