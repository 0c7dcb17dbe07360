"""Pauses an agent for twice its lease and resumes it: its late result changes nothing."""

import argparse
import hashlib
import signal
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent))
from system import Bridge, Table, agent, await_true, server, show

CASES = 55
NEARLY_DONE = 50
TIMEOUT_S = 240


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--lease-s", type=int, default=15)
    given = parser.parse_args()
    table = Table("lease")
    with tempfile.TemporaryDirectory(prefix="sitaf-lease-") as folder, Bridge() as bridge:
        folder = Path(folder)
        central = server(folder, f"--sitaf.lease={given.lease_s}s").start()
        api = central.api
        options = ("--bridge", bridge.target)
        first = agent(folder, "first", central.grpc, *options)
        second = agent(folder, "second", central.grpc, *options)
        try:
            suite = api.suite(100)
            first.start()
            build = api.build(suite)

            def now():
                return api.get(f"/api/v1/builds/{build}")

            near = await_true(lambda: now()["casesDone"] >= NEARLY_DONE, TIMEOUT_S, 0.05)
            table.row("finished cases when the first agent is paused", now()["casesDone"], f">= {NEARLY_DONE}", near)
            # Only the agent is paused; its test application continues and finishes.
            first.signal(signal.SIGSTOP)
            stopped = time.monotonic()
            second.start()
            given_on = await_true(lambda: now().get("agent") == "second", 2 * given.lease_s)
            table.row("time until the build is reassigned, s", time.monotonic() - stopped,
                      f"<= {2 * given.lease_s}", given_on)
            # A generous timeout, because durations are not tested here.
            done = await_true(lambda: now()["state"] == "DONE", TIMEOUT_S)
            table.row("state after the result of the second agent", now()["state"], "DONE", done)
            result = api.get(f"/api/v1/builds/{build}/result/document")
            history = api.get(f"/api/v1/builds/{build}/history")
            time.sleep(max(0, stopped + 2 * given.lease_s - time.monotonic()))
            first.signal(signal.SIGCONT)

            def attempts():
                return {a["no"]: a["state"] for a in api.get(f"/api/v1/builds/{build}/attempts")}

            superseded = await_true(lambda: attempts()[1] == "SUPERSEDED", TIMEOUT_S)
            table.row("state of the first agent's late result", attempts()[1], "SUPERSEDED", superseded)
            after = api.get(f"/api/v1/builds/{build}/result/document")
            table.row("digest of the result, unchanged", hashlib.sha256(after).hexdigest()[:12],
                      hashlib.sha256(result).hexdigest()[:12], after == result)
            table.row("changes of the build after its end",
                      len(api.get(f"/api/v1/builds/{build}/history")) - len(history), "0",
                      api.get(f"/api/v1/builds/{build}/history") == history)
            second.stop()
            again = api.build(suite)
            works = await_true(lambda: api.state(again) == "DONE", TIMEOUT_S)
            worker = api.get(f"/api/v1/builds/{again}").get("agent", "none")
            table.row("agent of the next build, without the other one", worker, "first", works and worker == "first")
        finally:
            first.signal(signal.SIGCONT)
            for part in (first, second, central):
                part.stop()
            if table.short:
                show(first, second, central)
    return table.end()


if __name__ == "__main__":
    sys.exit(main())
