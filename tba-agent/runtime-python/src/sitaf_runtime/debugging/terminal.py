"""Connects a terminal to the pdb of a test application: `python -m sitaf_runtime.debugging.terminal SOCKET`."""

import os
import signal
import socket
import struct
import sys
import threading

_CREDENTIALS = struct.Struct("3i")
_CHUNK = 65536


def _print_until_end(connection: socket.socket) -> None:
    try:
        while data := connection.recv(_CHUNK):
            sys.stdout.buffer.write(data)
            sys.stdout.buffer.flush()
    except OSError:
        pass  # The test application has ended.
    finally:
        # The main thread may wait for a line.
        os._exit(0)


def _peer(connection: socket.socket) -> int:
    """The process id of the test application."""
    credentials = connection.getsockopt(socket.SOL_SOCKET, socket.SO_PEERCRED, _CREDENTIALS.size)
    return _CREDENTIALS.unpack(credentials)[0]


def main() -> None:
    """Pass lines to pdb and its answers to the terminal until either ends."""
    with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as connection:
        connection.connect(sys.argv[1])
        printing = threading.Thread(target=_print_until_end, args=(connection,))
        printing.start()
        debugged = _peer(connection)
        signal.signal(signal.SIGINT, lambda *_: os.kill(debugged, signal.SIGINT))
        try:
            for line in sys.stdin:
                connection.sendall(line.encode())
            connection.shutdown(socket.SHUT_WR)
        except OSError:
            pass  # The test application has ended.
        printing.join()


if __name__ == "__main__":
    main()
