"""Agents of the previous and next release work with a server; others get a message that names what to update."""

import re
import shutil
import zipfile

import pytest
from system import DIST, agent, await_true, own_bridge, server

MANIFEST = "META-INF/MANIFEST.MF"
TIMEOUT_S = 180


def installation(folder, release):
    """The current agent with another version number."""
    shutil.copytree(DIST / "agent", folder, ignore=shutil.ignore_patterns("*.jsa"))
    jar, other = folder / "agent.jar", folder / "other.jar"
    with zipfile.ZipFile(jar) as source, zipfile.ZipFile(other, "w") as target:
        for item in source.infolist():
            content = source.read(item)
            if item.filename == MANIFEST:
                content, found = re.subn(rb"(?m)^(Implementation-Version: )\S+", rb"\g<1>" + release, content)
                assert found == 1
            target.writestr(item, content)
    other.replace(jar)
    return folder


@pytest.fixture(scope="module")
def central(installed, tmp_path_factory):
    with server(tmp_path_factory.mktemp("releases")) as part:
        part.suite = part.api.suite()
        yield part


def release_of(server_log, steps):
    """The server's version plus this many minor releases."""
    major, minor = (int(number) for number in re.search(r"\(server (\d+)\.(\d+)\.", server_log).groups())
    return f"{major}.{minor + steps}.0".encode()


@pytest.fixture(scope="module")
def output(central, tmp_path_factory):
    """The output of an agent of the same release."""
    with agent(tmp_path_factory.mktemp("same"), "same", central.grpc) as same:
        return same.log.read_text()


@pytest.mark.parametrize("steps", [-1, pytest.param(1, marks=pytest.mark.long)])
def test_one_release_apart_works(central, output, tmp_path, steps):
    release = release_of(output, steps) if not output.count("(server 0.0.") else pytest.skip("there is no release before")
    other = installation(tmp_path / "agent", release)
    with agent(tmp_path, f"release-{steps + 1}", central.grpc, *own_bridge(), installation=other):
        build = central.api.build(central.suite)
        assert await_true(lambda: central.api.state(build) == "DONE", TIMEOUT_S)
        known = {a["name"]: a for a in central.api.get("/api/v1/agents")}
        assert known[f"release-{steps + 1}"]["version"] == release.decode()


def test_two_releases_apart_is_rejected_with_a_message(central, output, tmp_path):
    other = installation(tmp_path / "agent", release_of(output, 2))
    newer = agent(tmp_path, "too-new", central.grpc, installation=other)
    try:
        newer.start(wait=False)
        expected = rb"at most one release apart; update the server"
        assert await_true(lambda: newer.has_logged(expected), TIMEOUT_S)
        assert not newer.has_logged(newer.ready)
    finally:
        newer.stop()
