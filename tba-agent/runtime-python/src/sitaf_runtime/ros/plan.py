"""The plan of a test application, which SITAF generates as `plan.json`."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

_NANOS = 1_000_000_000
_TAKEN = ("geometry_msgs/msg/Twist", "geometry_msgs/msg/TwistStamped")


@dataclass(frozen=True, slots=True)
class Topic:
    """A topic and what it is connected to; names are empty where there is nothing."""

    name: str
    type: str
    input: str = ""
    output: str = ""
    world: bool = False
    device: str = ""
    kind: str = ""
    rate_hz: float = 10.0
    frame: str = ""

    @property
    def commands(self) -> bool:
        """Whether its device takes the messages of the node."""
        return bool(self.device) and self.type in _TAKEN

    @property
    def senses(self) -> bool:
        """Whether its device, or the world, sends messages to the node."""
        return self.world or (bool(self.device) and not self.commands)


@dataclass(frozen=True, slots=True)
class Call:
    """A call of the test: what it publishes or calls, and what is recorded; times are in nanoseconds.

    As a step of a sequence it may change the world (`settings`) and the answers of required services from then on.
    """

    target: dict[str, Any]
    settle_ns: int
    run_for_ns: int
    inputs: tuple[dict[str, Any], ...]
    outputs: tuple[dict[str, Any], ...]
    settings: tuple[str, ...]
    answers: tuple[dict[str, Any], ...]

    @classmethod
    def of(cls, given: dict[str, Any]) -> Call:
        """Read a call."""
        return cls(
            given["target"],
            round(given["settle"] * _NANOS),
            round(given["run_for"] * _NANOS),
            tuple(given["inputs"]),
            tuple(given["outputs"]),
            tuple(given["settings"]),
            tuple(given["answers"]),
        )


@dataclass(frozen=True, slots=True)
class Event:
    """A step that sets a parameter of the world, or a fault of a device."""

    set: str
    to: float


@dataclass(frozen=True, slots=True)
class Plan:
    """What the cases of a suite do; times are in nanoseconds.

    `call` is that of each case, and `settle_ns` and `run_for_ns` are its own. Of a sequence it is None; then `calls`
    and `events` are the steps by name, and time passes before the first step and after the last one.
    """

    node: dict[str, Any]
    suite_life: bool
    topics: tuple[Topic, ...]
    call: Call | None
    calls: dict[str, Call]
    events: dict[str, Event]
    settle_ns: int
    run_for_ns: int
    case_sim_ns: int
    world: bool
    settings: tuple[str, ...]
    parameters: tuple[dict[str, str], ...]
    required: tuple[dict[str, Any], ...]
    answers: tuple[dict[str, Any], ...]

    @classmethod
    def read(cls, file: Path) -> Plan:
        """Read a plan."""
        given = json.loads(file.read_text(encoding="utf-8"))
        steps = given.get("steps")
        return cls(
            given["node"],
            given["life_cycle"] == "SUITE",
            tuple(Topic(**topic) for topic in given["topics"]),
            Call.of(given) if steps is None else None,
            {} if steps is None else {call["name"]: Call.of(call) for call in steps["calls"]},
            {} if steps is None else {event["name"]: Event(event["set"], event["to"]) for event in steps["events"]},
            round(given["settle"] * _NANOS),
            round(given["run_for"] * _NANOS),
            round(given["case_sim_s"] * _NANOS),
            given["world"],
            tuple(given["settings"]),
            tuple(given["parameters"]),
            tuple(given["required"]),
            tuple(given["answers"]),
        )
