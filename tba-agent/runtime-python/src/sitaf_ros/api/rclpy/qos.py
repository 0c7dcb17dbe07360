"""Quality of service; defaults and rules as in https://docs.ros.org/en/jazzy/Concepts/Intermediate/About-Quality-of-Service-Settings.html."""

from __future__ import annotations

from enum import Enum, IntEnum
from typing import Any

from sitaf_ros import graph

from .duration import Duration, Infinite


class QoSPolicyKind(IntEnum):
    INVALID = 1
    DURABILITY = 2
    DEADLINE = 4
    LIVELINESS = 8
    RELIABILITY = 16
    HISTORY = 32
    LIFESPAN = 64
    DEPTH = 128
    LIVELINESS_LEASE_DURATION = 256
    AVOID_ROS_NAMESPACE_CONVENTIONS = 512


def qos_policy_name_from_kind(policy_kind: QoSPolicyKind | int) -> str:
    return QoSPolicyKind(policy_kind).name


class InvalidQoSProfileException(Exception):
    def __init__(self, *args: Any) -> None:
        super().__init__("Invalid QoSProfile", *args)


class QoSPolicyEnum(IntEnum):
    @classmethod
    def short_keys(cls) -> list[str]:
        return [name.lower() for name in cls.__members__ if not name.startswith("RMW")]

    @classmethod
    def get_from_short_key(cls, name: str) -> Any:
        return cls[name.upper()].value

    @property
    def short_key(self) -> str:
        return self.name.lower()


class HistoryPolicy(QoSPolicyEnum):
    SYSTEM_DEFAULT = 0
    KEEP_LAST = 1
    KEEP_ALL = 2
    UNKNOWN = 3


class ReliabilityPolicy(QoSPolicyEnum):
    SYSTEM_DEFAULT = 0
    RELIABLE = 1
    BEST_EFFORT = 2
    UNKNOWN = 3
    BEST_AVAILABLE = 4


class DurabilityPolicy(QoSPolicyEnum):
    SYSTEM_DEFAULT = 0
    TRANSIENT_LOCAL = 1
    VOLATILE = 2
    UNKNOWN = 3
    BEST_AVAILABLE = 4


class LivelinessPolicy(QoSPolicyEnum):
    SYSTEM_DEFAULT = 0
    AUTOMATIC = 1
    MANUAL_BY_TOPIC = 3
    UNKNOWN = 4
    BEST_AVAILABLE = 5


QoSHistoryPolicy = HistoryPolicy
QoSReliabilityPolicy = ReliabilityPolicy
QoSDurabilityPolicy = DurabilityPolicy
QoSLivelinessPolicy = LivelinessPolicy

_FIELDS = (
    "history",
    "depth",
    "reliability",
    "durability",
    "lifespan",
    "deadline",
    "liveliness",
    "liveliness_lease_duration",
    "avoid_ros_namespace_conventions",
)


class QoSProfile:
    def __init__(self, **kwargs: Any) -> None:
        unknown = [key for key in kwargs if key not in _FIELDS]
        if unknown:
            raise AssertionError(f"Invalid arguments passed to constructor: {set(unknown)}")
        if "history" not in kwargs and "depth" not in kwargs:
            raise InvalidQoSProfileException("History and/or depth settings are required.")
        self._history = HistoryPolicy(kwargs.get("history", HistoryPolicy.KEEP_LAST))
        if "depth" not in kwargs and self._history == HistoryPolicy.KEEP_LAST:
            raise InvalidQoSProfileException("History set to KEEP_LAST without a depth setting.")
        self.depth = kwargs.get("depth", 0)
        self.reliability = kwargs.get("reliability", ReliabilityPolicy.RELIABLE)
        self.durability = kwargs.get("durability", DurabilityPolicy.VOLATILE)
        self.lifespan = kwargs.get("lifespan", Duration())
        self.deadline = kwargs.get("deadline", Duration())
        self.liveliness = kwargs.get("liveliness", LivelinessPolicy.SYSTEM_DEFAULT)
        self.liveliness_lease_duration = kwargs.get("liveliness_lease_duration", Duration())
        self.avoid_ros_namespace_conventions = kwargs.get("avoid_ros_namespace_conventions", False)

    @property
    def history(self) -> HistoryPolicy:
        return self._history

    @history.setter
    def history(self, value: Any) -> None:
        self._history = HistoryPolicy(value)

    @property
    def depth(self) -> int:
        return self._depth

    @depth.setter
    def depth(self, value: int) -> None:
        if not isinstance(value, int) or value < 0:
            raise ValueError(f"depth must be an integer greater than or equal to zero, got {value!r}")
        self._depth = value

    @property
    def reliability(self) -> ReliabilityPolicy:
        return self._reliability

    @reliability.setter
    def reliability(self, value: Any) -> None:
        self._reliability = ReliabilityPolicy(value)

    @property
    def durability(self) -> DurabilityPolicy:
        return self._durability

    @durability.setter
    def durability(self, value: Any) -> None:
        self._durability = DurabilityPolicy(value)

    @property
    def liveliness(self) -> LivelinessPolicy:
        return self._liveliness

    @liveliness.setter
    def liveliness(self, value: Any) -> None:
        self._liveliness = LivelinessPolicy(value)

    def get_c_qos_profile(self) -> QoSProfile:
        return self

    def __eq__(self, other: object) -> bool:
        return isinstance(other, QoSProfile) and all(getattr(self, f) == getattr(other, f) for f in _FIELDS)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"QoSProfile({', '.join(f'{f}={getattr(self, f)}' for f in _FIELDS)})"


def quality_of(profile: QoSProfile, subscribes: bool = False) -> graph.Quality:
    """Return the profile as the graph of a case knows it."""
    # BEST_AVAILABLE takes what the counterparts have; offering the best and asking for the least matches all of them.
    best = not subscribes
    reliable = profile.reliability != ReliabilityPolicy.BEST_EFFORT
    local = profile.durability == DurabilityPolicy.TRANSIENT_LOCAL
    if profile.reliability == ReliabilityPolicy.BEST_AVAILABLE:
        reliable = best
    if profile.durability == DurabilityPolicy.BEST_AVAILABLE:
        local = best
    return graph.Quality(
        depth=profile.depth,
        keep_all=profile.history == HistoryPolicy.KEEP_ALL,
        reliable=reliable,
        transient_local=local,
        deadline_ns=profile.deadline.nanoseconds or graph.INFINITE_NS,
        manual_liveliness=profile.liveliness == LivelinessPolicy.MANUAL_BY_TOPIC,
        lease_ns=profile.liveliness_lease_duration.nanoseconds or graph.INFINITE_NS,
        lifespan_ns=profile.lifespan.nanoseconds or graph.INFINITE_NS,
    )


class QoSCompatibility(IntEnum):
    OK = 0
    WARNING = 1
    ERROR = 2


def qos_check_compatible(publisher_qos: QoSProfile, subscription_qos: QoSProfile) -> tuple[QoSCompatibility, str]:
    policy = graph.incompatible(quality_of(publisher_qos), quality_of(subscription_qos, subscribes=True))
    return (QoSCompatibility.OK, "") if policy is None else (QoSCompatibility.ERROR, f"ERROR: {policy};")


_BEST_EFFORT, _KEEP_LAST = ReliabilityPolicy.BEST_EFFORT, HistoryPolicy.KEEP_LAST
qos_profile_unknown = QoSProfile(history=HistoryPolicy.UNKNOWN, depth=0)
qos_profile_default = QoSProfile(history=_KEEP_LAST, depth=10)
qos_profile_system_default = QoSProfile(
    history=HistoryPolicy.SYSTEM_DEFAULT,
    depth=0,
    reliability=ReliabilityPolicy.SYSTEM_DEFAULT,
    durability=DurabilityPolicy.SYSTEM_DEFAULT,
)
qos_profile_sensor_data = QoSProfile(history=_KEEP_LAST, depth=5, reliability=_BEST_EFFORT)
qos_profile_services_default = QoSProfile(history=_KEEP_LAST, depth=10)
qos_profile_parameters = QoSProfile(history=_KEEP_LAST, depth=1000)
qos_profile_parameter_events = QoSProfile(history=_KEEP_LAST, depth=1000)
qos_profile_rosout_default = QoSProfile(
    history=_KEEP_LAST,
    depth=1000,
    durability=DurabilityPolicy.TRANSIENT_LOCAL,
    lifespan=Duration(seconds=10),
)
qos_profile_action_status_default = QoSProfile(history=_KEEP_LAST, depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
qos_profile_best_available = QoSProfile(
    history=_KEEP_LAST,
    depth=10,
    reliability=ReliabilityPolicy.BEST_AVAILABLE,
    durability=DurabilityPolicy.BEST_AVAILABLE,
)


class QoSPresetProfiles(Enum):
    UNKNOWN = qos_profile_unknown
    DEFAULT = qos_profile_default
    SYSTEM_DEFAULT = qos_profile_system_default
    SENSOR_DATA = qos_profile_sensor_data
    SERVICES_DEFAULT = qos_profile_services_default
    PARAMETERS = qos_profile_parameters
    PARAMETER_EVENTS = qos_profile_parameter_events
    ACTION_STATUS_DEFAULT = qos_profile_action_status_default
    BEST_AVAILABLE = qos_profile_best_available

    @classmethod
    def short_keys(cls) -> list[str]:
        return [name.lower() for name in cls.__members__]

    @classmethod
    def get_from_short_key(cls, name: str) -> QoSProfile:
        return cls[name.upper()].value


DeprecatedEnum = QoSPresetProfiles
INFINITE = Infinite


def profile_of(qos: Any) -> QoSProfile:
    """Return the profile that a user gives as a profile, a preset or a depth."""
    if isinstance(qos, QoSProfile):
        return qos
    if isinstance(qos, QoSPresetProfiles):
        return qos.value
    if isinstance(qos, bool) or not isinstance(qos, int):
        raise TypeError(f"Expected QoSProfile or int, but received {type(qos)!r}")
    if qos < 0:
        raise ValueError("history depth must be greater than or equal to zero")
    return QoSProfile(depth=qos)
