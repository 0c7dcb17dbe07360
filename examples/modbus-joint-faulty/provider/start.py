"""Starts the servo drive and the provider; stops them with Ctrl-C.

usage: start.py [ADDRESS]
"""

import signal
import socket
import subprocess
import sys
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent


def main(address: str) -> int:
    """Run until the provider ends."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    processes = [subprocess.Popen([sys.executable, HERE / "servo.py", str(port)])]
    try:
        while processes[0].poll() is None and not accepts(port):
            time.sleep(0.05)
        processes.append(subprocess.Popen([sys.executable, HERE / "modbus_joint.py", str(port), address]))
        return processes[-1].wait()
    finally:
        for process in reversed(processes):
            process.terminate()
            process.wait()


def accepts(port: int) -> bool:
    """Whether the drive accepts connections."""
    with socket.socket() as tried:
        return tried.connect_ex(("127.0.0.1", port)) == 0


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(0))
    try:
        sys.exit(main(sys.argv[1] if len(sys.argv) > 1 else "unix:/tmp/sitaf-modbus-joint.sock"))
    except KeyboardInterrupt:
        sys.exit(0)
