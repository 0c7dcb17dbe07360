"""Checks of the machine while and after hostile code runs."""

import os
import subprocess
from pathlib import Path

FIRST_USER, LAST_USER = 840_000, 1_100_000
WAITING = (b"sitaf_bridge", b"multiprocessing", b"compiler-java")
CANARY = "sitaf-hostile-canary"
PLACES = ("/etc", "/usr", "/usr/lib", "/opt", "/var/tmp", "/root", "/home", "/")


def peak_mib(pid):
    """The peak memory of a process."""
    for line in Path(f"/proc/{pid}/status").read_text().splitlines():
        if line.startswith("VmHWM"):
            return int(line.split()[1]) // 1024
    return 0


def survivors(mark):
    """Processes that hostile code left: those of sandbox users, or with a mark in their command lines."""
    found = []
    for entry in Path("/proc").glob("[0-9]*"):
        try:
            owner = entry.stat().st_uid
            line = (entry / "cmdline").read_bytes()
        except OSError:
            continue
        # A simulation and a compiler that were started ahead also run as sandbox users.
        ours = b"sitaf-hostile-orphan" in line or (FIRST_USER <= owner < LAST_USER and mark.encode() in line)
        if ours and not any(waiting in line for waiting in WAITING):
            found.append(f"{entry.name} {line[:80]!r}")
    return found


def canaries():
    """Files that hostile code created on this machine."""
    return [place for place in PLACES if os.path.lexists(os.path.join(place, CANARY))]


def disk_mib(folder):
    """The size of a folder of any shape."""
    done = subprocess.run(["du", "-sm", str(folder)], capture_output=True, text=True, check=False)
    return int(done.stdout.split()[0]) if done.stdout else 0
