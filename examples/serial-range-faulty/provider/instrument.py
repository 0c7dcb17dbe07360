"""The range finder at the other end of the serial line, with the linear stage that moves its target.

usage: instrument.py TTY

Requests and answers are lines of ASCII, each answer with the exclusive or of its bytes as two hexadecimal digits:

    D?          D 1500 5B       the distance in millimetres
    S 1500      OK 04           moves the target; answers when it is there
    anything    E 01 11         an unknown request, or a target beyond 20 m
"""

import os
import sys
import tty
from functools import reduce

LONGEST_MM = 20_000


def with_checksum(text: str) -> bytes:
    """A line with its checksum."""
    return f"{text} {reduce(lambda a, b: a ^ b, text.encode()):02X}\n".encode()


def main(path: str) -> None:
    """Answer requests until the line is closed."""
    line = os.open(path, os.O_RDWR | os.O_NOCTTY)
    tty.setraw(line)
    target_mm = 2000
    waiting = b""
    while chunk := os.read(line, 256):
        *requests, waiting = (waiting + chunk).split(b"\n")
        for request in requests:
            word, _, number = request.decode("ascii", "replace").strip().partition(" ")
            if word == "D?":
                os.write(line, with_checksum(f"D {target_mm}"))
            elif word == "S" and number.isdecimal() and int(number) <= LONGEST_MM:
                target_mm = int(number)
                os.write(line, with_checksum("OK"))
            else:
                os.write(line, with_checksum("E 01"))


if __name__ == "__main__":
    main(sys.argv[1])
