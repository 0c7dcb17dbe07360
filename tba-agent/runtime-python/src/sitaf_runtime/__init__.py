"""Runtime library of Python test applications; components under test may import it, too."""

from sitaf_runtime.out import Out
from sitaf_runtime.robot.geometry import Quaternion, Vector
from sitaf_runtime.robot.hardware import Hardware

__all__ = ["Hardware", "Out", "Quaternion", "Vector"]
__version__ = "0.1.0"
