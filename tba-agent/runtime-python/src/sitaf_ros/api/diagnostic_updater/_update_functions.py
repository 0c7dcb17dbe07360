"""Tasks for frequencies and time stamps."""

from __future__ import annotations

import threading
from typing import Any

from rclpy.clock import ROSClock
from rclpy.time import Time

from ._diagnostic_status_wrapper import ERROR, OK, WARN
from ._diagnostic_updater import DiagnosticTask, FunctionDiagnosticTask

GenericFunctionDiagnosticTask = FunctionDiagnosticTask


class FrequencyStatusParam:
    """`freq_bound` holds `min` and `max` in Hz."""

    def __init__(self, freq_bound: dict[str, float], tolerance: float = 0.1, window_size: int = 5) -> None:
        self.freq_bound, self.tolerance, self.window_size = freq_bound, tolerance, window_size


class FrequencyStatus(DiagnosticTask):
    def __init__(self, params: FrequencyStatusParam, name: str = "FrequencyStatus") -> None:
        super().__init__(name)
        self.params, self.lock, self.clock = params, threading.Lock(), ROSClock()
        self.clear()

    def clear(self) -> None:
        with self.lock:
            self.count = 0
            now = self.clock.now()
            self.times = [now] * self.params.window_size
            self.seq_nums = [0] * self.params.window_size
            self.hist_indx = 0

    def tick(self) -> None:
        with self.lock:
            self.count += 1

    def run(self, stat: Any) -> Any:
        with self.lock:
            now = self.clock.now()
            events = self.count - self.seq_nums[self.hist_indx]
            window = (now - self.times[self.hist_indx]).nanoseconds / 1e9
            frequency = events / window if window > 0 else 0.0
            self.seq_nums[self.hist_indx], self.times[self.hist_indx] = self.count, now
            self.hist_indx = (self.hist_indx + 1) % self.params.window_size
            low, high = self.params.freq_bound["min"], self.params.freq_bound["max"]
            tolerance = self.params.tolerance
            if events == 0:
                stat.summary(ERROR, "No events recorded.")
            elif frequency < low * (1 - tolerance):
                stat.summary(WARN, "Frequency too low.")
            elif frequency > high * (1 + tolerance):
                stat.summary(WARN, "Frequency too high.")
            else:
                stat.summary(OK, "Desired frequency met")
            stat.addf("Events in window", "%d", events)
            stat.addf("Events since startup", "%d", self.count)
            stat.addf("Duration of window (s)", "%f", window)
            stat.addf("Actual frequency (Hz)", "%f", frequency)
            if low == high:
                stat.addf("Target frequency (Hz)", "%f", low)
            if low > 0:
                stat.addf("Minimum acceptable frequency (Hz)", "%f", low * (1 - tolerance))
            stat.addf("Maximum acceptable frequency (Hz)", "%f", high * (1 + tolerance))
        return stat


class TimeStampStatusParam:
    """Bounds of now minus stamp, in s."""

    def __init__(self, min_acceptable: float = -1, max_acceptable: float = 5) -> None:
        self.min_acceptable, self.max_acceptable = min_acceptable, max_acceptable


class TimeStampStatus(DiagnosticTask):
    def __init__(self, params: TimeStampStatusParam | None = None, name: str = "Timestamp Status") -> None:
        super().__init__(name)
        self.params, self.lock, self.clock = params or TimeStampStatusParam(), threading.Lock(), ROSClock()
        self.early_count = self.late_count = self.zero_count = 0
        self.zero_seen = False
        self.max_delta: float | None = None
        self.min_delta: float | None = None

    def tick(self, stamp: Any) -> None:
        if isinstance(stamp, Time):
            seconds = stamp.nanoseconds / 1e9
        else:
            seconds = stamp.sec + stamp.nanosec / 1e9 if hasattr(stamp, "sec") else float(stamp)
        with self.lock:
            if seconds == 0:
                self.zero_seen = True
                return
            delta = self.clock.now().nanoseconds / 1e9 - seconds
            self.max_delta = delta if self.max_delta is None else max(self.max_delta, delta)
            self.min_delta = delta if self.min_delta is None else min(self.min_delta, delta)

    def run(self, stat: Any) -> Any:
        with self.lock:
            stat.summary(OK, "Timestamps are reasonable.")
            if self.max_delta is None or self.min_delta is None:
                stat.summary(WARN, "No data since last update.")
            else:
                if self.min_delta < self.params.min_acceptable:
                    stat.summary(ERROR, "Timestamps too far in future seen.")
                    self.early_count += 1
                if self.max_delta > self.params.max_acceptable:
                    stat.summary(ERROR, "Timestamps too far in past seen.")
                    self.late_count += 1
            if self.zero_seen:
                stat.summary(ERROR, "Zero timestamp seen.")
                self.zero_count += 1
            stat.addf("Earliest timestamp delay", "%f", self.min_delta or 0.0)
            stat.addf("Latest timestamp delay", "%f", self.max_delta or 0.0)
            stat.addf("Earliest acceptable timestamp delay", "%f", self.params.min_acceptable)
            stat.addf("Latest acceptable timestamp delay", "%f", self.params.max_acceptable)
            stat.add("Late diagnostic update count", self.late_count)
            stat.add("Early diagnostic update count", self.early_count)
            stat.add("Zero seen diagnostic update count", self.zero_count)
            self.min_delta = self.max_delta = None
            self.zero_seen = False
        return stat


class Heartbeat(DiagnosticTask):
    def __init__(self) -> None:
        super().__init__("Heartbeat")

    def run(self, stat: Any) -> Any:
        stat.summary(OK, "Alive")
        return stat
