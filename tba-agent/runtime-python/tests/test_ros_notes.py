"""Notes about a case, and the stamps of messages that the test publishes."""

import pytest

from tests.ros_cases import node

HEAD = """
import rclpy
from rclpy.node import Node
"""

LISTENER = (
    HEAD
    + """
from geometry_msgs.msg import Twist, TwistStamped
from nav_msgs.msg import Path
from tf2_msgs.msg import TFMessage
from tf2_ros import Buffer, TransformListener
class Probe(Node):
    def __init__(self):
        super().__init__('probe')
        self.create_subscription(TFMessage, '/tf', self.transforms, 10)
        self.create_subscription(Path, 'path', self.path, 10)
        self.create_subscription(TwistStamped, 'speed', self.never, 10)
        self.listener = TransformListener(Buffer(), self)

    def transforms(self, message):
        self.get_logger().info(' '.join(str(t.header.stamp.sec - 1_700_000_000) for t in message.transforms))

    def path(self, message):
        stamps = [message.header.stamp, *(p.header.stamp for p in message.poses)]
        self.get_logger().info(' '.join(str(s.sec) for s in stamps))

    def never(self, message):
        pass
"""
)


def test_headers_in_elements_have_the_time_of_publication_unless_they_are_named(tmp_path):
    def script(case):
        case.run(2)
        transform = {"child_frame_id": "lidar", "header": {"frame_id": "base"}}
        early = {"child_frame_id": "camera", "header": {"frame_id": "base", "stamp": {}}}
        case.system.publish("/tf", "tf2_msgs/msg/TFMessage", {"transforms": [transform, early]})
        poses = [{"header": {"stamp": {"sec": 7}}}, {"pose": {"position": {"x": 1.0}}}]
        case.system.publish("/path", "nav_msgs/msg/Path", {"header": {"stamp": {"sec": 5}}, "poses": poses})
        case.run(3)
        return case.texts

    assert node(tmp_path, LISTENER, script) == ["2 -1700000000", "5 7 1700000002"]


def test_different_types_are_no_quality_of_service_and_callbacks_of_the_api_are_not_named(tmp_path):
    def script(case):
        case.system.advertise("/speed", "geometry_msgs/msg/Twist")
        case.run(1)
        return case.system.report()

    report = node(tmp_path, LISTENER, script)
    assert report.incompatible_qos == ()
    assert report.different_types == (
        "/speed: the test -> /probe: geometry_msgs/msg/Twist and geometry_msgs/msg/TwistStamped",
    )
    assert report.uncalled_callbacks == ("Probe.never", "Probe.path", "Probe.transforms")


TIMER = (
    HEAD
    + """
from rclpy.timer import TimerInfo
class Probe(Node):
    def __init__(self):
        super().__init__('probe')
        self.create_timer(1.0, self.tick)

    def tick(self, PARAMETER):
        self.get_logger().info('tick')

def main():
    with rclpy.init():
        rclpy.spin(Probe())
"""
)


def test_a_parameter_of_a_timers_callback_is_an_error_unless_it_is_a_timer_info(tmp_path):
    def script(case):
        case.run(1)
        return case.texts, case.system.report().warnings

    texts, warnings = node(tmp_path, TIMER.replace("PARAMETER", "info: TimerInfo"), script, entry="followed:main")
    assert texts == ["tick"]
    assert warnings == (
        "TimerInfo for the callback of a timer: in ROS 2 from Kilted on, an error in Jazzy",
        "with rclpy.init(): in ROS 2 from Kilted on, an error in Jazzy",
    )
    with pytest.raises(AssertionError, match=r"TypeError: .*missing 1 required positional argument: 'event'"):
        node(tmp_path, TIMER.replace("PARAMETER", "event"), script, entry="followed:main")


ASKING = (
    HEAD
    + """
class Probe(Node):
    def __init__(self):
        super().__init__('probe')
        self.create_timer(0.1, lambda: input('Name: '))
"""
)


@pytest.mark.parametrize(("lines", "warns"), [((), True), (("Ada",), False)])
def test_a_node_that_waits_for_a_line_is_told_how_to_get_one(tmp_path, lines, warns):
    def script(case):
        case.run(1)
        return case.system.report().warnings

    warnings = node(tmp_path, ASKING, script, stdin=lines)
    assert any("stdin in activity.yaml" in warning for warning in warnings) == warns
