"""Measures the portal with a suite and a result of 100,000 cases on loopback in Debian's Chromium."""

import io
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import zipfile
from pathlib import Path

from playwright.sync_api import sync_playwright

HOME = Path(os.environ["SITAF_HOME"])
SMALL = 2048
VALUES = 317  # its square is the first one above 100,000

FILES = {
    "activity.yaml": """name: adder
component: {language: java, sources: component/, class: demo.Adder}
provided: [AdderService.xml]
models: [Add.xml]
""",
    "AdderService.xml": """<service_port_type_profile><service_port_type><type_name>AdderService</type_name>
<method name="Add" return_type="int" call_type="blocking">
<param index="1"><type>int</type><name>a</name></param><param index="2"><type>int</type><name>b</name></param>
</method></service_port_type></service_port_type_profile>
""",
    "component/demo/Adder.java": """package demo;
public class Adder {
  public int Add(int a, int b) { return a + b; }
}
""",
    "Add.xml": f"""<test_model><name>Add</name><target interface="AdderService" method="Add"/><input_spec_list>
<test_element abstract_type="NUMERIC" real_type="int"><name>a</name><type>TDI</type>
<test_spec type="RANDOM" count="{VALUES}" min="0" max="1000000"/></test_element>
<test_element abstract_type="NUMERIC" real_type="int"><name>b</name><type>TDI</type>
<test_spec type="RANDOM" count="{VALUES}" min="0" max="1000000"/></test_element>
</input_spec_list><output_spec_list><test_element abstract_type="NUMERIC" real_type="int"><name>return</name>
<type>RETURN</type><expected>a + b</expected></test_element></output_spec_list>
<order_of_combinations>all</order_of_combinations></test_model>
""",
}

SCROLL = """async (label) => {
  const place = document.querySelector(`div[aria-label="${label}"]`);
  const gaps = [];
  let last = performance.now();
  for (let frame = 0; frame < 120; frame++) {
    place.scrollTop += 900;
    await new Promise(requestAnimationFrame);
    const now = performance.now();
    gaps.push(now - last);
    last = now;
  }
  gaps.sort((a, b) => a - b);
  return gaps[Math.floor(gaps.length * 0.95)];
}"""


def archive():
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w") as file:
        for path, text in FILES.items():
            file.writestr(path, text)
    return content.getvalue()


def call(page, method, path, data=None, kind="application/json"):
    """A request of the portal's own session."""
    token = next((c["value"] for c in page.context.cookies() if c["name"] == "XSRF-TOKEN"), "")
    answer = page.request.fetch(
        path, method=method, data=data, headers={"Content-Type": kind, "X-XSRF-TOKEN": token}, timeout=600_000
    )
    assert answer.ok, f"{method} {path}: {answer.status} {answer.text()}"
    return answer.json()


def seconds_until(page, address, selector):
    """Time from navigation to the first row, with an empty browser cache."""
    began = time.perf_counter()
    page.goto(address)
    page.locator(selector).first.wait_for(timeout=120_000)
    return time.perf_counter() - began


def measure(page, link):
    root = re.match(r"https?://[^/]+", link).group(0)
    loaded = []

    def note(request):
        loaded.append(request)

    page.on("requestfinished", note)
    page.goto(link)
    page.get_by_role("heading", name="Interface tests").wait_for()
    page.wait_for_load_state("networkidle")
    scripts = [request for request in loaded if request.url.endswith(".js")]
    page.remove_listener("requestfinished", note)
    first_page_kb = sum(request.sizes()["responseBodySize"] for request in scripts) / 1000
    # The server does not compress very small responses.
    plain = sum(
        "content-encoding" not in request.response().all_headers()
        for request in scripts
        if request.sizes()["responseBodySize"] > SMALL
    )
    activity = call(page, "POST", f"{root}/api/v1/activities", archive(), "application/zip")["id"]
    suite = call(page, "POST", f"{root}/api/v1/activities/{activity}/models/Add/suites", "{}")
    build = call(page, "POST", f"{root}/api/v1/builds", f'{{"suiteId":"{suite["id"]}"}}')["id"]
    while (state := call(page, "GET", f"{root}/api/v1/builds/{build}"))["state"] not in ("DONE", "FAILED", "CANCELLED"):
        time.sleep(1)
    assert state["state"] == "DONE", state
    grid = min(
        seconds_until(page, f"{root}/suites/{suite['id']}", 'input[aria-label="Expected return of case 1"]')
        for _ in range(3)
    )
    grid_frame = page.evaluate(SCROLL, "Test cases")
    result = min(seconds_until(page, f"{root}/builds/{build}", 'button[aria-label="Case 1"]') for _ in range(3))
    result_frame = page.evaluate(SCROLL, "Cases")
    return [
        ("cases", suite["total"], 100_000, "at least", ""),
        ("script of the first page, compressed", first_page_kb, 400, "below", "kB"),
        ("larger scripts that came uncompressed", plain, 1, "below", ""),
        ("grid of test cases opens", grid, 1.0, "below", "s"),
        ("grid scrolls, 95 % of frames", grid_frame, 50, "below", "ms"),
        ("results page opens", result, 1.5, "below", "s"),
        ("results scroll, 95 % of frames", result_frame, 50, "below", "ms"),
    ]


def main():
    with tempfile.TemporaryDirectory() as data:
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
                rows = measure(chromium.new_page(viewport={"width": 1280, "height": 900}), link)
                chromium.close()
        finally:
            system.send_signal(signal.SIGINT)
            system.wait(timeout=60)
    short = []
    for name, value, target, sense, unit in rows:
        held = value >= target if sense == "at least" else value < target
        print(f"{name:40} {value:12.2f} {unit:3} target {sense} {target} {unit}  {'held' if held else 'SHORT'}")
        if not held:
            short.append(name)
    print(f"load of the machine: {os.getloadavg()[0]:.1f} on {os.cpu_count()} processors")
    print("portal: held" if not short else f"portal: short: {', '.join(short)}")
    return 1 if short else 0


if __name__ == "__main__":
    sys.exit(main())
