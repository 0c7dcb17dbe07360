"""Clients of gRPC services with unary calls, created from their descriptors without generated code."""

from typing import Any

import grpc
from google.protobuf import message_factory
from google.protobuf.descriptor import FileDescriptor


def client(channel: grpc.Channel, file: FileDescriptor, service: str) -> Any:
    """An object with a method for each unary call of a service; it takes a request, and a `timeout` in seconds."""
    description = file.services_by_name[service]
    calls = {
        method.name: channel.unary_unary(
            f"/{description.full_name}/{method.name}",
            request_serializer=message_factory.GetMessageClass(method.input_type).SerializeToString,
            response_deserializer=message_factory.GetMessageClass(method.output_type).FromString,
        )
        for method in description.methods
        if not (method.client_streaming or method.server_streaming)
    }
    return type(service, (), {"__slots__": (), **{name: staticmethod(call) for name, call in calls.items()}})()
