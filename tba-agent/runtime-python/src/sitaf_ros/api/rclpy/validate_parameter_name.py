"""Validation of parameter names."""

from .exceptions import InvalidParameterException


def validate_parameter_name(name: str) -> bool:
    if not isinstance(name, str) or not name:
        raise InvalidParameterException(name)
    return True
