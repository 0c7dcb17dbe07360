"""Stops the server while agents finish builds, and compares the received results with those of the agents."""

import argparse
import hashlib
import re
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent))
from system import OVER, Bridge, Table, agent, await_true, server, show, together

DIGEST = re.compile(rb"[0-9a-f]{64}$")
UNDER_WAY = {"COMPILING", "RUNNING", "UPLOADING"}


def spooled(agents):
    """Digests of the results in the agents' spools, as computed by the agents."""
    found = []
    for part in agents:
        for message in (part.directory / "spool").glob("*/message"):
            digest = DIGEST.search(message.read_bytes())
            if digest:
                found.append(digest.group().decode())
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--away-s", type=int, default=600)
    parser.add_argument("--agents", type=int, default=20)
    parser.add_argument("--pause-ms", type=int, default=600, help="pause of the component in each of the 55 cases")
    given = parser.parse_args()
    table = Table("outage")
    with tempfile.TemporaryDirectory(prefix="sitaf-outage-") as folder, Bridge() as bridge:
        folder = Path(folder)
        central = server(folder).start()
        api = central.api
        agents = [
            agent(folder, f"agent-{i:02}", central.grpc, "--bridge", bridge.target, heap="64m")
            for i in range(given.agents)
        ]
        try:
            suite = api.suite(given.pause_ms)
            for i in range(0, len(agents), 4):
                together(agents[i : i + 4], lambda part: part.start())
            ids = [api.build(suite) for _ in agents]

            all_begun = await_true(lambda: all(api.state(b) in UNDER_WAY | OVER for b in ids), 120)
            before = sum(api.state(b) == "DONE" for b in ids)
            central.kill()
            gone = time.monotonic()
            time.sleep(given.away_s)
            waiting = spooled(agents)
            central.start()
            away = time.monotonic() - gone
            arrived = await_true(lambda: all(api.state(b) in OVER for b in ids), 180)
            took = time.monotonic() - gone - away
            done = [b for b in ids if api.state(b) == "DONE"]
            at_server = {hashlib.sha256(api.get(f"/api/v1/builds/{b}/result/document")).hexdigest() for b in done}
            table.row("running builds when the server was killed", len(ids) - before, f"of {len(ids)}", all_begun)
            table.row("duration of the outage, s", away, f">= {given.away_s}", away >= given.away_s)
            table.row("results on the agents' disks during the outage", len(waiting), "> 0", len(waiting) > 0)
            table.row("results on the server afterwards", len(done), f"{len(ids)}", arrived and len(done) == len(ids))
            table.row("results received with equal digests", len(at_server & set(waiting)),
                      f"{len(waiting)}", set(waiting) <= at_server)
            table.row("maximum attempts of a build", max(api.get(f"/api/v1/builds/{b}")["attempt"] for b in ids),
                      "1", all(api.get(f"/api/v1/builds/{b}")["attempt"] == 1 for b in ids))
            table.row("time until all results were received, s", took, "", True)
            empty = await_true(lambda: not spooled(agents), 10)
            table.row("results left on the agents' disks", len(spooled(agents)), "0", empty)
        finally:
            together([*agents], lambda part: part.stop())
            central.stop()
            if table.short:
                show(central, *agents, lines=20)
    return table.end()


if __name__ == "__main__":
    sys.exit(main())
