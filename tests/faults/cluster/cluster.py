"""Kills one of two servers with a shared database at random: every fire time requests exactly one build."""

import argparse
import datetime
import random
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent))
from system import Postgres, Refused, Table, agent, await_true, own_bridge, server, show

SCHEDULES = 5
EVERY_S = 5
TIMEOUT_S = 240


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kills", type=int, default=10)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    rng, table = random.Random(given.seed), Table("cluster")
    with tempfile.TemporaryDirectory(prefix="sitaf-cluster-") as folder, Postgres() as database:
        folder = Path(folder)
        servers = [server(folder, name=f"server-{i}", database=database.url) for i in (1, 2)]
        target = ",".join(f"127.0.0.1:{s.grpc}" for s in servers)
        worker = agent(folder, "worker", target, *own_bridge())
        try:
            for part in servers:
                part.start()
            api = servers[0].api
            suite = api.suite()
            # No agent has the label, so the builds stay queued; the test counts the requests.
            request = {"suiteId": suite, "cron": f"*/{EVERY_S} * * * * ?", "misfire": "ALL", "labels": ["nowhere"]}
            schedules = [api.post("/api/v1/schedules", request)["id"] for _ in range(SCHEDULES)]
            began = datetime.datetime.now(datetime.UTC)
            for kill in range(given.kills):
                time.sleep(rng.uniform(2, 6))
                victim = servers[kill % 2] if rng.random() < 0.8 else rng.choice(servers)
                victim.kill()
                time.sleep(rng.uniform(1, 4))
                victim.start()
            # The other server may catch up on the last fire times.
            time.sleep(3 * EVERY_S)
            for schedule in schedules:
                await_true(lambda s=schedule: pause(api, s), 30)
            ended = datetime.datetime.now(datetime.UTC) - datetime.timedelta(seconds=2 * EVERY_S)
            expected, missing, twice = 0, [], []
            for schedule in schedules:
                fires = history(api, schedule)
                times = [datetime.datetime.fromisoformat(f["fireTime"]) for f in fires]
                wanted = every(began, ended)
                expected += len(wanted)
                missing += [t for t in wanted if t not in times]
                builds = api.get(f"/api/v1/builds?scheduleId={schedule}&size=500")["total"]
                if len(set(times)) != len(times) or builds != len(times):
                    twice.append(schedule)
            table.row("servers killed", given.kills, "", True)
            table.row("fire times during the kills", expected, "> 0", expected > 0)
            table.row("fire times without a build", len(missing), "0", not missing)
            table.row("schedules with two builds for one fire time", len(twice), "0", not twice)
            table.row("builds with one server down", *works(servers, worker, suite))
        finally:
            for part in (worker, *servers):
                part.stop()
            if table.short:
                show(worker, *servers)
    return table.end()


def pause(api, schedule):
    try:
        return api.post(f"/api/v1/schedules/{schedule}/pause", {})["paused"]
    except (OSError, Refused):
        return False


def history(api, schedule):
    return api.get(f"/api/v1/schedules/{schedule}/history?size=500")["items"]


def every(began, ended):
    first = began.replace(second=0, microsecond=0)
    times = []
    for step in range(int((ended - first).total_seconds() // EVERY_S) + 1):
        time_ = first + datetime.timedelta(seconds=step * EVERY_S)
        if began + datetime.timedelta(seconds=1) < time_ <= ended:
            times.append(time_)
    return times


def works(servers, worker, suite):
    """Kill each server in turn, also the one that the agent is connected to; the other one assigns a build."""
    worker.start()
    done = 0
    for victim, other in (servers, servers[::-1]):
        victim.kill()
        build = other.api.build(suite)
        done += await_true(lambda api=other.api, b=build: api.state(b) == "DONE", TIMEOUT_S)
        victim.start()
    return done, "2", done == 2


if __name__ == "__main__":
    sys.exit(main())
