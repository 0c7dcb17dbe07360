"""`./sitaf up`, and scripts that use a server: remote runs, and requests generated from the OpenAPI document."""

import http.cookiejar
import io
import json
import os
import re
import signal
import subprocess
import sys
import urllib.request
import xml.etree.ElementTree as ElementTree
import zipfile
from dataclasses import dataclass
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "contract"))

from provider_contract import running, simulated  # noqa: E402


@dataclass(frozen=True)
class Server:
    address: str
    token: str
    # Where the agent looks for the provider of its real devices ir1 to ir7.
    provider: Path


@pytest.fixture(scope="module")
def server(sitaf, tmp_path_factory):
    """Server and agent of `up`, and an API token created with the sign-in link."""
    data = tmp_path_factory.mktemp("up")
    up = subprocess.Popen(
        [
            sitaf.root / "sitaf", "up", "--port", "0", "--grpc-port", "0", "--data", str(data),
            *(word for n in range(1, 8) for word in ("--device", f"ir{n}=unix:{data}/provider")),
        ],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        text=True,
    )
    try:
        said = re.compile(r"Sign in with this link, valid once: ((http://\S+)/open/\S+)")
        link, address = next(found.groups() for line in up.stdout if (found := said.search(line)))
        cookies = http.cookiejar.CookieJar()
        browser = urllib.request.build_opener(urllib.request.HTTPCookieProcessor(cookies))
        browser.open(link).close()
        browser.open(address + "/api/v1/session").close()
        csrf = next(cookie.value for cookie in cookies if cookie.name == "XSRF-TOKEN")
        request = urllib.request.Request(
            address + "/api/v1/tokens",
            data=json.dumps({"name": "e2e", "role": "ADMINISTRATOR", "days": 1}).encode(),
            headers={"Content-Type": "application/json", "X-XSRF-TOKEN": csrf},
        )
        with browser.open(request) as answer:
            token = json.load(answer)["secret"]
        yield Server(address, token, data / "provider")
    finally:
        # Processes in the background of a shell ignore SIGINT.
        up.send_signal(signal.SIGTERM)
        assert up.wait(timeout=60) in (0, 143)


def test_an_activity_is_tested_on_the_servers_agents(sitaf, server, tmp_path):
    junit, result = tmp_path / "report.xml", tmp_path / "result.xml"
    run = sitaf(
        "run", "examples/ir-sensor", "--server", server.address,
        "--model", "GetInfraredData", "--junit", junit, "--result", result,
        env={"SITAF_TOKEN": server.token},
    )
    assert run.returncode == 0, run.stdout + run.stderr
    assert "GetInfraredData: 55 cases, 55 PASS" in run.stdout
    assert f"{server.address}/builds/" in run.stderr
    assert ElementTree.parse(junit).getroot().find("testsuite").attrib["tests"] == "55"
    assert ElementTree.parse(result).getroot().find("summary").attrib["pass"] == "55"


def test_failed_cases_have_the_same_exit_code_remotely(sitaf, server):
    run = sitaf("run", "examples/ir-sensor-faulty", "--server", server.address, env={"SITAF_TOKEN": server.token})
    assert run.returncode == 1, run.stdout + run.stderr
    assert "GetInfraredData: 55 cases, 50 PASS, 5 FAIL" in run.stdout


def test_an_agent_tests_with_the_real_devices_that_it_offers(sitaf, server, activity, tmp_path):
    pytest.importorskip("sitaf_hardware.wire", reason="pip install ./hardware/python")
    profile = activity / "activity.yaml"
    # The agent uses its own address, and never the one of an uploaded activity.
    elsewhere = f"unix:{tmp_path}/nothing"
    lines = [f'  ir{n}: {{backend: provider, address: "{elsewhere}", max_age_s: 5}}\n' for n in range(1, 8)]
    profile.write_text(
        re.sub(r"(?m)^(limits|name):.*\n", "", profile.read_text())
        + "name: ir-sensor-real\nhardware:\n" + "".join(lines) + "limits: {jitter_ms: 2000}\n"
    )
    results = tmp_path / "results"
    with running(lambda address: simulated("ir-sensor/world/ir.world.yaml", address)) as (_, address):
        server.provider.symlink_to(address.removeprefix("unix:"))
        # A heartbeat can be late on a busy machine, which makes a case DONT, but never FAIL or ERROR.
        for _ in range(3):
            run = sitaf(
                "run", activity, "--server", server.address, "--result", results, env={"SITAF_TOKEN": server.token}
            )
            assert "0 FAIL, 0 ERROR" in run.stdout, run.stdout + run.stderr
            if run.returncode == 0:
                break
    assert "55 cases, 55 PASS" in run.stdout
    cases = ElementTree.parse(results / "GetInfraredData.xml").getroot().findall(".//test_result")
    assert all(len(case.find("hardware").findall("device")) == 7 for case in cases)
    agents = answer(server, "/api/v1/agents")
    assert agents[0]["devices"] == [f"ir{n}" for n in range(1, 8)]
    build = re.search(r"/builds/([\w-]+)", run.stderr).group(1)
    devices = answer(server, f"/api/v1/builds/{build}/result/cases?size=1")["items"][0]["devices"]
    assert devices["devices"][0] == "ir1: a real device"
    assert devices["safeStops"] == 1


def test_cases_that_differ_between_remote_runs_are_listed_and_fail(sitaf, server, activity):
    component = next(activity.glob("component/**/InfraredSensor.java"))
    source = component.read_text()
    measured = re.search(r"(?m)^ *double .*\.range\(\);$", source).group()
    component.write_text(source.replace(measured, measured + "\n    range += System.nanoTime() % 1_000_003;"))
    run = sitaf(
        "run", activity, "--server", server.address, "--case", "1-3", "--repeat", "3",
        env={"SITAF_TOKEN": server.token},
    )
    assert run.returncode == 1, run.stdout + run.stderr
    assert "not reproducible in 3 runs:" in run.stdout
    assert re.search(r"case 1: FAIL FAIL FAIL; the component: its readings are equal, and what it", run.stdout), run.stdout


def test_equal_remote_runs_pass(sitaf, server):
    run = sitaf(
        "run", "examples/ir-sensor", "--server", server.address, "--case", "1-3", "--repeat", "2",
        env={"SITAF_TOKEN": server.token},
    )
    assert run.returncode == 0, run.stdout + run.stderr
    assert "in 2 runs each case had the same verdict and the same values" in run.stdout
    run = sitaf("run", "examples/ir-sensor", "--server", server.address, "--repeat", "102")
    assert run.returncode == 2
    assert "--repeat must be at most 101 with --server" in run.stderr


def test_a_node_runs_with_the_ros_of_an_agent(sitaf, server):
    if not (sitaf.root / ".sitaf" / "ros-jazzy" / "stamp").exists() and "CI" not in os.environ:
        pytest.skip("needs ./sitaf doctor --install ros")
    run = sitaf(
        "run", "examples/velocity-mux-ros", "--server", server.address, "--model", "Mux", "--case", "1-3",
        "--ros", "system", env={"SITAF_TOKEN": server.token},
    )
    assert run.returncode == 0, run.stdout + run.stderr
    assert "Mux: 3 cases, 3 PASS" in run.stdout
    build = answer(server, "/api/v1/builds?size=1")["items"][0]
    assert build["ros"] == "SYSTEM"
    assert "an installed ROS 2" in build["requirements"]
    (agent,) = answer(server, "/api/v1/agents")
    assert {"language": "ros", "version": "jazzy"} in agent["toolchains"]


def test_a_remote_compiler_error_is_reported_with_file_and_line(sitaf, server, activity):
    source = next(activity.glob("component/**/InfraredSensor.java"))
    lines = source.read_text().splitlines()
    at = next(i for i, line in enumerate(lines) if line.strip().startswith("return "))
    lines[at] = "    return nonsense;"
    source.write_text("\n".join(lines))
    run = sitaf("run", activity, "--server", server.address, env={"SITAF_TOKEN": server.token})
    assert run.returncode == 2
    assert re.search(rf"InfraredSensor\.java:{at + 1}: error: .*cannot find symbol", run.stderr), run.stderr


def answer(server, path):
    request = urllib.request.Request(server.address + path, headers={"Authorization": f"Bearer {server.token}"})
    with urllib.request.urlopen(request) as found:
        return json.load(found)


def committed(folder):
    """Commits all files of a new repository and returns the id."""
    git = ["git", "-C", folder, "-c", "user.name=Ada", "-c", "user.email=ada@example"]
    subprocess.run([*git, "init", "--quiet"], check=True)
    subprocess.run([*git, "add", "--all"], check=True)
    subprocess.run([*git, "commit", "--quiet", "--no-verify", "--message", "Begin"], check=True)
    return subprocess.run([*git, "rev-parse", "HEAD"], check=True, capture_output=True, text=True).stdout.strip()


def test_runs_update_one_activity_and_their_builds_know_the_commit(sitaf, server, activity):
    profile = activity / "activity.yaml"
    profile.write_text(re.sub(r"(?m)^name: .*", "name: with-history", profile.read_text()))
    commit = committed(activity)

    def run(*options):
        done = sitaf(
            "run", activity, "--server", server.address, "--model", "GetInfraredData", *options,
            env={"SITAF_TOKEN": server.token},
        )
        assert done.returncode == 0, done.stdout + done.stderr

    run("--label", "branch=main", "--label", "run=7=8")
    source = next(activity.glob("component/**/InfraredSensor.java"))
    source.write_text(source.read_text() + "// changed\n")
    run()
    found = answer(server, "/api/v1/activities?name=with-history")
    assert found["total"] == 1
    uploaded = found["items"][0]
    newest, first = answer(server, f"/api/v1/builds?activityId={uploaded['id']}")["items"]
    assert (first["commit"], first["buildLabels"]) == (commit, {"branch": "main", "run": "7=8"})
    assert (newest["commit"], newest["buildLabels"]) == (f"{commit}-dirty", {})

    other = answer(server, "/api/v1/activities?name=ir-sensor")["items"]
    run("--activity", uploaded["id"])
    assert answer(server, f"/api/v1/builds?activityId={uploaded['id']}")["total"] == 3
    assert answer(server, "/api/v1/activities?name=ir-sensor")["items"] == other

    values = answer(server, f"/api/v1/builds/{newest['id']}/result/comparison/values?with={first['id']}")
    assert (values["cases"], values["differences"]) == (55, 0)


def test_labels_need_a_server(sitaf):
    run = sitaf("run", "examples/ir-sensor", "--label", "a=b")
    assert run.returncode == 2
    assert "--activity and --label need --server" in run.stderr


@pytest.mark.parametrize(
    ("address", "token", "expected"),
    [
        (None, "", "SITAF_TOKEN: error: is not set"),
        (None, "sitaf_wrong", "unknown, revoked or expired"),
        ("http://sitaf.example", "sitaf_x", "without TLS"),
        ("sitaf.example", "sitaf_x", "expected an address"),
    ],
)
def test_authentication_errors_are_reported(sitaf, server, address, token, expected):
    run = sitaf("run", "examples/ir-sensor", "--server", address or server.address, env={"SITAF_TOKEN": token})
    assert run.returncode == 2
    assert expected in run.stderr


@pytest.mark.parametrize(
    ("phases", "examples"),
    [("examples,fuzzing", "2"), pytest.param("examples,coverage,fuzzing", "8", marks=pytest.mark.long)],
    ids=["short", "long"],
)
def test_requests_of_the_openapi_document_do_not_break_the_server(server, tmp_path, phases, examples):
    pytest.importorskip("schemathesis", reason="./sitaf test installs it")
    # The server makes the document at the first request, for which schemathesis waits 10 s only.
    document = urllib.request.Request(
        server.address + "/v3/api-docs", headers={"Authorization": f"Bearer {server.token}"}
    )
    urllib.request.urlopen(document, timeout=120).close()
    fuzz = subprocess.run(
        [
            sys.executable, "-m", "schemathesis.cli", "run", server.address + "/v3/api-docs",
            "--header", f"Authorization: Bearer {server.token}",
            "--checks", "not_a_server_error",
            "--max-examples", os.environ.get("SITAF_FUZZ_EXAMPLES", examples),
            "--phases", phases,
            "--seed", "1",
            # Requests that would revoke the token are excluded.
            *(word for name in ("signOut", "revokeToken", "deleteUser", "changeUser", "resetPassword", "changePassword")
              for word in ("--exclude-operation-id", name)),
            # It cannot generate zip archives, which are tested with the archive reader.
            *(word for name in ("createActivity", "checkActivity", "proposeActivity", "replaceActivity", "addFiles")
              for word in ("--exclude-operation-id", name)),
            "--request-timeout", "30",
        ],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=False,
    )
    assert fuzz.returncode == 0, fuzz.stdout[-6000:] + fuzz.stderr[-2000:]


def test_the_client_in_python_that_the_server_offers_requests_a_suite(server, sitaf, tmp_path):
    for package in ("pydantic", "dateutil", "urllib3"):
        pytest.importorskip(package, reason="./sitaf test installs it")
    request = urllib.request.Request(
        server.address + "/api/v1/clients/python", headers={"Authorization": f"Bearer {server.token}"}
    )
    with urllib.request.urlopen(request) as answer:
        zipfile.ZipFile(io.BytesIO(answer.read())).extractall(tmp_path)
    with zipfile.ZipFile(tmp_path / "activity.zip", "w") as activity:
        root = sitaf.root / "examples" / "ir-sensor"
        for file in root.rglob("*"):
            activity.write(file, file.relative_to(root))
    program = tmp_path / "use.py"
    program.write_text(USE_OF_CLIENT)
    used = subprocess.run(
        [sys.executable, program, server.address, tmp_path / "activity.zip"],
        env={**os.environ, "SITAF_TOKEN": server.token, "PYTHONPATH": str(tmp_path / "sitaf-client-python")},
        capture_output=True, text=True, check=False,
    )
    assert used.stdout.split() == ["ir-sensor", "55", "404"], used.stderr


USE_OF_CLIENT = """
import os, pathlib, sys
import sitaf_client

client = sitaf_client.ApiClient(sitaf_client.Configuration(host=sys.argv[1], access_token=os.environ["SITAF_TOKEN"]))
activities = sitaf_client.ActivitiesApi(client)
activity = activities.create_activity(pathlib.Path(sys.argv[2]).read_bytes())
suite = sitaf_client.SuitesApi(client).generate_suite(activity.id, "GetInfraredData", sitaf_client.SuiteOptions())
try:
    activities.get_activity("none")
except sitaf_client.ApiException as e:
    print(activity.name, suite.total, e.status)
"""
