"""The process for hostile input has no power over the process that reads its answer."""

import gc
import os
import pickle
import signal
import subprocess
import sys
import time
from multiprocessing.connection import Connection
from pathlib import Path

import pytest

from sitaf_bridge.world import isolation
from sitaf_bridge.world.isolation import Crashed, TooSlow, isolated

pytestmark = pytest.mark.slow


class Hostile:
    """Makes a folder where it is unpickled."""

    def __init__(self, folder: str) -> None:
        self.folder = folder

    def __reduce__(self) -> tuple[object, ...]:
        return os.mkdir, (self.folder,)


def answers(word: str, content: bytes) -> tuple[str, bytes]:
    return word, content


def ends_with(signal_number: int) -> tuple[str, bytes]:
    os.kill(os.getpid(), signal_number)
    signal.pause()
    raise AssertionError


def opens(path: str) -> tuple[str, bytes]:
    try:
        with open(path):
            return "opened", b""
    except OSError as error:
        return "refused", str(error).encode()


def waits(seconds: float) -> tuple[str, bytes]:
    time.sleep(seconds)
    return "waited", b""


def takes_over(folder: str, sent: str) -> tuple[str, bytes]:
    """What native code could do after an exploit: write anything into the connection."""
    ends = [each for each in gc.get_objects() if isinstance(each, Connection) and each.writable]
    content = {"object": pickle.dumps(Hostile(folder)), "no word": b"\n", "nothing": b""}[sent]
    for end in ends:
        end.send_bytes(content)
    os._exit(0)


def test_an_answer_is_a_word_and_bytes() -> None:
    content = b"\n\0" * 100_000
    answer = isolated(answers, ("refused", content))
    assert (answer.word, answer.content) == ("refused", content)


def test_the_process_cannot_open_files() -> None:
    assert isolated(opens, (__file__,)).word == "refused"


@pytest.mark.parametrize(
    ("number", "raised"), [(signal.SIGKILL, Crashed), (signal.SIGSEGV, Crashed), (signal.SIGXCPU, TooSlow)]
)
def test_the_end_by_a_signal_is_known(number: signal.Signals, raised: type[Exception]) -> None:
    with pytest.raises(raised) as failure:
        isolated(ends_with, (number,))
    if raised is Crashed:
        assert number.name in str(failure.value)


def test_a_process_that_takes_too_long_is_killed(monkeypatch) -> None:
    began = time.monotonic()
    with monkeypatch.context() as changed:
        changed.setattr(isolation, "WALL_SECONDS", 0.5)
        with pytest.raises(TooSlow):
            isolated(waits, (60,))
    assert time.monotonic() - began < 20
    # The next one is not affected.
    assert isolated(answers, ("refused", b"")).word == "refused"


def test_the_process_that_forks_is_replaced_when_it_was_killed() -> None:
    """In a process of its own, which forks it early as a server does."""
    program = f"""
import os, signal, sys
sys.path[:] = {sys.path!r}
from sitaf_bridge.world import isolation
from tests.test_isolation import answers
isolation.prepare()
children = open(f"/proc/self/task/{{os.getpid()}}/children").read().split()
print(len(children), isolation.isolated(answers, ("first", b"")).word)
os.kill(int(children[0]), signal.SIGKILL)
os.waitpid(int(children[0]), 0)
print(isolation.isolated(answers, ("second", b"")).word)
"""
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=60, check=False)
    assert run.stdout.splitlines() == ["1 first", "second"], run.stderr


def test_a_server_loads_its_modules_once(tmp_path) -> None:
    command = [sys.executable, "-m", "sitaf_bridge", "serve", "--listen", f"unix:{tmp_path}/s", "--stop-with-stdin"]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as server:
        assert server.stdout is not None
        assert server.stdout.readline().startswith("listening ")
        children = [Path(f"/proc/{child}") for child in children_of(server.pid)]
        programs = {(child / "cmdline").read_bytes() for child in children}
        maps = Path(f"/proc/{server.pid}/maps").read_text()
        assert len(children) == 1
        # A fork has the command line of its parent; a new interpreter would not.
        assert programs == {Path(f"/proc/{server.pid}/cmdline").read_bytes()}
        assert "glfw" not in maps
        server.communicate("")
        assert server.returncode == 0
    limit = time.monotonic() + 20
    while children[0].exists() and "State:\tZ" not in (children[0] / "status").read_text():
        assert time.monotonic() < limit
        time.sleep(0.01)


def children_of(pid: int) -> list[str]:
    return Path(f"/proc/{pid}/task/{pid}/children").read_text().split()


@pytest.mark.parametrize("sent", ["object", "no word", "nothing"])
def test_another_answer_is_a_crash(tmp_path, sent: str) -> None:
    folder = tmp_path / "made"
    with pytest.raises(Crashed):
        isolated(takes_over, (str(folder), sent))
    assert not folder.exists()
