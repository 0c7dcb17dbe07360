"""Transforms, message filters and diagnostics."""

import math

import pytest

from sitaf_ros.transform_tree import (
    ArgumentError,
    ExtrapolationError,
    Rigid,
    TransformTree,
    UnconnectedError,
    UnknownFrameError,
    slerp,
)
from tests.ros_cases import node

S = 1_000_000_000


def turned(angle):
    return (0.0, 0.0, math.sin(angle / 2), math.cos(angle / 2))


@pytest.fixture
def tree():
    tree = TransformTree()
    tree.set("map", "odom", Rigid((1.0, 0.0, 0.0)), 0, static=True)
    for second in (1, 2, 3):
        tree.set("odom", "base", Rigid((second, 0.0, 0.0), turned(second * math.pi / 4)), second * S, static=False)
    tree.set("base", "laser", Rigid((0.5, 0.0, 0.0), turned(math.pi)), 0, static=True)
    return tree


def test_interpolation_between_samples(tree):
    found, time = tree.lookup("map", "base", int(1.5 * S))
    assert found.translation == pytest.approx((2.5, 0, 0))
    assert found.rotation == pytest.approx(turned(1.5 * math.pi / 4))
    assert time == 1.5 * S


def test_the_latest_common_time_and_the_inverse(tree):
    forth, time = tree.lookup("map", "laser", 0)
    back, _ = tree.lookup("laser", "map", 0)
    assert time == 3 * S
    assert forth.applied((0.0, 0.0, 0.0)) == pytest.approx(
        (4 + 0.5 * math.cos(3 * math.pi / 4), 0.5 * math.sin(3 * math.pi / 4), 0)
    )
    assert back.applied(forth.applied((1.0, 2.0, 3.0))) == pytest.approx((1, 2, 3))


@pytest.mark.parametrize(
    ("target", "source", "time", "error", "text"),
    [
        ("map", "base", 0.5, ExtrapolationError, "into the past"),
        ("map", "base", 3.5, ExtrapolationError, "into the future.  Requested time 3.500000 but the latest data is at"),
        ("map", "nowhere", 0, UnknownFrameError, '"nowhere" passed to lookupTransform argument source_frame does not'),
        ("map", "other", 0, UnconnectedError, "Could not find a connection between 'map' and 'other'"),
        ("/map", "base", 0, ArgumentError, "cannot start with a '/'"),
    ],
)
def test_errors_of_lookups(tree, target, source, time, error, text):
    tree.set("island", "other", Rigid(), 0, static=True)
    with pytest.raises(error) as e:
        tree.lookup(target, source, int(time * S))
    assert text in str(e.value)


def test_what_is_refused_and_what_is_forgotten(tree):
    assert "same" in tree.set("a", "a", Rigid(), 0, static=False)
    assert "nan" in tree.set("a", "b", Rigid((math.nan, 0.0, 0.0)), 0, static=False)
    assert "quaternion" in tree.set("a", "b", Rigid(rotation=(0.0, 0.0, 0.0, 0.0)), 0, static=False)
    assert tree.set("odom", "base", Rigid(), 12 * S, static=False) is None
    with pytest.raises(ExtrapolationError):
        tree.lookup("odom", "base", int(1.5 * S))
    assert "old" in tree.set("odom", "base", Rigid(), 1 * S, static=False)


def test_slerp_takes_the_shorter_arc():
    assert slerp(turned(0.2), tuple(-c for c in turned(0.6)), 0.5) == pytest.approx(turned(0.4))


FOLLOWS = """
import math
import rclpy
from rclpy.duration import Duration
from rclpy.node import Node
from geometry_msgs.msg import PointStamped, TransformStamped
from tf2_ros import Buffer, TransformListener, TransformBroadcaster, StaticTransformBroadcaster, TransformException
from tf_transformations import quaternion_from_euler, euler_from_quaternion
import tf2_geometry_msgs

class Probe(Node):
    def __init__(self):
        super().__init__('probe')
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.fixed = StaticTransformBroadcaster(self)
        self.moving = TransformBroadcaster(self)
        mount = TransformStamped()
        mount.header.stamp = self.get_clock().now().to_msg()
        mount.header.frame_id, mount.child_frame_id = 'base', 'laser'
        mount.transform.translation.x = 0.5
        self.fixed.sendTransform(mount)
        self.out = self.create_publisher(PointStamped, 'out', 10)
        self.create_timer(0.5, self.tick)

    def tick(self):
        moved = TransformStamped()
        moved.header.stamp = self.get_clock().now().to_msg()
        moved.header.frame_id, moved.child_frame_id = 'odom', 'base'
        q = quaternion_from_euler(0.0, 0.0, math.pi / 2)
        r = moved.transform.rotation
        r.x, r.y, r.z, r.w = q
        self.moving.sendTransform(moved)
        try:
            found = self.buffer.lookup_transform('map', 'laser', rclpy.time.Time())
        except TransformException as e:
            self.get_logger().info(str(e))
            return
        point = PointStamped()
        point.header.frame_id, point.header.stamp = 'laser', found.header.stamp
        point.point.x = 1.0
        self.out.publish(self.buffer.transform(point, 'map', Duration(seconds=0.1)))
        yaw = euler_from_quaternion([r.x, r.y, r.z, r.w])[2]
        self.get_logger().info(f'{yaw:.6f}')
"""


def test_a_node_listens_to_and_broadcasts_transforms(tmp_path):
    def script(case):
        got = case.heard("/out", "geometry_msgs/msg/PointStamped", "point")
        fixed = {"header": {"frame_id": "map"}, "child_frame_id": "odom", "transform": {"translation": {"x": 10}}}
        case.run(0.7)
        case.system.publish("/tf_static", "tf2_msgs/msg/TFMessage", {"transforms": [fixed]})
        case.run(1.2)
        return [(t, (p.x, p.y, p.z)) for t, p in got], case.texts

    got, texts = node(tmp_path, FOLLOWS, script)
    assert [t for t, _ in got] == [1.0]
    assert got[0][1] == pytest.approx((10, 1.5, 0))
    assert texts[0] == '"map" passed to lookupTransform argument target_frame does not exist. '
    assert texts[-1] == "1.570796"


FILTERS = """
import rclpy
from rclpy.node import Node
from sensor_msgs.msg import Imu, Range
from diagnostic_updater import Updater, FrequencyStatus, FrequencyStatusParam
from diagnostic_msgs.msg import DiagnosticStatus
from message_filters import ApproximateTimeSynchronizer, Subscriber, TimeSynchronizer

class Probe(Node):
    def __init__(self):
        super().__init__('probe')
        imu, near = Subscriber(self, Imu, 'imu'), Subscriber(self, Range, 'range')
        self.exact = TimeSynchronizer([imu, near], 10)
        self.exact.registerCallback(lambda a, b: self.get_logger().info('exact'))
        self.close = ApproximateTimeSynchronizer([imu, near], 10, 0.05)
        self.close.registerCallback(self.together)
        self.updater = Updater(self)
        self.updater.setHardwareID('arm')
        self.updater.add('Battery', self.battery)

    def together(self, imu, near):
        self.get_logger().info(f'close {near.range:.1f}')

    def battery(self, stat):
        stat.summary(DiagnosticStatus.WARN, 'low')
        stat.add('volts', 11.5)
        return stat
"""


def test_filters_and_diagnostics(tmp_path):
    def script(case):
        statuses = []
        case.system.subscribe(
            "/diagnostics",
            "diagnostic_msgs/msg/DiagnosticArray",
            lambda m, t: statuses.append((t / S, m.status[0].name, m.status[0].level, m.status[0].message)),
        )
        for time, topic, kind, fields in (
            (0.10, "/imu", "Imu", {}),
            (0.14, "/range", "Range", {"range": 1}),
            (0.30, "/range", "Range", {"range": 2}),
            (0.38, "/imu", "Imu", {}),
            (0.50, "/imu", "Imu", {}),
            (0.50, "/range", "Range", {"range": 3}),
        ):
            case.run(time)
            case.system.publish(topic, f"sensor_msgs/msg/{kind}", fields)
        case.run(1.5)
        return statuses, case.texts

    statuses, texts = node(tmp_path, FILTERS, script)
    assert statuses == [
        (0.0, "probe: Battery", b"\0", "Node starting up"),
        (1.0, "probe: Battery", b"\1", "low"),
    ]
    assert texts == ["close 1.0", "exact", "close 3.0"]


CLOUD = """
import math
from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from sensor_msgs_py import point_cloud2
from std_msgs.msg import Header
from tf2_geometry_msgs import PoseStamped
from tf2_sensor_msgs.tf2_sensor_msgs import do_transform_cloud


class Probe(Node):
    def __init__(self):
        super().__init__('probe')
        turned = TransformStamped()
        turned.header.frame_id = 'odom'
        turned.transform.translation.x = 10.0
        turned.transform.rotation.z = turned.transform.rotation.w = math.sqrt(0.5)
        cloud = point_cloud2.create_cloud_xyz32(Header(frame_id='laser'), [(1, 0, 3), (0, 2, 4)])
        moved = do_transform_cloud(cloud, turned)
        points = [[round(float(v), 5) + 0.0 for v in p] for p in point_cloud2.read_points_list(moved)]
        self.get_logger().info(f'{moved.header.frame_id} {points} {PoseStamped().pose.orientation.w}')
"""


def test_a_point_cloud_is_transformed(tmp_path):
    texts = node(tmp_path, CLOUD, lambda case: (case.run(0), case.texts)[1])
    assert texts == ["odom [[10.0, 1.0, 3.0], [8.0, 0.0, 4.0]] 1.0"]
