"""Drives forward and stops before an obstacle."""

import math

import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Float64

# Half of the sector ahead that counts, in radians.
SECTOR = 0.2


class WallStop(Node):
    """Drives with the speed of the last `start` message until something ahead is nearer than `stop_distance`."""

    def __init__(self):
        super().__init__("wall_stop")
        self.declare_parameter("stop_distance", 0.5)
        self.speed = 0.0
        self.create_subscription(Float64, "start", self.on_start, 10)
        self.create_subscription(LaserScan, "scan", self.on_scan, 10)
        self.publisher = self.create_publisher(Twist, "cmd_vel", 10)

    def on_start(self, speed):
        self.speed = speed.data

    def on_scan(self, scan):
        ahead = min(self.ahead(scan), default=math.inf)
        command = Twist()
        if ahead > self.get_parameter("stop_distance").value:
            command.linear.x = self.speed
        self.publisher.publish(command)

    @staticmethod
    def ahead(scan):
        """The distances ahead. An infinite one means that there is nothing."""
        for index, distance in enumerate(scan.ranges):
            if abs(scan.angle_min + index * scan.angle_increment) <= SECTOR and not math.isnan(distance):
                yield distance


def main():
    rclpy.init()
    rclpy.spin(WallStop())
    rclpy.shutdown()
