"""Idioms of tutorials: a spin in a thread that the main function ends, and what comes with a message."""

import pytest

from tests.ros_cases import node

SPINS_ASIDE = """
import threading
import rclpy
from std_msgs.msg import String

def main():
    rclpy.init()
    node = rclpy.create_node('aside')
    pub = node.create_publisher(String, 'out', 10)
    thread = threading.Thread(target=TARGET, args=(node,), daemon=True)
    thread.start()
    rate = node.create_rate(5)
    for i in range(3):
        pub.publish(String(data=str(i)))
        rate.sleep()
    node.get_logger().info('over')
    rclpy.shutdown()
    thread.join()
"""


def test_a_thread_that_spins_ends_with_the_shutdown_of_the_main_function(tmp_path):
    def script(case):
        got = case.heard("/out", "std_msgs/msg/String")
        case.run(1)
        return got, case.texts, case.system.ended, case.system.report().warnings

    text = SPINS_ASIDE.replace("TARGET", "rclpy.spin")
    got, texts, ended, warnings = node(tmp_path, text, script, entry="followed:main")
    assert got == [(0.0, "0"), (0.2, "1"), (0.4, "2")]
    assert texts == ["over"]
    assert ended
    assert [w for w in warnings if "(spin)" in w and "ExternalShutdownException" in w]


def test_what_a_thread_raises_after_the_shutdown_stays_an_error(tmp_path):
    text = SPINS_ASIDE.replace("TARGET", "after") + (
        "\ndef after(node):\n    try:\n        rclpy.spin(node)\n    except Exception:\n        node.nothing()\n"
    )
    with pytest.raises(AssertionError, match=r"thread Thread-\d+ \(after\): AttributeError"):
        node(tmp_path, text, lambda case: case.run(1), entry="followed:main")


INFORMED = """
from rclpy.node import Node
from rclpy.subscription import MessageInfo
from std_msgs.msg import String

class Probe(Node):
    def __init__(self):
        super().__init__('probe')
        self.create_subscription(String, 'in', self.hear, 10)

    def hear(self, message, info: MessageInfo):
        age = info['received_timestamp'] - info['source_timestamp']
        self.get_logger().info(f"{message.data} {info['source_timestamp']} {age} {type(info).__name__}")
        self.get_logger().info(' '.join(sorted(info)))
"""


def test_the_info_of_a_message_is_a_dictionary(tmp_path):
    def script(case):
        case.run(0.25)
        case.system.publish("/in", "std_msgs/msg/String", {"data": "a"})
        case.run(1)
        return case.texts

    assert node(tmp_path, INFORMED, script) == [
        "a 1700000000250000000 0 dict",
        "publication_sequence_number received_timestamp reception_sequence_number source_timestamp",
    ]
