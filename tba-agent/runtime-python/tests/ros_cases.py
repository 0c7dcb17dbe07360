"""Runs a ROS node in a process of its own, as the test application does."""

import base64
import functools
import os
import pickle
import subprocess
import sys
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


def installed_ros():
    """The environment of a process with an installed ROS 2; None without one."""
    given = os.environ.get("AMENT_PREFIX_PATH", "").split(":")[0]
    prefix = Path(given) if given else Path(__file__).parents[3] / ".sitaf" / "ros-jazzy"
    modules = prefix / "lib" / f"python{sys.version_info.major}.{sys.version_info.minor}" / "site-packages"
    if not (modules / "rclpy").is_dir():
        return None
    libraries = [prefix / "lib", *sorted(modules.glob("ros_*.libs"))]
    return {
        **os.environ,
        "AMENT_PREFIX_PATH": str(prefix),
        "SITAF_ROS_MODULES": str(modules),
        "LD_LIBRARY_PATH": ":".join(map(str, libraries)),
        "PYTHONPATH": str(Path(__file__).parents[1]),
    }


def run_installed(folder, entry, script, **settings):
    """Run as `run_case`, with the installed ROS 2; `script` is a function of a module."""
    package, types = settings.pop("package", ""), [*settings.pop("types", ()), types_folder()]
    given = pickle.dumps((folder, entry, script, package, settings, types))
    command = [sys.executable, "-c", "from tests.ros_cases import serve_installed; serve_installed()"]
    ended = subprocess.run(command, input=given, env=installed_ros(), capture_output=True, timeout=120)
    assert ended.returncode == 0, ended.stderr.decode()
    well, answer = pickle.loads(base64.b64decode(ended.stdout.splitlines()[-1]))
    assert well, answer
    return answer


def serve_installed():
    from sitaf_ros.installed.application import InstalledApplication
    from sitaf_ros.installed.cpp_application import InstalledCppApplication

    folder, entry, script, package, settings, types = pickle.load(sys.stdin.buffer)
    kind = InstalledCppApplication if str(entry).endswith(".so") else InstalledApplication
    application = kind(TypeFolders(types), package, [Path(folder)], None)
    application.load(entry)

    def drive():
        try:
            system = application.start(RosSettings(**settings))
            answer = (True, script(Case(system, [])))
            system.end()
        except BaseException:
            answer = (False, traceback.format_exc())
        print(f"\n{base64.b64encode(pickle.dumps(answer)).decode()}", flush=True)
        os._exit(0)

    application.run_case(drive, lambda: os._exit(1))


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
