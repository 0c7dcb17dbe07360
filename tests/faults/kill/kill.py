"""Kills server, agents, simulations and test applications at random while builds run, and checks that nothing is lost."""

import argparse
import hashlib
import random
import re
import sys
import tempfile
import threading
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent))
from system import OVER, Refused, Table, agent, await_true, kill_process, own_bridge, processes_of, server, show

LEASE_S = 15
OPEN_BUILDS = 3
TIMEOUT_S = 10
CASES = 55
ACCEPTED = re.compile(r"build ([0-9a-f-]{36}), attempt \d+: accepted, SHA-256 ([0-9a-f]{64})")


class Client:
    """Request builds and record the digest of each result when it first appears."""

    def __init__(self, api, suite):
        self.api, self.suite = api, suite
        self.requested, self.digests, self.changed = set(), {}, []
        self.going_on = True
        self.thread = threading.Thread(target=self.work, daemon=True)

    def work(self):
        while self.going_on:
            try:
                self.look()
            except (OSError, Refused, ValueError):
                pass  # The server is down at the moment.
            time.sleep(0.5)

    def look(self):
        builds = self.api.builds()
        for build in builds:
            if build["state"] == "DONE" and build["id"] not in self.digests:
                self.note(build["id"])
        if self.going_on and sum(b["state"] not in OVER for b in builds) < OPEN_BUILDS:
            self.requested.add(self.api.build(self.suite))

    def note(self, build):
        digest = hashlib.sha256(self.api.get(f"/api/v1/builds/{build}/result/document")).hexdigest()
        if self.digests.setdefault(build, digest) != digest:
            self.changed.append(build)


def kill_one(rng, main, agents):
    """Kill one process, restart it unless its parent does, and return its kind and time of death."""
    kind = rng.choice(["server", "agent", "simulation", "harness"])
    if kind in ("simulation", "harness"):
        word = "sitaf_bridge" if kind == "simulation" else "execution"
        # There is none while agents start or compile.
        await_true(lambda: victims(agents, word), TIMEOUT_S, 0.05)
        found = victims(agents, word)
        return (kind, time.monotonic()) if found and kill_process(rng.choice(found)) else (None, 0)
    part = main if kind == "server" else rng.choice(agents)
    part.kill()
    died = time.monotonic()
    time.sleep(rng.uniform(0, 1))
    part.start(wait=kind == "server")
    return kind, died


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kills", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--pause-ms", type=int, default=30, help="pause of the component in each of the 55 cases")
    parser.add_argument(
        "--within-s", type=int, default=2 * LEASE_S, help="time until every build has ended after the last kill"
    )
    given = parser.parse_args()
    rng, table = random.Random(given.seed), Table("kill")
    counts = {}
    with tempfile.TemporaryDirectory(prefix="sitaf-kill-") as folder:
        folder = Path(folder)
        central = server(folder, f"--sitaf.lease={LEASE_S}s", "--sitaf.retry-delay=200ms").start()
        agents = [agent(folder, f"agent-{i}", central.grpc, *own_bridge()) for i in (1, 2)]
        try:
            for part in agents:
                part.start()
            client = Client(central.api, central.api.suite(given.pause_ms))
            client.thread.start()
            began = last = time.monotonic()
            while sum(counts.values()) < given.kills:
                time.sleep(rng.uniform(0.2, 1.5))
                kind, died = kill_one(rng, central, agents)
                if kind:
                    counts[kind] = counts.get(kind, 0) + 1
                    last = died
            requested_to_the_end = client.thread.is_alive()
            client.going_on = False
            client.thread.join(40)
            ended = await_true(lambda: over(central.api), last + given.within_s - time.monotonic())
            took = time.monotonic() - last
            table.row("builds requested until the end", "yes" if requested_to_the_end else "no", "yes", requested_to_the_end)
            report(table, client, agents, counts, last - began)
            table.row("time from the last kill to the last result, s", took, f"<= {given.within_s}", ended)
        finally:
            for part in [*agents, central]:
                part.stop()
            if table.short:
                show(central, *agents)
    return table.end()


def victims(agents, word):
    return [pid for a in agents for pid in processes_of(a.directory, word)]


def over(api):
    try:
        return all(build["state"] in OVER for build in api.builds())
    except OSError:
        return False


def report(table, client, agents, counts, struck_s):
    builds = {b["id"]: b for b in client.api.builds()}
    acknowledged = {}
    for build, digest in (found for a in agents for found in ACCEPTED.findall(a.log.read_text(errors="replace"))):
        acknowledged.setdefault(build, set()).add(digest)
    lost_results, twice = [], []
    for build in builds.values():
        history = client.api.get(f"/api/v1/builds/{build['id']}/history")
        dones = sum(t["state"] == "DONE" for t in history)
        if build["state"] == "DONE":
            client.note(build["id"])
            cases = client.api.get(f"/api/v1/builds/{build['id']}/result/cases?size=500")
            numbers = [c["no"] for c in cases["items"]]
            accepted = [a for a in client.api.get(f"/api/v1/builds/{build['id']}/attempts") if a["state"] == "DONE"]
            if dones != 1 or len(accepted) != 1 or len(set(numbers)) != len(numbers):
                twice.append(build["id"])
            kept = client.digests[build["id"]]
            if cases["total"] != CASES or acknowledged.get(build["id"], {kept}) != {kept}:
                lost_results.append(build["id"])
        elif build["id"] in acknowledged or build["id"] in client.digests:
            lost_results.append(build["id"])
    done = sum(b["state"] == "DONE" for b in builds.values())
    attempts = sum(b["attempt"] for b in builds.values())
    table.row("kills", sum(counts.values()), " ".join(f"{k} {n}" for k, n in sorted(counts.items())), True)
    table.row("duration of the kills, s", struck_s, "", True)
    table.row("acknowledged builds", len(client.requested), "", len(client.requested) > 0)
    table.row("lost builds", len(client.requested - builds.keys()), "0", client.requested <= builds.keys())
    table.row("builds with a result", done, "> 0", done > 0)
    table.row("attempts", attempts, "", True)
    table.row("results acknowledged to agents", len(acknowledged), "", True)
    table.row("lost acknowledged results", len(lost_results), "0", not lost_results)
    table.row("results accepted twice", len(twice), "0", not twice)
    table.row("results that changed later", len(client.changed), "0", not client.changed)
    stuck = [b["id"] for b in builds.values() if b["state"] not in OVER]
    table.row("unfinished builds", len(stuck), "0", not stuck)


if __name__ == "__main__":
    sys.exit(main())
