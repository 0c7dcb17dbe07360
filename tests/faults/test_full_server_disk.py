"""A server with a full disk stays readable, loses nothing, and continues when there is free space."""

import json
import time
import urllib.error
import urllib.request

import pytest
from system import Refused, agent, await_true, fill, own_bridge, server

MIB = 1 << 20
TIMEOUT_S = 180

# Below this, no new work is accepted; below a quarter of it, nothing is written.
MIN_FREE_MIB = 24
LEASE_S = 4
SETTINGS = (f"--sitaf.min-free={MIN_FREE_MIB}MB", f"--sitaf.lease={LEASE_S}s", "--sitaf.retry-delay=1s")


@pytest.fixture
def central(installed, disk, tmp_path):
    part = server(disk, *SETTINGS)
    part.log = tmp_path / "server.log"
    with part:
        yield part


@pytest.fixture
def worker(central, tmp_path):
    """An agent on another disk."""
    with agent(tmp_path, "worker", central.grpc, *own_bridge()) as part:
        yield part


def health(part):
    """The health status of the server and its components."""
    try:
        with urllib.request.urlopen(f"http://127.0.0.1:{part.http}/actuator/health", timeout=30) as answer:
            status = json.load(answer)
    except urllib.error.HTTPError as error:
        status = json.load(error)
    return status["status"], status["components"]["disks"]["status"]


def person(part):
    """Sign in like a browser; return what the user sees."""
    browser = urllib.request.build_opener(urllib.request.HTTPCookieProcessor())
    root = f"http://127.0.0.1:{part.http}"
    link = part.api.post("/api/v1/session/link", {})["path"]
    browser.open(root + link, timeout=30).close()

    def see(path):
        with browser.open(root + path, timeout=30) as answer:
            return json.load(answer)

    return see


def refusal(call):
    with pytest.raises(Refused) as refused:
        call()
    return str(refused.value)


def insist(call):
    """Repeat a request as long as the server answers that it can be retried."""
    end = time.monotonic() + TIMEOUT_S
    while True:
        try:
            return call()
        except Refused as refused:
            if " 503 " not in str(refused) or time.monotonic() > end:
                raise
        time.sleep(0.2)


def spooled(worker):
    return list((worker.directory / "spool").glob("*/message"))


def test_results_wait_for_free_space_on_the_server(central, worker, disk):
    api = central.api
    see = person(central)
    suite = api.suite(60)
    build = api.build(suite)
    assert await_true(lambda: api.get(f"/api/v1/builds/{build}")["casesDone"] >= 5, TIMEOUT_S, 0.05)

    give_back = fill(disk)
    assert health(central) == ("DOWN", "DOWN")
    assert "507" in refusal(lambda: api.build(suite))
    message = refusal(api.suite)
    assert "507" in message and "the disk of the server's data has only 0 MiB left" in message

    # The agent's uploads fail for longer than a lease, and readers are not affected.
    assert await_true(lambda: spooled(worker), TIMEOUT_S)
    end = time.monotonic() + 2 * LEASE_S
    while time.monotonic() < end:
        assert api.state(build) == "RUNNING"
        assert see(f"/api/v1/suites/{suite}")["total"] == 55
        time.sleep(0.2)
    assert spooled(worker)

    give_back()
    assert await_true(lambda: api.state(build) == "DONE", TIMEOUT_S), api.get(f"/api/v1/builds/{build}")
    finished = api.get(f"/api/v1/builds/{build}")
    assert finished["summary"]["pass"] == finished["summary"]["total"] == 55
    assert finished["attempt"] == 1
    assert await_true(lambda: not spooled(worker), TIMEOUT_S)
    assert health(central) == ("UP", "UP")
    after = api.build(suite)
    assert await_true(lambda: api.state(after) == "DONE", TIMEOUT_S)

    # Acknowledged results exist after a restart; a start without free space is not tested.
    central.kill()
    give_back = fill(disk)
    with pytest.raises(RuntimeError, match="The server does not start: the disk of the server's data has only 0 MiB"):
        central.start()
    give_back()
    central.start()
    assert {b["id"]: b["state"] for b in api.builds()} == {build: "DONE", after: "DONE"}


def test_space_is_reserved_for_accepted_builds(central, worker, disk):
    api = central.api
    suite = api.suite(60)
    build = api.build(suite)
    assert await_true(lambda: api.get(f"/api/v1/builds/{build}")["casesDone"] >= 5, TIMEOUT_S, 0.05)
    waiting = api.build(suite)

    give_back = fill(disk, leave=(MIN_FREE_MIB - 8) * MIB)
    assert health(central) == ("OUT_OF_SERVICE", "OUT_OF_SERVICE")
    message = refusal(lambda: api.build(suite))
    assert "507" in message and "The server accepts no new work" in message and "Free disk space" in message
    assert await_true(lambda: api.state(build) == "DONE", TIMEOUT_S)
    assert "the disk of the server's data has only" in api.get(f"/api/v1/builds/{waiting}")["waitingFor"]
    assert api.state(waiting) == "QUEUED"

    give_back()
    assert await_true(lambda: api.state(waiting) == "DONE", TIMEOUT_S)
    assert health(central) == ("UP", "UP")


def test_the_database_is_reopened_after_a_failed_write(installed, disk, tmp_path):
    # Nothing checks the free space here, so the database hits the end of the disk.
    part = server(disk, "--sitaf.min-free=0")
    part.log = tmp_path / "server.log"
    with part:
        api = part.api
        suite = api.suite()
        made = [api.build(suite)]
        for _ in range(2):
            give_back = fill(disk)
            assert "507" in refusal(lambda: api.build(suite))
            assert [b["id"] for b in insist(api.builds)][::-1] == made
            give_back()
            made.append(insist(lambda: api.build(suite)))
        assert [b["id"] for b in api.builds()][::-1] == made
        assert part.process.poll() is None
