"""Commands that a person uses in a terminal: their output is read while they run."""

import os
import re
import subprocess
import threading
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
LIMIT_S = 300


class Terminal:
    """A command whose output is read while it runs."""

    def __init__(self, *arguments, command=None):
        self.process = subprocess.Popen(
            command or [str(ROOT / "sitaf"), *map(str, arguments)],
            cwd=ROOT,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            start_new_session=True,
        )
        self.output = ""
        self._seen = 0
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def _read(self):
        while data := os.read(self.process.stdout.fileno(), 65536):
            self.output += data.decode(errors="replace")

    def expect(self, pattern):
        """Wait until further output matches."""
        end = time.monotonic() + LIMIT_S
        while time.monotonic() < end:
            running = self._reader.is_alive()
            if found := re.compile(pattern).search(self.output, self._seen):
                self._seen = found.end()
                return found
            if not running:
                break
            time.sleep(0.02)
        raise AssertionError(
            f"no output matches {pattern!r} after character {self._seen}:\n{self.output}"
        )

    def send(self, line):
        self.process.stdin.write(f"{line}\n".encode())
        self.process.stdin.flush()

    def end(self):
        """Close the input and wait for the end; return the exit code."""
        if not self.process.stdin.closed:
            self.process.stdin.close()
        code = self.process.wait(LIMIT_S)
        self._reader.join(LIMIT_S)
        return code
