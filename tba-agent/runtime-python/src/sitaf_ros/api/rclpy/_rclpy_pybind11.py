"""Exceptions that rclpy's C++ part raises and that nodes catch."""

from .exceptions import InvalidHandle, TimerCancelledError

__all__ = ["InvalidHandle", "RCLError", "TimerCancelledError"]


class RCLError(RuntimeError):
    pass
