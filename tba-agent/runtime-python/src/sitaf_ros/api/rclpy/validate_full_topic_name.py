"""Validation of full topic names."""

from sitaf_ros.names import topic_problem

from .exceptions import InvalidTopicNameException


def validate_full_topic_name(name: str, *, is_service: bool = False) -> bool:
    problem = topic_problem(name)
    if problem is None and not name.startswith("/"):
        problem = "topic name must be absolute, it must lead with a '/'"
    if problem is None and any(c in name for c in "~{}"):
        problem = "topic name must not contain characters other than alphanumerics, '_', or '/'"
    if problem is not None:
        raise InvalidTopicNameException(name, problem)
    return True
