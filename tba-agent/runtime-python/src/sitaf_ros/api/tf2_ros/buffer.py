"""The buffer of transforms of a node."""

from __future__ import annotations

from typing import Any

import tf2_py
from rclpy.duration import Duration
from rclpy.task import Future
from rclpy.time import Time

from sitaf_ros.current import message, system

from .buffer_interface import BufferInterface

DEFAULT_CACHE_TIME_S = 10


class Buffer(tf2_py.BufferCore, BufferInterface):
    def __init__(self, cache_time: Duration | None = None, node: Any = None) -> None:
        BufferInterface.__init__(self)
        tf2_py.BufferCore.__init__(self, cache_time or Duration(seconds=DEFAULT_CACHE_TIME_S))
        self._watchers: list[tuple[Any, Future]] = []
        if node is not None:
            service = message("tf2_msgs/srv/FrameGraph")
            self.srv = node.create_service(service, "tf2_frames", self._get_frames)

    def _get_frames(self, request: Any, response: Any) -> Any:
        response.frame_yaml = self.all_frames_as_yaml()
        return response

    def _set(self, transform: Any, static: bool) -> None:
        super()._set(transform, static)
        for watcher in list(self._watchers):
            ready, future = watcher
            if ready():
                self._watchers.remove(watcher)
                future.set_result(True)

    def lookup_transform(self, target_frame: str, source_frame: str, time: Any, timeout: Duration | None = None) -> Any:
        self._wait(lambda: self.can_transform_core(target_frame, source_frame, _time(time))[0], timeout)
        return self.lookup_transform_core(target_frame, source_frame, _time(time))

    async def lookup_transform_async(self, target_frame: str, source_frame: str, time: Any) -> Any:
        await self.wait_for_transform_async(target_frame, source_frame, time)
        return self.lookup_transform_core(target_frame, source_frame, _time(time))

    def lookup_transform_full(
        self,
        target_frame: str,
        target_time: Any,
        source_frame: str,
        source_time: Any,
        fixed_frame: str,
        timeout: Duration | None = None,
    ) -> Any:
        where = (target_frame, _time(target_time), source_frame, _time(source_time), fixed_frame)
        self._wait(lambda: self.can_transform_full_core(*where)[0], timeout)
        return self.lookup_transform_full_core(*where)

    async def lookup_transform_full_async(
        self, target_frame: str, target_time: Any, source_frame: str, source_time: Any, fixed_frame: str
    ) -> Any:
        where = (target_frame, _time(target_time), source_frame, _time(source_time), fixed_frame)
        await self.wait_for_transform_full_async(*where)
        return self.lookup_transform_full_core(*where)

    def can_transform(
        self,
        target_frame: str,
        source_frame: str,
        time: Any,
        timeout: Duration | None = None,
        return_debug_tuple: bool = False,
    ) -> Any:
        self._wait(lambda: self.can_transform_core(target_frame, source_frame, _time(time))[0], timeout)
        found = self.can_transform_core(target_frame, source_frame, _time(time))
        return found if return_debug_tuple else found[0]

    def can_transform_full(
        self,
        target_frame: str,
        target_time: Any,
        source_frame: str,
        source_time: Any,
        fixed_frame: str,
        timeout: Duration | None = None,
        return_debug_tuple: bool = False,
    ) -> Any:
        where = (target_frame, _time(target_time), source_frame, _time(source_time), fixed_frame)
        self._wait(lambda: self.can_transform_full_core(*where)[0], timeout)
        found = self.can_transform_full_core(*where)
        return found if return_debug_tuple else found[0]

    def wait_for_transform_async(self, target_frame: str, source_frame: str, time: Any) -> Future:
        return self._watch(lambda: self.can_transform_core(target_frame, source_frame, _time(time))[0])

    def wait_for_transform_full_async(
        self, target_frame: str, target_time: Any, source_frame: str, source_time: Any, fixed_frame: str
    ) -> Future:
        where = (target_frame, _time(target_time), source_frame, _time(source_time), fixed_frame)
        return self._watch(lambda: self.can_transform_full_core(*where)[0])

    def _watch(self, ready: Any) -> Future:
        future = Future()
        if ready():
            future.set_result(True)
        else:
            self._watchers.append((ready, future))
        return future

    def _wait(self, ready: Any, timeout: Duration | None) -> None:
        """Wait in simulated time; transforms arrive only if another thread spins, as in ROS."""
        if timeout is None or timeout.nanoseconds <= 0 or ready():
            return
        threads = system().threads
        me, end = threads.current(), threads.now_ns + timeout.nanoseconds
        future = self._watch(ready)

        def done(_: Future) -> None:
            threads.wake(me)

        done.runs_at_once = True  # type: ignore[attr-defined]
        future.add_done_callback(done)
        while not future.done() and threads.now_ns < end and not threads.ending:
            threads.wait(end)


def _time(time: Any) -> Time:
    if isinstance(time, Time):
        return time
    if hasattr(time, "sec"):
        return Time.from_msg(time)
    raise TypeError(f"expected rclpy.time.Time, got {type(time)}")
