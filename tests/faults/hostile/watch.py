"""What is looked at from outside while and after hostile code runs."""

import os
import subprocess
from pathlib import Path

FIRST_USER, LAST_USER = 840_000, 1_100_000
WAITING = (b"sitaf_bridge", b"multiprocessing", b"compiler-java")
CANARY = "sitaf-hostile-canary"
PLACES = ("/etc", "/usr", "/usr/lib", "/opt", "/var/tmp", "/root", "/home", "/")


def peak_mib(pid):
    """The most memory that a process has had."""
    for line in Path(f"/proc/{pid}/status").read_text().splitlines():
        if line.startswith("VmHWM"):
            return int(line.split()[1]) // 1024
    return 0


def survivors(mark):
    """Processes that hostile code left: those of a sandbox's users, or with a word of its own in their command lines."""
    found = []
    for entry in Path("/proc").glob("[0-9]*"):
        try:
            owner = entry.stat().st_uid
            line = (entry / "cmdline").read_bytes()
        except OSError:
            continue
        # A simulation and a compiler that wait for the next build have sandboxes and users of their own, too.
        ours = b"sitaf-hostile-orphan" in line or (FIRST_USER <= owner < LAST_USER and mark.encode() in line)
        if ours and not any(waiting in line for waiting in WAITING):
            found.append(f"{entry.name} {line[:80]!r}")
    return found


def canaries():
    """Files that hostile code made in folders of this machine."""
    return [place for place in PLACES if os.path.lexists(os.path.join(place, CANARY))]


def disk_mib(folder):
    """What a folder holds, whatever its shape."""
    done = subprocess.run(["du", "-sm", str(folder)], capture_output=True, text=True, check=False)
    return int(done.stdout.split()[0]) if done.stdout else 0
