"""Measures the portal with 1,000 activities, 100,000 builds, 500 agents, and a result of 100,000 cases with causes.

On loopback, in Debian's Chromium. The large result is one that the system makes; the many others are copies of a build
in the database of the stopped server. If the causes are not found in time, the pages are measured without
them. Each page is opened three times, and the shortest time counts.
"""

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from playwright.sync_api import TimeoutError as PlaywrightTimeout
from portal_session import HOME, example, signed_in

SMALL = 2048
VALUES = 317  # its square is the first one above 100,000
ACTIVITIES, BUILDS, AGENTS = 1_000, 100_000, 500
PAGE_S = 1.5
CAUSES_S = 600
PATIENCE_MS = 15_000

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
    # About 1 % of the cases fail.
    "component/demo/Adder.java": """package demo;
public class Adder {
  public int Add(int a, int b) { return a > 900_000 && b > 900_000 ? 0 : a + b; }
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


def prepare(session):
    """The large result, the small one that is copied, and after how many seconds the causes were found, or None."""
    large = session.build(FILES, "Add")
    small = session.build(example("ir-sensor-faulty"), "GetInfraredData")
    explanation = f"/api/v1/builds/{large.build}/explanation"
    requested = session.post(explanation)["id"]
    began = time.perf_counter()
    if session.wait(explanation, CAUSES_S):
        return large, small, time.perf_counter() - began
    session.post(f"/api/v1/builds/{requested}/cancel", "")
    return large, small, None


def multiply(data, build):
    h2 = next((HOME / ".sitaf" / "dist" / "server" / "lib").glob("h2-*.jar"))
    counts = [str(ACTIVITIES - 2), str(BUILDS - 2), str(AGENTS - 1)]
    database = data / "server" / "database"
    subprocess.run(["java", "-cp", h2, Path(__file__).parent / "Many.java", database, build, *counts], check=True)


def seconds_until(page, address, selector):
    """The shortest of three times from navigation to what the page is about, scripts in the cache; or infinite."""
    times = []
    for _ in range(3):
        began = time.perf_counter()
        page.goto(address)
        try:
            page.locator(selector).first.wait_for(timeout=PATIENCE_MS)
        except PlaywrightTimeout:
            return float("inf")
        times.append(time.perf_counter() - began)
    return min(times)


def first_load(session):
    """Kilobytes of script of the home page, and how many larger scripts came uncompressed."""
    loaded = []

    def note(request):
        loaded.append(request)

    # A context of its own has an empty cache.
    context = session.page.context.browser.new_context(storage_state=session.page.context.storage_state())
    first = context.new_page()
    first.on("requestfinished", note)
    first.goto(session.root)
    first.get_by_role("heading", name="Interface tests").wait_for()
    first.wait_for_load_state("networkidle")
    scripts = [request for request in loaded if request.url.endswith(".js")]
    # The server does not compress very small responses.
    plain = sum(
        "content-encoding" not in request.response().all_headers()
        for request in scripts
        if request.sizes()["responseBodySize"] > SMALL
    )
    kilobytes = sum(request.sizes()["responseBodySize"] for request in scripts) / 1000
    context.close()
    return kilobytes, plain


def pages(large, small):
    """What is opened, and what shows that it is there."""
    return {
        "home": ("/", 'section:has(h2:text("Recent builds")) tbody tr'),
        "activities": ("/activities", "main tbody tr"),
        "activities, searched": ("/activities?search=0777", 'main a:has-text("0777")'),
        "builds": ("/builds", "main tbody tr"),
        "builds, page 1,000": ("/builds?page=1000", "main tbody tr"),
        "builds, searched": ("/builds?search=0777", 'main a:has-text("0777")'),
        "agents": ("/agents", "main tbody tr"),
        "schedules": ("/schedules", 'main h1:text("Schedules")'),
        "activity": (f"/activities/{small.activity}", "main tbody tr, main .cm-content, main nav"),
        "history of an activity": ("/builds/copy-build-1?tab=history", "main tbody tr"),
        "result of a copy": ("/builds/copy-build-1", 'button[aria-label="Case 1"]'),
        "test cases of 100,000": (f"/suites/{large.suite}", 'input[aria-label="Expected return of case 1"]'),
        "result of 100,000": (f"/builds/{large.build}", 'button[aria-label="Case 1"]'),
        "causes of 100,000": (f"/builds/{large.build}", '[aria-label="Cause 1"]'),
        "graphs of 100,000": (f"/builds/{large.build}?tab=graphs", "main canvas"),
        "case of 100,000": (f"/builds/{large.build}/cases/77777", 'table[aria-label^="Values of case"]'),
    }


def measure(session, large, small, causes_s):
    page, root = session.page, session.root
    kilobytes, plain = first_load(session)
    total = session.get("/api/v1/builds?size=1")["total"]
    rows = [
        ("builds", total, BUILDS, "at least", ""),
        ("script of the first page, compressed", kilobytes, 400, "below", "kB"),
        ("larger scripts that came uncompressed", plain, 1, "below", ""),
    ]
    rows.append(("causes of 100,000 found", causes_s or float("inf"), CAUSES_S, "below", "s"))
    for name, (path, selector) in pages(large, small).items():
        if name.startswith("causes") and causes_s is None:
            continue
        rows.append((name, seconds_until(page, root + path, selector), PAGE_S, "below", "s"))
    page.goto(f"{root}/suites/{large.suite}")
    page.locator('input[aria-label="Expected return of case 1"]').first.wait_for()
    rows.append(("test cases scroll, 95 % of frames", page.evaluate(SCROLL, "Test cases"), 50, "below", "ms"))
    page.goto(f"{root}/builds/{large.build}")
    page.locator('button[aria-label="Case 1"]').first.wait_for()
    rows.append(("result scrolls, 95 % of frames", page.evaluate(SCROLL, "Cases"), 50, "below", "ms"))
    return rows


def main():
    with tempfile.TemporaryDirectory() as folder:
        data = Path(folder) / "data"
        with signed_in(data) as session:
            large, small, causes_s = prepare(session)
        multiply(data, small.build)
        with signed_in(data) as session:
            rows = measure(session, large, small, causes_s)
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
