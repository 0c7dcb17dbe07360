"""What a Python test application links against, and so may a component under test."""

from sitaf_runtime.out import Out
from sitaf_runtime.robot.geometry import Quaternion, Vector
from sitaf_runtime.robot.hardware import Hardware

__all__ = ["Hardware", "Out", "Quaternion", "Vector"]
__version__ = "0.1.0"
