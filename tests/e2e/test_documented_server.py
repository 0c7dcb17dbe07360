"""The commands of the documents for people who operate a server or use its REST interface.

Hosts, folders and tokens are replaced by those of the test; the rest runs as shown.
"""

import datetime
import hashlib
import hmac
import json
import os
import re
import shlex
import shutil
import subprocess
import urllib.request
import uuid
from pathlib import Path

import pytest
from needs import postgresql
from snippets import ROOT, snippet
from system import EXAMPLE, TOKEN, agent, await_true, free_port, own_bridge, server
from system import activity as packed

LIMIT_S = 180
PROJECT = "robots/sensors"
AUTHOR = {
    f"GIT_{who}_{what}": value
    for who in ("AUTHOR", "COMMITTER")
    for what, value in (("NAME", "Ada"), ("EMAIL", "ada@robots.example"))
}


def shell(commands, cwd, functions="", **environment):
    """Runs commands of a page in bash; returns what they print."""
    ran = subprocess.run(
        ["bash", "-euc", functions + commands], cwd=cwd, env={**os.environ, **environment},
        capture_output=True, text=True, timeout=LIMIT_S, check=False,
    )  # fmt: skip
    assert ran.returncode == 0, f"{commands}\n{ran.stdout}{ran.stderr}"
    return ran.stdout


class Repository:
    """A Git repository with the paper's sensor, whose commits change the distance that it measures."""

    def __init__(self, folder):
        self.folder = folder
        folder.mkdir(parents=True)
        self.git("init", "-q", "-b", "main")
        shutil.copytree(EXAMPLE, folder / "infrared")
        self.first = self.commit("Add the sensor")

    def git(self, *arguments):
        ran = subprocess.run(
            ["git", "-C", self.folder, *arguments],
            env={**os.environ, **AUTHOR}, capture_output=True, text=True, check=True,
        )  # fmt: skip
        return ran.stdout.strip()

    def commit(self, subject):
        self.git("add", "-A")
        self.git("commit", "-q", "-m", subject)
        return self.git("rev-parse", "HEAD")

    def change(self, text, by, subject):
        source = next(self.folder.rglob("InfraredSensor.java"))
        assert text in source.read_text()
        source.write_text(source.read_text().replace(text, by))
        return self.commit(subject)


@pytest.fixture(scope="module")
def installed(sitaf):
    assert sitaf("bench").returncode == 0
    return sitaf


@pytest.fixture(scope="module")
def repository(tmp_path_factory):
    return Repository(tmp_path_factory.mktemp("git") / PROJECT)


@pytest.fixture(scope="module")
def central(installed, repository, tmp_path_factory):
    """A server that may read the repository, with an agent that was started as the page of security says."""
    folder = tmp_path_factory.mktemp("central")
    part = server(
        folder,
        f"--sitaf.git.file-folders={repository.folder.parents[1]}",
        "--sitaf.git.min-interval=1s",
        "--sitaf.retry-delay=200ms",
        "--sitaf.webhooks.allowed-hosts=bot.example.org",
    )
    assignment, *command = shlex.split(snippet("security-2-output"))
    assert assignment.startswith("SITAF_ENROLMENT_TOKEN=")
    assert command[:3] == ["./sitaf", "agent", "--server"]
    with part, agent(folder, "agent", part.grpc, *command[4:], *own_bridge()):
        part.folder = folder
        yield part


def request(central, commands, cwd, **replaced):
    """Sends the request of a page with curl; returns the JSON of the answer."""
    commands = re.sub(r"^\$ ", "", commands)
    for shown, real in {
        "https://sitaf.example.org": central.api.root,
        "https://sitaf.example": central.api.root,
        **replaced,
    }.items():
        assert shown in commands or shown.startswith("https://"), shown
        commands = commands.replace(shown, real)
    functions = 'curl() { command curl --silent --show-error --fail-with-body "$@"; }\n'
    return json.loads(shell(commands, cwd, functions, TOKEN=TOKEN, SITAF_TOKEN=TOKEN))


def commits(central, activity, request=None):
    only = f"&request={request}" if request else ""
    listed = central.api.get(f"/api/v1/activities/{activity}/git/commits?size=100{only}")
    return {commit["sha"]: commit for commit in listed["items"]}


def is_built(central, activity, sha, request=None):
    found = commits(central, activity, request).get(sha)
    return found is not None and found["state"] == "DONE"


@pytest.fixture(scope="module")
def line(central, repository):
    """An activity from Git whose newest commit fails; the commits before were pushed with it, but the first was built."""
    activity = central.api.post(
        "/api/v1/git-activities",
        {"url": repository.folder.as_uri(), "branch": "main", "folder": "infrared", "policy": "LATEST", "intervalS": 1},
    )["id"]
    assert await_true(lambda: is_built(central, activity, repository.first), LIMIT_S)
    # One push: the server looks for commits each second.
    repository.git("checkout", "-q", "-b", "work")
    repository.change("return NO_DISTANCE;", "return NO_DISTANCE; // none", "Explain")
    bad = repository.change(
        "double NO_DISTANCE = -1", "double NO_DISTANCE = -2", "Change what there is without a distance"
    )
    newest = repository.change("// none", "// no distance", "Explain more")
    repository.git("update-ref", "refs/heads/main", newest)
    repository.git("checkout", "-q", "main")
    assert await_true(lambda: is_built(central, activity, newest), LIMIT_S)
    return activity, bad, newest


def test_an_activity_is_created_from_git(central, repository, tmp_path):
    replaced = {
        "https://github.com/robots/sensors.git": repository.folder.as_uri(),
        # A folder has no credentials.
        '"credential": "TOKEN", "secret": "github_pat_..."': '"credential": "NONE"',
    }
    created = request(central, snippet("git-1-console"), tmp_path, **replaced)
    source = central.api.get(f"/api/v1/activities/{created['id']}/git")
    assert (source["branch"], source["folder"]) == ("main", "infrared")
    assert await_true(lambda: commits(central, created["id"]), LIMIT_S)


def test_the_first_bad_commit_is_found(central, line, tmp_path):
    activity, bad, newest = line
    commands = snippet("git-2-console")
    search = request(central, commands, tmp_path, **{"/ID/": f"/{activity}/", "40 hexadecimal digits": newest})
    path = f"/api/v1/activities/{activity}/git/bisections/{search['number']}"
    assert await_true(lambda: central.api.get(path)["state"] != "RUNNING", LIMIT_S)
    found = central.api.get(path)
    assert [commit["sha"] for commit in found["firstBad"]] == [bad], found


def test_the_history_of_a_case_is_read(central, line, tmp_path):
    activity, _, newest = line
    build = commits(central, activity)[newest]["cells"][0]["buildId"]
    replaced = {"/ID/": f"/{activity}/", "BUILD": build}
    history = request(central, snippet("git-3-console"), tmp_path, **replaced)
    assert len(history["items"]) >= 2, history


def report_request(central, activity, head):
    """Sends what GitHub sends when a request of a fork is opened."""
    secret = central.api.post(f"/api/v1/activities/{activity}/git/hook", {})["secret"]
    content = {
        "action": "opened",
        "pull_request": {
            "number": 7, "state": "open", "title": "Measure", "user": {"login": "contributor"},
            "head": {"sha": head, "repo": {"id": 8}},
            "base": {"ref": "main", "repo": {"id": 7, "full_name": PROJECT}},
        },
    }  # fmt: skip
    body = json.dumps(content).encode()
    message = urllib.request.Request(f"{central.api.root}/api/v1/git-hooks/{activity}", data=body, method="POST")
    message.add_header("Content-Type", "application/json")
    message.add_header("X-GitHub-Event", "pull_request")
    message.add_header("X-GitHub-Delivery", str(uuid.uuid4()))
    message.add_header("X-Hub-Signature-256", "sha256=" + hmac.new(secret.encode(), body, hashlib.sha256).hexdigest())
    central.api.answer(message)


def test_a_request_of_a_fork_is_built(central, line, repository, tmp_path):
    activity, _, _ = line
    repository.git("checkout", "-q", "-b", "fork")
    head = repository.change("double NO_DISTANCE = -2", "double NO_DISTANCE = -1", "Measure as before")
    repository.git("update-ref", "refs/pull/7/head", head)
    repository.git("checkout", "-q", "main")
    report_request(central, activity, head)
    replaced = {"/ID/": f"/{activity}/", "40 hexadecimal digits": head}
    request(central, snippet("git-4-console"), tmp_path, **replaced)
    assert await_true(lambda: is_built(central, activity, head, 7), LIMIT_S), commits(central, activity, 7)


def test_a_webhook_is_created(central, tmp_path):
    activity = central.api.call("POST", "/api/v1/activities", packed(0), "application/zip")["name"]
    assert activity == "ir-sensor"
    created = request(central, snippet("git-5-console"), tmp_path)
    assert created["secret"]
    assert [hook["url"] for hook in central.api.get("/api/v1/webhooks")["items"]] == ["https://bot.example.org/sitaf"]


def test_scripts_use_a_token(central, tmp_path):
    run, listing = snippet("security-1-output").splitlines()
    assert run.startswith("SITAF_TOKEN=sitaf_... ./sitaf ")
    command = run.replace("sitaf_...", TOKEN).replace("https://sitaf.example", central.api.root)
    assert "55 PASS" in shell(command, ROOT)
    assert request(central, listing, tmp_path)["total"] >= 1


def test_an_agent_offers_its_devices(central):
    command = shlex.split(snippet("hardware-6-sh"))
    assert command[:4] == ["./sitaf", "agent", "--server", "localhost:9090"]
    with agent(central.folder, "with-devices", central.grpc, *command[4:]):
        offered = next(a["devices"] for a in central.api.get("/api/v1/agents") if a["name"] == "with-devices")
    assert offered == ["arm", "ir1"]


def names(part):
    return sorted(a["name"] for a in part.api.get("/api/v1/activities")["items"])


def operate(commands, part, places, functions="", **environment):
    """Runs the commands of a page, which stop and start the server."""
    for line in commands.splitlines():
        if line == "systemctl stop sitaf-server":
            part.stop()
        elif line == "systemctl start sitaf-server":
            part.start()
        else:
            for shown, real in places.items():
                line = line.replace(shown, str(real))
            shell(line, part.log.parent, functions, **environment)


def back_up_and_restore(part, backup, restore, places, **further):
    """What was there at the backup is there after the restore, and nothing else."""
    part.api.suite()
    before = names(part)
    operate(backup, part, places, **further)
    identity = part.api.get("/api/v1/activities")["items"][0]["id"]
    part.api.call("DELETE", f"/api/v1/activities/{identity}")
    assert names(part) != before
    # The date of the backup in the documents is not that of today.
    dated = re.sub(r"sitaf-\d{4}-\d\d-\d\d", f"sitaf-{datetime.date.today()}", restore)
    assert dated != restore or str(datetime.date.today()) in restore
    operate(dated, part, places, **further)
    assert names(part) == before


def test_a_backup_of_h2_is_restored(installed, tmp_path):
    (tmp_path / "backup").mkdir()
    places = {"/backup/": f"{tmp_path}/backup/", "/var/lib/sitaf": tmp_path}
    with server(tmp_path) as part:
        back_up_and_restore(part, snippet("backup-1-sh"), snippet("backup-2-sh"), places)


@pytest.fixture
def database(tmp_path):
    """A PostgreSQL server of Debian with a role and a database for the server."""
    programs = max(Path("/usr/lib/postgresql").iterdir()) / "bin"
    # It refuses to run as root.
    user = ["setpriv", "--reuid=nobody", "--regid=nogroup", "--clear-groups"] if os.geteuid() == 0 else []
    place, port = tmp_path / "postgresql", free_port()
    place.mkdir()
    if user:
        shutil.chown(place, "nobody", "nogroup")
        for folder in [tmp_path, *tmp_path.parents]:
            if folder.stat().st_uid == os.geteuid() and folder != Path("/"):
                folder.chmod(folder.stat().st_mode | 0o011)
    create = [*user, programs / "initdb", "--auth=trust", "--username=admin", "--no-sync", place / "data"]
    subprocess.run(create, check=True, capture_output=True)
    options = ["-h", "127.0.0.1", "-p", str(port), "-k", str(place), "-F"]
    running = subprocess.Popen(
        [*user, programs / "postgres", "-D", place / "data", *options],
        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
    )  # fmt: skip
    environment = {"PGHOST": "127.0.0.1", "PGPORT": str(port), "PGUSER": "admin"}
    try:
        ready = [programs / "pg_isready", "-h", "127.0.0.1", "-p", str(port), "-q"]
        assert await_true(lambda: subprocess.run(ready, check=False).returncode == 0, LIMIT_S)
        shell("createuser sitaf; createdb --owner=sitaf sitaf", tmp_path, **environment)
        yield environment
    finally:
        running.terminate()
        running.wait()


@postgresql
def test_a_backup_of_postgresql_is_restored(installed, database, tmp_path):
    (tmp_path / "backup").mkdir()
    url = f"jdbc:postgresql://127.0.0.1:{database['PGPORT']}/sitaf?user=sitaf&reWriteBatchedInserts=true"
    places = {"/backup/": f"{tmp_path}/backup/"}
    with server(tmp_path, database=url) as part:
        back_up_and_restore(part, snippet("backup-3-sh"), snippet("backup-4-sh"), places, **database)


@pytest.mark.skipif(not shutil.which("systemctl"), reason="systemd is not installed")
@pytest.mark.skipif(os.geteuid() != 0, reason="only root adds users")
def test_units_and_users_are_installed(tmp_path):
    for folder in ("etc/systemd/system", "var/lib"):
        (tmp_path / folder).mkdir(parents=True)
    for name in ("passwd", "group", "shadow", "gshadow", "login.defs"):
        shutil.copy(Path("/etc") / name, tmp_path / "etc")
    functions = (
        # Below a folder there is no systemd that could start the units now.
        f'systemctl() {{ command systemctl --root={tmp_path} "${{@/--now/--no-reload}}"; }}\n'
        f'useradd() {{ command useradd --prefix {tmp_path} "$@"; }}\n'
    )
    shell(snippet("deployment-1-output").replace("/etc/systemd", f"{tmp_path}/etc/systemd"), ROOT, functions)
    wanted = tmp_path / "etc" / "systemd" / "system" / "multi-user.target.wants"
    assert sorted(unit.name for unit in wanted.iterdir()) == [
        "sitaf-agent@1.service", "sitaf-agent@2.service", "sitaf-server.service",
    ]  # fmt: skip
    users = (tmp_path / "etc" / "passwd").read_text()
    for unit in wanted.iterdir():
        user = re.search(r"(?m)^User=(\S+)$", (ROOT / "docs" / "systemd" / re.sub(r"@\d", "@", unit.name)).read_text())[
            1
        ]
        assert re.search(rf"(?m)^{user}:", users), user
