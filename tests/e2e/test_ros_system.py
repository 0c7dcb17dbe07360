"""Nodes that run with an installed ROS 2 (`--ros system`, "ros2-4-output"): verdicts as with the API that comes along."""

import os
import re
import shutil
import xml.etree.ElementTree as ElementTree

import pytest
from needs import cpp

SYSTEM = ("--ros", "system", "--no-coverage")


@pytest.fixture(scope="module", autouse=True)
def ros(sitaf):
    if "CI" not in os.environ and not (sitaf.root / ".sitaf" / "ros-jazzy" / "stamp").exists():
        pytest.skip("needs ./sitaf doctor --install ros")
    installed = sitaf("doctor", "--install", "ros")
    assert installed.returncode == 0, installed.stderr


def verdicts(file):
    """The verdict, the actual outputs and the messages of each case."""
    cases = ElementTree.parse(file).getroot().iter("test_result")
    return {case.get("no"): ElementTree.tostring(compared(case)) for case in cases}


def compared(case):
    # An installed ROS 2 does not tell which callbacks were never called.
    for differing in case.findall("processing_time") + case.findall("note"):
        case.remove(differing)
    return case


def test_a_node_gives_the_same_results_with_an_installed_ros(sitaf, tmp_path):
    example = ("run", "examples/velocity-mux-ros", "--model", "Mux", "--result")
    included = sitaf(*example, tmp_path / "included.xml", "--no-coverage")
    system = sitaf(*example, tmp_path / "system.xml", *SYSTEM)
    assert included.returncode == system.returncode == 0, system.stdout + system.stderr
    assert verdicts(tmp_path / "system.xml") == verdicts(tmp_path / "included.xml") != {}


def test_the_faulty_twin_fails_in_the_same_cases(sitaf):
    run = sitaf("run", "examples/velocity-mux-ros-faulty", "--model", "Timeout", "--case", "3-5", *SYSTEM)
    assert run.returncode == 1, run.stdout + run.stderr
    violation = "post-condition violated: a command that is too old is not passed on"
    assert re.search(rf"FAIL in 2 cases[:;].*{violation}", run.stdout), run.stdout
    assert "Timeout: 3 cases, 1 PASS, 2 FAIL" in run.stdout


def test_a_node_senses_and_drives_in_a_simulation(sitaf):
    run = sitaf("run", "examples/wall-stop-ros", "--case", "1-2", *SYSTEM)
    assert run.returncode == 0, run.stdout + run.stderr
    assert "Stop: 2 cases, 2 PASS" in run.stdout


def test_what_only_ros_itself_does_is_found(sitaf):
    # rclpy ends a managed node that is asked by number for a transition which its state does not allow.
    run = sitaf("run", "examples/lifecycle-node", *SYSTEM)
    assert run.returncode == 1, run.stdout + run.stderr
    assert "RCLError: Failed to trigger lifecycle state machine transition" in run.stdout
    assert "0 FAIL" in run.stdout


@cpp
def test_a_cpp_node_is_compiled_with_the_installed_ros(sitaf, tmp_path):
    # The ROS 2 of PyPI has no rclcpp, so this package uses what is below it.
    shutil.copytree(sitaf.root / "tba-agent/runtime-python/tests/packages/rcl_echo", tmp_path / "src")
    (tmp_path / "activity.yaml").write_text(
        "name: echo\ncomponent:\n  language: ros2-cpp\n  sources: src\n  main: src/echo.cpp\ntopics:\n"
        "  /in: {with: input.said, type: std_msgs/msg/String}\n"
        "  /out: {with: output.heard, type: std_msgs/msg/String}\nmodels: [Model.xml]\n"
    )
    (tmp_path / "Model.xml").write_text(
        '<test_model><name>Model</name><target interface="topics" method="publish" settle="0.1" run_for="0.1"/>'
        '<input_spec_list><test_element abstract_type="STRING" real_type="string"><name>said.data</name><type>TDI</type>'
        "<user_value_list><value>a</value><value>b</value></user_value_list></test_element></input_spec_list>"
        '<output_spec_list><test_element abstract_type="STRING" real_type="string"><name>heard.data</name>'
        "<type>OUT</type></test_element></output_spec_list><post_condition_spec_list>"
        '<post_condition>messages["heard"][0].data == "heard " + said.data</post_condition></post_condition_spec_list>'
        "<order_of_combinations>1</order_of_combinations></test_model>"
    )
    run = sitaf("run", tmp_path, "--ros", "system")
    assert run.returncode == 0, run.stdout + run.stderr
    assert ", 0 FAIL, 0 ERROR, 0 DONT" in run.stdout
    assert "coverage of the component: " in run.stdout


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("examples/ir-sensor", "--ros", "system"), "the component is no ROS 2 node"),
        (("examples/velocity-mux-ros", "--ros", "humble"), "must be included or system, not 'humble'"),
    ],
)
def test_what_cannot_run_is_refused_at_once(sitaf, arguments, message):
    run = sitaf("run", *arguments)
    assert run.returncode == 2
    assert message in run.stderr
    assert run.stdout == ""


def test_a_machine_without_ros_says_what_is_missing(sitaf, tmp_path):
    (tmp_path / "lib").mkdir()
    run = sitaf("run", "examples/velocity-mux-ros", *SYSTEM, env={"AMENT_PREFIX_PATH": str(tmp_path)})
    assert run.returncode == 2
    assert f"the ROS 2 in {tmp_path} has no rclpy for Python" in run.stderr
