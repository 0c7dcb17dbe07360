"""The domain of the node's process."""

import os
import signal
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from sitaf_runtime.ros import domain

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="Landlock is a part of Linux")


def in_child(attempt: Callable[[], None], *, confined: bool) -> str:
    """The name of the exception that an attempt raises in a forked process; empty for none."""
    reader, writer = os.pipe()
    child = os.fork()
    if child == 0:
        found = domain.enter() if confined else ""
        if not found:
            try:
                attempt()
            except OSError as e:
                found = type(e).__name__
        os.write(writer, found.encode())
        os._exit(0)
    os.close(writer)
    with os.fdopen(reader) as answer:
        found = answer.read()
    os.waitpid(child, 0)
    return found


@pytest.mark.parametrize(("confined", "expected"), [(False, ""), (True, "PermissionError")])
def test_a_pipe_of_the_parent_cannot_be_opened(confined, expected):
    ours, theirs = os.pipe()
    parent = os.getpid()

    def attempt():
        os.close(theirs)
        os.close(os.open(f"/proc/{parent}/fd/{theirs}", os.O_WRONLY))

    try:
        assert in_child(attempt, confined=confined) == expected
    finally:
        os.close(ours)
        os.close(theirs)


def test_the_memory_of_the_parent_cannot_be_opened():
    memory = f"/proc/{os.getpid()}/mem"
    assert in_child(lambda: os.close(os.open(memory, os.O_RDWR)), confined=False) == ""
    assert in_child(lambda: os.close(os.open(memory, os.O_RDWR)), confined=True) == "PermissionError"


def test_what_a_node_does_still_works(tmp_path: Path):
    for folder in ("a", "b"):
        (tmp_path / folder).mkdir()

    def attempt():
        (tmp_path / "a/file").write_text("x")
        os.rename(tmp_path / "a/file", tmp_path / "b/file")
        child = os.fork()
        if child == 0:
            signal.pause()
        os.close(os.open(f"/proc/{child}/environ", os.O_RDONLY))
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)

    assert in_child(attempt, confined=True) == ""
    assert (tmp_path / "b/file").read_text() == "x"
