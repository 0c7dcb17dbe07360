"""Every Python node of the public packages in ros2-packages runs unchanged: its topics, services and so on work."""

import os
import re
from pathlib import Path

import pytest

from tests.ros_cases import run_case

STRING, ADD = "std_msgs/msg/String", "example_interfaces/srv/AddTwoInts"
FIBONACCI = "example_interfaces/action/Fibonacci"
PACKAGES = Path(os.environ.get("SITAF_ROS2_PACKAGES", Path(__file__).resolve().parents[4] / "shared" / "ros2-packages"))
pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(
        not PACKAGES.is_dir(), reason=f"the public packages are not in {PACKAGES}; set SITAF_ROS2_PACKAGES"
    ),
]


def talks(topic, times, prefix, first=0):
    def script(case):
        got = case.heard(topic, STRING)
        case.run(times[-1])
        assert [t for t, _ in got] == pytest.approx(times)
        assert [text for _, text in got] == [f"{prefix}{i + first}" for i in range(len(times))]

    return script


def listens(topic, log):
    def script(case):
        case.run(0.5)
        case.system.publish(topic, STRING, {"data": "hello"})
        case.run(1)
        assert case.texts[-1] == log, case.texts

    return script


def answers(case):
    case.run(0)
    call = case.system.call_service("/add_two_ints", ADD, {"a": 4, "b": -9})
    case.run(0.1)
    assert call.response.sum == -5


def asks(log):
    def script(case):
        case.run(2.2)
        asked = []
        case.system.serve_service("/add_two_ints", ADD, lambda r: asked.append((r.a, r.b)) or {"sum": r.a + r.b})
        case.run(5)
        assert len(asked) == 1
        assert any(log in text for text in case.texts), case.texts

    return script


def asks_for_goal(log, clients=1):
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
        assert sum(log in text for text in case.texts) == clients, case.texts
        assert any("Received feedback" in text for text in case.texts)

    return script


def executes(cancels=True, after=0):
    def script(case):
        case.run(0)
        feedback = []
        goal = case.system.send_goal(
            "/fibonacci", FIBONACCI, {"order": 4}, feedback=lambda m, t: feedback.append(list(m.sequence))
        )
        case.run(after + 5)
        assert (goal.accepted, goal.done, goal.status) == (True, True, 4)
        assert list(goal.result.sequence) == [0, 1, 1, 2, 3]
        assert feedback[0] == [0, 1, 1]
        assert len(feedback) == 3
        if cancels:
            goal = case.system.send_goal("/fibonacci", FIBONACCI, {"order": 9})
            case.run(after * 2 + 7.5)
            cancel = goal.cancel()
            case.run(after * 2 + 9)
            assert len(cancel.response.goals_canceling) == 1
            assert (goal.done, goal.status) == (True, 5)

    return script


def aborts_the_first_goal(case):
    case.run(0)
    first = case.system.send_goal("/fibonacci", FIBONACCI, {"order": 9})
    case.run(2.5)
    second = case.system.send_goal("/fibonacci", FIBONACCI, {"order": 3})
    case.run(8)
    assert (first.status, second.status) == (6, 4)


def queues_goals(case):
    case.run(0)
    goals = [case.system.send_goal("/fibonacci", FIBONACCI, {"order": 3}) for _ in range(2)]
    case.run(2.5)
    assert [goal.done for goal in goals] == [True, False]
    case.run(5)
    assert [goal.status for goal in goals] == [4, 4]


def executes_tutorial(case):
    case.run(0)
    goal = case.system.send_goal("/fibonacci", FIBONACCI, {"order": 5})
    case.run(6)
    assert (goal.status, list(goal.result.sequence)) == (4, [0, 1, 1, 2, 3, 5])


def cancels_its_goal(case):
    from sitaf_ros import ActionAnswer

    case.system.serve_action("/fibonacci", FIBONACCI, lambda goal: ActionAnswer(after_s=100))
    case.run(5)
    assert case.texts[-1] == "Goal successfully canceled"
    assert case.system.ended


def changes_states(case):
    got = case.heard("/lifecycle_chatter", STRING)
    case.run(0)
    states = []
    for time, transition in ((1, 1), (3.5, 3), (6.2, 4), (8, 2), (9, 5)):
        call = case.system.call_service(
            "/lc_talker/change_state", "lifecycle_msgs/srv/ChangeState", {"transition": {"id": transition}}
        )
        state = case.system.call_service("/lc_talker/get_state", "lifecycle_msgs/srv/GetState", {})
        case.run(time)
        states.append((call.response.success, state.response.current_state.label))
    assert [label for _, label in states] == ["inactive", "active", "inactive", "unconfigured", "finalized"]
    assert [ok for ok, _ in states] == [True, True, True, True, True]
    assert [t for t, _ in got] == [2, 3]


def sets_parameters(case):
    case.run(0)
    new = {"parameters": [{"name": "param1", "value": {"type": 3, "double_value": 2.5}}]}
    base, kind = "/set_parameters_callback", "rcl_interfaces/srv"
    done = case.system.call_service(f"{base}/set_parameters", f"{kind}/SetParameters", new)
    got = case.system.call_service(f"{base}/get_parameters", f"{kind}/GetParameters", {"names": ["param1", "param2"]})
    case.run(1)
    assert [(r.successful, r.reason) for r in done.response.results] == [(True, "")]
    assert [v.double_value for v in got.response.values] == [2.5, 4.0]


def introspects(case):
    got = []
    case.system.subscribe(
        "/add_two_ints/_service_event", f"{ADD}_Event", lambda m, t: got.append((m.info.event_type, len(m.request)))
    )
    case.run(0)
    for side in ("client", "service"):
        new = {"name": f"{side}_configure_introspection", "value": {"type": 4, "string_value": "contents"}}
        case.system.call_service(
            f"/introspection_{side}/set_parameters", "rcl_interfaces/srv/SetParameters", {"parameters": [new]}
        )
    case.run(2)
    assert sorted(set(got)) == [(0, 1), (1, 1), (2, 0), (3, 0)]
    assert "Result of add_two_ints: 5" in case.texts


def detects_matches(case):
    case.run(100)
    assert [t for t in case.texts if not t.startswith(("Create", "Destroy"))] == [
        "First subscription is connected.",
        "The changed number of connected subscription is 1 and current number of connected subscription is 2",
        "The changed number of connected subscription is -1 and current number of connected subscription is 1",
        "Last subscription is disconnected.",
        "First publisher is connected.",
        "The changed number of connected publisher is 1 and current number of connected publisher is 2",
        "The changed number of connected publisher is -1 and current number of connected publisher is 1",
        "Last publisher is disconnected.",
    ]
    assert case.system.ended
    assert case.system.now_ns == 100_000_000_000


def sets_levels(case):
    case.run(10)
    levels = [text.rpartition(": ")[2] for text in case.texts if text.startswith("Current logger level")]
    assert levels == ["0", "10", "30", "40"]
    assert [level for level, text in case.log if text.startswith("Output 2 with")] == ["DEBUG", "INFO", "WARN", "ERROR"]
    assert [level for level, text in case.log if text.startswith("Output 4 with")] == ["ERROR"]


def asks_for_parameters(case):
    values = {}

    def set_all(request):
        for one in request.parameters:
            values[one.name] = one.value
        return {"results": [{"successful": True}] * len(request.parameters)}

    kind, base = "rcl_interfaces/srv", "/parameter_blackboard"
    serve = case.system.serve_service
    serve(f"{base}/set_parameters", f"{kind}/SetParameters", set_all)
    serve(f"{base}/set_parameters_atomically", f"{kind}/SetParametersAtomically", lambda r: {})
    serve(
        f"{base}/get_parameters",
        f"{kind}/GetParameters",
        lambda r: {"values": [values[name] for name in r.names]},
    )
    serve(f"{base}/list_parameters", f"{kind}/ListParameters", lambda r: {"result": {"names": list(values)}})
    serve(f"{base}/get_parameter_types", f"{kind}/GetParameterTypes", lambda r: {})
    serve(f"{base}/describe_parameters", f"{kind}/DescribeParameters", lambda r: {})
    case.run(5)
    assert "    - string_parameter: Fee Fi Fo Fum" in case.texts
    assert "        value: I smell the blood of an Englishman" in case.texts
    assert case.system.ended


def publishes_clouds(case):
    clouds = []
    case.system.subscribe("/test_cloud", "sensor_msgs/msg/PointCloud2", lambda m, t: clouds.append(m))
    case.run(0.11)
    assert [(c.width, c.height, c.point_step, len(c.data)) for c in clouds] == [(10000, 1, 16, 160000)] * 3
    assert clouds[0].header.frame_id == "map"
    assert (clouds[0].header.stamp.sec, clouds[0].header.stamp.nanosec) == (1_700_000_000, 33_333_333)


def triggers_guard(case):
    case.run(3)
    assert "guard callback called shutdown" in case.texts
    assert case.system.ended


def talks_and_listens(lines):
    def script(case):
        case.run(2.1)
        assert [text for text in case.texts if "heard" in text or "Publishing" in text] == lines

    return script


def throttles(case):
    got = case.heard("/chatter", STRING)
    case.run(4.95)
    # Ten tokens at once, then one more each half second.
    assert len(got) == 19
    assert [t for t, _ in got][:9] == pytest.approx([0.1 * i for i in range(1, 10)])


def estops(case):
    case.run(0.1)
    case.system.publish("/estop", STRING, {"data": "stop"})
    case.run(1.5)
    assert 'I heard: "stop"' in case.texts
    assert any("Publishing" in text for text in case.texts)


PUBLISHES = [f'{what}: "Hello World: {i}"' for i in (0, 1) for what in ("Publishing", "I heard")]
DEMO, EXAMPLE = "demos/demo_nodes_py", "examples/rclpy"
EXECUTORS = f"{EXAMPLE}/executors"
ACTION_CLIENT = f"{EXAMPLE}/actions/minimal_action_client"
ACTION_SERVER = f"{EXAMPLE}/actions/minimal_action_server"
GOAL = "Goal succeeded! Result: array('i', [0, 1, 1, 2, 3, 5, 8, 13, 21, 34])"
HALVES = [0.5, 1, 1.5, 2]
SUM = "Result of add_two_ints: for 41 + 1 = 42"
NODES = {
    f"{DEMO}:demo_nodes_py.topics.talker": talks("/chatter", [1, 2, 3], "Hello World: "),
    f"{DEMO}:demo_nodes_py.topics.talker_qos": talks("/chatter", [1, 2, 3], "Hello World: "),
    f"{DEMO}:demo_nodes_py.topics.listener": listens("/chatter", "I heard: [hello]"),
    f"{DEMO}:demo_nodes_py.topics.listener_qos": listens("/chatter", "I heard: [hello]"),
    f"{DEMO}:demo_nodes_py.topics.listener_serialized": listens(
        "/chatter", f'I heard: "{bytes([0, 1, 0, 0, 6, 0, 0, 0, *b"hello", 0])}"'
    ),
    f"{DEMO}:demo_nodes_py.services.add_two_ints_server": answers,
    f"{DEMO}:demo_nodes_py.services.add_two_ints_client": asks("Result of add_two_ints: 5"),
    f"{DEMO}:demo_nodes_py.services.add_two_ints_client_async": asks("Result of add_two_ints: 5"),
    f"{DEMO}:demo_nodes_py.services.introspection": introspects,
    f"{DEMO}:demo_nodes_py.parameters.set_parameters_callback": sets_parameters,
    f"{DEMO}:demo_nodes_py.parameters.async_param_client": asks_for_parameters,
    f"{DEMO}:demo_nodes_py.events.matched_event_detect": detects_matches,
    f"{DEMO}:demo_nodes_py.logging.use_logger_service": sets_levels,
    "demos/action_tutorials/action_tutorials_py:action_tutorials_py.fibonacci_action_server": executes_tutorial,
    "demos/action_tutorials/action_tutorials_py:action_tutorials_py.fibonacci_action_client": asks_for_goal("Result: "),
    "demos/lifecycle_py:lifecycle_py.talker": changes_states,
    f"{EXAMPLE}/services/minimal_service:examples_rclpy_minimal_service.service": answers,
    f"{EXAMPLE}/services/minimal_service:examples_rclpy_minimal_service.service_member_function": answers,
    f"{EXAMPLE}/services/minimal_client:examples_rclpy_minimal_client.client": asks(SUM),
    f"{EXAMPLE}/services/minimal_client:examples_rclpy_minimal_client.client_async": asks(SUM),
    f"{EXAMPLE}/services/minimal_client:examples_rclpy_minimal_client.client_async_callback": asks(SUM),
    f"{EXAMPLE}/services/minimal_client:examples_rclpy_minimal_client.client_async_member_function": asks(SUM),
    f"{ACTION_CLIENT}:examples_rclpy_minimal_action_client.client": asks_for_goal(GOAL),
    f"{ACTION_CLIENT}:examples_rclpy_minimal_action_client.client_asyncio": asks_for_goal(GOAL, clients=4),
    f"{ACTION_CLIENT}:examples_rclpy_minimal_action_client.client_cancel": cancels_its_goal,
    f"{ACTION_CLIENT}:examples_rclpy_minimal_action_client.client_not_composable": asks_for_goal(GOAL),
    f"{ACTION_SERVER}:examples_rclpy_minimal_action_server.server": executes(),
    f"{ACTION_SERVER}:examples_rclpy_minimal_action_server.server_not_composable": executes(),
    f"{ACTION_SERVER}:examples_rclpy_minimal_action_server.server_defer": executes(after=3),
    f"{ACTION_SERVER}:examples_rclpy_minimal_action_server.server_queue_goals": queues_goals,
    f"{ACTION_SERVER}:examples_rclpy_minimal_action_server.server_single_goal": aborts_the_first_goal,
    f"{EXAMPLE}/guard_conditions:examples_rclpy_guard_conditions.trigger_guard_condition": triggers_guard,
    f"{EXAMPLE}/topics/pointcloud_publisher:examples_rclpy_pointcloud_publisher.pointcloud_publisher": publishes_clouds,
    f"{EXAMPLE}/topics/minimal_publisher:examples_rclpy_minimal_publisher.publisher_old_school": talks(
        "/topic", [0, *HALVES], "Hello World: "
    ),
    f"{EXAMPLE}/topics/minimal_publisher:examples_rclpy_minimal_publisher.publisher_local_function": talks(
        "/topic", HALVES, "Hello World: "
    ),
    f"{EXAMPLE}/topics/minimal_publisher:examples_rclpy_minimal_publisher.publisher_member_function": talks(
        "/topic", HALVES, "Hello World: "
    ),
    f"{EXAMPLE}/topics/minimal_subscriber:examples_rclpy_minimal_subscriber.subscriber_old_school": listens(
        "/topic", 'I heard: "hello"'
    ),
    f"{EXAMPLE}/topics/minimal_subscriber:examples_rclpy_minimal_subscriber.subscriber_lambda": listens(
        "/topic", 'I heard: "hello"'
    ),
    f"{EXAMPLE}/topics/minimal_subscriber:examples_rclpy_minimal_subscriber.subscriber_member_function": listens(
        "/topic", 'I heard: "hello"'
    ),
    f"{EXECUTORS}:examples_rclpy_executors.talker": talks("/chatter", [1, 2], "Hello World: "),
    f"{EXECUTORS}:examples_rclpy_executors.listener": listens("/chatter", 'I heard: "hello"'),
    f"{EXECUTORS}:examples_rclpy_executors.composed": talks_and_listens(PUBLISHES),
    f"{EXECUTORS}:examples_rclpy_executors.callback_group": talks("/chatter", [0.5, 1, 1, 1.5], "Hello World: "),
    f"{EXECUTORS}:examples_rclpy_executors.custom_callback_group": throttles,
    f"{EXECUTORS}:examples_rclpy_executors.custom_executor": estops,
}


@pytest.mark.parametrize("name", NODES)
def test_a_public_node_runs_unchanged(name):
    folder, _, module = name.partition(":")
    package = module.partition(".")[0]
    run_case(PACKAGES / folder, f"{module}:main", NODES[name], package=package)


def test_the_table_has_every_node():
    scripts = set()
    for setup in PACKAGES.rglob("setup.py"):
        text = re.sub(r"'\s*\n\s*'", "", setup.read_text(encoding="utf-8"))
        package = re.search(r"^package_name = '(\w+)'", text, re.MULTILINE)[1]
        scripts.update(re.sub(r"^\.", f"{package}.", name) for name in re.findall(r"([\w.]+):main", text))
    assert scripts == {name.partition(":")[2] for name in NODES}
