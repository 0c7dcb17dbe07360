"""What the compiler adds to C++ nodes: counters of lines, and the options of sanitizers."""

import json
import shutil
import subprocess

import pytest

from sitaf_ros.cpp.instrumentation import PRELOADED, Instrumentation, InstrumentationError
from tests.cpp_cases import build_node, run_node

NODE = """#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
class Probe : public rclcpp::Node
{
public:
  Probe() : Node("probe")
  {
    subscription_ = create_subscription<std_msgs::msg::String>("in", 10, [this](const std_msgs::msg::String & m) {
          if (m.data == "never") {
            RCLCPP_INFO(get_logger(), "not executed");
          }
          RCLCPP_INFO(get_logger(), "executed");
        });
  }
  rclcpp::Subscription<std_msgs::msg::String>::SharedPtr subscription_;
};
"""
STRING = "std_msgs/msg/String"


def executions(folder, data):
    """How often each line of the node was executed in all processes."""
    notes = folder / "built" / "coverage"
    [recorded] = data.rglob("*.gcda")
    shutil.copy(recorded, notes)
    command = ["gcov", "-j", "-t", recorded.name]
    text = subprocess.run(command, cwd=notes, capture_output=True, text=True, check=True).stdout
    # Of other files only what the compiler has put into functions of the node is there.
    lines = {file["file"]: file["lines"] for file in json.loads(text)["files"]}["activity/src/probe.cpp"]
    return {line["line_number"]: line["count"] for line in lines}


@pytest.mark.slow
def test_the_lines_of_a_node_are_counted_in_all_its_processes(tmp_path, monkeypatch):
    package = tmp_path / "package"
    package.mkdir()
    (package / "package.xml").write_text("<package><name>probe</name></package>")
    (package / "probe.cpp").write_text(NODE)
    done = build_node(package, "Probe", tmp_path / "built", False, "--coverage", "--recorded-as", "activity/src")
    assert done.returncode == 0, done.stdout + done.stderr
    monkeypatch.setenv("GCOV_PREFIX", str(tmp_path / "data"))

    def script(case):
        case.run(0.1)
        for _ in range(3):
            case.system.publish("in", STRING, {"data": "hello"})
            case.run(0.1)
        case.system.application.save_coverage()

    for _ in range(2):
        run_node(tmp_path / "built" / "libnode.so", script)
    counts = executions(tmp_path, tmp_path / "data")
    lines = NODE.splitlines()
    assert counts[next(n for n, line in enumerate(lines, 1) if "never" in line)] == 6
    assert counts[next(n for n, line in enumerate(lines, 1) if "not executed" in line)] == 0


def test_a_compiler_without_the_library_of_a_sanitizer_is_reported(tmp_path):
    compiler = tmp_path / "cxx"
    compiler.write_text("#!/bin/sh\necho libasan.so\n")
    compiler.chmod(0o755)
    with pytest.raises(InstrumentationError, match=r"cxx has no libasan\.so; install"):
        Instrumentation(str(compiler), coverage=False, sanitizers=("address",)).prepare(tmp_path)
    Instrumentation(str(compiler), coverage=False, sanitizers=("undefined",)).prepare(tmp_path)
    assert not (tmp_path / PRELOADED).exists()


def test_clang_does_not_count_lines(tmp_path):
    compiler = tmp_path / "cxx"
    compiler.write_text("#!/bin/sh\necho clang version 14\n")
    compiler.chmod(0o755)
    instrumentation = Instrumentation(str(compiler), coverage=True, sanitizers=("undefined",))
    assert instrumentation.of_library() == [*instrumentation.of_unit(tmp_path), "-shared-libsan"]
    assert not any("coverage" in option for option in instrumentation.of_library())
