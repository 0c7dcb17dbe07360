"""Measures the comparison of two results of 10,000 cases, in the server and in Debian's Chromium.

The alternative in the same run: both result documents downloaded and compared by GNU diff, which finds lines but no
groups, knows no last bits and does not match cases.
"""

import os
import re
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from portal_session import signed_in

VALUES = 100
CASES = VALUES * VALUES
ROUNDS = 5
PATIENCE_MS = 120_000

COMPONENT = """package demo;
public class Scale {
  public double Weigh(double a, double b) {
    %s
    return a * 0.1 + b;
  }
}
"""
# 100 other values, 100 exceptions and 9,800 equal values.
CHANGE = 'if (a == 7) return a * 0.1 + b + 0.5; if (b == 3 && a != 7) throw new IllegalStateException("too light");'


def files(change):
    number = '<test_element abstract_type="NUMERIC" real_type="double"><name>{0}</name><type>TDI</type>'
    values = "".join(f"<value>{value}</value>" for value in range(VALUES))
    inputs = "".join(
        f"{number.format(name)}<user_value_list>{values}</user_value_list></test_element>" for name in ("a", "b")
    )
    return {
        "activity.yaml": """name: scale
component: {language: java, sources: component/, class: demo.Scale}
provided: [ScaleService.xml]
models: [Weigh.xml]
""",
        "ScaleService.xml": """<service_port_type_profile><service_port_type><type_name>ScaleService</type_name>
<method name="Weigh" return_type="double" call_type="blocking">
<param index="1"><type>double</type><name>a</name></param><param index="2"><type>double</type><name>b</name></param>
</method></service_port_type></service_port_type_profile>
""",
        "component/demo/Scale.java": COMPONENT % change,
        "Weigh.xml": f"""<test_model><name>Weigh</name><target interface="ScaleService" method="Weigh"/>
<input_spec_list>{inputs}</input_spec_list>
<order_of_combinations>all</order_of_combinations></test_model>
""",
    }


def timed(work, *given):
    began = time.perf_counter()
    result = work(*given)
    return time.perf_counter() - began, result


def both_documents(session, folder, base, now):
    for name in (base, now):
        (folder / f"{name}.xml").write_bytes(session.bytes(f"/api/v1/builds/{name}/result/document"))
    return subprocess.run(["diff", f"{base}.xml", f"{now}.xml"], cwd=folder, capture_output=True, check=False)


def cases_of_the_first_group(page, address):
    page.goto(address)
    page.get_by_role("table", name="Groups of differences").wait_for(timeout=PATIENCE_MS)
    page.get_by_role("button", name=re.compile("^Show cases")).first.click()
    page.get_by_role("table", name="Cases of the group").wait_for(timeout=PATIENCE_MS)


def measure(session, folder):
    """Each round compares another pair, so that no comparison is in the server's cache."""
    base = session.build(files(""), "Weigh").build
    pairs = [session.build(files(f"{CHANGE} // {i}"), "Weigh").build for i in range(ROUNDS)]
    server, pages, diffs = [], [], []
    for now in pairs:
        path = f"/api/v1/builds/{now}/result/comparison/values?with={base}"
        seconds, values = timed(session.get, path)
        server.append(seconds)
        assert values["cases"] == CASES, values
        assert sorted(group["size"] for group in values["groups"]) == [99, 100], values["groups"]
        diffs.append(timed(both_documents, session, folder, base, now)[0])
    for now in pairs[1:]:
        # The other direction is not in the cache.
        pages.append(
            timed(cases_of_the_first_group, session.page, f"{session.root}/builds/{base}/compare?with={now}")[0]
        )
    return server[0], statistics.median(server[1:]), max(server[1:]), statistics.median(pages), statistics.median(diffs)


def main():
    with tempfile.TemporaryDirectory() as data:
        with signed_in(Path(data) / "system") as session:
            first, median, longest, usable, diff = measure(session, Path(data))
    rows = [
        ("comparison in the server, median of new pairs, s", median, 0.5),
        ("comparison in the server, longest, s", longest, None),
        ("first comparison after the start of the server, s", first, None),
        ("page opened until the cases of a group are shown, median, s", usable, 1.0),
        ("both documents downloaded and compared by GNU diff, median, s", diff, None),
        ("ratio: server to GNU diff", median / diff, None),
    ]
    short = []
    print(f"{CASES} cases each")
    for name, value, target in rows:
        held = target is None or value < target
        print(f"{name:62} {value:8.3f}" + (f"  target below {target}  {'held' if held else 'SHORT'}" if target else ""))
        if not held:
            short.append(name)
    print(f"load of the machine: {os.getloadavg()[0]:.1f} on {os.cpu_count()} processors")
    print("comparison: held" if not short else f"comparison: short: {', '.join(short)}")
    return 1 if short else 0


if __name__ == "__main__":
    sys.exit(main())
