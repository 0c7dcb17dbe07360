"""The name under which nodes find the exceptions of rclpy's C++ part."""

from .. import _rclpy_pybind11 as rclpy_implementation

__all__ = ["rclpy_implementation"]
