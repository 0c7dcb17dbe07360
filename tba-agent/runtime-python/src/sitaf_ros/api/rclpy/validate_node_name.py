"""Validation of node names."""

from sitaf_ros.names import node_problem

from .exceptions import InvalidNodeNameException


def validate_node_name(node_name: str) -> bool:
    problem = node_problem(node_name)
    if problem is not None:
        raise InvalidNodeNameException(node_name, problem)
    return True
