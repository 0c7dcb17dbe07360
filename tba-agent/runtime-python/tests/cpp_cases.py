"""Builds C++ nodes and runs them as the test application does; the runtime of nodes is built once a session.

SITAF_ROS2_SANITIZE names sanitizers for all of them; their libraries must be loaded before Python.
"""

import functools
import hashlib
import os
import pickle
import shutil
import subprocess
import sys
import tempfile
import traceback
from pathlib import Path

import pytest

from sitaf_ros import RosSettings, TypeFolders
from sitaf_ros.cpp.application import CppApplication
from tests.ros_cases import Case, types_folder

API = Path(__file__).resolve().parents[2] / "runtime-cpp" / "ros"
SOURCES = Path(__file__).resolve().parents[1] / "src"


def build(*arguments):
    """Run a build; the finished process."""
    command = [sys.executable, "-m", "sitaf_ros.cpp.build", *map(str, arguments), "--api", API]
    command += ["--interfaces", types_folder()]
    environment = {**os.environ, "PYTHONPATH": str(SOURCES)}
    return subprocess.run(command, capture_output=True, text=True, env=environment, check=False)


@functools.cache
def runtime():
    """The compiled runtime, kept between sessions by its sources."""
    if shutil.which("g++") is None and not os.environ.get("CXX"):
        pytest.skip("there is no C++ compiler")
    digest = hashlib.sha256()
    files = [f for f in API.rglob("*") if f.is_file()]
    files += (SOURCES / "sitaf_ros" / "cpp").glob("*.py")
    for file in sorted(files):
        digest.update(str(file).encode() + file.read_bytes())
    folder = Path(tempfile.gettempdir()) / f"sitaf-cpp-nodes-{os.getuid()}-{digest.hexdigest()[:16]}"
    if not (folder / "complete").is_file():
        folder.mkdir(exist_ok=True)
        done = build("runtime", "--into", folder)
        assert done.returncode == 0, done.stdout + done.stderr
        (folder / "complete").touch()
    return folder


def build_node(package, entry, into, is_main=True, *further):
    """Build a node; the finished process."""
    scratch = into / "scratch"
    scratch.mkdir(parents=True, exist_ok=True)
    options = ["--into", into, "--runtime", runtime(), "--scratch", scratch, "--package", package, "--entry", entry]
    if sanitizers := os.environ.get("SITAF_ROS2_SANITIZE", "").split():
        further = (*further, "--sanitize", *sanitizers)
    return build("node", *options, *(["--main"] if is_main else []), *further)


def run_node(library, script, **settings):
    """Run `script(case)` with a built node in a forked process; return what the script returns."""
    read, write = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            answer = (True, _in_child(library, script, settings))
        except BaseException:
            answer = (False, traceback.format_exc())
        with os.fdopen(write, "wb") as pipe:
            pickle.dump(answer, pipe)
        os._exit(0)
    os.close(write)
    with os.fdopen(read, "rb") as pipe:
        data = pipe.read()
    _, status = os.waitpid(child, 0)
    assert data, f"the process of the node ended without an answer: {status}"
    well, answer = pickle.loads(data)
    assert well, answer
    return answer


def _in_child(library, script, settings):
    log = []
    application = CppApplication(TypeFolders([types_folder()]))
    application.load(str(library))
    system = application.start(RosSettings(log=lambda level, name, text, t: log.append((level, text)), **settings))
    result = script(Case(system, log))
    system.end()
    return result


def node(folder, text, script, entry="Probe", **settings):
    """Build and run a node from its text."""
    package = folder / "package"
    package.mkdir(exist_ok=True)
    (package / "package.xml").write_text("<package><name>probe</name></package>")
    (package / "probe.cpp").write_text(text)
    done = build_node(package, entry, folder / "built", is_main=entry.endswith(".cpp"))
    assert done.returncode == 0, done.stdout + done.stderr
    return run_node(folder / "built" / "libnode.so", script, **settings)
