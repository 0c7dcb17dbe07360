"""ROS 2 nodes: the examples, their faulty twins, and nodes of public packages, unchanged."""

import os
import shutil
import xml.etree.ElementTree as ElementTree
import zipfile
from pathlib import Path

import pytest
from needs import cpp

ROOT = Path(__file__).resolve().parents[2]
PACKAGES = ROOT.parent / "shared" / "ros2-packages"

needs_packages = pytest.mark.skipif(
    not PACKAGES.is_dir() and not os.environ.get("CI"), reason="../shared/ros2-packages is missing"
)


def results(sitaf, activity, folder):
    """Run an activity; the exit code, and each model's result without what differs between runs."""
    run = sitaf("run", activity, "--result", folder, "--no-coverage")
    found = {}
    for file in sorted(Path(folder).glob("*.xml")):
        result = ElementTree.parse(file).getroot()
        for case in result.iter("test_result"):
            for time in case.findall("processing_time"):
                case.remove(time)
        found[file.stem] = ElementTree.tostring(result.find("test_result_list"))
    return run, found


def element(name, kind, real_type, values=(), expected=None):
    abstract = {"string": "STRING", "boolean": "BOOLEAN"}.get(real_type, "NUMERIC")
    listed = "".join(f"<value>{value}</value>" for value in values)
    user = f"<user_value_list>{listed}</user_value_list>" if values else ""
    judged = f"<expected>{expected}</expected>" if expected is not None else ""
    return (
        f'<test_element abstract_type="{abstract}" real_type="{real_type}"><name>{name}</name><type>{kind}</type>'
        f"{user}{judged}</test_element>"
    )


def model(target, inputs=(), outputs=(), conditions=()):
    posts = "".join(f"<post_condition>{condition}</post_condition>" for condition in conditions)
    return (
        f"<test_model><name>Model</name><target {target}/><input_spec_list>{''.join(inputs)}</input_spec_list>"
        f"<output_spec_list>{''.join(outputs)}</output_spec_list>"
        f"<post_condition_spec_list>{posts}</post_condition_spec_list>"
        "<order_of_combinations>1</order_of_combinations></test_model>"
    )


def activity(folder, package, component, topics="{}", further="", text=""):
    """An activity with an unchanged package."""
    shutil.copytree(PACKAGES / package, folder / "src")
    (folder / "activity.yaml").write_text(
        f"name: public\ncomponent:\n  language: ros2-python\n  sources: src\n  {component}\n"
        f"topics: {topics}\n{further}models: [Model.xml]\n"
    )
    (folder / "Model.xml").write_text(text)
    return folder


@pytest.mark.parametrize(
    "example",
    [
        "velocity-mux-ros",
        pytest.param("wall-stop-ros-cpp", marks=cpp),
        pytest.param("wall-stop-ros", marks=pytest.mark.long),
    ],
)
def test_an_example_passes_with_the_same_result_each_time(sitaf, tmp_path, example):
    first, once = results(sitaf, f"examples/{example}", tmp_path / "once")
    again, twice = results(sitaf, f"examples/{example}", tmp_path / "twice")
    assert first.returncode == again.returncode == 0, first.stdout + first.stderr
    assert once == twice
    assert once


@pytest.mark.parametrize(
    ("example", "message"),
    [
        ("velocity-mux-ros-faulty", "a command that is too old is not passed on"),
        pytest.param("wall-stop-ros-faulty", "keeps its distance: broken at", marks=pytest.mark.long),
        pytest.param("wall-stop-ros-cpp-faulty", "keeps its distance: broken at", marks=cpp),
    ],
)
def test_a_faulty_node_fails(sitaf, example, message):
    run = sitaf("run", f"examples/{example}")
    assert run.returncode == 1, run.stdout + run.stderr
    assert message in run.stdout
    assert " 0 ERROR" in run.stdout


@cpp
def test_a_sanitizer_finds_what_no_result_shows(sitaf, tmp_path):
    passing = sitaf("run", "examples/mean-range-ros-cpp")
    assert passing.returncode == 0, passing.stdout + passing.stderr
    assert "Mean: 24 cases, 24 PASS" in passing.stdout
    assert "coverage of the component: 100.0 % of statements" in passing.stdout
    faulty = shutil.copytree(ROOT / "examples/mean-range-ros-cpp-faulty", tmp_path / "faulty")
    source = faulty / "src/mean_range/src/mean_range.cpp"
    line = next(i for i, text in enumerate(source.read_text().splitlines(), 1) if "ranges[i]" in text)
    run = sitaf("run", faulty)
    assert run.returncode == 1, run.stdout + run.stderr
    assert f"ERROR in 24 cases: heap-buffer-overflow at mean_range.cpp:{line}" in run.stdout
    # The same sources are compiled again, with the other check.
    profile = faulty / "activity.yaml"
    profile.write_text(profile.read_text().replace("[address, undefined]", "[undefined]"))
    source.write_text(source.read_text().replace("std::size_t count = 0;", "int count = 2147483647;"))
    run = sitaf("run", faulty)
    assert run.returncode == 1, run.stdout + run.stderr
    assert (
        "signed integer overflow: 2147483647 + 1 cannot be represented in type 'int' at mean_range.cpp:" in run.stdout
    )
    assert "heap-buffer-overflow" not in run.stdout


def test_modules_see_the_environment_when_they_are_imported(sitaf, tmp_path):
    source = tmp_path / "activity/src/robot/robot"
    source.mkdir(parents=True)
    (source.parent / "package.xml").write_text("<package><name>robot</name></package>")
    (source / "__init__.py").write_text("")
    (source / "node.py").write_text(
        "import os\nfrom rclpy.node import Node\nfrom std_msgs.msg import String\n"
        "ROBOT = f\"{os.environ['ROBOT']} {os.environ['ROS_DISTRO']}\"\n\n\n"
        "class Robot(Node):\n    def __init__(self):\n        super().__init__('robot')\n"
        "        self.out = self.create_publisher(String, 'robot', 10)\n"
        "        self.create_timer(0.5, lambda: self.out.publish(String(data=ROBOT)))\n"
    )
    (tmp_path / "activity/activity.yaml").write_text(
        "name: robot\ncomponent:\n  language: ros2-python\n  sources: src/robot\n  class: robot.node:Robot\n"
        "  environment: {ROBOT: small}\ntopics: {/robot: output.robot}\nmodels: [Model.xml]\n"
    )
    output = element("robot.data", "OUT", "string", expected="'small jazzy'")
    (tmp_path / "activity/Model.xml").write_text(
        model('interface="topics" method="publish" run_for="1"', outputs=[output])
    )
    run = sitaf("run", tmp_path / "activity")
    assert run.returncode == 0, run.stdout + run.stderr
    assert "1 PASS" in run.stdout


@cpp
def test_a_crash_names_the_callback(sitaf, tmp_path):
    source = tmp_path / "activity/src/robot/src"
    source.mkdir(parents=True)
    (source.parent / "package.xml").write_text("<package><name>robot</name></package>")
    (source / "node.cpp").write_text(
        "#include <rclcpp/rclcpp.hpp>\n#include <std_msgs/msg/string.hpp>\nusing std_msgs::msg::String;\n"
        "class Robot : public rclcpp::Node {\npublic:\n  Robot() : Node(\"robot\") {\n"
        '    in_ = create_subscription<String>("name", 1, [](String::SharedPtr m) {\n'
        '      if (m->data == "none") {volatile char * nothing = nullptr; *nothing = 1;}});\n  }\n'
        "private:\n  rclcpp::Subscription<String>::SharedPtr in_;\n};\n"
        "int main(int argc, char ** argv) {\n  rclcpp::init(argc, argv);\n"
        "  rclcpp::spin(std::make_shared<Robot>());\n}\n"
    )
    (tmp_path / "activity/activity.yaml").write_text(
        "name: robot\ncomponent:\n  language: ros2-cpp\n  sources: src/robot\n  main: src/node.cpp\n"
        "topics: {/name: input.name}\nmodels: [Model.xml]\n"
    )
    name = element("name.data", "TDI", "string", values=("some", "none"))
    (tmp_path / "activity/Model.xml").write_text(model('interface="topics" method="publish"', inputs=[name]))
    run = sitaf("run", tmp_path / "activity")
    assert run.returncode == 1, run.stdout + run.stderr
    assert "by the signal SIGSEGV, in the callback of the subscription /name" in run.stdout
    assert "1 PASS, 0 FAIL, 1 ERROR" in run.stdout


def test_a_node_holds_no_channel_of_results(sitaf, tmp_path):
    shutil.copytree(ROOT / "examples/velocity-mux-ros", tmp_path / "hostile")
    node = tmp_path / "hostile/src/velocity_mux/velocity_mux/mux.py"
    node.write_text(
        """
import fcntl, os, stat
from sitaf_runtime.suite import channel

for fd in range(3, 1024):
    try:
        written = stat.S_ISFIFO(os.fstat(fd).st_mode) and fcntl.fcntl(fd, fcntl.F_GETFL) & os.O_ACCMODE
    except OSError:
        continue
    if written:
        raise RuntimeError(f"descriptor {fd} is a pipe for results")
if channel._held:
    raise RuntimeError("the token is known")
"""
        + node.read_text()
    )
    run = sitaf("run", tmp_path / "hostile", "--no-coverage")
    assert run.returncode == 0, run.stdout + run.stderr


@cpp
def test_a_package_of_a_component_does_not_run_when_a_node_is_compiled(sitaf, tmp_path):
    """The compiled runtime of nodes is shared by all builds."""
    activity = tmp_path / "hostile"
    shutil.copytree(ROOT / "examples/wall-stop-ros-cpp", activity)
    info = "evil-1.0.dist-info/"
    with zipfile.ZipFile(activity / "evil-1.0-py3-none-any.whl", "w") as wheel:
        wheel.writestr(
            "evil.pth",
            "import os, sys; 'sitaf_ros.cpp.build' in sys.orig_argv and os.write(2, b'BREACH') and os._exit(9)\n",
        )
        wheel.writestr(info + "METADATA", "Metadata-Version: 2.1\nName: evil\nVersion: 1.0\n")
        wheel.writestr(info + "WHEEL", "Wheel-Version: 1.0\nRoot-Is-Purelib: true\nTag: py3-none-any\n")
        wheel.writestr(info + "RECORD", "")
    profile = activity / "activity.yaml"
    profile.write_text(profile.read_text() + "libraries: [evil-1.0-py3-none-any.whl]\n")
    run = sitaf("run", activity, "--case", "1")
    assert run.returncode == 0, run.stdout + run.stderr


def test_a_node_cannot_open_the_channel_of_results_of_its_driver(sitaf, tmp_path):
    shutil.copytree(ROOT / "examples/velocity-mux-ros", tmp_path / "hostile")
    node = tmp_path / "hostile/src/velocity_mux/velocity_mux/mux.py"
    node.write_text(
        """
import glob, os

own = f"/proc/{os.getpid()}/"
opened = []
for link in glob.glob("/proc/[0-9]*/fd/*") + [f"/proc/{os.getppid()}/fd/{fd}" for fd in range(3, 256)]:
    try:
        if not link.startswith(own) and os.readlink(link).startswith("pipe:"):
            opened.append(os.open(link, os.O_WRONLY | os.O_NONBLOCK))
    except OSError:
        continue
try:
    opened.append(os.open(f"/proc/{os.getppid()}/mem", os.O_RDWR))
except OSError:
    pass
if opened:
    raise RuntimeError(f"opened {len(opened)} files of other processes")
"""
        + node.read_text()
    )
    run = sitaf("run", tmp_path / "hostile", "--no-coverage")
    assert run.returncode == 0, run.stdout + run.stderr


def test_an_exception_in_a_callback_is_an_error(sitaf, tmp_path):
    copy = shutil.copytree(ROOT / "examples" / "velocity-mux-ros", tmp_path / "copy")
    node = copy / "src" / "velocity_mux" / "velocity_mux" / "mux.py"
    node.write_text(node.read_text().replace("now = self.get_clock().now()", "now = self.no_clock()"))
    run = sitaf("run", copy, "--model", "Mux")
    assert run.returncode == 1, run.stdout + run.stderr
    assert "on_timer" in run.stdout
    assert "no_clock" in run.stdout
    assert " 14 ERROR" in run.stdout


@needs_packages
def test_a_public_talker_publishes_each_second(sitaf, tmp_path):
    folder = activity(
        tmp_path / "talker",
        "demos/demo_nodes_py",
        "class: demo_nodes_py.topics.talker:Talker",
        "{/chatter: output.chatter}",
        text=model(
            'interface="topics" method="publish" run_for="3.5"',
            outputs=[
                element("chatter.data", "OUT", "string", expected='"Hello World: 2"'),
                element("chatter.count", "OUT", "int", expected="3"),
            ],
            conditions=['messages["chatter"][1].t == 2.0'],
        ),
    )
    run = sitaf("run", folder)
    assert run.returncode == 0, run.stdout + run.stderr


@needs_packages
def test_a_public_service_runs_from_its_main_function(sitaf, tmp_path):
    folder = activity(
        tmp_path / "service",
        "demos/demo_nodes_py",
        "main: demo_nodes_py.services.add_two_ints_server:main",
        further="provided: [{type: example_interfaces/srv/AddTwoInts.srv, name: /add_two_ints}]\n",
        text=model(
            'interface="example_interfaces" method="AddTwoInts"',
            inputs=[element("a", "TDI", "int64", [2, -3]), element("b", "TDI", "int64", [5])],
            outputs=[element("return", "RETURN", "int64", expected="a + b")],
        ),
    )
    run = sitaf("run", folder)
    assert run.returncode == 0, run.stdout + run.stderr


@needs_packages
def test_a_public_action_server(sitaf, tmp_path):
    folder = activity(
        tmp_path / "action",
        "examples/rclpy/actions/minimal_action_server",
        "class: examples_rclpy_minimal_action_server.server:MinimalActionServer",
        further="provided: [{type: example_interfaces/action/Fibonacci.action, name: /fibonacci}]\n",
        text=model(
            'interface="example_interfaces" method="Fibonacci"',
            inputs=[element("order", "TDI", "int", [4])],
            outputs=[element("return[4]", "RETURN", "int", expected="3")],
        ),
    )
    run = sitaf("run", folder)
    assert run.returncode == 0, run.stdout + run.stderr


@needs_packages
def test_a_public_client_gets_the_answers_of_the_case(sitaf, tmp_path):
    folder = activity(
        tmp_path / "client",
        "examples/rclpy/services/minimal_client",
        "main: examples_rclpy_minimal_client.client_async_member_function:main",
        further="required: [example_interfaces/srv/AddTwoInts.srv]\n",
        text=model(
            'interface="topics" method="publish" settle="0.1" run_for="1"',
            inputs=[element("example_interfaces.AddTwoInts", "TDTS", "int64", [42])],
            conditions=[
                'calls["example_interfaces.AddTwoInts"].size() == 1 &amp;&amp; calls["example_interfaces.AddTwoInts"][0].a == 41'
            ],
        ),
    )
    run = sitaf("run", folder)
    assert run.returncode == 0, run.stdout + run.stderr
