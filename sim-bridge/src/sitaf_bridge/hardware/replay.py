"""Recorded readings: CSV files, and topics of rosbag2 MCAP files."""

import csv
import io
import math
import tempfile
from bisect import bisect_right
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from sitaf_bridge.errors import InvalidRequest, Unavailable

MAX_ROWS = 1_000_000
TIME = "t"
NANOS = 1e9


@dataclass(frozen=True)
class Recorded:
    """Readings over simulation time in seconds, in the order of time."""

    times: Sequence[float]
    rows: Sequence[tuple[float, ...]]

    def at(self, time_s: float, max_age_s: float) -> tuple[float, ...] | None:
        """The last reading before or at a time; None if there is none, or if it is older than allowed."""
        index = bisect_right(self.times, time_s + 1e-9) - 1
        if index < 0 or time_s - self.times[index] > max_age_s + 1e-9:
            return None
        return self.rows[index]


def read_recording(file: str, content: bytes, topic: str, *, device: str, kind: str, fields: Sequence[str]) -> Recorded:
    """Read the recording of a device. Raises InvalidRequest with the line, Unavailable."""
    if file.endswith(".csv"):
        return _csv(file, content, device, fields)
    if file.endswith(".mcap"):
        return _mcap(file, content, topic, kind, fields)
    raise InvalidRequest(f"{file}: must be a .csv or .mcap file")


def _csv(file: str, content: bytes, device: str, fields: Sequence[str]) -> Recorded:
    try:
        rows = csv.reader(io.StringIO(content.decode("utf-8-sig"), newline=""), strict=True)
        header = [name.strip() for name in next(rows, [])]
        columns = [_column(file, header, TIME, TIME)]
        columns += [_column(file, header, f"{device}.{field}", field) for field in fields]
        times: list[float] = []
        readings: list[tuple[float, ...]] = []
        for row in rows:
            if not row:
                continue
            numbers = [_number(file, rows.line_num, row, column, header) for column in columns]
            if not math.isfinite(numbers[0]):
                raise InvalidRequest(f"{file}:{rows.line_num}: t: {numbers[0]} is not a finite number")
            if times and numbers[0] < times[-1]:
                raise InvalidRequest(
                    f"{file}:{rows.line_num}: t: {numbers[0]:g} is before {times[-1]:g}; sort the rows"
                )
            if len(times) >= MAX_ROWS:
                raise InvalidRequest(f"{file}: has more than {MAX_ROWS} rows")
            times.append(numbers[0])
            readings.append(tuple(numbers[1:]))
    except (UnicodeDecodeError, csv.Error) as error:
        raise InvalidRequest(f"{file}: is not a CSV file in UTF-8: {error}") from error
    if not times:
        raise InvalidRequest(f"{file}: has no rows")
    return Recorded(times, readings)


def _column(file: str, header: Sequence[str], *names: str) -> int:
    for name in names:
        if name in header:
            return header.index(name)
    known = ", ".join(header[:50]) or "none"
    raise InvalidRequest(f"{file}:1: has no column {names[-1]!r}; its columns are {known}")


def _number(file: str, line: int, row: Sequence[str], column: int, header: Sequence[str]) -> float:
    if column >= len(row):
        raise InvalidRequest(f"{file}:{line}: has {len(row)} columns instead of {len(header)}")
    try:
        return float(row[column])
    except ValueError:
        raise InvalidRequest(f"{file}:{line}: {header[column]}: {row[column]!r} is not a number") from None


def _vector(message: Any) -> tuple[float, ...]:
    return (message.x, message.y, message.z)


def _quaternion(message: Any) -> tuple[float, ...]:
    return (message.x, message.y, message.z, message.w)


def _posed(message: Any) -> tuple[float, ...]:
    pose = message.pose
    pose = getattr(pose, "pose", pose)
    return (*_vector(pose.position), *_quaternion(pose.orientation))


def _joint(message: Any) -> tuple[float, ...]:
    def first(values: Any) -> float:
        return float(values[0]) if len(values) else math.nan

    return (first(message.position), first(message.velocity), first(message.effort))


# The numbers of a device in a message of each type, by kind of device.
MESSAGES: Mapping[str, Mapping[str, Callable[[Any], tuple[float, ...]]]] = {
    "range": {"sensor_msgs/msg/Range": lambda m: (float(m.range),)},
    "laser_scan": {"sensor_msgs/msg/LaserScan": lambda m: tuple(float(r) for r in m.ranges)},
    "imu": {
        "sensor_msgs/msg/Imu": lambda m: (
            *_quaternion(m.orientation),
            *_vector(m.angular_velocity),
            *_vector(m.linear_acceleration),
        )
    },
    "magnetometer": {"sensor_msgs/msg/MagneticField": lambda m: _vector(m.magnetic_field)},
    "pose": {
        "geometry_msgs/msg/PoseStamped": _posed,
        "geometry_msgs/msg/PoseWithCovarianceStamped": _posed,
        "nav_msgs/msg/Odometry": _posed,
    },
    "force_torque": {
        "geometry_msgs/msg/WrenchStamped": lambda m: (*_vector(m.wrench.force), *_vector(m.wrench.torque))
    },
    "joint_encoder": {"sensor_msgs/msg/JointState": lambda m: _joint(m)[:2]},
    "joint_motor": {"sensor_msgs/msg/JointState": _joint},
    "battery": {
        "sensor_msgs/msg/BatteryState": lambda m: (m.voltage, m.current, m.charge, m.percentage),
    },
}


def _mcap(file: str, content: bytes, topic: str, kind: str, fields: Sequence[str]) -> Recorded:
    try:
        from rosbags.rosbag2 import Reader  # noqa: PLC0415  # only recordings in MCAP need it
        from rosbags.typesys import Stores, get_typestore  # noqa: PLC0415
    except ImportError as error:
        raise Unavailable(f"{file}: the simulator cannot read MCAP files: pip install 'sim-bridge[ros]'") from error
    converters = MESSAGES.get(kind, {})
    store = get_typestore(Stores.ROS2_JAZZY)
    times: list[float] = []
    rows: list[tuple[float, ...]] = []
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "recording.mcap"
        path.write_bytes(content)
        # A damaged file can raise any error in the library.
        try:
            with Reader(path) as reader:
                topics = {c.topic: c for c in reader.connections}
                connection = topics.get(topic)
                if connection is None:
                    raise InvalidRequest(
                        f"{file}: has no topic {topic!r}; its topics are {', '.join(topics) or 'none'}"
                    )
                convert = converters.get(connection.msgtype)
                if convert is None:
                    fits = ", ".join(converters) or "none"
                    raise InvalidRequest(
                        f"{file}: {topic} has messages of {connection.msgtype}, but a {kind} needs one of: {fits}"
                    )
                for _, stamp, raw in reader.messages([connection]):
                    if len(times) >= MAX_ROWS:
                        raise InvalidRequest(f"{file}: {topic} has more than {MAX_ROWS} messages")
                    times.append(stamp / NANOS)
                    rows.append(convert(store.deserialize_cdr(raw, connection.msgtype)))
        except InvalidRequest:
            raise
        except Exception as error:
            raise InvalidRequest(f"{file}: is not a rosbag2 recording in MCAP: {error}") from error
    wrong = next((row for row in rows if len(row) != len(fields)), None)
    if wrong is not None:
        raise InvalidRequest(f"{file}: {topic} has {len(wrong)} numbers, but the device has {len(fields)}")
    if not rows:
        raise InvalidRequest(f"{file}: {topic} has no messages")
    # A recording begins with its first message.
    order = sorted(range(len(times)), key=times.__getitem__)
    return Recorded([times[i] - times[order[0]] for i in order], [rows[i] for i in order])
