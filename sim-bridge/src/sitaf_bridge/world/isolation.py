"""Runs work on hostile input in a separate process, which cannot open files and may crash without consequences.

The process is forked with all modules loaded. It gives up the right to open files, and limits its memory and its
processor time.
"""

import multiprocessing
import os
import re
import resource
import signal
import tempfile
import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from multiprocessing.connection import Connection
from typing import Any

CPU_SECONDS = 30
WALL_SECONDS = 60.0
# Lower than the memory limit of a build's bridge, so that the error names the world as the cause.
MEMORY_BYTES = 1536 * 1024**2
_WORD = re.compile(rb"([a-z]{1,20})\n")
# Limits the number of concurrent processes.
RUNNING = threading.BoundedSemaphore(2)

# The fork server imports these modules, and with them MuJoCo, once; each child is a cheap fork of it.
_processes = multiprocessing.get_context("forkserver")
_processes.set_forkserver_preload(["sitaf_bridge.world.compiler", "sitaf_bridge.world.robots.xacro_text"])


class TooSlow(Exception):
    """The work exceeds its limit of time."""


class Crashed(Exception):
    """The process ended without an answer; the message says how."""


@dataclass(frozen=True)
class Answer:
    """What the work returned: a word and the content that belongs to it."""

    word: str
    content: bytes

    @property
    def text(self) -> str:
        """The content as text."""
        return self.content.decode("utf-8", "replace")


def isolated(work: Callable[..., tuple[str, bytes]], arguments: Sequence[Any]) -> Answer:
    """Run `work`, a function of a module, with arguments that can be pickled. Raises TooSlow, Crashed.

    Hostile input may have taken control of the process that answers, so its answer is bytes: an object that it pickled
    could run code here.
    """
    with RUNNING:
        receiver, sender = _processes.Pipe(duplex=False)
        process = _processes.Process(target=_child, args=(sender, work, tuple(arguments)), daemon=True)
        process.start()
        sender.close()
        answer: bytes | None = None
        slow = False
        try:
            if receiver.poll(WALL_SECONDS):
                answer = receiver.recv_bytes(MEMORY_BYTES)
            else:
                slow = True
        except (EOFError, OSError):
            pass
        finally:
            receiver.close()
            process.join(0.5)
            if process.is_alive():
                process.kill()
                process.join()
    word = None if answer is None else _WORD.match(answer)
    if answer is not None and word is not None:
        return Answer(word[1].decode(), answer[word.end() :])
    if slow or process.exitcode == -signal.SIGXCPU:
        raise TooSlow
    raise Crashed(_ending(process.exitcode))


def _ending(code: int | None) -> str:
    if code is not None and code < 0:
        return f"{signal.Signals(-code).name} (too large, or a defect of MuJoCo)"
    return f"exit code {code}"


def _child(answer: Connection, work: Callable[..., tuple[str, bytes]], arguments: tuple[Any, ...]) -> None:
    """Run in the forked process."""
    with tempfile.TemporaryDirectory() as empty:
        os.chdir(empty)
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_CPU, (CPU_SECONDS, CPU_SECONDS + 1))
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY_BYTES, MEMORY_BYTES))
    # From here on the process cannot open any file, socket or device.
    resource.setrlimit(resource.RLIMIT_NOFILE, (0, 0))
    word, content = work(*arguments)
    answer.send_bytes(word.encode() + b"\n" + content)
