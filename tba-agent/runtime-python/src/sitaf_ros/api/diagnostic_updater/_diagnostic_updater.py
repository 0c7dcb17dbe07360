"""Tasks, and the updater that runs them."""

from __future__ import annotations

import threading
from typing import Any

from sitaf_ros.callback_names import callback_name
from sitaf_ros.current import message

from ._diagnostic_status_wrapper import ERROR, OK, DiagnosticStatusWrapper

PERIOD = "diagnostic_updater.period"
USE_FQN = "diagnostic_updater.use_fqn"


class DiagnosticTask:
    def __init__(self, name: str) -> None:
        self.name = name

    def getName(self) -> str:
        return self.name

    def run(self, stat: Any) -> Any:
        return stat


class FunctionDiagnosticTask(DiagnosticTask):
    def __init__(self, name: str, fn: Any) -> None:
        super().__init__(name)
        self.fn = fn

    def run(self, stat: Any) -> Any:
        result = self.fn(stat)
        return stat if result is None else result


class CompositeDiagnosticTask(DiagnosticTask):
    def __init__(self, name: str) -> None:
        super().__init__(name)
        self.tasks: list[DiagnosticTask] = []

    def run(self, stat: Any) -> Any:
        combined = DiagnosticStatusWrapper()
        original = DiagnosticStatusWrapper()
        original.summary(stat)
        for task in self.tasks:
            stat.summary(original)
            stat = task.run(stat)
            combined.mergeSummary(stat)
        stat.summary(combined)
        return stat

    def addTask(self, t: DiagnosticTask) -> None:
        self.tasks.append(t)


class DiagnosticTaskVector:
    def __init__(self) -> None:
        self.tasks: list[DiagnosticTask] = []
        self.lock = threading.Lock()

    def addedTaskCallback(self, task: DiagnosticTask) -> None:
        """Called when a task is added."""

    def add(self, *args: Any) -> None:
        task = args[0] if len(args) == 1 else FunctionDiagnosticTask(args[0], args[1])
        with self.lock:
            self.tasks.append(task)
            self.addedTaskCallback(task)

    def removeByName(self, name: str) -> bool:
        with self.lock:
            found = [task for task in self.tasks if task.name == name]
            self.tasks = [task for task in self.tasks if task.name != name]
            return bool(found)


class Updater(DiagnosticTaskVector):
    def __init__(self, node: Any, period: float = 1.0) -> None:
        super().__init__()
        self.node = node
        self.publisher = node.create_publisher(message("diagnostic_msgs/msg/DiagnosticArray"), "/diagnostics", 1)
        self.clock = node.get_clock()
        self.verbose = False
        self.hwid = ""
        if not node.has_parameter(PERIOD):
            node.declare_parameter(PERIOD, float(period))
        if not node.has_parameter(USE_FQN):
            node.declare_parameter(USE_FQN, False)
        self._period = float(node.get_parameter(PERIOD).value)
        self._names = node.get_parameter(USE_FQN).value
        self.timer = node.create_timer(self._period, self.update)

    @property
    def period(self) -> float:
        return self._period

    @period.setter
    def period(self, value: float) -> None:
        self._period = float(value)
        self.node.destroy_timer(self.timer)
        self.timer = self.node.create_timer(self._period, self.update)

    def update(self) -> None:
        self.force_update()

    def force_update(self) -> None:
        statuses: list[Any] = []
        with self.lock:
            for task in self.tasks:
                stat = DiagnosticStatusWrapper()
                stat.name, stat.hardware_id = task.name, self.hwid
                stat.summary(ERROR, "No message was set")
                result = task.run(stat)
                if result is None:
                    what = callback_name(getattr(task, "fn", task.run))
                    raise TypeError(f"the diagnostic task {task.name} ({what}) must return the status")
                statuses.append(result)
        self.publish(statuses)

    def broadcast(self, lvl: Any, msg: str) -> None:
        statuses = []
        for task in self.tasks:
            stat = DiagnosticStatusWrapper()
            stat.name, stat.hardware_id = task.name, self.hwid
            stat.summary(lvl, msg)
            statuses.append(stat)
        self.publish(statuses)

    def setHardwareID(self, hwid: str) -> None:
        self.hwid = hwid

    set_hardware_id = setHardwareID

    def setHardwareIDf(self, form: str, *args: Any) -> None:
        self.hwid = form % args

    def addedTaskCallback(self, task: DiagnosticTask) -> None:
        stat = DiagnosticStatusWrapper()
        stat.name, stat.hardware_id = task.name, self.hwid
        stat.summary(OK, "Node starting up")
        self.publish([stat])

    def publish(self, msg: Any) -> None:
        statuses = msg if isinstance(msg, list) else [msg]
        name = self.node.get_fully_qualified_name() if self._names else self.node.get_name()
        array = message("diagnostic_msgs/msg/DiagnosticArray")()
        array.header.stamp = self.clock.now().to_msg()
        for stat in statuses:
            stat.name = f"{name}: {stat.name}"
        array.status = statuses
        self.publisher.publish(array)
