"""Names of topics, services and nodes: validation, expansion and remapping.

Rules: https://design.ros2.org/articles/topic_and_service_names.html and .../static_remapping.html.
"""

from __future__ import annotations

import re

TOPIC = re.compile(r"^(~(?=/|$)|/)?[A-Za-z_{}0-9]*(/?[A-Za-z_0-9{}]+)*$")
NODE = re.compile(r"^[A-Za-z_][A-Za-z0-9_]*$")


def expand(name: str, node_name: str, namespace: str) -> str:
    """Return the full name of a topic or service as a node uses it."""
    problem = topic_problem(name)
    if problem is not None:
        raise ValueError(f"`{name}`: {problem}")
    base = namespace.rstrip("/")
    name = name.replace("{node}", node_name).replace("{ns}", base or "/").replace("{namespace}", base or "/")
    if name.startswith("~"):
        rest = name[1:].lstrip("/")
        return f"{base}/{node_name}" + (f"/{rest}" if rest else "")
    return name if name.startswith("/") else f"{base}/{name}"


def topic_problem(name: str) -> str | None:
    """Return what is wrong with a topic's name."""
    if not name:
        return "topic name must not be empty string"
    if name.endswith("/") and name != "/":
        return "topic name must not end with a forward slash"
    if "//" in name:
        return "topic name must not contain repeated '/'"
    if "~" in name[1:] or (name.startswith("~") and len(name) > 1 and name[1] != "/"):
        return "topic name has tilde in invalid location, it may only be first and followed by '/'"
    for c in name:
        if not (c.isascii() and (c.isalnum() or c in "_/~{}")):
            return "topic name must not contain characters other than alphanumerics, '_', '~', '{', or '}'"
    if any(part[:1].isdigit() for part in name.lstrip("~/").split("/")):
        return "topic name token must not start with a number"
    return None


def node_problem(name: str) -> str | None:
    """Return what is wrong with a node's name."""
    if not name:
        return "node name must not be empty"
    if not NODE.match(name):
        return "node name must not contain characters other than alphanumerics or '_', and must not start with a number"
    return None


def namespace_problem(name: str) -> str | None:
    """Return what is wrong with a namespace."""
    if not name.startswith("/"):
        return "namespace must be absolute, it must lead with a '/'"
    return None if name == "/" else topic_problem(name)


class Remapping:
    """Rules `from: to`; a key may be relative, private or absolute, or begin with `NODE:`."""

    def __init__(self, rules: dict[str, str]) -> None:
        self.rules = dict(rules)

    def apply(self, name: str, node_name: str, namespace: str) -> str:
        """Return the full name after the first rule that matches."""
        full = expand(name, node_name, namespace)
        for source, target in self.rules.items():
            only, colon, pattern = source.rpartition(":")
            if colon and only not in ("rostopic", "rosservice", node_name):
                continue
            if pattern.startswith("__"):
                continue
            if expand(pattern, node_name, namespace) == full:
                return expand(target, node_name, namespace)
        return full

    def special(self, key: str, node_name: str) -> str | None:
        """Return the value of `__node`, `__name` or `__ns`, for all nodes or the named one."""
        return self.rules.get(f"{node_name}:{key}", self.rules.get(key))
