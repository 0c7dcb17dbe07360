"""C++ nodes with an installed ROS 2: their build, their process and their end.

The ROS 2 of PyPI has no rclcpp, so this node uses what is below it, the C library rcl, with the C++ types of messages.
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from sitaf_ros import NodeError
from tests.ros_cases import installed_ros, run_installed, types_folder

pytestmark = [
    pytest.mark.skipif(installed_ros() is None, reason="needs ./sitaf doctor --install ros"),
    pytest.mark.skipif(not shutil.which("g++"), reason="needs ./sitaf doctor --install cpp"),
    pytest.mark.slow,
]
API = "../runtime-cpp/ros"

PACKAGE = Path(__file__).with_name("packages") / "rcl_echo"


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    folder = tmp_path_factory.mktemp("echo")
    (folder / "scratch").mkdir()
    (folder / "into").mkdir()
    ros = installed_ros()
    command = [sys.executable, "-m", "sitaf_ros.cpp.build", "node", "--api", API, "--interfaces", str(types_folder())]
    command += ["--into", str(folder / "into"), "--runtime", str(folder), "--scratch", str(folder / "scratch")]
    command += ["--package", str(PACKAGE), "--entry", "src/echo.cpp", "--main"]
    command += ["--ros", ros["AMENT_PREFIX_PATH"]]
    built = subprocess.run(command, capture_output=True, text=True, env={**os.environ, "CXX": "g++"}, check=False)
    assert built.returncode == 0, built.stdout + built.stderr
    return folder / "into" / "libnode.so"


def talk(case):
    got = case.heard("/heard", "std_msgs/msg/String")
    case.run(0.01)
    case.system.publish("/in", "std_msgs/msg/String", {"data": "hello"})
    case.run(0.02)
    case.system.publish("/in", "std_msgs/msg/String", {"data": "again"})
    case.run(0.03)
    return got


def test_a_node_answers_at_the_time_of_the_message(library):
    answered = run_installed(library.parent, str(library), talk, remap={"out": "/heard"})
    assert answered == [(0.01, "heard hello"), (0.02, "heard again")]


def stop(case):
    case.run(0.01)
    case.system.publish("/in", "std_msgs/msg/String", {"data": "stop"})
    try:
        case.run(0.5)
    except NodeError as e:
        return str(e)
    return None


def test_what_a_node_throws_is_the_error_of_the_case(library):
    assert run_installed(library.parent, str(library), stop) == "main: CppNodeFailedError: stop requested"
