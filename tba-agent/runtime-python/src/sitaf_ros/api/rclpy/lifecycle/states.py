"""The state machine of lifecycle nodes; numbers are those of lifecycle_msgs."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum


class TransitionCallbackReturn(Enum):
    SUCCESS = 97
    FAILURE = 98
    ERROR = 99


@dataclass(frozen=True)
class LifecycleState:
    label: str
    state_id: int


UNKNOWN = LifecycleState("unknown", 0)
UNCONFIGURED = LifecycleState("unconfigured", 1)
INACTIVE = LifecycleState("inactive", 2)
ACTIVE = LifecycleState("active", 3)
FINALIZED = LifecycleState("finalized", 4)
CONFIGURING = LifecycleState("configuring", 10)
CLEANING_UP = LifecycleState("cleaningup", 11)
SHUTTING_DOWN = LifecycleState("shuttingdown", 12)
ACTIVATING = LifecycleState("activating", 13)
DEACTIVATING = LifecycleState("deactivating", 14)
ERROR_PROCESSING = LifecycleState("errorprocessing", 15)
ALL = (
    UNKNOWN,
    UNCONFIGURED,
    INACTIVE,
    ACTIVE,
    FINALIZED,
    CONFIGURING,
    CLEANING_UP,
    SHUTTING_DOWN,
    ACTIVATING,
    DEACTIVATING,
    ERROR_PROCESSING,
)


@dataclass(frozen=True)
class Transition:
    """A transition that a user asks for, and where it leads."""

    number: int
    label: str
    start: LifecycleState
    during: LifecycleState
    success: LifecycleState
    failure: LifecycleState
    callback: str
    first_result: int
    """The number of the following transition on success; failure and error have the next two."""


TRANSITIONS = (
    Transition(1, "configure", UNCONFIGURED, CONFIGURING, INACTIVE, UNCONFIGURED, "on_configure", 10),
    Transition(2, "cleanup", INACTIVE, CLEANING_UP, UNCONFIGURED, INACTIVE, "on_cleanup", 20),
    Transition(3, "activate", INACTIVE, ACTIVATING, ACTIVE, INACTIVE, "on_activate", 30),
    Transition(4, "deactivate", ACTIVE, DEACTIVATING, INACTIVE, ACTIVE, "on_deactivate", 40),
    Transition(5, "shutdown", UNCONFIGURED, SHUTTING_DOWN, FINALIZED, FINALIZED, "on_shutdown", 50),
    Transition(6, "shutdown", INACTIVE, SHUTTING_DOWN, FINALIZED, FINALIZED, "on_shutdown", 50),
    Transition(7, "shutdown", ACTIVE, SHUTTING_DOWN, FINALIZED, FINALIZED, "on_shutdown", 50),
)


def available(state: LifecycleState) -> list[Transition]:
    """Return the transitions that begin in a state."""
    return [transition for transition in TRANSITIONS if transition.start == state]
