"""The instructions of `docs/deployment.md` and `docs/security.md`: TLS and systemd units."""

import re
import shlex
import shutil
import ssl
import subprocess

import pytest
from snippets import snippet
from system import Api, Refused, agent, await_true, own_bridge, server

TIMEOUT_S = 180
# Of the server, and of an agent.
COMMANDS = snippet("security-3-output").replace("\\\n", "").splitlines()


def certificate(folder, name):
    """A self-signed certificate for this machine, and its key."""
    certificate, key = folder / f"{name}.pem", folder / f"{name}-key.pem"
    subprocess.run(
        ["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes", "-days", "2",
         "-subj", f"/CN={name}", "-addext", "subjectAltName=DNS:localhost,IP:127.0.0.1",
         "-keyout", str(key), "-out", str(certificate)],
        check=True, capture_output=True,
    )  # fmt: skip
    return certificate, key


@pytest.fixture(scope="module")
def certificates(tmp_path_factory):
    folder = tmp_path_factory.mktemp("certificates")
    return {name: certificate(folder, name) for name in ("sitaf", "stranger")}


@pytest.fixture(scope="module")
def secured(sitaf, certificates, tmp_path_factory):
    assert sitaf("bench").returncode == 0
    chain, key = certificates["sitaf"]
    command, _ = COMMANDS
    # Tests listen on loopback only.
    for shown, here in {"/etc/sitaf/chain.pem": chain, "/etc/sitaf/key.pem": key, "0.0.0.0": "127.0.0.1"}.items():
        assert shown in command
        command = command.replace(shown, str(here))
    program, name, *options = shlex.split(command)
    assert (program, name) == ("./sitaf", "server")
    part = server(tmp_path_factory.mktemp("secured"), *options)
    part.api = Api(part.http, ssl.create_default_context(cafile=chain))
    with part:
        yield part


def test_an_agent_builds_for_a_server_that_it_trusts(secured, certificates, tmp_path):
    _, command = COMMANDS
    words = shlex.split(command.replace("/etc/sitaf/ca.pem", str(certificates["sitaf"][0])), comments=True)
    assert words[:4] == ["./sitaf", "agent", "--server", "sitaf.example:9090"]
    with agent(tmp_path, "trusting", secured.grpc, *words[4:], *own_bridge()):
        build = secured.api.build(secured.api.suite())
        assert await_true(lambda: secured.api.state(build) == "DONE", TIMEOUT_S)


@pytest.mark.parametrize(
    ("options", "expected"),
    [
        ("stranger", rb"(?s)no connection to the server: UNAVAILABLE.*certification path"),
        (None, rb"no connection to the server"),
    ],
    ids=["another-authority", "without-tls"],
)
def test_an_agent_sends_its_token_to_trusted_servers_only(secured, certificates, tmp_path, options, expected):
    trusted = ("--ca", str(certificates[options][0])) if options else ()
    name = f"wary-{options}"
    wary = agent(tmp_path, name, secured.grpc, *trusted)
    try:
        wary.start(wait=False)
        assert await_true(lambda: wary.has_logged(expected), TIMEOUT_S), wary.log.read_text()
        assert not wary.has_logged(wary.ready)
        assert not (wary.directory / "key").exists()
        assert name not in [a["name"] for a in secured.api.get("/api/v1/agents")]
    finally:
        wary.stop()


def test_the_portal_uses_tls_only(secured):
    with pytest.raises((OSError, Refused)):
        Api(secured.http).get("/api/v1/agents")


@pytest.fixture
def units(sitaf, tmp_path):
    """The systemd units; the agent's unit is a template."""
    if shutil.which("systemd-analyze") is None:
        pytest.skip("systemd-analyze is not installed")
    for unit in (sitaf.root / "docs" / "systemd").iterdir():
        shutil.copy(unit, tmp_path / unit.name.replace("@.", "@1."))
    return sorted(tmp_path.glob("*.service"))


def verify(units):
    return subprocess.run(
        ["systemd-analyze", "verify", "--man=no", *map(str, units)], capture_output=True, text=True, check=False
    )


def test_systemd_accepts_the_units(units):
    assert len(units) == 2
    verified = verify(units)
    assert (verified.returncode, verified.stderr) == (0, "")
    # It rejects an invalid unit.
    units[0].write_text(units[0].read_text().replace("Restart=always", "Restart=allways"))
    assert "allways" in verify(units).stderr


def test_the_units_use_existing_options(sitaf, units):
    text = next(unit for unit in units if "agent" in unit.name).read_text()
    options = set(re.findall(r"(?<=\s)--[a-z-]+", text))
    assert {"--server", "--directory", "--bridge-command"} <= options
    known = sitaf("agent", "--help").stdout
    assert all(option in known for option in options), options
