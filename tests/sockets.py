"""Waits for servers on Unix sockets."""

import socket
import time

LIMIT_S = 60


def await_listener(path, process):
    """Wait until a process accepts connections; the file of a socket is there a moment earlier."""
    end = time.monotonic() + LIMIT_S
    while True:
        with socket.socket(socket.AF_UNIX) as client:
            try:
                client.connect(str(path))
                return
            except OSError:
                pass
        assert process.poll() is None, f"{process.args} ended with exit code {process.returncode}"
        assert time.monotonic() < end, f"{process.args} does not listen"
        time.sleep(0.02)
