"""The services that get and set the levels of loggers."""

from __future__ import annotations

from typing import Any

from sitaf_ros.current import message

from . import logging
from .qos import qos_profile_services_default


class LoggingService:
    def __init__(self, node: Any) -> None:
        for kind in ("get_logger_levels", "set_logger_levels"):
            name = "".join(part.capitalize() for part in kind.split("_"))
            service = message(f"rcl_interfaces/srv/{name}")
            node._ros_create_own_service(service, f"~/{kind}", getattr(self, f"_{kind}"), qos_profile_services_default)

    def _get_logger_levels(self, request: Any, response: Any) -> Any:
        level = message("rcl_interfaces/msg/LoggerLevel")
        response.levels = [level(name=name, level=int(logging.get_logger_level(name))) for name in request.names]
        return response

    def _set_logger_levels(self, request: Any, response: Any) -> Any:
        result = message("rcl_interfaces/msg/SetLoggerLevelsResult")
        for level in request.levels:
            try:
                logging.set_logger_level(level.name, level.level)
                response.results.append(result(successful=True))
            except ValueError as e:
                response.results.append(result(successful=False, reason=str(e)))
        return response
