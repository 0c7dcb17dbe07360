"""Measures the time from "run now" to the first case, without compilation, as reported by the server."""

import argparse
import statistics
import subprocess
import sys
import tempfile
import time
from datetime import datetime
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent.parent / "faults"))
from system import Table, agent, await_true, own_bridge, server

PAUSE_MS = 20
TARGET_S = 1.0


def compiled_s(api, build):
    """Duration of the compilation according to the history; 0 without one."""
    times = {}
    for change in api.get(f"/api/v1/builds/{build}/history"):
        times.setdefault(change["state"], datetime.fromisoformat(change["time"]))
    if "COMPILING" not in times or "RUNNING" not in times:
        return 0.0
    return (times["RUNNING"] - times["COMPILING"]).total_seconds()


def first_case_s(api, suite):
    """Seconds from the request to the first case, and the share of the compilation."""
    began = time.monotonic()
    build = api.build(suite)
    if not await_true(lambda: api.get(f"/api/v1/builds/{build}")["casesDone"] > 0, 60, 0.005):
        raise RuntimeError(f"no case of build {build} ended: {api.get(f'/api/v1/builds/{build}')}")
    waited = time.monotonic() - began
    await_true(lambda: api.get(f"/api/v1/builds/{build}")["state"] in {"DONE", "FAILED"}, 60, 0.1)
    return waited, compiled_s(api, build)


def empty_jvm_s():
    began = time.monotonic()
    subprocess.run(["java", "-Xshare:auto", "-version"], check=True, capture_output=True)
    return time.monotonic() - began


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=7)
    given = parser.parse_args()
    table = Table("run-now")
    with tempfile.TemporaryDirectory(prefix="sitaf-run-now-") as folder:
        folder = Path(folder)
        central = server(folder).start()
        worker = agent(folder, "warm", central.grpc, *own_bridge())
        try:
            worker.start()
            api = central.api
            same = api.suite(PAUSE_MS)
            first_case_s(api, same)
            unchanged = [first_case_s(api, same)[0] for _ in range(given.rounds)]
            # A different pause makes each component different, so that it is compiled.
            changed = [first_case_s(api, api.suite(PAUSE_MS + 1 + i)) for i in range(given.rounds)]
            beyond = [waited - compiled for waited, compiled in changed]
            jvm = statistics.median(empty_jvm_s() for _ in range(given.rounds))
            for what, seconds in (("unchanged component", unchanged), ("changed component, less compilation", beyond)):
                median = statistics.median(seconds)
                table.row(f"{what}: time to first case, median, s", median, f"< {TARGET_S:g}", median < TARGET_S)
                table.row(f"{what}: time to first case, maximum, s", max(seconds), "", True)
                table.row(f"{what}: relative to the start of an empty JVM", median / jvm, "", True)
            table.row("compilation, s", statistics.median(compiled for _, compiled in changed), "", True)
        finally:
            worker.stop()
            central.stop()
    return table.end()


if __name__ == "__main__":
    sys.exit(main())
