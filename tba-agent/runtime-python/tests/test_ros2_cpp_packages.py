"""C++ nodes of the public packages in ros2-packages run unchanged: their topics, services and so on work.

The whole table takes some minutes; SITAF_ROS2_CPP_NODES=all runs it, otherwise only a sample is run.
"""

import os
import re

import pytest

from tests.cpp_cases import build_node, run_node
from tests.test_ros2_packages import (
    FIBONACCI,
    PACKAGES,
    STRING,
    answers,
    executes,
    talks,
)

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(
        not PACKAGES.is_dir(), reason=f"the public packages are not in {PACKAGES}; set SITAF_ROS2_PACKAGES"
    ),
]
ADD = "example_interfaces/srv/AddTwoInts"
EXAMPLE, DEMO = "examples/rclcpp", "demos/demo_nodes_cpp"


def listens(topic, log):
    def script(case):
        case.run(0.5)
        case.system.publish(topic, STRING, {"data": "hello"})
        case.run(2)
        assert any(log in text for text in case.texts), case.texts

    return script


def takes(topic):
    """What the node prints is not in its log, but its callback is called."""

    def script(case):
        case.run(0.5)
        case.system.publish(topic, STRING, {"data": "hello"})
        case.run(1)
        assert case.system.report().uncalled_callbacks == ()

    return script


def logs(*texts, seconds=10):
    """What the node logs, and no failure."""

    def script(case):
        case.run(seconds)
        for text in texts:
            assert any(text in line for line in case.texts), case.texts

    return script


def asks(log):
    def script(case):
        asked = []
        case.system.serve_service("/add_two_ints", ADD, lambda r: asked.append((r.a, r.b)) or {"sum": r.a + r.b})
        case.run(5)
        assert asked
        assert any(log in text for text in case.texts), case.texts

    return script


def asks_for_goal(log):
    def script(case):
        from sitaf_ros import ActionAnswer

        def answer(goal):
            numbers = [0, 1]
            while len(numbers) < goal.order:
                numbers.append(numbers[-1] + numbers[-2])
            feedback = [(0.5, {"sequence": numbers[:3]}), (3, {"sequence": numbers[:4]})]
            return ActionAnswer(feedback=feedback, after_s=4, result={"sequence": numbers})

        case.system.serve_action("/fibonacci", FIBONACCI, answer)
        case.run(20)
        assert any(log in text for text in case.texts), case.texts

    return script


def publishes(topic, type_name, count, seconds):
    def script(case):
        got = []
        case.system.subscribe(topic, type_name, lambda m, t: got.append(m))
        case.run(seconds)
        assert len(got) == count

    return script


def changes_states(case):
    got = case.heard("/lifecycle_chatter", STRING)
    case.run(0)
    states = []
    for time, transition in ((1, 1), (3.5, 3), (6.2, 4), (8, 2), (9, 5)):
        call = case.system.call_service(
            "/lc_talker/change_state", "lifecycle_msgs/srv/ChangeState", {"transition": {"id": transition}}
        )
        case.run(max(time, case.system.now_ns / 1e9 + 2.1))
        state = case.system.call_service("/lc_talker/get_state", "lifecycle_msgs/srv/GetState", {})
        case.run(case.system.now_ns / 1e9 + 0.1)
        states.append((call.response.success, state.response.current_state.label))
    assert [label for _, label in states] == ["inactive", "active", "inactive", "unconfigured", "finalized"]
    assert all(ok for ok, _ in states)
    assert got


def sets_parameters(case):
    case.run(0)
    new = {"parameters": [{"name": "param1", "value": {"type": 3, "double_value": 2.5}}]}
    base, kind = "/set_param_callback_node", "rcl_interfaces/srv"
    done = case.system.call_service(f"{base}/set_parameters", f"{kind}/SetParameters", new)
    got = case.system.call_service(f"{base}/get_parameters", f"{kind}/GetParameters", {"names": ["param1", "param2"]})
    case.run(1)
    assert [(r.successful, r.reason) for r in done.response.results] == [(True, "")]
    assert [v.double_value for v in got.response.values] == [2.5, 4.0]


def watches_parameters(case):
    case.run(1)
    new = {"parameters": [{"name": "an_int_param", "value": {"type": 2, "integer_value": 21}}]}
    case.system.call_service("/this_node/set_parameters", "rcl_interfaces/srv/SetParameters", new)
    case.run(2)
    assert 'cb1: Received an update to parameter "an_int_param" of type integer: "21"' in case.texts, case.texts


CLIENT, SERVER = f"{EXAMPLE}/actions/minimal_action_client", f"{EXAMPLE}/actions/minimal_action_server"
PUBLISHER, SUBSCRIBER = f"{EXAMPLE}/topics/minimal_publisher", f"{EXAMPLE}/topics/minimal_subscriber"
HALVES = [0.5, 1, 1.5, 2]
COMPONENT = "demo_nodes_cpp::"
NODES = {
    f"{PUBLISHER}:lambda.cpp": talks("/topic", HALVES, "Hello, world! "),
    f"{PUBLISHER}:member_function.cpp": talks("/topic", HALVES, "Hello, world! "),
    f"{PUBLISHER}:member_function_with_type_adapter.cpp": talks("/topic", HALVES, "Hello, world! "),
    f"{PUBLISHER}:not_composable.cpp": talks("/topic", [0, *HALVES], "Hello, world! "),
    f"{PUBLISHER}:member_function_with_wait_for_all_acked.cpp": talks("/topic", HALVES, "Hello, world! "),
    f"{SUBSCRIBER}:lambda.cpp": listens("/topic", "I heard: 'hello'"),
    f"{SUBSCRIBER}:member_function.cpp": listens("/topic", "I heard: 'hello'"),
    f"{SUBSCRIBER}:member_function_with_type_adapter.cpp": listens("/topic", "I heard: 'hello'"),
    f"{SUBSCRIBER}:member_function_with_topic_statistics.cpp": listens("/topic", "I heard: 'hello'"),
    f"{SUBSCRIBER}:not_composable.cpp": listens("/topic", "I heard: 'hello'"),
    f"{EXAMPLE}/timers/minimal_timer:lambda.cpp": logs("Hello, world!"),
    f"{EXAMPLE}/timers/minimal_timer:member_function.cpp": logs("Hello, world!"),
    f"{EXAMPLE}/services/minimal_service:main.cpp": answers,
    f"{EXAMPLE}/services/minimal_client:main.cpp": asks("result of 41 + 1 = 42"),
    f"{CLIENT}:member_functions.cpp": asks_for_goal("Result received"),
    f"{CLIENT}:not_composable.cpp": asks_for_goal("result received"),
    f"{CLIENT}:not_composable_with_feedback.cpp": asks_for_goal("result received"),
    f"{SERVER}:member_functions.cpp": executes(),
    f"{SERVER}:not_composable.cpp": executes(),
    f"{EXAMPLE}/executors/multithreaded_executor:multithreaded_executor.cpp": logs("Heard"),
    f"{EXAMPLE}/composition/minimal_composition:PublisherNode": talks("/topic", HALVES, "Hello, world! "),
    f"{EXAMPLE}/composition/minimal_composition:SubscriberNode": listens("/topic", "hello"),
    f"{EXAMPLE}/wait_set:src/wait_set.cpp": logs("wait-set waiting failed because wait-set is empty"),
    f"{DEMO}:{COMPONENT}Talker": talks("/chatter", [1, 2, 3], "Hello World: ", 1),
    f"{DEMO}:{COMPONENT}LoanedMessageTalker": logs("Publishing"),
    f"{DEMO}:{COMPONENT}SerializedMessageTalker": talks("/chatter", [1, 2, 3], "Hello World:", 1),
    f"{DEMO}:{COMPONENT}Listener": listens("/chatter", "I heard: [hello]"),
    f"{DEMO}:{COMPONENT}ListenerBestEffort": listens("/chatter", "I heard: [hello]"),
    f"{DEMO}:{COMPONENT}SerializedMessageListener": takes("/chatter"),
    f"{DEMO}:{COMPONENT}ServerNode": answers,
    f"{DEMO}:{COMPONENT}ClientNode": asks("Result of add_two_ints: 5"),
    f"{DEMO}:src/services/add_two_ints_client.cpp": asks("Result of add_two_ints: 5"),
    f"{DEMO}:{COMPONENT}OneOffTimerNode": logs("in one_off_timer callback"),
    f"{DEMO}:{COMPONENT}ReuseTimerNode": logs("in one_off_timer callback"),
    f"{DEMO}:{COMPONENT}ListParameters": logs("Parameter name"),
    f"{DEMO}:src/parameters/list_parameters_async.cpp": logs("Parameter name"),
    f"{DEMO}:{COMPONENT}SetAndGetParameters": logs("Parameter name"),
    f"{DEMO}:src/parameters/set_and_get_parameters_async.cpp": logs("Parameter name"),
    f"{DEMO}:{COMPONENT}SetParametersCallback": sets_parameters,
    f"{DEMO}:{COMPONENT}ParameterBlackboard": logs("Parameter blackboard node named"),
    f"{DEMO}:src/parameters/parameter_events.cpp": logs("Parameter event:"),
    f"{DEMO}:{COMPONENT}ParameterEventsAsyncNode": logs("Parameter event:"),
    f"{DEMO}:src/parameters/parameter_event_handler.cpp": watches_parameters,
    f"{DEMO}:src/events/matched_event_detect.cpp": logs("First subscription is connected", seconds=100),
    "demos/action_tutorials/action_tutorials_cpp:action_tutorials_cpp::FibonacciActionServer": executes(),
    "demos/action_tutorials/action_tutorials_cpp:action_tutorials_cpp::FibonacciActionClient": asks_for_goal(
        "Result received"
    ),
    "demos/lifecycle:src/lifecycle_talker.cpp": changes_states,
    "demos/lifecycle:src/lifecycle_listener.cpp": listens("/lifecycle_chatter", "hello"),
    "demos/dummy_robot/dummy_sensors:src/dummy_laser.cpp": publishes("/scan", "sensor_msgs/msg/LaserScan", 31, 1.01),
    "demos/dummy_robot/dummy_sensors:src/dummy_joint_states.cpp": publishes(
        "/joint_states", "sensor_msgs/msg/JointState", 51, 1.01
    ),
    "demos/dummy_robot/dummy_map_server:src/dummy_map_server.cpp": publishes(
        "/map", "nav_msgs/msg/OccupancyGrid", 1, 0.5
    ),
}
SAMPLE = [
    f"{PUBLISHER}:lambda.cpp",
    f"{SUBSCRIBER}:member_function_with_type_adapter.cpp",
    f"{EXAMPLE}/services/minimal_client:main.cpp",
    f"{SERVER}:member_functions.cpp",
    f"{DEMO}:{COMPONENT}ServerNode",
    "demos/lifecycle:src/lifecycle_talker.cpp",
]
CHOSEN = list(NODES) if os.environ.get("SITAF_ROS2_CPP_NODES") == "all" else SAMPLE


@pytest.mark.parametrize("name", CHOSEN)
def test_a_public_node_runs_unchanged(name, tmp_path):
    folder, _, entry = name.partition(":")
    done = build_node(PACKAGES / folder, entry, tmp_path, is_main=bool(re.search(r"\.cpp$", entry)))
    assert done.returncode == 0, done.stdout + done.stderr
    run_node(tmp_path / "libnode.so", NODES[name])
