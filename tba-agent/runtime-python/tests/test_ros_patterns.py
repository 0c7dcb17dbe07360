"""Ways in which public nodes use rclpy: teleoperation, threads that spin, blocking calls, waits for transforms."""

from tests.ros_cases import node

TELEOP = """
import os, select, sys, termios, tty
import rclpy
from geometry_msgs.msg import Twist

MODEL = os.environ['MODEL']

def key_of(settings):
    tty.setraw(sys.stdin.fileno())
    ready, _, _ = select.select([sys.stdin], [], [], 0.1)
    key = sys.stdin.read(1) if ready else ''
    termios.tcsetattr(sys.stdin, termios.TCSADRAIN, settings)
    return key

def main():
    settings = termios.tcgetattr(sys.stdin)
    rclpy.init()
    node = rclpy.create_node('teleop')
    out = node.create_publisher(Twist, 'cmd_vel', 10)
    speed = 0.0
    try:
        while True:
            key = key_of(settings)
            speed += {'w': 0.5, 'x': -0.5}.get(key, 0.0)
            message = Twist()
            message.linear.x = speed
            out.publish(message)
    except Exception as e:
        print(e)
    finally:
        out.publish(Twist())
        termios.tcsetattr(sys.stdin, termios.TCSADRAIN, settings)
        node.get_logger().info('restored')
"""


def test_a_teleoperation_node_reads_keys_from_its_terminal(tmp_path, monkeypatch):
    monkeypatch.setenv("MODEL", "burger")

    def script(case):
        got = []
        case.system.subscribe("/cmd_vel", "geometry_msgs/msg/Twist", lambda m, t: got.append((t / 1e9, m.linear.x)))
        case.run(0.35)
        case.system.end()
        return got, case.texts

    got, texts = node(tmp_path, TELEOP, script, entry="followed:main", stdin=["ww"])
    assert [speed for t, speed in got if t == 0] == [0.5, 1.0, 1.0]
    assert [t for t, _ in got][3:] == [0.1, 0.2, 0.30000000000000004] or [t for t, _ in got][3:] == [0.1, 0.2, 0.3]
    assert texts == ["restored"]


SPINS_IN_THREAD = """
import threading
import rclpy
from geometry_msgs.msg import Twist
from std_msgs.msg import Bool

class PublishThread(threading.Thread):
    def __init__(self, node, period):
        super().__init__()
        self.publisher = node.create_publisher(Twist, 'cmd_vel', 10)
        self.condition, self.done, self.period, self.x = threading.Condition(), False, period, 0.0
        self.start()

    def update(self, x):
        with self.condition:
            self.x = x
            self.condition.notify()

    def run(self):
        while not self.done:
            with self.condition:
                self.condition.wait(self.period)
                message = Twist()
                message.linear.x = self.x
            self.publisher.publish(message)

def main():
    rclpy.init()
    node = rclpy.create_node('driver')
    publisher = PublishThread(node, 0.2)
    node.create_subscription(Bool, 'go', lambda m: publisher.update(1.0 if m.data else 0.0), 10)
    spinner = threading.Thread(target=rclpy.spin, args=(node,))
    spinner.start()
    rate = node.create_rate(5)
    try:
        while rclpy.ok():
            rate.sleep()
    finally:
        publisher.done = True
        spinner.join()
        publisher.join(0.5)
        node.get_logger().info('joined')
        rclpy.shutdown()
"""


def test_threads_that_spin_and_publish_end_with_the_case(tmp_path):
    def script(case):
        got = []
        case.system.subscribe("/cmd_vel", "geometry_msgs/msg/Twist", lambda m, t: got.append((t // 10**7, m.linear.x)))
        case.run(0.5)
        case.system.publish("/go", "std_msgs/msg/Bool", {"data": True})
        case.run(1)
        case.system.end()
        return got, case.texts, case.system.ended

    got, texts, ended = node(tmp_path, SPINS_IN_THREAD, script, entry="followed:main")
    assert got == [(20, 0.0), (40, 0.0), (50, 1.0), (70, 1.0), (90, 1.0)]
    assert (texts, ended) == (["joined"], True)


BLOCKS = """
import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from std_srvs.srv import Trigger

class Probe(Node):
    def __init__(self):
        super().__init__('probe')
        self.client = self.create_client(Trigger, 'ask', callback_group=MutuallyExclusiveCallbackGroup())
        self.create_timer(1.0, self.tick, callback_group=ReentrantCallbackGroup())
        self.create_timer(0.4, lambda: self.get_logger().info('other'))

    def tick(self):
        self.get_logger().info(self.client.call(Trigger.Request()).message)

def main():
    with rclpy.init():
        executor = MultiThreadedExecutor(3)
        executor.add_node(Probe())
        executor.spin()
"""


def test_a_blocking_call_waits_while_other_threads_of_the_executor_work(tmp_path):
    def script(case):
        from sitaf_ros import Delayed

        case.system.serve_service("/ask", "std_srvs/srv/Trigger", lambda r: Delayed(0.5, {"message": "answer"}))
        case.run(1.7)
        return case.texts

    assert node(tmp_path, BLOCKS, script, entry="followed:main") == ["other", "other", "other", "answer", "other"]


WAITS = """
import rclpy
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.time import Time
from tf2_ros import Buffer, LookupException, TransformListener

class Probe(Node):
    def __init__(self):
        super().__init__('probe')
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self, spin_thread=False)
        self.timer = self.create_timer(0.1, self.tick)

    async def tick(self):
        self.timer.cancel()
        try:
            self.buffer.lookup_transform('a', 'b', Time(), timeout=Duration(seconds=0.3))
        except LookupException:
            self.get_logger().info(f'not yet at {self.get_clock().now().nanoseconds % 10**9 / 1e9}')
        found = await self.buffer.lookup_transform_async('a', 'b', Time())
        self.get_logger().info(f'{found.transform.translation.y} {self.get_clock().now().nanoseconds % 10**9 / 1e9}')
"""


def test_waiting_for_a_transform_with_a_timeout_and_asynchronously(tmp_path):
    def script(case):
        case.run(0.7)
        moved = {"header": {"frame_id": "a"}, "child_frame_id": "b", "transform": {"translation": {"y": 2}}}
        case.system.publish("/tf", "tf2_msgs/msg/TFMessage", {"transforms": [moved]})
        case.run(1)
        return case.texts

    assert node(tmp_path, WAITS, script) == ["not yet at 0.4", "2.0 0.7"]


SWALLOWS = """
import rclpy
from rclpy.node import Node

class Probe(Node):
    def __init__(self):
        super().__init__('probe')
        self.create_timer(1.0, self.tick)

    def tick(self):
        raise SystemExit

def main():
    rclpy.init()
    node = Probe()
    try:
        rclpy.spin(node)
    except SystemExit:
        rclpy.logging.get_logger('quit').info('quitting')
    node.destroy_node()
    rclpy.shutdown()
"""


def test_system_exit_in_a_callback_ends_main_as_in_ros(tmp_path):
    def script(case):
        case.run(3)
        return case.texts, case.system.ended

    assert node(tmp_path, SWALLOWS, script, entry="followed:main") == (["quitting"], True)


OWN_NAMES = """
import rclpy
from rclpy.lifecycle import LifecycleNode, TransitionCallbackReturn
from std_msgs.msg import String

class Probe(LifecycleNode):
    def __init__(self):
        super().__init__('probe')
        self._publishers, self._timers, self._clients, self._subscriptions = {}, {}, {}, {}
        self._state, self._name, self._executor, self._store, self._group = 'idle', 'x', None, {}, None
        self.entities, self._rates, self._destroyed, self._trigger = [], [], True, None
        self._publishers['out'] = self.create_publisher(String, 'out', 10)
        self._timers['tick'] = self.create_timer(0.5, self.wake)

    def wake(self):
        self._publishers['out'].publish(String(data=f'{self._state} {self.get_name()}'))

    def keep(self):
        return 1

    def on_configure(self, state):
        self._state = 'ready'
        return TransitionCallbackReturn.SUCCESS
"""


def test_a_node_may_use_names_that_rclpy_leaves_to_it(tmp_path):
    def script(case):
        got = case.heard("/out", "std_msgs/msg/String")
        case.run(0.6)
        call = case.system.call_service(
            "/probe/change_state", "lifecycle_msgs/srv/ChangeState", {"transition": {"id": 1}}
        )
        case.run(1)
        return got, call.response.success

    assert node(tmp_path, OWN_NAMES, script) == ([(0.5, "idle probe"), (1.0, "ready probe")], True)


RANDOM = """
import random, uuid
import numpy
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

class Probe(Node):
    made = 0

    def __init__(self):
        super().__init__('probe')
        Probe.made += 1
        out = self.create_publisher(String, 'out', 10)
        draws = random.random(), numpy.random.default_rng().random(), uuid.uuid4().hex, Probe.made
        self.create_timer(0.1, lambda: out.publish(String(data=repr(draws))))
"""


def test_several_cases_in_one_process_and_seeds(tmp_path):
    def script(case):
        from sitaf_ros import RosSettings

        application, seen = case.system.application, []
        for seed in (1, 1, 2):
            system = application.start(RosSettings(seed=seed))
            system.subscribe("/out", "std_msgs/msg/String", lambda m, t: seen.append(eval(m.data)))
            system.run_until(150_000_000)
            system.end()
        return seen

    first, second, third = node(tmp_path, RANDOM, script)
    assert first[:3] == second[:3]
    assert first[:2] != third[:2]
    assert (first[3], second[3], third[3]) == (1, 2, 3)


TYPED = """
from rclpy.client import Client
from rclpy.node import Node
from rclpy.publisher import Publisher
from rclpy.task import Future
from std_msgs.msg import String
from turtlesim.srv import Spawn

class Probe(Node):
    def __init__(self) -> None:
        super().__init__('probe')
        self.client: Client[Spawn.Request, Spawn.Response] = self.create_client(Spawn, 'spawn')
        self.create_timer(0.1, lambda: self.ask(self.create_publisher(String, 'out', 1)))

    def ask(self, out: Publisher[String]) -> None:
        future = self.client.call_async(Spawn.Request(name='turtle2'))
        future.add_done_callback(lambda f: self.done(f, out))

    def done(self, future: Future[Spawn.Response], out: Publisher[String]) -> None:
        out.publish(String(data=future.result().name))
"""


def test_annotations_may_name_the_types_of_entities(tmp_path):
    def script(case):
        got = case.heard("/out", "std_msgs/msg/String")
        case.system.serve_service("/spawn", "turtlesim/srv/Spawn", lambda request: {"name": request.name})
        case.run(0.15)
        return got

    assert node(tmp_path, TYPED, script) == [(0.1, "turtle2")]


QOS_OVERRIDES = """
import diagnostic_msgs
from rclpy.node import Node
from rclpy.qos import QoSPolicyKind
from rclpy.qos_overriding_options import QosCallbackResult, QoSOverridingOptions
from std_msgs.msg import String

class Probe(Node):
    def __init__(self):
        super().__init__('probe')
        kinds = (QoSPolicyKind.DEPTH, QoSPolicyKind.RELIABILITY, QoSPolicyKind.DEADLINE)
        self.sub = self.create_subscription(
            String, 'in', lambda m: None, 10, qos_overriding_options=QoSOverridingOptions(kinds, callback=self.check))
        profile = self.sub.qos_profile
        self.get_logger().info(f'{profile.depth} {profile.reliability.name} {profile.deadline.nanoseconds}')
        self.get_logger().info(str(diagnostic_msgs.msg.DiagnosticStatus.WARN))

    def check(self, profile):
        result = QosCallbackResult()
        result.successful, result.reason = profile.depth <= 10, 'too deep'
        return result
"""


def test_parameters_override_the_quality_of_service(tmp_path):
    def script(case):
        case.run(0)
        return case.texts

    start = "qos_overrides./in.subscription."
    given = {f"{start}depth": 3, f"{start}reliability": "best_effort", f"{start}deadline": 500_000_000}
    assert node(tmp_path, QOS_OVERRIDES, script, parameters=given) == ["3 BEST_EFFORT 500000000", "b'\\x01'"]


IN_THE_TEST = """
import threading
from rclpy.node import Node

class Worker(threading.Thread):
    pass

class Probe(Node):
    def __init__(self):
        super().__init__('probe')
        plain, own = threading.Thread(target=print), Worker()
        self.get_logger().info(repr([isinstance(plain, Worker), isinstance(own, threading.Thread),
                                     isinstance(threading.main_thread(), threading.Thread)]))
"""


def test_threads_locks_and_clocks_of_the_test_itself_stay_real(tmp_path):
    def script(case):
        import threading
        import time

        case.run(0)
        begin, lock, done = time.monotonic(), threading.Lock(), []
        thread = threading.Thread(target=lambda: done.append(lock.acquire(timeout=1)))
        thread.start()
        thread.join()
        assert isinstance(threading.main_thread(), threading.Thread)
        return case.texts, done, time.monotonic() - begin < 1_000_000, abs(time.time() - 1_700_000_000) > 1000

    assert node(tmp_path, IN_THE_TEST, script) == (["[False, True, True]"], [True], True, True)
