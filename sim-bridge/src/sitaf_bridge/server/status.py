"""The gRPC status code of each error category."""

import functools
from collections.abc import Callable
from typing import Any, TypeVar

import grpc

from sitaf_bridge.errors import (
    BridgeError,
    Cancelled,
    Diverged,
    Forbidden,
    InvalidRequest,
    LimitReached,
    NoSuchEndpoint,
    NoSuchSession,
    TimeReset,
    Unauthenticated,
    UnreachableValue,
    WrongState,
)

CODES: dict[type[BridgeError], grpc.StatusCode] = {
    InvalidRequest: grpc.StatusCode.INVALID_ARGUMENT,
    UnreachableValue: grpc.StatusCode.OUT_OF_RANGE,
    NoSuchSession: grpc.StatusCode.NOT_FOUND,
    NoSuchEndpoint: grpc.StatusCode.NOT_FOUND,
    Forbidden: grpc.StatusCode.PERMISSION_DENIED,
    Diverged: grpc.StatusCode.DATA_LOSS,
    LimitReached: grpc.StatusCode.RESOURCE_EXHAUSTED,
    WrongState: grpc.StatusCode.FAILED_PRECONDITION,
    TimeReset: grpc.StatusCode.ABORTED,
    Unauthenticated: grpc.StatusCode.UNAUTHENTICATED,
    Cancelled: grpc.StatusCode.CANCELLED,
}
# Status messages are sent percent-encoded in HTTP/2 headers, which clients limit to 8 KiB.
MAX_MESSAGE = 3_000

Answer = TypeVar("Answer")


def code_of(error: BridgeError) -> grpc.StatusCode:
    """The status code of an error's category."""
    return next(code for kind, code in CODES.items() if isinstance(error, kind))


def message_of(error: BridgeError) -> str:
    """The message of an error, shortened to the limit."""
    text = str(error)
    return text if len(text) <= MAX_MESSAGE else text[:MAX_MESSAGE] + "\n... and more"


def answering(method: Callable[..., Answer]) -> Callable[..., Answer]:
    """Decorate a servicer method to answer errors with their status code."""

    @functools.wraps(method)
    def answered(self: Any, request: Any, context: grpc.ServicerContext) -> Answer:
        try:
            return method(self, request, context)
        except BridgeError as error:
            context.abort(code_of(error), message_of(error))

    return answered
