"""Contexts: whether rclpy is initialized."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import Any

from sitaf_ros.current import CURRENT

from ._rclpy_pybind11 import RCLError


class Context:
    def __init__(self) -> None:
        self._initialized = False
        self._shut_down = False
        self._callbacks: list[Callable[[], Any]] = []
        self._logging = False

    @property
    def handle(self) -> Context:
        return self

    def init(
        self, args: list[str] | None = None, *, initialize_logging: bool = True, domain_id: int | None = None
    ) -> None:
        from .utilities import apply_ros_arguments

        if domain_id is not None and domain_id < 0:
            raise RuntimeError(f"Domain id ({domain_id}) should not be lower than zero.")
        if self._initialized and not self._shut_down:
            raise RuntimeError("Context.init() must only be called once")
        apply_ros_arguments(sys.argv if args is None else args)
        self._initialized, self._shut_down = True, False

    def ok(self) -> bool:
        ending = CURRENT.threads is not None and CURRENT.threads.ending
        return self._initialized and not self._shut_down and not ending

    def case_ended(self) -> None:
        """The test case has ended: shut down without an error for those who do it again."""

    def shutdown(self) -> None:
        ending = CURRENT.threads is not None and CURRENT.threads.ending
        if not self._initialized or self._shut_down:
            if ending:
                return
            if self._shut_down:
                raise RCLError("failed to shutdown: rcl_shutdown already called on the given context")
            raise RuntimeError("Context must be initialized before it can be shutdown")
        self._shut_down = True
        self._call_back()

    def try_shutdown(self) -> None:
        if self._initialized and not self._shut_down:
            self._shut_down = True
            self._call_back()

    def _call_back(self) -> None:
        callbacks, self._callbacks = self._callbacks, []
        for callback in callbacks:
            callback()

    def on_shutdown(self, callback: Callable[[], Any]) -> None:
        if not callable(callback):
            raise TypeError("callback should be a callable")
        self._callbacks.append(callback)

    def get_domain_id(self) -> int:
        if not self._initialized:
            raise RuntimeError("Context must be initialized before it can be used")
        return 0

    def __enter__(self) -> Context:
        return self

    def __exit__(self, *_: object) -> None:
        self.try_shutdown()
