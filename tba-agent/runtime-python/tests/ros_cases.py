"""Runs a ROS node in a process of its own, as the test application does."""

import functools
import os
import pickle
import tempfile
import traceback
from pathlib import Path

import pytest

from sitaf_ros import RosApplication, RosSettings, TypeFolders
from sitaf_ros.export import export

S = 1_000_000_000


@functools.cache
def types_folder():
    pytest.importorskip("rosbags", reason="message types need rosbags, which is in the extra `dev`")
    folder = Path(tempfile.mkdtemp(prefix="sitaf-ros-types-"))
    export(folder)
    return folder


class Case:
    """What a test's script gets: the system, and what the node logged as (level, text)."""

    def __init__(self, system, log):
        self.system, self.log = system, log

    @property
    def texts(self):
        return [text for _, text in self.log]

    def run(self, seconds):
        self.system.run_until(round(seconds * S))

    def heard(self, topic, type_name, field="data"):
        got = []
        self.system.subscribe(topic, type_name, lambda m, t: got.append((t / S, getattr(m, field))))
        return got


def run_case(folder, entry, script, package="", share=None, types=(), **settings):
    """Load the entry and run `script(case)` in a forked process; return what the script returns."""
    types_folder()
    read, write = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            answer = (True, _in_child(folder, entry, script, package, share, types, settings))
        except BaseException:
            answer = (False, traceback.format_exc())
        with os.fdopen(write, "wb") as pipe:
            pickle.dump(answer, pipe)
        os._exit(0)
    os.close(write)
    with os.fdopen(read, "rb") as pipe:
        data = pipe.read()
    os.waitpid(child, 0)
    assert data, "the process of the node ended without an answer"
    well, answer = pickle.loads(data)
    assert well, answer
    return answer


def _in_child(folder, entry, script, package, share, types, settings):
    log = []
    application = RosApplication(TypeFolders([*types, types_folder()]), package, [Path(folder)], share)
    application.load(entry)
    system = application.start(RosSettings(log=lambda level, name, text, t: log.append((level, text)), **settings))
    result = script(Case(system, log))
    system.end()
    return result


def node(tmp_path, text, script, entry="followed:Probe", **settings):
    """Run a node from its text: the module `followed`."""
    (tmp_path / "followed.py").write_text(text, encoding="utf-8")
    return run_case(tmp_path, entry, script, **settings)
