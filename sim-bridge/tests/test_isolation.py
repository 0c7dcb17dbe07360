"""The process for hostile input has no power over the process that reads its answer."""

import gc
import os
import pickle
from multiprocessing.connection import Connection

import pytest

from sitaf_bridge.world.isolation import Crashed, isolated

pytestmark = pytest.mark.slow


class Hostile:
    """Makes a folder where it is unpickled."""

    def __init__(self, folder: str) -> None:
        self.folder = folder

    def __reduce__(self) -> tuple[object, ...]:
        return os.mkdir, (self.folder,)


def answers(word: str, content: bytes) -> tuple[str, bytes]:
    return word, content


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


@pytest.mark.parametrize("sent", ["object", "no word", "nothing"])
def test_another_answer_is_a_crash(tmp_path, sent: str) -> None:
    folder = tmp_path / "made"
    with pytest.raises(Crashed):
        isolated(takes_over, (str(folder), sent))
    assert not folder.exists()
