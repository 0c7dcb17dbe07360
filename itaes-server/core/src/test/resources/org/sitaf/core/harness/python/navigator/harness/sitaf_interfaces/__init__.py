"""Interfaces and types that the component shares with the test."""

from sitaf_interfaces.RangeFinder import RangeFinder
from sitaf_interfaces.Wheels import Wheels
from sitaf_interfaces.data_types import Mode, Point, Route
from sitaf_interfaces.errors import Lost, NoEcho

__all__ = ["Lost", "Mode", "NoEcho", "Point", "RangeFinder", "Route", "Wheels"]
