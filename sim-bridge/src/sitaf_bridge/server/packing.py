"""Encodes world states from templates, because a message object per number takes longer than the simulation."""

import struct
from collections.abc import Callable, Iterable, Sequence
from functools import lru_cache
from itertools import chain
from typing import TypeVar

from google.protobuf.message import Message

from sitaf_bridge.server.readings import reading_message
from sitaf_bridge.wire import simulation_pb2 as pb
from sitaf_bridge.world.description.declaration import Description
from sitaf_bridge.world.devices import KINDS, DeviceDeclaration, Reading
from sitaf_bridge.world.state import WorldState

Stated = TypeVar("Stated", bound=Message)
# Number 1, length-delimited.
STATE_FIELD = b"\x0a"
Piece = Callable[[WorldState], bytes]
DOUBLE = struct.Struct("<d")


def state_message(state: WorldState) -> pb.WorldState:
    """Encode a world state; equals the encoding of messages built by `readings`."""
    return pb.WorldState.FromString(_encoded(state))


def with_state(response: type[Stated], state: WorldState) -> Stated:
    """A response with nothing but a state, its field 1, which would be copied if it were given as a message."""
    encoded = _encoded(state)
    return response.FromString(STATE_FIELD + varint(len(encoded)) + encoded)


def _encoded(state: WorldState) -> bytes:
    head = pb.WorldState(step=state.step, time_ns=state.time_ns).SerializeToString()
    return head + b"".join([piece(state) for piece in _layout(state.declared)])


def varint(number: int) -> bytes:
    """Encode a length."""
    encoded = bytearray()
    while number > 127:
        encoded.append(number & 127 | 128)
        number >>= 7
    encoded.append(number)
    return bytes(encoded)


@lru_cache(maxsize=256)
def _layout(declared: Description) -> tuple[Piece, ...]:
    """Choose the encoders of a world: templates for devices of fixed form, builders for the others."""
    devices = [d for d in declared.devices.values() if not KINDS[d.kind].image]
    pieces: list[Piece] = []
    run: list[list[bytes]] = []

    def close(end: int) -> None:
        if run:
            pieces.append(_readings(slice(end - len(run), end), Template(run)))
            run.clear()

    for index, device in enumerate(devices):
        gaps = _gaps(device)
        if gaps is None:
            close(index)
            pieces.append(_reading(index))
        else:
            run.append(gaps)
    close(len(devices))
    if declared.observations:
        pieces.append(_observations(Template([_observation_gaps(name) for name in declared.observations])))
    return tuple(pieces)


class Template:
    """Bytes with gaps for numbers, for several messages in a row."""

    def __init__(self, parts: Sequence[Sequence[bytes]]) -> None:
        between = [b""]
        for first, *others in parts:
            between[-1] += first
            between += others
        self._form = struct.Struct("<" + "d".join(f"{len(gap)}s" for gap in between))
        self._template: list[bytes | float] = [0.0] * (2 * len(between) - 1)
        self._template[::2] = between

    def fill(self, numbers: Iterable[float]) -> bytes:
        """Fill the numbers into the gaps."""
        filled = self._template.copy()
        filled[1::2] = numbers
        return self._form.pack(*filled)


def _readings(where: slice, template: Template) -> Piece:
    return lambda state: template.fill(chain.from_iterable([reading.values for reading in state.readings[where]]))


def _reading(index: int) -> Piece:
    return lambda state: pb.WorldState(readings=[reading_message(state.readings[index])]).SerializeToString()


def _observations(template: Template) -> Piece:
    return lambda state: template.fill(state.observations.values())


def _gaps(device: DeviceDeclaration) -> list[bytes] | None:
    """The bytes around the numbers of a device's reading; None if the numbers are not encoded as they are."""
    kind = KINDS[device.kind]
    if kind.truths:
        return None
    marks = [1e300 * (1 + index / 1e6) for index in range(len(kind.fields(device)))]
    reading = reading_message(Reading(device, tuple(marks)))
    return _between(pb.WorldState(readings=[reading]).SerializeToString(), marks)


def _observation_gaps(name: str) -> list[bytes]:
    gaps = _between(pb.WorldState(observations=[pb.Observation(name=name, value=1e300)]).SerializeToString(), [1e300])
    assert gaps is not None  # noqa: S101  # it has one number
    return gaps


def _between(message: bytes, marks: Sequence[float]) -> list[bytes] | None:
    """Split a message at numbers that occur once each, in this order; None if they do not."""
    gaps: list[bytes] = []
    for mark in map(DOUBLE.pack, marks):
        if message.count(mark) != 1:
            return None
        before, _, message = message.partition(mark)
        gaps.append(before)
    return [*gaps, message]
