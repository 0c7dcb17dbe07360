"""Time, order, quality of service, threads, input and errors of ROS nodes."""

import pytest

from sitaf_ros import NodeError, RosLoadError
from tests.ros_cases import S, node

HEAD = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import String, Float64
"""

ORDER = (
    HEAD
    + """
class Probe(Node):
    def __init__(self):
        super().__init__('probe')
        self.out = self.create_publisher(String, 'out', 10)
        self.create_timer(1.0, lambda: self.say('timer a'))
        self.create_timer(0.5, lambda: self.say('timer b'))
        self.create_subscription(String, 'one', lambda m: self.say('one ' + m.data), 10)
        self.create_subscription(String, 'two', lambda m: self.say('two ' + m.data), 10)

    def say(self, text):
        self.out.publish(String(data=text))
"""
)


def send_at_one_second(case):
    got = case.heard("/out", "std_msgs/msg/String")
    case.system.run_before(S)
    for topic, text in (("two", "x"), ("one", "y"), ("two", "z")):
        case.system.publish(f"/{topic}", "std_msgs/msg/String", {"data": text})
    case.run(1)
    return [text for t, text in got if t == 1]


def test_messages_come_in_order_of_publication_and_before_timers_in_order_of_creation(tmp_path):
    assert node(tmp_path, ORDER, send_at_one_second) == ["two x", "one y", "two z", "timer a", "timer b"]


def test_another_callback_order_is_the_same_in_every_run_and_keeps_each_topics_order(tmp_path):
    first = [node(tmp_path, ORDER, send_at_one_second, callback_order=n) for n in range(1, 6)]
    again = [node(tmp_path, ORDER, send_at_one_second, callback_order=n) for n in range(1, 6)]
    assert first == again
    assert len({tuple(order) for order in first}) > 1
    for order in first:
        assert sorted(order) == sorted(["two x", "one y", "two z", "timer a", "timer b"])
        assert order.index("two x") < order.index("two z")


QUALITY = (
    HEAD
    + """
from rclpy.qos import QoSProfile, DurabilityPolicy, ReliabilityPolicy, HistoryPolicy
class Probe(Node):
    def __init__(self):
        super().__init__('probe')
        latched = QoSProfile(depth=2, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.map = self.create_publisher(String, 'map', latched)
        for text in 'abc':
            self.map.publish(String(data=text))
        self.create_subscription(String, 'map', lambda m: self.get_logger().info('late ' + m.data), latched)
        self.create_subscription(String, 'map', lambda m: self.get_logger().info('volatile ' + m.data), 10)
        self.create_subscription(String, 'burst', lambda m: self.get_logger().info('burst ' + m.data), 2)
        weak = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
        self.weak = self.create_publisher(String, 'weak', weak)
        self.create_subscription(String, 'weak', lambda m: self.get_logger().info('weak'), 10)
        self.create_timer(1.0, lambda: self.weak.publish(String()))
"""
)


def test_depth_durability_and_incompatible_pairs(tmp_path):
    def script(case):
        case.run(0)
        for i in range(5):
            case.system.publish("/burst", "std_msgs/msg/String", {"data": str(i)})
        case.run(1.5)
        return case.log, case.system.report()

    log, report = node(tmp_path, QUALITY, script)
    assert [text for level, text in log if level == "INFO"] == ["late b", "late c", "burst 3", "burst 4"]
    assert report.incompatible_qos == ("/weak: /probe -> /probe: RELIABILITY",)
    assert any("incompatible QoS" in text for level, text in log if level == "WARN")
    assert len(report.uncalled_callbacks) == 2


CLOCKS = (
    HEAD
    + """
import datetime, threading, time
from time import sleep, monotonic
class Probe(Node):
    def __init__(self):
        super().__init__('probe')
        self.create_timer(1.0, self.tick)

    def tick(self):
        a = (time.time(), datetime.datetime.now(datetime.UTC).second, self.get_clock().now().nanoseconds)
        begin, counter = monotonic(), time.perf_counter()
        sleep(0.25)
        done = threading.Event()
        threading.Timer(0.5, done.set).start()
        waited = done.wait(2.0)
        timed_out = threading.Event().wait(0.25)
        b = (monotonic() - begin, time.perf_counter() - counter, waited, timed_out)
        self.get_logger().info(repr((a, b)))
"""
)


@pytest.mark.parametrize(("simulated", "zero"), [(False, 1_700_000_000), (True, 0)])
def test_clocks_sleeps_and_timeouts_are_simulated_time(tmp_path, simulated, zero):
    def script(case):
        case.run(2.5)
        return case.texts

    first, *_ = node(tmp_path, CLOCKS, script, use_sim_time=simulated)
    moment = (1_700_000_001.0, 1_700_000_001 % 60, (zero + 1) * S)
    assert eval(first) == (moment, (1.0, 1.0, True, False))


LOOPS = (
    HEAD
    + """
import time
def main():
    rclpy.init()
    node = rclpy.create_node('probe')
    out = node.create_publisher(Float64, 'out', 10)
    heard = []
    node.create_subscription(Float64, 'in', heard.append, 10)
    rate = node.create_rate(10)
    while rclpy.ok():
        rclpy.spin_once(node, timeout_sec=0)
        out.publish(Float64(data=float(len(heard))))
        rate.sleep()
    node.get_logger().info('ended')
    node.destroy_node()
    rclpy.shutdown()
"""
)


def test_a_loop_with_spin_once_runs_to_the_end_of_the_case(tmp_path):
    def script(case):
        got = case.heard("/out", "std_msgs/msg/Float64")
        case.run(0.15)
        case.system.publish("/in", "std_msgs/msg/Float64", {"data": 1})
        case.run(0.5)
        case.system.end()
        return got, case.texts, case.system.ended

    got, texts, ended = node(tmp_path, LOOPS, script, entry="followed:main")
    assert got == [(0.0, 0.0), (0.1, 0.0), (0.2, 1.0), (0.3, 1.0), (0.4, 1.0), (0.5, 1.0)]
    assert (texts, ended) == (["ended"], True)


NESTED = (
    HEAD
    + """
from std_srvs.srv import Trigger
class Probe(Node):
    def __init__(self):
        super().__init__('probe')
        self.client = self.create_client(Trigger, 'ask')
        self.create_subscription(String, 'in', lambda m: self.get_logger().info('heard'), 10)
        self.create_timer(1.0, self.tick)

    def tick(self):
        future = self.client.call_async(Trigger.Request())
        rclpy.spin_until_future_complete(self, future, timeout_sec=0.8)
        self.get_logger().info('answer ' + (future.result().message if future.done() else 'none'))
"""
)


def test_a_nested_spin_runs_other_callbacks_and_keeps_the_outer_one(tmp_path):
    def script(case):
        from sitaf_ros import Delayed

        case.system.serve_service("/ask", "std_srvs/srv/Trigger", lambda r: Delayed(0.5, {"message": "yes"}))
        case.run(1.2)
        case.system.publish("/in", "std_msgs/msg/String", {})
        case.run(3.9)
        return case.texts

    assert node(tmp_path, NESTED, script) == ["heard", "answer yes", "answer yes", "answer yes"]


FAILS = (
    HEAD
    + """
class Probe(Node):
    def __init__(self):
        super().__init__('probe')
        self.create_subscription(Float64, 'in', self.on_value, 10)

    def on_value(self, message):
        self.get_logger().info(str(1.0 / message.data))
"""
)


def test_an_exception_in_a_callback_names_the_callback(tmp_path):
    def script(case):
        case.run(1)
        case.system.publish("/in", "std_msgs/msg/Float64", {"data": 0})
        try:
            case.run(2)
        except NodeError as e:
            return str(e), e.callback

    text, callback = node(tmp_path, FAILS, script)
    assert (text, callback) == (
        "callback Probe.on_value: ZeroDivisionError: float division by zero",
        "callback Probe.on_value",
    )


ASKS = (
    HEAD
    + """
import select, sys, threading
class Probe(Node):
    def __init__(self):
        super().__init__('probe')
        threading.Thread(target=self.read, daemon=True).start()
        self.create_timer(1.0, lambda: None)

    def read(self):
        self.get_logger().info('terminal' if sys.stdin.isatty() else 'no terminal')
        self.get_logger().info('first ' + input())
        self.get_logger().info('second ' + sys.stdin.readline().strip())
        ready = select.select([sys.stdin], [], [], 0.5)[0]
        self.get_logger().info('nothing' if not ready else 'something')
        input()
        self.get_logger().info('never')
"""
)


def test_input_comes_line_by_line_and_then_waits_for_the_end(tmp_path):
    def script(case):
        case.run(5)
        case.system.end()
        return case.texts[1:]

    assert node(tmp_path, ASKS, script, stdin=["yes", "no"]) == ["first yes", "second no", "nothing"]


def test_what_is_not_available_is_refused_by_name_before_anything_runs(tmp_path):
    (tmp_path / "helper.py").write_text("import rclpy.something\n", encoding="utf-8")
    (tmp_path / "other.py").write_text("import rclpy.not_imported\n", encoding="utf-8")
    text = "import rclpy\nimport cv_bridge\nfrom rclpy.qos import QoSProfile, Foo\nimport rclpy.nothing\n"
    text += "from std_msgs.msg import Strin; import helper\n\n\ndef main():\n    rclpy.spin_for_ever(None)\n"
    with pytest.raises(AssertionError) as e:
        node(tmp_path, text, lambda case: None, entry="followed:main")
    assert RosLoadError.__name__ in str(e.value)
    for line in (
        "followed.py:2: cv_bridge is not available",
        "followed.py:3: rclpy.qos.Foo is not available",
        "followed.py:4: rclpy.nothing is not available",
        "followed.py:5: std_msgs/msg/Strin: no such type",
        "followed.py:9: rclpy.spin_for_ever is not available",
        "helper.py:1: rclpy.something is not available",
    ):
        assert line in str(e.value)
    assert "not_imported" not in str(e.value)


THREADS = (
    HEAD
    + """
import queue, threading, time
from concurrent.futures import ThreadPoolExecutor
class Probe(Node):
    def __init__(self):
        super().__init__('probe')
        self.jobs, self.lock, self.results = queue.Queue(), threading.Lock(), []
        for name in 'ab':
            threading.Thread(target=self.work, args=(name,), daemon=True).start()
        self.pool = ThreadPoolExecutor(2)
        self.create_timer(0.1, self.tick)
        self.out = self.create_publisher(String, 'out', 10)
        self.count = 0

    def tick(self):
        self.count += 1
        self.jobs.put(self.count)
        self.pool.submit(self.say, f'pool {self.count}')

    def work(self, name):
        while True:
            job = self.jobs.get()
            with self.lock:
                time.sleep(0.03)
                self.say(f'{name} {job}')

    def say(self, text):
        self.out.publish(String(data=text))
"""
)


def test_threads_queues_and_pools_give_the_same_in_every_run(tmp_path):
    def script(case):
        got = case.heard("/out", "std_msgs/msg/String")
        case.run(1)
        return got

    runs = [node(tmp_path, THREADS, script) for _ in range(3)]
    assert runs[0] == runs[1] == runs[2]
    assert len(runs[0]) == 19


REMAPPED = (
    HEAD
    + """
class Probe(Node):
    def __init__(self):
        super().__init__('probe', namespace='robot')
        for name in ('cmd_vel', '/scan', '~/status'):
            self.create_publisher(String, name, 10)
"""
)


def test_topics_are_expanded_and_remapped(tmp_path):
    def script(case):
        case.run(0)
        return [topic for topic in case.system.topics() if topic != "/parameter_events"]

    assert node(tmp_path, REMAPPED, script, remap={"cmd_vel": "/base/cmd", "/scan": "front"}) == [
        "/base/cmd",
        "/robot/front",
        "/robot/probe/status",
    ]


RAISES_IN_GOAL = (
    HEAD
    + """
from example_interfaces.action import Fibonacci
from rclpy.action import ActionServer, CancelResponse, GoalResponse
class Probe(Node):
    def __init__(self):
        super().__init__('probe')
        self.server = ActionServer(self, Fibonacci, 'count', self.execute, goal_callback=self.decide)

    def decide(self, goal):
        return GoalResponse.REJECT if goal.order < 0 else GoalResponse.ACCEPT

    def execute(self, handle):
        if handle.request.order == 0:
            raise ValueError('nothing to count')
        handle.abort()
        return Fibonacci.Result()
"""
)


def test_goals_are_rejected_aborted_or_an_error(tmp_path):
    def script(case):
        case.run(0)
        goals = [case.system.send_goal("/count", "example_interfaces/action/Fibonacci", {"order": n}) for n in (-1, 1)]
        case.run(1)
        cancel = goals[1].cancel()
        case.run(2)
        case.system.send_goal("/count", "example_interfaces/action/Fibonacci", {"order": 0})
        try:
            case.run(3)
        except NodeError as e:
            return [(goal.accepted, goal.done, goal.status) for goal in goals], cancel.response.return_code, str(e)

    goals, cancel, error = node(tmp_path, RAISES_IN_GOAL, script)
    assert goals == [(False, True, 0), (True, True, 6)]
    assert cancel == 3  # ERROR_GOAL_TERMINATED
    assert error == "callback Probe.execute: ValueError: nothing to count"


BUSY = (
    HEAD
    + """
import time
def main():
    rclpy.init()
    node = rclpy.create_node('probe')
    end = time.time() + 0.05
    while time.time() < end:
        pass
    node.get_logger().info('passed')
"""
)


def test_a_loop_that_only_looks_at_the_clock_takes_simulated_time(tmp_path):
    def script(case):
        case.run(0.2)
        return case.texts, case.system.report().warnings

    texts, warnings = node(tmp_path, BUSY, script, entry="followed:main")
    assert texts == ["passed"]
    assert len(warnings) == 1


ASYNC = (
    HEAD
    + """
import asyncio, signal
def main():
    async def work():
        rclpy.init()
        node = rclpy.create_node('probe')
        asyncio.get_running_loop().add_signal_handler(signal.SIGTERM, lambda: None)
        out = node.create_publisher(String, 'out', 10)
        heard = asyncio.Event()
        node.create_subscription(String, 'in', lambda m: heard.set(), 10)

        async def spin():
            while rclpy.ok():
                rclpy.spin_once(node, timeout_sec=0)
                await asyncio.sleep(0.01)

        task = asyncio.create_task(spin())
        try:
            await asyncio.wait_for(heard.wait(), 0.5)
        except TimeoutError:
            out.publish(String(data='timeout'))
        await heard.wait()
        out.publish(String(data='heard'))
        task.cancel()
    asyncio.run(work())
"""
)


def test_asyncio_runs_over_simulated_time(tmp_path):
    def script(case):
        got = case.heard("/out", "std_msgs/msg/String")
        case.run(1.005)
        case.system.publish("/in", "std_msgs/msg/String", {})
        case.run(2)
        return [(round(t, 2), text) for t, text in got]

    assert node(tmp_path, ASYNC, script, entry="followed:main") == [(0.5, "timeout"), (1.01, "heard")]


EVENTS = (
    HEAD
    + """
from rclpy.duration import Duration
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.qos import DurabilityPolicy, LivelinessPolicy, QoSProfile
class Probe(Node):
    def __init__(self):
        super().__init__('probe')
        say = self.get_logger().info
        self.missed = QoSProfile(depth=1, deadline=Duration(seconds=0.3))
        self.create_subscription(String, 'in', lambda m: None, self.missed, event_callbacks=SubscriptionEventCallbacks(
            deadline=lambda e: say(f'requested deadline {e.total_count}')))
        alive = QoSProfile(depth=1, liveliness=LivelinessPolicy.MANUAL_BY_TOPIC,
                           liveliness_lease_duration=Duration(seconds=0.5))
        self.out = self.create_publisher(String, 'alive', alive, event_callbacks=PublisherEventCallbacks(
            liveliness=lambda e: say(f'lost {e.total_count}')))
        self.create_subscription(String, 'alive', lambda m: None, alive, event_callbacks=SubscriptionEventCallbacks(
            liveliness=lambda e: say(f'alive {e.alive_count} not alive {e.not_alive_count}')))
        self.out.publish(String())
        short = QoSProfile(depth=5, durability=DurabilityPolicy.TRANSIENT_LOCAL, lifespan=Duration(seconds=1))
        self.short = self.create_publisher(String, 'short', short)
        self.short.publish(String(data='old'))
        self.create_timer(0.8, self.late)

    def late(self):
        latched = QoSProfile(depth=5, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.late_sub = self.create_subscription(
            String, 'short', lambda m: self.get_logger().info('late ' + m.data), latched)
        self.out.publish(String())
"""
)


def test_deadlines_liveliness_and_lifespan(tmp_path):
    def script(case):
        case.run(0.1)
        case.system.publish("/in", "std_msgs/msg/String", {})
        case.run(0.75)
        first = list(case.texts)
        case.run(1.7)
        return first, [text for text in case.texts[len(first) :] if "deadline" not in text]

    first, later = node(tmp_path, EVENTS, script)
    assert first == [
        "alive 1 not alive 0",
        "requested deadline 1",
        "alive 0 not alive 1",
        "lost 1",
        "requested deadline 2",
    ]
    assert later == ["late old", "alive 1 not alive 0", "alive 0 not alive 1", "lost 2", "alive 1 not alive 0"]


TWO_LOGS_ON_A_LINE = """
from rclpy.node import Node


class Probe(Node):
    def __init__(self):
        super().__init__('probe')
        log = self.get_logger()
        for i in range(2):
            log.info(f'once {i}', once=True); log.info(f'skip {i}', skip_first=True)
"""


def test_logs_on_one_line_are_filtered_apart(tmp_path):
    texts = node(tmp_path, TWO_LOGS_ON_A_LINE, lambda case: (case.run(0), case.texts)[1])
    assert texts == ["once 0", "skip 1"]
