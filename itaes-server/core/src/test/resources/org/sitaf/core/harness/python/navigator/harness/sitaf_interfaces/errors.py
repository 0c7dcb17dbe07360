"""The exceptions of the interfaces and of the stub's answers."""


class Lost(Exception):
    """The exception Lost."""


class NoEcho(Exception):
    """The exception NoEcho."""
