"""Validation of namespaces."""

from sitaf_ros.names import namespace_problem

from .exceptions import InvalidNamespaceException


def validate_namespace(namespace: str) -> bool:
    problem = namespace_problem(namespace)
    if problem is not None:
        raise InvalidNamespaceException(namespace, problem)
    return True
