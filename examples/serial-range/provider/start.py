"""Starts the instrument, a serial cable (socat) and the provider; stops them with Ctrl-C.

usage: start.py [ADDRESS]
"""

import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent


def main(address: str) -> int:
    """Run until the provider ends."""
    if shutil.which("socat") is None:
        print("socat, which is the serial cable, is missing; apt-get install socat", file=sys.stderr)
        return 1
    with tempfile.TemporaryDirectory() as folder:
        ends = [Path(folder) / name for name in ("instrument", "computer")]
        processes = [subprocess.Popen(["socat", *(f"pty,raw,echo=0,link={end}" for end in ends)])]
        try:
            while not all(end.exists() for end in ends):
                if processes[0].poll() is not None:
                    return 1
                time.sleep(0.01)
            for script, arguments in (("instrument.py", ends[:1]), ("serial_range.py", [ends[1], address])):
                processes.append(subprocess.Popen([sys.executable, HERE / script, *arguments]))
            return processes[-1].wait()
        finally:
            for process in reversed(processes):
                process.terminate()
                process.wait()


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(0))
    try:
        sys.exit(main(sys.argv[1] if len(sys.argv) > 1 else "unix:/tmp/sitaf-serial-range.sock"))
    except KeyboardInterrupt:
        sys.exit(0)
