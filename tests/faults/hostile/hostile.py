"""Runs hostile components, worlds and models on an agent and sends hostile uploads to a server, while another user builds."""

import argparse
import http.client
import os
import pwd
import statistics
import subprocess
import sys
import tempfile
import threading
import time
from contextlib import ExitStack
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
sys.path.insert(0, str(Path(__file__).parent.parent))
import activities
import watch
from system import MODEL, OVER, TOKEN, Refused, Table, agent, await_true, own_bridge, server, show

CASES = 55
HOSTILE_LIMIT_S = 150
CANCEL_LIMIT_S = 20
RUNTIME_LIMIT_S = 900
VICTIM_FACTOR = 3
# Tolerated difference between two builds of a few milliseconds.
VICTIM_ALLOWANCE_S = 0.5
ANOTHER_LOOK = 2
AGENT_MIB = 768
LOG_MIB = 16
DISK_MIB = 1024


class Victim:
    """Builds the paper's example repeatedly as another user."""

    def __init__(self, api):
        self.api, self.suite = api, api.suite()
        self.usual_s = 0.0

    def build(self):
        """Run one build; return its duration and summary."""
        began = time.monotonic()
        build = self.api.build(self.suite)
        await_true(lambda: self.api.state(build) in OVER, HOSTILE_LIMIT_S, 0.05)
        took, found = time.monotonic() - began, self.api.get(f"/api/v1/builds/{build}")
        return took, (found.get("summary") or {}).get("pass", 0), found

    def learn(self, rounds):
        # The first build fills the caches.
        self.build()
        self.usual_s = self.alone_s(rounds)

    def alone_s(self, rounds):
        return statistics.median(self.build()[0] for _ in range(rounds))

    def is_late(self, took_s):
        return took_s > VICTIM_FACTOR * self.usual_s + VICTIM_ALLOWANCE_S

    def is_delayed(self, took_s):
        """Attribute a late build to hostile input only if the machine is as fast as before without it."""
        return self.is_late(took_s) and took_s > VICTIM_FACTOR * self.alone_s(3) + VICTIM_ALLOWANCE_S


class Trial:
    """Run one hostile build in parallel to the victim's builds; return the outcome."""

    def __init__(self, system, suite):
        self.system, self.api, self.suite = system, system.api, suite
        self.faults, self.took_s, self.build, self.victim_s = [], 0.0, None, 0.0

    def run(self, never_green):
        try:
            hostile = self.api.build(self.suite)
        except Refused as refused:
            # A world or model that the server rejects is not built.
            self.build = {"state": "REFUSED", "message": str(refused)}
            return self
        began = time.monotonic()
        await_true(lambda: self.api.state(hostile) in OVER | {"RUNNING"}, HOSTILE_LIMIT_S, 0.05)
        self.victim(hostile)
        if not await_true(lambda: self.api.state(hostile) in OVER, HOSTILE_LIMIT_S):
            self.cancel(hostile)
        self.took_s = time.monotonic() - began
        self.build = self.api.get(f"/api/v1/builds/{hostile}")
        self.judge(hostile, never_green)
        self.judge_delay()
        return self

    def victim(self, hostile):
        self.victim_s, passed, found = self.system.victim.build()
        if passed != CASES:
            self.faults.append(f"another user's build: {found['state']}, {passed} PASS, {found.get('failure')}")
        # Other load may slow this machine down, so a late build is repeated while the hostile build still runs.
        for _ in range(ANOTHER_LOOK):
            if not self.system.victim.is_late(self.victim_s) or self.api.state(hostile) in OVER:
                break
            self.victim_s = min(self.victim_s, self.system.victim.build()[0])

    def judge_delay(self):
        if self.system.victim.is_delayed(self.victim_s):
            self.faults.append(f"another user's build took {self.victim_s:.1f} s")

    def cancel(self, hostile):
        self.faults.append(f"did not end within {HOSTILE_LIMIT_S} s")
        self.api.post(f"/api/v1/builds/{hostile}/cancel", {})
        if not await_true(lambda: self.api.state(hostile) in OVER, CANCEL_LIMIT_S):
            self.faults.append("cannot be cancelled")

    def judge(self, hostile, never_green):
        summary = self.build.get("summary") or {}
        green = self.build["state"] == "DONE" and summary.get("pass") == summary.get("total") and not self.build.get("suspect")
        if green and never_green:
            self.faults.append(f"is green: {summary}")
        self.judge_log(hostile)
        if self.system.agent.process.poll() is not None:
            self.faults.append("the agent died")
            self.system.agent.start()
        peak = watch.peak_mib(self.system.agent_pid())
        if peak > AGENT_MIB:
            self.faults.append(f"the agent took {peak} MiB")
        if not await_true(lambda: not watch.survivors(str(self.system.folder)), 10):
            self.faults.append(f"left {watch.survivors(str(self.system.folder))[:3]}")
        for place in watch.canaries():
            self.faults.append(f"wrote into {place}")

    def judge_log(self, hostile):
        offset, log = 0, []
        while len(log) <= LOG_MIB:
            part = self.api.get(f"/api/v1/builds/{hostile}/log?offset={offset}")
            if not part:
                break
            offset += len(part)
            log.append(part)
        if len(log) > LOG_MIB:
            self.faults.append(f"has a log of more than {LOG_MIB} MiB")
        text = b"".join(log).decode(errors="replace")
        self.faults += [line[:100] for line in dict.fromkeys(text.splitlines()) if line.startswith("BREACH")][:5]

    def summary(self):
        if self.build["state"] == "REFUSED":
            return "refused"
        counted = self.build.get("summary")
        shown = "/".join(str(counted[k]) for k in ("pass", "fail", "error", "dont")) if counted else self.build["state"].lower()
        return f"{shown} {self.took_s:.1f} s"


class System:
    """A server, one agent with two slots, and the builds of two users."""

    def __init__(self, folder, user):
        self.folder, self.user = folder, user
        self.central = server(folder)
        self.agent = agent(folder, "tester", self.central.grpc, "--sandbox", "required", *own_bridge(), slots=2, heap="256m")
        if user:
            os.chmod(folder, 0o711)
            self.agent.directory.mkdir()
            owner = pwd.getpwnam(user)
            os.chown(self.agent.directory, owner.pw_uid, owner.pw_gid)
            self.agent.command = ["setpriv", f"--reuid={user}", f"--regid={owner.pw_gid}", "--clear-groups", *self.agent.command]
        self.api, self.victim = self.central.api, None

    def __enter__(self):
        self.central.start()
        self.agent.start()
        self.victim = Victim(self.api)
        self.victim.learn(5)
        return self

    def __exit__(self, *_):
        self.agent.stop()
        self.central.stop()

    def agent_pid(self):
        return self.agent.process.pid

    def suite(self, archive, model):
        made = self.api.call("POST", "/api/v1/activities", archive, "application/zip")
        return self.api.post(f"/api/v1/activities/{made['id']}/models/{model}/suites", {})["id"]

    def compile_runtime(self):
        """The first C++ build of an agent compiles the runtime of test applications, whose time belongs to no trial."""
        build = self.api.build(self.suite(activities.archive(activities.files_of("ir-sensor-cpp")), MODEL))
        await_true(lambda: self.api.state(build) in OVER, RUNTIME_LIMIT_S, 0.5)


def components(system, table, languages, chosen, short):
    ports = (system.central.http, system.central.grpc)
    for language in languages:
        if language == "cpp":
            system.compile_runtime()
        for kind in activities.SHORT[language] if short else activities.kinds(language):
            if chosen and kind not in chosen:
                continue
            suite = system.suite(activities.hostile_component(language, kind, ports), "Hostile")
            trial = Trial(system, suite).run(kind in activities.NEVER_GREEN)
            report(table, f"{language} {kind}", trial)


def report(table, name, trial):
    what = f"{name}: {'; '.join(trial.faults)}" if trial.faults else name
    ratio = f", other {trial.victim_s / trial.system.victim.usual_s:.1f}x" if trial.victim_s else ""
    table.row(what, trial.summary() + ratio, "contained", not trial.faults)


def overlaid(files):
    return activities.archive({**activities.files_of("ir-sensor"), **files})


def worlds(system, table, chosen):
    from worlds import worlds as listed

    for name, files, expected in listed():
        if chosen and name not in chosen:
            continue
        build_or_refusal(system, table, f"world {name}", overlaid(files), expected)


def models(system, table, chosen):
    from models import models as listed

    for name, content, expected in listed():
        if chosen and name not in chosen:
            continue
        build_or_refusal(system, table, f"model {name}", overlaid({"GetInfraredData.xml": content}), expected)


def build_or_refusal(system, table, name, archive, expected):
    began = time.monotonic()
    try:
        suite = system.suite(archive, MODEL)
    except Refused as refused:
        in_time = time.monotonic() - began < HOSTILE_LIMIT_S
        fault = " 500 " in f"{refused} "
        table.row(name, f"rejected {time.monotonic() - began:.1f} s", "contained", in_time and not fault)
        return
    # A valid world or model may pass, but must not affect others.
    report(table, f"{name} ({expected})", Trial(system, suite).run(never_green=expected != "survived"))


def uploads(system, table, chosen):
    from uploads import uploads as listed

    for name, content_type, content, expected in listed():
        if chosen and name not in chosen:
            continue
        faults, answer = [], {}
        other = threading.Thread(target=lambda: answer.update(status=send(system, content_type, content)), daemon=True)
        other.start()
        took, passed, _ = system.victim.build()
        other.join(HOSTILE_LIMIT_S)
        if passed != CASES:
            faults.append(f"another user's build: {passed} PASS")
        if system.victim.is_delayed(took):
            faults.append(f"another user's build took {took:.1f} s")
        if answer.get("status") not in expected:
            faults.append(f"answered {answer.get('status')}, not one of {sorted(expected)}")
        table.row(f"upload {name}" + "".join(f": {f}" for f in faults), str(answer.get("status")), "contained", not faults)


def send(system, content_type, content):
    """Upload an activity; return the status, or 0 if the server closed the connection."""
    connection = http.client.HTTPConnection("127.0.0.1", system.central.http, timeout=HOSTILE_LIMIT_S)
    headers = {"Authorization": f"Bearer {TOKEN}", "Content-Type": content_type}
    body = content() if callable(content) else content
    try:
        try:
            connection.request("POST", "/api/v1/activities", body, headers, encode_chunked=not isinstance(body, bytes))
        except OSError:
            # The server may have answered before the whole body was sent.
            answer = http.client.HTTPResponse(connection.sock, method="POST")
            answer.begin()
            return answer.status
        return connection.getresponse().status
    except (OSError, http.client.HTTPException):
        return 0
    finally:
        connection.close()


def afterwards(system, table):
    """Check the agent at the end."""
    table.row("peak memory of the agent, MiB", watch.peak_mib(system.agent_pid()), f"<= {AGENT_MIB}",
              watch.peak_mib(system.agent_pid()) <= AGENT_MIB)
    small = await_true(lambda: watch.disk_mib(system.agent.directory) <= DISK_MIB, 60, 2)
    table.row("disk of the agent, MiB", watch.disk_mib(system.agent.directory), f"<= {DISK_MIB}", small)
    system.agent.kill()
    began = time.monotonic()
    system.agent.start(limit_s=60)
    took = time.monotonic() - began
    table.row("restart of a killed agent, s", took, "<= 60", took <= 60)
    _, passed, _ = system.victim.build()
    table.row("PASS of another user's build afterwards", passed, CASES, passed == CASES)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--languages", default="java,cpp,python", help="languages of components, separated by commas")
    parser.add_argument("--only", default="components,worlds,models,uploads", help="tables to run, separated by commas")
    parser.add_argument("--kinds", default="", help="kinds to run, separated by commas; all by default")
    parser.add_argument("--user", default="", help="user that runs the agent; the current user by default")
    parser.add_argument("--short", action="store_true", help="run one attack per escape and limit")
    given = parser.parse_args()
    parts, chosen = given.only.split(","), set(filter(None, given.kinds.split(",")))
    table = Table("hostile")
    # Not /tmp, which components then see as a small file system without a limit of the number of files.
    with tempfile.TemporaryDirectory(prefix="sitaf-hostile-", dir="/var/tmp", ignore_cleanup_errors=True) as folder, ExitStack() as stack:
        system = System(Path(folder), given.user)
        try:
            stack.enter_context(system)
            table.row("usual time of another user's build, s", system.victim.usual_s, "", True)
            if "components" in parts:
                components(system, table, given.languages.split(","), chosen, given.short)
            if "worlds" in parts:
                worlds(system, table, chosen)
            if "models" in parts:
                models(system, table, chosen)
            if "uploads" in parts:
                uploads(system, table, chosen)
            afterwards(system, table)
        finally:
            if table.short or sys.exc_info()[0]:
                show(system.central, system.agent)
    # Delete deep folders that are left.
    subprocess.run(["rm", "-rf", folder], check=False)
    return table.end()


if __name__ == "__main__":
    sys.exit(main())
