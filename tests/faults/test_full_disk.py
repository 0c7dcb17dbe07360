"""A full disk of an agent stops new builds and loses no result. Uses a tmpfs, which only root can mount."""

import re
import time

import pytest
from system import agent, await_true, fill, own_bridge, server

NEEDED_MIB = 24
TIMEOUT_S = 180
FULL_S = 10

# Long leases: they are not tested here, and registration is slow on a busy machine.
SETTINGS = ("--sitaf.lease=60s", "--sitaf.retry-delay=1s")


def waiting_for(api, build):
    return api.get(f"/api/v1/builds/{build}").get("waitingFor", "")


@pytest.fixture
def central(installed, tmp_path):
    with server(tmp_path, *SETTINGS) as part:
        yield part


def test_an_agent_with_a_full_disk_accepts_no_builds_and_keeps_its_results(central, disk, tmp_path):
    api = central.api
    worker = agent(disk, "worker", central.grpc, "--min-free-mib", str(NEEDED_MIB), *own_bridge())
    worker.log = tmp_path / "worker.log"
    with worker:
        suite = api.suite(100)
        first = api.build(suite)
        assert await_true(lambda: api.state(first) == "RUNNING", TIMEOUT_S)
        central.kill()
        assert await_true(lambda: list((worker.directory / "spool").glob("*/message")), TIMEOUT_S)
        give_back = fill(disk)
        central.start()
        assert await_true(lambda: api.state(first) == "DONE", TIMEOUT_S)
        assert api.get(f"/api/v1/builds/{first}")["attempt"] == 1

        second = api.build(suite)
        assert await_true(lambda: re.search(r"its disk has only \d+ MiB left", waiting_for(api, second)), TIMEOUT_S)
        give_back()
        assert await_true(lambda: api.state(second) == "DONE", TIMEOUT_S)


def test_a_disk_that_fills_up_during_a_build_affects_no_verdict(central, disk, tmp_path):
    api = central.api
    worker = agent(disk, "worker", central.grpc, "--min-free-mib", str(NEEDED_MIB), *own_bridge())
    worker.log = tmp_path / "worker.log"
    with worker:
        # Long enough to fill the disk during the build, even on a busy machine.
        build = api.build(api.suite(400))
        assert await_true(lambda: api.get(f"/api/v1/builds/{build}")["casesDone"] >= 5, TIMEOUT_S, 0.05)
        give_back = fill(disk)
        # The component writes to a tmpfs here, so the cases continue and the result waits for free space. If the agent's own
        # files cannot be written, the attempt fails instead.
        time.sleep(FULL_S)
        give_back()
        assert await_true(lambda: api.state(build) == "DONE", TIMEOUT_S), api.get(f"/api/v1/builds/{build}")
        finished = api.get(f"/api/v1/builds/{build}")
        assert finished["summary"]["pass"] == finished["summary"]["total"] == 55
        # The failure reports that the agent accepts no builds, so the server does not assign a second attempt.
        assert finished["attempt"] <= 2
        causes = [change["cause"] for change in api.get(f"/api/v1/builds/{build}/history")]
        assert finished["attempt"] == 1 or any("disk" in cause or "No space" in cause for cause in causes), causes
