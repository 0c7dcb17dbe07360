"""Passes on the velocity command of the source with the highest priority that is not too old."""

import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node

PERIOD = 0.05


class VelocityMux(Node):
    """A person's commands hide those of navigation. A source counts for `timeout` seconds after its last command."""

    def __init__(self):
        super().__init__("velocity_mux")
        self.declare_parameter("timeout", 0.5)
        # From the highest priority to the lowest: time and content of the last command.
        self.sources = {"teleop": None, "navigation": None}
        self.create_subscription(Twist, "teleop/cmd_vel", self.on_teleop, 10)
        self.create_subscription(Twist, "navigation/cmd_vel", self.on_navigation, 10)
        self.publisher = self.create_publisher(Twist, "cmd_vel", 10)
        self.create_timer(PERIOD, self.on_timer)

    def on_teleop(self, command):
        self.sources["teleop"] = (self.get_clock().now(), command)

    def on_navigation(self, command):
        self.sources["navigation"] = (self.get_clock().now(), command)

    def on_timer(self):
        timeout = self.get_parameter("timeout").value
        now = self.get_clock().now()
        for last in self.sources.values():
            if last is not None and (now - last[0]).nanoseconds * 1e-12 <= timeout:
                self.publisher.publish(last[1])
                return
        # Nobody commands: stop.
        self.publisher.publish(Twist())


def main():
    rclpy.init()
    rclpy.spin(VelocityMux())
    rclpy.shutdown()
