"""Keeps the nodes of one case from hearing those of others, and a robot's."""

from __future__ import annotations

import os
import socket

# Domains whose ports are below the ephemeral ones of Linux; 0 is what everybody uses.
_DOMAINS = range(1, 102)


def enter() -> socket.socket:
    """Reserve a DDS domain for this process, as long as the returned socket is open. Raises RuntimeError."""
    number, reserved = _reserve()
    os.environ.update(
        {
            "ROS_DOMAIN_ID": str(number),
            "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST",
            "RCUTILS_COLORIZED_OUTPUT": "0",
        }
    )
    if os.environ.get("ROS_DISTRO") in ("foxy", "galactic", "humble"):
        # These do not know the range; newer ones warn of this variable.
        os.environ["ROS_LOCALHOST_ONLY"] = "1"
    return reserved


def _reserve() -> tuple[int, socket.socket]:
    # Names of abstract sockets are per network namespace, as the traffic is, and free when a process ends.
    first = os.getpid() % len(_DOMAINS)
    for number in (*_DOMAINS[first:], *_DOMAINS[:first]):
        reserved = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        try:
            reserved.bind(f"\0sitaf-ros-domain-{number}")
        except OSError:
            reserved.close()
            continue
        return number, reserved
    raise RuntimeError(f"all {len(_DOMAINS)} ROS domains of this machine are in use by other test cases; run fewer")
