"""Waitables: work of a user's own kind, polled when the executor looks for work."""

from __future__ import annotations


class NumberOfEntities:
    def __init__(self, *_: int) -> None:
        pass
