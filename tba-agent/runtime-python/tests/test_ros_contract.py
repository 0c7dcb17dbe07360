"""What holds for a node whatever it runs with: the API that comes along, or an installed ROS 2 (`--ros system`)."""

from concurrent.futures import ThreadPoolExecutor

import pytest

from sitaf_ros import ActionAnswer, Delayed, NodeError
from tests.ros_cases import S, installed_ros, run_case, run_installed

needs_ros = pytest.mark.skipif(installed_ros() is None, reason="needs ./sitaf doctor --install ros")


@pytest.fixture(params=["included", pytest.param("installed", marks=[needs_ros, pytest.mark.slow])])
def run(request, tmp_path):
    """Runs a script with a node, given by its text, which is the module `followed`."""

    def run(text, script, entry="followed:Probe", **settings):
        (tmp_path / "followed.py").write_text(HEAD + text, encoding="utf-8")
        return (run_case if request.param == "included" else run_installed)(tmp_path, entry, script, **settings)

    return run


HEAD = """
import rclpy
from rclpy.node import Node
from rclpy.qos import QoSProfile, DurabilityPolicy
from std_msgs.msg import Float64, String
"""

ORDER = """
class Probe(Node):
    def __init__(self):
        super().__init__('probe')
        self.out = self.create_publisher(String, 'out', 10)
        self.create_timer(0.2, lambda: self.say('timer a'))
        self.create_timer(0.1, lambda: self.say('timer b'))
        self.create_subscription(String, 'one', lambda m: self.say('one ' + m.data), 10)
        self.create_subscription(String, 'two', lambda m: self.say('two ' + m.data), 10)

    def say(self, text):
        self.out.publish(String(data=text))
"""


def send_at_two_tenths(case):
    case.system.advertise("/one", "std_msgs/msg/String")
    got = case.heard("/out", "std_msgs/msg/String")
    case.system.run_before(round(0.2 * S))
    for topic, text in (("two", "x"), ("two", "y")):
        case.system.publish(f"/{topic}", "std_msgs/msg/String", {"data": text})
    case.run(0.2)
    case.system.publish("/one", "std_msgs/msg/String", {"data": "z"})
    case.run(0.25)
    return got


def test_messages_come_before_timers_of_the_same_time(run):
    assert run(ORDER, send_at_two_tenths) == [
        (0.1, "timer b"),
        (0.2, "two x"),
        (0.2, "two y"),
        (0.2, "timer a"),
        (0.2, "timer b"),
        (0.2, "one z"),
    ]


PARAMETERS = """
class Probe(Node):
    def __init__(self):
        super().__init__('probe')
        self.declare_parameter('speed', 1.0)
        self.declare_parameter('names', ['a'])
        self.declare_parameter('kept', 3)
        out = self.create_publisher(String, 'out', 10)
        text = repr([self.get_parameter(n).value for n in ('speed', 'names', 'kept', 'use_sim_time')])
        self.create_timer(0.2, lambda: out.publish(String(data=text)))
"""


def hear_and_report(case):
    got = case.heard("/robot/out", "std_msgs/msg/String")
    case.run(0.25)
    case.system.end()
    return got, case.system.report()


def test_parameters_and_names_are_replaced(run):
    settings = {"parameters": {"speed": 2.5, "names": ["b", "c"], "spede": 1, "use_sim_time": True}}
    got, report = run(PARAMETERS, hear_and_report, remap={"out": "/robot/out"}, use_sim_time=True, **settings)
    assert got == [(0.2, "[2.5, ['b', 'c'], 3, True]")]
    assert report.undeclared_parameters == ("spede",)
    assert report.unobserved_topics == ()


def test_a_parameter_file_names_its_nodes(run):
    given = {"parameters": {"/**": {"ros__parameters": {"speed": 4.0}}, "other": {"ros__parameters": {"kept": 9}}}}
    got, _ = run(PARAMETERS, hear_and_report, remap={"out": "/robot/out"}, **given)
    assert got[0][1].startswith("[4.0, ['a'], 3,")


TOPICS = """
class Probe(Node):
    def __init__(self):
        super().__init__('probe')
        self.latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.map = self.create_publisher(String, 'map', self.latched)
        self.map.publish(String(data='early'))
        self.begin = self.create_timer(0.02, self.listen)
        self.create_subscription(String, 'missing', print, 10)
        self.out = self.create_publisher(String, 'out', 10)
        self.create_publisher(String, 'loose', 10).publish(String())

    def listen(self):
        self.begin.cancel()
        self.create_subscription(String, 'map', lambda m: self.out.publish(m), self.latched)
"""


def hear_latched(case):
    got = case.heard("/out", "std_msgs/msg/String")
    # A subscription that is made later meets its publisher in real time.
    case.run(1)
    case.system.end()
    return [text for _, text in got], case.system.report()


def test_a_latched_message_reaches_a_later_subscription_and_loose_topics_are_reported(run):
    got, report = run(TOPICS, hear_latched)
    assert got == ["early"]
    assert report.unobserved_topics == ("/loose",)
    assert report.unfed_topics == ("/missing",)


SERVICES = """
from std_srvs.srv import SetBool, Trigger
class Probe(Node):
    def __init__(self):
        super().__init__('probe')
        self.create_service(SetBool, 'enable', self.enable)
        self.asks = self.create_client(Trigger, 'helper')
        self.out = self.create_publisher(String, 'out', 10)
        self.create_timer(0.5, self.ask)
        self.asked = False

    def enable(self, request, response):
        response.success, response.message = not request.data, f'was {request.data}'
        return response

    def ask(self):
        if not self.asked:
            self.asked = True
            self.asks.call_async(Trigger.Request()).add_done_callback(self.answered)

    def answered(self, future):
        self.out.publish(String(data=future.result().message))
"""


def answer_later(request):
    return Delayed(0.1, {"success": True, "message": "helped"})


def call_and_answer(case):
    case.system.serve_service("/helper", "std_srvs/srv/Trigger", answer_later)
    got = case.heard("/out", "std_msgs/msg/String")
    case.run(0.01)
    call = case.system.call_service("/enable", "std_srvs/srv/SetBool", {"data": True})
    missing = case.system.call_service("/nobody", "std_srvs/srv/SetBool", {"data": True})
    case.run(0.02)
    answered = case.system.fields(call.response)
    case.run(1)
    return answered, missing.error, got


def test_services_are_called_and_answered_after_simulated_time(run):
    answered, error, got = run(SERVICES, call_and_answer)
    assert answered == {"success": False, "message": "was True"}
    assert error == "no node offers the service /nobody of type std_srvs/srv/SetBool"
    assert [text for _, text in got] == ["helped"]
    assert got[0][0] == pytest.approx(0.6, abs=0.002)


ERRORS = """
class Probe(Node):
    def __init__(self):
        super().__init__('probe')
        self.create_timer(0.05, self.tick)

    def tick(self):
        raise ValueError('no plan')
"""


def run_into_error(case):
    try:
        case.run(0.2)
    except NodeError as e:
        return case.system.now_ns / S, str(e)
    return None


def test_an_exception_ends_the_case(run):
    at, text = run(ERRORS, run_into_error)
    assert at == pytest.approx(0.05, abs=0.002)
    assert text.endswith("ValueError: no plan")


MAIN = """
def main():
    name = input()
    rclpy.init()
    node = rclpy.create_node('probe')
    out = node.create_publisher(String, 'out', 10)
    node.create_timer(0.1, lambda: out.publish(String(data=name)))
    try:
        rclpy.spin(node)
    except BaseException as e:
        print(type(e).__name__)
"""


def hear(case):
    got = case.heard("/out", "std_msgs/msg/String")
    case.run(0.25)
    return got


def test_a_main_function_reads_a_terminal_and_spins(run):
    assert run(MAIN, hear, entry="followed:main", stdin=["alpha"]) == [(0.1, "alpha"), (0.2, "alpha")]


@needs_ros
@pytest.mark.slow
def test_nodes_that_run_at_once_do_not_hear_each_other(tmp_path):
    (tmp_path / "followed.py").write_text(HEAD + MAIN, encoding="utf-8")

    def run_one(name):
        return run_installed(tmp_path, "followed:main", hear, stdin=[name])

    names = [f"node {i}" for i in range(4)]
    with ThreadPoolExecutor(len(names)) as pool:
        heard = list(pool.map(run_one, names))
    assert [[text for _, text in got] for got in heard] == [[name, name] for name in names]


EARLY = """
import sys
def main(argv=sys.argv[1:]):
    rclpy.init(args=argv)
    node = rclpy.create_node('probe')
    out = node.create_publisher(String, 'out', 10)
    node.declare_parameter('word', 'none')
    node.create_timer(0.1, lambda: out.publish(String(data=node.get_parameter('word').value)))
    rclpy.spin(node)
"""


def test_a_main_function_may_take_its_arguments_when_it_is_imported(run):
    assert run(EARLY, hear, entry="followed:main", parameters={"word": "given"}) == [(0.1, "given"), (0.2, "given")]


ACTIONS = """
from rclpy.action import ActionClient, ActionServer, GoalResponse
from test_msgs.action import Fibonacci
class Probe(Node):
    def __init__(self):
        super().__init__('probe')
        self.server = ActionServer(self, Fibonacci, 'count', self.count, goal_callback=self.accept)
        self.asks = ActionClient(self, Fibonacci, 'other')
        self.out = self.create_publisher(String, 'out', 10)
        self.begin = self.create_timer(0.5, self.ask)

    def accept(self, goal):
        return GoalResponse.REJECT if goal.order < 0 else GoalResponse.ACCEPT

    def count(self, handle):
        feedback = Fibonacci.Feedback()
        feedback.sequence = [handle.request.order]
        handle.publish_feedback(feedback)
        handle.succeed()
        result = Fibonacci.Result()
        result.sequence = list(range(handle.request.order))
        return result

    def ask(self):
        self.begin.cancel()
        self.asks.send_goal_async(Fibonacci.Goal(order=7)).add_done_callback(self.accepted)

    def accepted(self, future):
        future.result().get_result_async().add_done_callback(self.finished)

    def finished(self, future):
        self.out.publish(String(data=repr(list(future.result().result.sequence))))
"""
ACTION = "#goal\nint32 order\n---\n#result\nint32[] sequence\n---\n#feedback\nint32[] sequence\n"


def finish_later(goal):
    return ActionAnswer(after_s=0.1, result={"sequence": [goal.order, 1]})


def goals(case):
    case.system.serve_action("/other", "test_msgs/action/Fibonacci", finish_later)
    got = case.heard("/out", "std_msgs/msg/String")
    case.run(0.01)
    feedback = []
    good = case.system.send_goal("/count", "test_msgs/action/Fibonacci", {"order": 3}, lambda m, _: feedback.append(m))
    bad = case.system.send_goal("/count", "test_msgs/action/Fibonacci", {"order": -1})
    case.run(1)
    ended = (good.accepted, good.status, list(good.result.sequence), bad.accepted)
    return ended, [list(message.sequence) for message in feedback], got


def test_goals_are_sent_and_served(run, tmp_path):
    action = tmp_path / "types" / "test_msgs" / "action" / "Fibonacci.action"
    action.parent.mkdir(parents=True)
    action.write_text(ACTION, encoding="utf-8")
    ended, feedback, got = run(ACTIONS, goals, types=[tmp_path / "types"])
    assert ended == (True, 4, [0, 1, 2], False)
    assert feedback == [[3]]
    assert [text for _, text in got] == ["[7, 1]"]
    assert got[0][0] == pytest.approx(0.6, abs=0.003)


STATE = """
from rclpy.lifecycle import LifecycleNode, TransitionCallbackReturn
class Probe(LifecycleNode):
    def __init__(self):
        super().__init__('probe')
        self.out = self.create_publisher(String, 'out', 10)

    def on_configure(self, state):
        self.out.publish(String(data='from ' + state.label))
        return TransitionCallbackReturn.SUCCESS
"""


def configure(case):
    got = case.heard("/out", "std_msgs/msg/String")
    case.run(0.01)
    change = "lifecycle_msgs/srv/ChangeState"
    done = case.system.call_service("/probe/change_state", change, {"transition": {"label": "configure"}})
    case.run(0.05)
    denied = case.system.call_service("/probe/change_state", change, {"transition": {"label": "configure"}})
    case.run(0.1)
    state = case.system.call_service("/probe/get_state", "lifecycle_msgs/srv/GetState", {})
    case.run(0.15)
    states = (done.response.success, denied.response.success, state.response.current_state.label)
    return states, [text for _, text in got]


def test_a_managed_node_changes_its_state(run):
    assert run(STATE, configure) == ((True, False, "inactive"), ["from unconfigured"])
