"""Parameters and lifecycle of ROS nodes."""

import pytest

from sitaf_ros import NodeError
from tests.ros_cases import node

DECLARES = """
import rclpy
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.exceptions import ParameterNotDeclaredException
from rclpy.parameter_event_handler import ParameterEventHandler
from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor, SetParametersResult

class Probe(Node):
    def __init__(self):
        super().__init__('probe')
        speed = ParameterDescriptor(floating_point_range=[FloatingPointRange(from_value=0.0, to_value=2.0)])
        self.declare_parameter('max_speed', 0.5, speed)
        self.declare_parameters('frame', [('base', 'base_link'), ('odom', 'odom', ParameterDescriptor(read_only=True))])
        self.declare_parameter('gains', [1.0, 2.0])
        self.declare_parameter('later', Parameter.Type.INTEGER)
        self.add_on_set_parameters_callback(self.check)
        self.handler = ParameterEventHandler(self)
        self.handler.add_parameter_callback('max_speed', '/probe', lambda p: self.say('new', p.value.double_value))
        frame = self.get_parameter('frame.base').get_parameter_value().string_value
        self.say(self.get_parameter('max_speed').value, frame)
        self.say(list(self.get_parameters_by_prefix('frame')), self.get_parameter('gains').value)
        try:
            self.get_parameter('unknown')
        except ParameterNotDeclaredException as e:
            self.say(e)

    def check(self, parameters):
        fast = any(p.name == 'max_speed' and p.value > 1.5 for p in parameters)
        return SetParametersResult(successful=not fast, reason='too fast' if fast else '')

    def say(self, *values):
        self.get_logger().info(' '.join(str(v) for v in values))
"""
SET = "rcl_interfaces/srv/SetParameters"


def value(name, kind, **field):
    return {"parameters": [{"name": name, "value": {"type": kind, **field}}]}


def test_declaring_setting_and_listening(tmp_path):
    def script(case):
        case.run(0)
        calls = [
            case.system.call_service("/probe/set_parameters", SET, request)
            for request in (
                value("max_speed", 3, double_value=1.0),
                value("max_speed", 3, double_value=1.9),
                value("max_speed", 3, double_value=7.0),
                value("max_speed", 2, integer_value=1),
                value("frame.odom", 4, string_value="x"),
                value("unknown", 4, string_value="x"),
            )
        ]
        listed = case.system.call_service(
            "/probe/list_parameters", "rcl_interfaces/srv/ListParameters", {"prefixes": ["frame"]}
        )
        case.run(1)
        results = [(c.response.results[0].successful, c.response.results[0].reason) for c in calls]
        return case.texts, results, listed.response.result.names, case.system.report().undeclared_parameters

    texts, results, names, undeclared = node(
        tmp_path, DECLARES, script, parameters={"max_speed": 0.75, "frame": {"base": "robot"}, "typo": 1}
    )
    assert texts == [
        "0.75 robot",
        "['base', 'odom'] [1.0, 2.0]",
        "Invalid access to undeclared parameter(s): unknown",
        "new 1.0",
    ]
    assert [ok for ok, _ in results] == [True, False, False, False, False, False]
    assert [reason for _, reason in results][1] == "too fast"
    assert "out of range" in results[2][1]
    assert "Wrong parameter type" in results[3][1]
    assert "read-only" in results[4][1]
    assert names == ["frame.base", "frame.odom"]
    assert undeclared == ("typo",)


@pytest.mark.parametrize(
    "content",
    [
        {"probe": {"ros__parameters": {"max_speed": 0.9}}},
        {"/**": {"ros__parameters": {"max_speed": 0.9}}},
        {"/probe": {"ros__parameters": {"max_speed": 0.9}}, "/**": {"ros__parameters": {"max_speed": 0.1}}},
        {"other": {"ros__parameters": {"max_speed": 0.1}}, "/*": {"ros__parameters": {"max_speed": 0.9}}},
    ],
)
def test_a_parameter_file_applies_to_the_nodes_that_it_names(tmp_path, content):
    def script(case):
        case.run(0)
        return case.texts[0]

    assert node(tmp_path, DECLARES, script, parameters=content) == "0.9 base_link"


def test_an_override_of_another_type_is_an_error_as_in_ros(tmp_path):
    def script(case):
        try:
            case.run(0)
        except NodeError as e:
            return str(e)

    error = node(tmp_path, DECLARES, script, parameters={"max_speed": 1})
    assert error.startswith("main: InvalidParameterTypeException: Trying to set parameter 'max_speed' to '1'")


LIFECYCLE = """
from rclpy.lifecycle import LifecycleNode, State, TransitionCallbackReturn
from std_msgs.msg import String

class Probe(LifecycleNode):
    def __init__(self):
        super().__init__('probe')
        self.tries = 0

    def on_configure(self, state: State):
        self.tries += 1
        if self.tries == 1:
            return TransitionCallbackReturn.FAILURE
        self.out = self.create_lifecycle_publisher(String, 'out', 10)
        self.create_timer(0.5, lambda: self.out.publish(String(data='x')))
        return TransitionCallbackReturn.SUCCESS

    def on_deactivate(self, state: State):
        raise RuntimeError('stuck')
"""


def test_lifecycle_failures_errors_and_events(tmp_path):
    handled = LIFECYCLE + "\n    def on_error(self, state):\n        return TransitionCallbackReturn.SUCCESS\n"

    def script(case):
        got, events = case.heard("/out", "std_msgs/msg/String"), []
        case.system.subscribe(
            "/probe/transition_event",
            "lifecycle_msgs/msg/TransitionEvent",
            lambda m, t: events.append(m.goal_state.label),
        )
        case.run(0)
        answers = []
        for i, label in enumerate(("configure", "activate", "configure", "activate", "deactivate")):
            call = case.system.call_service(
                "/probe/change_state", "lifecycle_msgs/srv/ChangeState", {"transition": {"label": label}}
            )
            try:
                case.run(i + 1.1)
            except NodeError as e:
                return str(e)
            answers.append(call.response.success)
        return answers, [t for t, _ in got], events

    answers, times, events = node(tmp_path, handled, script)
    assert answers == [False, False, True, True, False]
    # The publisher stays active, because on_deactivate failed before it called its base.
    assert times == pytest.approx([3.6, 4.1, 4.6, 5.1])
    assert events == [
        *("configuring", "unconfigured", "configuring", "inactive", "activating", "active"),
        *("deactivating", "errorprocessing", "unconfigured"),
    ]
    assert node(tmp_path, LIFECYCLE, script) == "callback Probe.on_deactivate: RuntimeError: stuck"
