"""Which format a robot model has: MJCF, URDF, xacro or SDF."""

import contextlib
from xml.parsers import expat


def format_of(path: str, content: bytes) -> str:
    """`mjcf`, `urdf`, `xacro` or `sdf`, by the root element; text that is not XML counts as what its suffix says."""
    if path.lower().endswith(".xacro"):
        return "xacro"
    root = _root(content)
    if root in ("sdf", "gazebo"):
        return "sdf"
    if root == "robot" or (not root and path.lower().endswith(".urdf")):
        # What xacro made keeps the declaration of its namespace.
        return "xacro" if b"<xacro:" in content else "urdf"
    return "sdf" if path.lower().endswith(".sdf") else "mjcf"


class _Found(Exception):
    """Ends the scan at the first element."""


def _root(content: bytes) -> str:
    parser = expat.ParserCreate("utf-8")
    found: list[str] = []

    def start(tag: str, _attributes: dict[str, str]) -> None:
        found.append(tag)
        raise _Found

    parser.StartElementHandler = start
    with contextlib.suppress(_Found, expat.ExpatError, ValueError):
        parser.Parse(content, True)
    return found[0] if found else ""
