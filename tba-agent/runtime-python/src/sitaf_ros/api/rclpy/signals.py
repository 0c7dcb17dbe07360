"""Signal handling: no signal reaches a node in a test case."""

from enum import IntEnum
from typing import Any


class SignalHandlerOptions(IntEnum):
    NO = 0
    SIGINT = 1
    SIGTERM = 2
    ALL = 3


def install_signal_handlers(options: SignalHandlerOptions = SignalHandlerOptions.ALL) -> None:
    """Install nothing."""


def get_current_signal_handlers_options() -> SignalHandlerOptions:
    return SignalHandlerOptions.NO


def uninstall_signal_handlers() -> None:
    """Nothing is installed."""


class SignalHandlerGuardCondition:
    def __init__(self, context: Any = None) -> None:
        self.context = context

    def destroy(self) -> None:
        """Nothing is installed."""
