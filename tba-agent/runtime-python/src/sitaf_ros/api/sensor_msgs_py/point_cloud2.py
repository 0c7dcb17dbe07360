"""Point clouds from and to numpy arrays."""

from __future__ import annotations

import sys
from collections import namedtuple
from collections.abc import Iterable
from typing import Any

import numpy as np

from sitaf_ros.current import message

from .numpy_compat import structured_to_unstructured

# The numbers of sensor_msgs/PointField.
_DATATYPES: dict[int, Any] = {
    1: np.dtype(np.int8),
    2: np.dtype(np.uint8),
    3: np.dtype(np.int16),
    4: np.dtype(np.uint16),
    5: np.dtype(np.int32),
    6: np.dtype(np.uint32),
    7: np.dtype(np.float32),
    8: np.dtype(np.float64),
}
FLOAT32, UINT32 = 7, 6
DUMMY_FIELD_PREFIX = "unnamed_field"


def dtype_from_fields(fields: Iterable[Any], point_step: int | None = None) -> Any:
    names: list[str] = []
    formats: list[Any] = []
    offsets: list[int] = []
    for i, field in enumerate(fields):
        datatype = _DATATYPES[field.datatype]
        name = field.name or f"{DUMMY_FIELD_PREFIX}_{i}"
        if field.count == 0:
            raise ValueError("Can't handle fields with count = 0.")
        for part in range(field.count):
            names.append(f"{name}_{part}" if field.count > 1 else name)
            offsets.append(field.offset + part * datatype.itemsize)
            formats.append(datatype.str)
    layout: dict[str, Any] = {"names": names, "formats": formats, "offsets": offsets}
    if point_step is not None:
        layout["itemsize"] = point_step
    made: Any = np.dtype
    return made(layout)


def read_points(
    cloud: Any,
    field_names: list[str] | None = None,
    skip_nans: bool = False,
    uvs: Any = None,
    reshape_organized_cloud: bool = False,
) -> Any:
    dtype = dtype_from_fields(cloud.fields, point_step=cloud.point_step)
    points = np.ndarray(shape=(cloud.width * cloud.height,), dtype=dtype, buffer=bytes(cloud.data))
    if field_names is not None:
        if not all(name in (points.dtype.names or ()) for name in field_names):
            raise AssertionError("Requests field is not in the fields of the PointCloud!")
        points = points[list(field_names)]
    if bool(sys.byteorder != "little") != bool(cloud.is_bigendian):
        points = points.byteswap()
    if skip_nans and not cloud.is_dense:
        keep = np.ones(len(points), dtype=bool)
        for name in points.dtype.names or ():
            keep &= ~np.isnan(points[name])
        points = points[keep]
    if uvs is not None:
        picked = np.asarray(list(uvs))
        points = points[picked[:, 0] + picked[:, 1] * cloud.width if picked.ndim > 1 else picked]
    if reshape_organized_cloud and cloud.height > 1:
        points = points.reshape(cloud.width, cloud.height)
    return points


def read_points_numpy(
    cloud: Any,
    field_names: list[str] | None = None,
    skip_nans: bool = False,
    uvs: Any = None,
    reshape_organized_cloud: bool = False,
) -> Any:
    return structured_to_unstructured(read_points(cloud, field_names, skip_nans, uvs, reshape_organized_cloud))


def read_points_list(
    cloud: Any, field_names: list[str] | None = None, skip_nans: bool = False, uvs: Any = None
) -> list[Any]:
    points = read_points(cloud, field_names, skip_nans, uvs)
    point = namedtuple("Point", points.dtype.names)
    return [point._make(values) for values in points.tolist()]


def create_cloud(header: Any, fields: Any, points: Any, step: int | None = None, point_step: int | None = None) -> Any:
    dtype = dtype_from_fields(fields, point_step if step is None else step)
    if not isinstance(points, np.ndarray):
        points = np.array([tuple(point) for point in points], dtype=dtype)
    elif points.dtype.names is None:
        flat = points.reshape(-1, points.shape[-1])
        structured = np.zeros(len(flat), dtype=dtype)
        for i, name in enumerate(dtype.names or ()):
            structured[name] = flat[:, i]
        points = structured.reshape(points.shape[:-1])
    height, width = (1, len(points)) if points.ndim == 1 else (points.shape[1], points.shape[0])
    return message("sensor_msgs/msg/PointCloud2")(
        header=header,
        height=height,
        width=width,
        is_dense=False,
        is_bigendian=sys.byteorder != "little",
        fields=fields,
        point_step=points.dtype.itemsize,
        row_step=points.dtype.itemsize * width,
        data=points.tobytes(),
    )


def _field(name: str, offset: int, datatype: int) -> Any:
    return message("sensor_msgs/msg/PointField")(name=name, offset=offset, datatype=datatype, count=1)


def create_cloud_xyz32(header: Any, points: Any, step: int | None = None) -> Any:
    return create_cloud(header, [_field(n, 4 * i, FLOAT32) for i, n in enumerate("xyz")], points, step)


def create_cloud_xyzi32(header: Any, points: Any, step: int | None = None) -> Any:
    fields = [_field(n, 4 * i, FLOAT32) for i, n in enumerate(("x", "y", "z", "intensity"))]
    return create_cloud(header, fields, points, step)
