"""The robot simulator of SITAF: a server with isolated sessions, each of which simulates one world.

Layers, each importing only those after it: `server` (gRPC), `session` (leases, locking), `world` (descriptions,
physics, devices; the only one that imports MuJoCo).
"""

__version__ = "0.1.0"
