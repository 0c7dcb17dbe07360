"""The exceptions that the interfaces declare, or that an answer of the stub raises."""


class Lost(Exception):
    """The exception Lost."""


class NoEcho(Exception):
    """The exception NoEcho."""
