"""The robot simulator of SITAF: a server of sessions, each of which simulates one world on its own.

Layers, each importing only those after it: `server` (the wire), `session` (leases, one caller at a time),
`world` (descriptions, physics, devices; the only one that imports MuJoCo).
"""

__version__ = "0.1.0"
