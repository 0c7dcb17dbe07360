"""Validation of topic names."""

from sitaf_ros.names import topic_problem

from .exceptions import InvalidTopicNameException

TOPIC_SEPARATOR_STRING = "/"


def validate_topic_name(name: str, *, is_service: bool = False) -> bool:
    problem = topic_problem(name)
    if problem is not None:
        raise InvalidTopicNameException(name, problem)
    return True
