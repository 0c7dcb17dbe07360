"""Filters of messages; see https://docs.ros.org/en/jazzy/p/message_filters/."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from typing import Any

from rclpy.clock_type import ClockType
from rclpy.duration import Duration
from rclpy.time import Time

from sitaf_ros.current import system

__all__ = ["ApproximateTimeSynchronizer", "Cache", "SimpleFilter", "Subscriber", "TimeSynchronizer"]


class SimpleFilter:
    """Calls its callbacks with each message."""

    def __init__(self) -> None:
        self.callbacks: dict[int, tuple[Callable[..., Any], tuple[Any, ...]]] = {}

    def registerCallback(self, cb: Callable[..., Any], *args: Any) -> int:
        connection = len(self.callbacks)
        self.callbacks[connection] = (cb, args)
        return connection

    def signalMessage(self, *msg: Any) -> None:
        for callback, args in list(self.callbacks.values()):
            callback(*(msg + args))


class Subscriber(SimpleFilter):
    def __init__(self, node: Any, msg_type: Any, topic: str, qos_profile: Any = 10, **kwargs: Any) -> None:
        super().__init__()
        self.node, self.topic = node, topic
        self.sub = node.create_subscription(msg_type, topic, self.callback, qos_profile, **kwargs)

    def callback(self, msg: Any) -> None:
        self.signalMessage(msg)

    def getTopic(self) -> str:
        return self.topic

    def unregister(self) -> None:
        self.node.destroy_subscription(self.sub)


def _stamp_of(msg: Any, headerless: bool, what: str) -> Time:
    if hasattr(msg, "header") and hasattr(msg.header, "stamp"):
        return Time.from_msg(msg.header.stamp)
    if headerless:
        return Time(nanoseconds=system().ros_time_ns(), clock_type=ClockType.ROS_TIME)
    raise ValueError(f"{what} needs messages with a header; {type(msg).__name__} has none (see allow_headerless)")


class Cache(SimpleFilter):
    def __init__(self, f: Any = None, cache_size: int = 1, allow_headerless: bool = False) -> None:
        super().__init__()
        self.cache_size, self.allow_headerless = cache_size, allow_headerless
        self.cache_msgs: list[Any] = []
        self.cache_times: list[Time] = []
        if f is not None:
            self.connectInput(f)

    def connectInput(self, f: Any) -> None:
        self.incoming_connection = f.registerCallback(self.add)

    def add(self, msg: Any) -> None:
        self.cache_times.append(_stamp_of(msg, self.allow_headerless, "Cache"))
        self.cache_msgs.append(msg)
        while len(self.cache_msgs) > self.cache_size:
            del self.cache_msgs[0], self.cache_times[0]
        self.signalMessage(msg)

    def _pairs(self) -> Any:
        return zip(self.cache_times, self.cache_msgs, strict=True)

    def getInterval(self, from_stamp: Time, to_stamp: Time) -> list[Any]:
        return [msg for stamp, msg in self._pairs() if from_stamp <= stamp <= to_stamp]

    def getElemAfterTime(self, stamp: Time) -> Any:
        later = [(at, i) for i, at in enumerate(self.cache_times) if at >= stamp]
        return self.cache_msgs[min(later, key=lambda p: (p[0].nanoseconds, p[1]))[1]] if later else None

    def getElemBeforeTime(self, stamp: Time) -> Any:
        earlier = [(at, i) for i, at in enumerate(self.cache_times) if at <= stamp]
        return self.cache_msgs[max(earlier, key=lambda p: (p[0].nanoseconds, p[1]))[1]] if earlier else None

    def getLastestTime(self) -> Time | None:
        return self.cache_times[-1] if self.cache_times else None

    getLatestTime = getLastestTime

    def getOldestTime(self) -> Time | None:
        return self.cache_times[0] if self.cache_times else None

    def getLast(self) -> Any:
        return self.cache_msgs[-1] if self.cache_msgs else None


class TimeSynchronizer(SimpleFilter):
    """Calls back with one message of each input when all have the same stamp."""

    def __init__(self, fs: Any, queue_size: int) -> None:
        super().__init__()
        self.queue_size = queue_size
        self.connectInput(fs)

    def connectInput(self, fs: Any) -> None:
        self.queues: list[dict[int, Any]] = [{} for _ in fs]
        self.input_connections = [
            f.registerCallback(self.add, queue, i) for i, (f, queue) in enumerate(zip(fs, self.queues, strict=True))
        ]

    def add(self, msg: Any, my_queue: dict[int, Any], my_queue_index: int | None = None) -> None:
        stamp = _stamp_of(msg, False, "TimeSynchronizer").nanoseconds
        my_queue[stamp] = msg
        _bound(my_queue, self.queue_size)
        if all(stamp in queue for queue in self.queues):
            self.signalMessage(*[queue.pop(stamp) for queue in self.queues])


class ApproximateTimeSynchronizer(TimeSynchronizer):
    """Calls back with one message of each input when their stamps differ by less than `slop` seconds."""

    def __init__(
        self,
        fs: Any,
        queue_size: int,
        slop: float,
        allow_headerless: bool = False,
        sync_arrival_time: bool = False,
    ) -> None:
        super().__init__(fs, queue_size)
        self.slop = Duration(seconds=slop)
        self.allow_headerless, self.sync_arrival_time = allow_headerless, sync_arrival_time

    def add(self, msg: Any, my_queue: dict[int, Any], my_queue_index: int | None = None) -> None:
        if self.sync_arrival_time:
            stamp = system().ros_time_ns()
        else:
            stamp = _stamp_of(msg, self.allow_headerless, "ApproximateTimeSynchronizer").nanoseconds
        my_queue[stamp] = msg
        _bound(my_queue, self.queue_size)
        slop = self.slop.nanoseconds
        near: list[list[int]] = []
        for queue in self.queues:
            if queue is my_queue:
                near.append([stamp])
            else:
                near.append(sorted((s for s in queue if abs(s - stamp) <= slop), key=lambda s: abs(s - stamp)))
        if not all(near):
            return
        for chosen in itertools.product(*near):
            if max(chosen) - min(chosen) <= slop:
                self.signalMessage(*[queue.pop(s) for queue, s in zip(self.queues, chosen, strict=True)])
                return


def _bound(queue: dict[int, Any], size: int) -> None:
    while len(queue) > size:
        del queue[min(queue)]
