"""Runs work on hostile input in a separate process, which cannot open files and may crash without consequences.

The process is forked, with all modules loaded, from a process that does nothing but fork. It gives up the right to open
files, and limits its memory and its processor time.
"""

import gc
import importlib
import json
import multiprocessing
import os
import pickle
import re
import resource
import select
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import traceback
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from multiprocessing.connection import Connection
from typing import Any, BinaryIO, NoReturn

CPU_SECONDS = 30
WALL_SECONDS = 60.0
# Lower than the memory limit of a build's bridge, so that the error names the world as the cause.
MEMORY_BYTES = 1536 * 1024**2
_WORD = re.compile(rb"([a-z]{1,20})\n")
# Limits the number of concurrent processes.
RUNNING = threading.BoundedSemaphore(2)
# What the work needs, loaded once before the forks.
_MODULES = ("sitaf_bridge.world.compiler", "sitaf_bridge.world.robots.xacro_text")
# A fresh interpreter with the module path of this one.
_PROGRAM = (
    "import json, sys; sys.path[:] = json.loads(sys.argv[2]); "
    "from sitaf_bridge.world.isolation import serve; serve(int(sys.argv[1]))"
)
_EXIT_SECONDS = 0.5
_REPORT_SECONDS = 5.0


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
        answer, slow, exitcode = _run(pickle.dumps((work, tuple(arguments))))
    word = None if answer is None else _WORD.match(answer)
    if answer is not None and word is not None:
        return Answer(word[1].decode(), answer[word.end() :])
    if slow or exitcode == -signal.SIGXCPU:
        raise TooSlow
    raise Crashed(_ending(exitcode))


def prepare() -> None:
    """Fork the process that forks from this one, which has loaded all modules.

    Only before this process has a second thread. Without it, the first work waits for a new interpreter.
    """
    _forking.fork()


def _run(request: bytes) -> tuple[bytes | None, bool, int | None]:
    """The answer, whether the time is over, and the exit code if it is known."""
    receiver, sender = multiprocessing.Pipe(duplex=False)
    control, keeper = socket.socketpair()
    answer: bytes | None = None
    slow = False
    code = b""
    with receiver, control:
        with sender, keeper:
            requests = _forking.begin([sender.fileno(), keeper.fileno()])
        # The process may end before it has read everything.
        with suppress(OSError), requests:
            requests.write(request)
        try:
            if receiver.poll(WALL_SECONDS):
                answer = receiver.recv_bytes(MEMORY_BYTES)
            else:
                slow = True
        except (EOFError, OSError):
            pass
        if not slow:
            control.settimeout(_REPORT_SECONDS if answer is None else _EXIT_SECONDS)
            with suppress(OSError):
                code = control.recv(16)
    # The keeper now ends the process if it is still running.
    return answer, slow, int(code) if code else None


class _Forking:
    """The process that forks, seen from this one."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._requests: socket.socket | None = None
        self._process: subprocess.Popen[bytes] | None = None

    def fork(self) -> None:
        with self._lock:
            ours, theirs = socket.socketpair()
            if os.fork() == 0:
                ours.close()
                _serve(theirs)
            theirs.close()
            self._requests = ours

    def begin(self, ends: Sequence[int]) -> BinaryIO:
        """Start a process that gets these descriptors; returns the file for its request."""
        reader, writer = os.pipe()
        try:
            with self._lock:
                if self._requests is not None:
                    try:
                        socket.send_fds(self._requests, [b"1"], [reader, *ends])
                        return os.fdopen(writer, "wb")
                    except OSError:
                        self._requests.close()  # it was killed, for example because the machine had no memory
                self._requests = self._start()
                socket.send_fds(self._requests, [b"1"], [reader, *ends])
                return os.fdopen(writer, "wb")
        finally:
            os.close(reader)

    def _start(self) -> socket.socket:
        ours, theirs = socket.socketpair()
        with theirs:
            command = [sys.executable, "-c", _PROGRAM, str(theirs.fileno()), json.dumps(sys.path)]
            self._process = subprocess.Popen(  # noqa: S603  # our own interpreter
                command, stdin=subprocess.DEVNULL, pass_fds=(theirs.fileno(),)
            )
        return ours


_forking = _Forking()


def serve(descriptor: int) -> NoReturn:
    """Fork for each request at a socket until its other end is closed."""
    for module in _MODULES:
        importlib.import_module(module)
    _serve(socket.socket(fileno=descriptor))


def _serve(requests: socket.socket) -> NoReturn:
    # Ctrl-C in a terminal is for the program that started this one.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)
    gc.freeze()
    while True:
        message, descriptors, _, _ = socket.recv_fds(requests, 1, 3)
        if not message:
            os._exit(0)
        if os.fork() == 0:
            requests.close()
            _keep(*descriptors)
        for descriptor in descriptors:
            os.close(descriptor)


def _keep(request: int, answer: int, control: int) -> NoReturn:
    """Fork the process for the work, end it when `control` is closed, and report its exit code there."""
    signal.signal(signal.SIGCHLD, signal.SIG_DFL)
    child = os.fork()
    if child == 0:
        os.close(control)
        _work(request, answer)
    os.close(request)
    os.close(answer)
    with suppress(OSError):
        waiting = select.poll()
        waiting.register(os.pidfd_open(child), select.POLLIN)
        waiting.register(control, select.POLLIN)
        if all(ready == control for ready, _ in waiting.poll()):
            os.kill(child, signal.SIGKILL)
        _, status = os.waitpid(child, 0)
        os.write(control, str(os.waitstatus_to_exitcode(status)).encode())
    os._exit(0)


def _work(request: int, answer: int) -> NoReturn:
    code = 1
    try:
        with os.fdopen(request, "rb") as requests:
            work, arguments = pickle.load(requests)  # noqa: S301  # from the process that started this one
        _child(Connection(answer, readable=False), work, arguments)
        code = 0
    except BrokenPipeError:
        pass  # nobody waits for the answer
    except BaseException:
        traceback.print_exc()
    os._exit(code)


def _ending(code: int | None) -> str:
    if code is None:
        return "an unknown exit code"
    if code < 0:
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
