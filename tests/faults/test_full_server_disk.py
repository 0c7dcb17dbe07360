"""A server whose own disk runs full goes on being read, loses nothing, and works again by itself when there is room."""

import json
import time
import urllib.error
import urllib.request

import pytest
from system import Refused, agent, await_true, fill, own_bridge, server

MIB = 1 << 20
PATIENCE_S = 180

# With less than this no new work is taken, with less than a quarter of it nothing is written.
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
    """An agent whose own disk is another one."""
    with agent(tmp_path, "worker", central.grpc, *own_bridge()) as part:
        yield part


def health(part):
    """The state of the server and of what it looks after."""
    try:
        with urllib.request.urlopen(f"http://127.0.0.1:{part.http}/actuator/health", timeout=30) as answer:
            told = json.load(answer)
    except urllib.error.HTTPError as error:
        told = json.load(error)
    return told["status"], told["components"]["disks"]["status"]


def person(part):
    """Somebody who has signed in with a browser; answers what they get to see."""
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
    """Repeats a request for as long as the server says that it may be repeated soon."""
    end = time.monotonic() + PATIENCE_S
    while True:
        try:
            return call()
        except Refused as refused:
            if " 503 " not in str(refused) or time.monotonic() > end:
                raise
        time.sleep(0.2)


def spooled(worker):
    return list((worker.directory / "spool").glob("*/message"))


def test_results_wait_for_room_on_the_disk_of_the_server(central, worker, disk):
    api = central.api
    see = person(central)
    suite = api.suite(60)
    build = api.build(suite)
    assert await_true(lambda: api.get(f"/api/v1/builds/{build}")["casesDone"] >= 5, PATIENCE_S, 0.05)

    give_back = fill(disk)
    assert health(central) == ("DOWN", "DOWN")
    assert "507" in refusal(lambda: api.build(suite))
    told = refusal(api.suite)
    assert "507" in told and "the disk of the server's data has only 0 MiB left" in told

    # The agent brings its result in vain, for longer than a lease, and nobody who looks is the worse for it.
    assert await_true(lambda: spooled(worker), PATIENCE_S)
    end = time.monotonic() + 2 * LEASE_S
    while time.monotonic() < end:
        assert api.state(build) == "RUNNING"
        assert see(f"/api/v1/suites/{suite}")["total"] == 55
        time.sleep(0.2)
    assert spooled(worker)

    give_back()
    assert await_true(lambda: api.state(build) == "DONE", PATIENCE_S), api.get(f"/api/v1/builds/{build}")
    told = api.get(f"/api/v1/builds/{build}")
    assert told["summary"]["pass"] == told["summary"]["total"] == 55
    assert told["attempt"] == 1
    assert await_true(lambda: not spooled(worker), PATIENCE_S)
    assert health(central) == ("UP", "UP")
    after = api.build(suite)
    assert await_true(lambda: api.state(after) == "DONE", PATIENCE_S)

    # What was acknowledged is there, whatever happens now; a start is not tried without room for it.
    central.kill()
    give_back = fill(disk)
    with pytest.raises(RuntimeError, match="The server does not start: the disk of the server's data has only 0 MiB"):
        central.start()
    give_back()
    central.start()
    assert {b["id"]: b["state"] for b in api.builds()} == {build: "DONE", after: "DONE"}


def test_little_room_is_kept_for_the_work_that_was_taken(central, worker, disk):
    api = central.api
    suite = api.suite(60)
    build = api.build(suite)
    assert await_true(lambda: api.get(f"/api/v1/builds/{build}")["casesDone"] >= 5, PATIENCE_S, 0.05)
    waiting = api.build(suite)

    give_back = fill(disk, leave=(MIN_FREE_MIB - 8) * MIB)
    assert health(central) == ("OUT_OF_SERVICE", "OUT_OF_SERVICE")
    told = refusal(lambda: api.build(suite))
    assert "507" in told and "The server accepts no new work" in told and "Free disk space" in told
    assert await_true(lambda: api.state(build) == "DONE", PATIENCE_S)
    assert "the disk of the server's data has only" in api.get(f"/api/v1/builds/{waiting}")["waitingFor"]
    assert api.state(waiting) == "QUEUED"

    give_back()
    assert await_true(lambda: api.state(waiting) == "DONE", PATIENCE_S)
    assert health(central) == ("UP", "UP")


def test_a_database_that_could_not_write_is_opened_anew(installed, disk, tmp_path):
    # Nobody asks for room here, so that the database runs into the end of the disk.
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
