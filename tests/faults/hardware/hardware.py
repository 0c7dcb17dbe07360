"""Builds with real devices under kills.

1. The provider is killed again and again while cases run: no case may be FAIL or ERROR.
2. A component sends 1,000 commands beyond the envelope: none may reach the provider.
3. The component, the simulator, the hardware guard or the command dies, or the guard hangs: the devices must stop within
   100 ms (plus the time that a loaded machine needs, which --grace-s names).
"""

import argparse
import contextlib
import os
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
HOME = Path(os.environ["SITAF_HOME"])
STOP_S = 0.1
COUNTS = re.compile(r"(\d+) cases, (\d+) PASS, (\d+) FAIL, (\d+) ERROR, (\d+) DONT")


class Provider:
    """A provider process that is restarted when it was killed."""

    def __init__(self, folder):
        self.address = f"unix:{folder}/p.sock"
        self.log = folder / "log"
        self.log.touch()
        self.kills = 0
        self.start()

    def start(self):
        Path(self.address[5:]).unlink(missing_ok=True)
        command = [sys.executable, HERE / "provider.py", self.address, self.log]
        self.process = subprocess.Popen(command, stdout=subprocess.DEVNULL)
        while not Path(self.address[5:]).exists():
            time.sleep(0.01)

    def kill(self):
        self.process.send_signal(signal.SIGKILL)
        self.process.wait()
        self.kills += 1
        self.start()

    def entries(self):
        """What the devices did: (what, value, time on the monotonic clock)."""
        words = [line.split() for line in self.log.read_text().splitlines() if line.endswith(tuple("0123456789"))]
        return [(what, float(value), float(at)) for what, value, at in words]

    def close(self):
        self.process.terminate()
        self.process.wait()


def sitaf(*arguments):
    """Starts a command in a process group of its own."""
    launcher = os.environ.get("SITAF_LAUNCHER", str(HOME / "sitaf"))
    return subprocess.Popen(
        [launcher, *map(str, arguments)], cwd=HOME, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT
    )


def below(pid):
    """The processes below a process, with their command lines."""
    parents = {}
    for entry in Path("/proc").iterdir():
        if entry.name.isdecimal():
            try:
                stat = (entry / "stat").read_text()
                words = (entry / "cmdline").read_bytes().decode("utf-8", "replace").replace("\0", " ")
            except OSError:
                continue
            parents[int(entry.name)] = (int(stat.rpartition(")")[2].split()[1]), words)
    found, wanted = {}, {pid}
    while wanted:
        children = {p for p, (parent, _) in parents.items() if parent in wanted and p not in found}
        found.update({p: parents[p][1] for p in children})
        wanted = children
    return found


def infrared(folder, provider):
    """The infrared example with a sensor behind the provider; each case takes a little time."""
    activity = folder / "ir"
    shutil.copytree(HOME / "examples" / "ir-sensor", activity)
    profile = activity / "activity.yaml"
    text = re.sub(r"(?m)^limits:.*\n", "", profile.read_text())
    entry = f'{{backend: provider, address: "{provider.address}", max_age_s: 5}}'
    hardware = "".join(f"  ir{n}: {entry}\n" for n in (1, 2, 3))
    profile.write_text(f"{text}hardware:\n{hardware}limits: {{jitter_ms: 60000, case_wall_s: 60}}\n")
    component = next((activity / "component").rglob("InfraredSensor.java"))
    source = component.read_text()
    call = re.search(r"public \w+ GetInfraredData\([^)]*\)[^{]*\{", source)
    wait = " try { Thread.sleep(80); } catch (InterruptedException e) { }"
    component.write_text(source[: call.end()] + wait + source[call.end() :])
    return activity


def killed_providers(folder, kills):
    provider, total, problems = Provider(folder), [0] * 5, []
    activity = infrared(folder, provider)
    dice = random.Random(1)
    try:
        while provider.kills < kills:
            seen = len(provider.entries())
            build = sitaf("run", activity, "--no-coverage")
            ended = threading.Event()

            def kill(seen=seen, ended=ended):
                # The first reads belong to the first case.
                while len(provider.entries()) <= seen and not ended.wait(0.05):
                    pass
                while not ended.wait(dice.uniform(0.05, 0.4)):
                    provider.kill()

            thread = threading.Thread(target=kill)
            thread.start()
            output = build.communicate()[0]
            ended.set()
            thread.join()
            found = COUNTS.search(output)
            if found is None:
                # The build could not begin: a failed attempt.
                if "does not answer" not in output and "provider" not in output:
                    problems.append(output[-2000:])
                continue
            total = [a + int(b) for a, b in zip(total, found.groups(), strict=True)]
    finally:
        provider.close()
    cases, passed, failed, errors, not_run = total
    print(
        f"{provider.kills} kills of the provider: {cases} cases, {passed} PASS, {failed} FAIL, {errors} ERROR, {not_run} DONT"
    )
    return not problems and failed == errors == 0 and not_run > 0


def commander(folder, provider, what):
    activity = folder / f"commander{what}"
    shutil.copytree(HERE / "activity", activity)
    for file, old, new in (("activity.yaml", "ADDRESS", provider.address), ("Command.xml", "WHAT", str(what))):
        (activity / file).write_text((activity / file).read_text().replace(old, new))
    return activity


def envelope(folder):
    provider = Provider(folder)
    try:
        output = sitaf("run", commander(folder, provider, 0), "--no-coverage").communicate()[0]
        reached = [value for what, value, _ in provider.entries() if what == "command" and abs(value) > 1.5]
    finally:
        provider.close()
    found = COUNTS.search(output)
    refused = found is not None and found[2] == "1"
    print(
        f"1,000 commands beyond the envelope: {'all' if refused else 'not all'} refused, {len(reached)} reached the provider"
    )
    if not refused:
        print(output[-2000:])
    return refused and not reached


VICTIMS = {
    "simulator": ("sitaf_bridge serve", signal.SIGKILL),
    "guard": ("sitaf_bridge guard", signal.SIGKILL),
    "guard that hangs": ("sitaf_bridge guard", signal.SIGSTOP),
    "command": ("", signal.SIGKILL),
}


def death(folder, victim):
    """The time from a death to the stop of the devices."""
    for attempt in range(3):
        place = folder / str(attempt)
        place.mkdir()
        took = stopped_after(place, victim)
        if took is not None:
            return took
        print(f"the devices stopped before the death of the {victim}, because the machine is busy")
    return float("inf")


def stopped_after(folder, victim):
    """The time from a death to the stop of the devices; None if they had stopped before it."""
    provider = Provider(folder)
    try:
        what = 1 if victim == "component" else 2
        build = sitaf("run", commander(folder, provider, what), "--no-coverage")
        while not any(entry[0] == "command" for entry in provider.entries()):
            if build.poll() is not None:
                print(build.stdout.read()[-2000:])
                return float("inf")
            time.sleep(0.02)
        if victim == "component":
            build.communicate()
            entries = provider.entries()
            first = next(i for i, entry in enumerate(entries) if entry[0] == "command")
            stop = next(i for i in range(first, len(entries)) if entries[i][0] == "stop")
            return entries[stop][2] - entries[stop - 1][2]
        time.sleep(0.3)
        words, number = VICTIMS[victim]
        processes = below(build.pid)
        pids = (
            [p for p, line in processes.items() if words in line and "bwrap" not in line.split(" ")[0]] if words else []
        )
        pids = (
            pids
            or [p for p, line in {build.pid: "", **processes}.items() if not words and "cli.jar" in line]
            or [build.pid]
        )
        seen = len(provider.entries())
        began = time.monotonic()
        for pid in pids:
            # A simulator has a second process, which may end with the first.
            with contextlib.suppress(ProcessLookupError):
                os.kill(pid, number)
        while time.monotonic() < began + 10:
            stops = [at for name, _, at in provider.entries()[seen:] if name == "stop" and at >= began]
            if stops:
                return stops[0] - began
            time.sleep(0.005)
        # A machine that is too busy for the heartbeat stops them, too.
        entries = provider.entries()
        first = next(i for i, entry in enumerate(entries) if entry[0] == "command")
        stopped = any(name == "stop" for name, _, _ in entries[first:])
        return None if stopped else float("inf")
    finally:
        for pid in below(build.pid):
            try:
                os.kill(pid, signal.SIGKILL)
            except OSError:
                continue
        build.kill()
        build.wait()
        provider.close()


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--kills", type=int, default=200, help="of the provider")
    options.add_argument("--deaths", type=int, default=5, help="of each kind")
    options.add_argument("--grace-s", type=float, default=0.0, help="added to the limit of a safe stop")
    chosen = options.parse_args()
    held = True
    with tempfile.TemporaryDirectory(prefix="sitaf-h") as folder:
        count = iter(range(10_000))

        def place():
            new = Path(folder) / str(next(count))
            new.mkdir()
            return new

        if chosen.kills:
            held &= killed_providers(place(), chosen.kills)
        held &= envelope(place())
        for victim in ("component", *VICTIMS):
            took = [death(place(), victim) for _ in range(chosen.deaths)]
            if took:
                shown = ", ".join(f"{seconds * 1000:.0f}" for seconds in took)
                print(f"safe stop after the death of the {victim}: {shown} ms (limit {STOP_S * 1000:g})", flush=True)
                held &= max(took) <= STOP_S + chosen.grace_s
    print(f"hardware: {'held' if held else 'BROKEN'}")
    return 0 if held else 1


if __name__ == "__main__":
    sys.exit(main())
