"""Switches a heater by a thermostat, as a managed node."""

import rclpy
from rclpy.lifecycle import LifecycleNode, TransitionCallbackReturn
from std_msgs.msg import Bool, Float64


class Heater(LifecycleNode):
    """Publishes whether to heat for each temperature, while it is active. The target belongs to a configuration."""

    def __init__(self):
        super().__init__("heater")
        self.declare_parameter("target", 20.0)
        self.target = None
        self.commands = None
        self.create_subscription(Float64, "target", self.on_target, 10)
        self.create_subscription(Float64, "temperature", self.on_temperature, 10)

    def on_configure(self, state):
        self.target = self.get_parameter("target").value
        self.commands = self.create_lifecycle_publisher(Bool, "heat", 10)
        return super().on_configure(state)

    def on_cleanup(self, state):
        self.destroy_lifecycle_publisher(self.commands)
        self.commands = None
        self.target = None
        return TransitionCallbackReturn.SUCCESS

    def on_target(self, message):
        if self.target is not None:
            self.target = message.data

    def on_temperature(self, message):
        if self.commands is not None and self.commands.is_activated:
            self.commands.publish(Bool(data=message.data < self.target))


def main():
    rclpy.init()
    rclpy.spin(Heater())
