"""Limits for numbers in MJCF that determine the cost of a step, an image or the model itself.

These checks give messages with file and line. The total cost of many small numbers is limited during compilation.
"""

import math
import re
from collections.abc import Iterator, Mapping

MAX_NAME = 1_000
MAX_ITERATIONS = 1_000
MAX_SIDE = 4_096
MIN_TIMESTEP_S = 1e-6
MAX_TIMESTEP_S = 1.0
MAX_DELAY_S = 10.0
MAX_SAMPLES = 10_000

_ITERATIONS = {f"{solver}iterations": (0.0, float(MAX_ITERATIONS)) for solver in ("", "ls_", "noslip_", "ccd_", "sdf_")}
_KINDS = ("body", "jnt", "geom", "site", "cam", "tendon", "actuator", "sensor")
_HISTORY = {"nsample": (0.0, float(MAX_SAMPLES)), "delay": (0.0, MAX_DELAY_S)}
# Lowest and highest value of the attributes of an element, both inclusive.
_LIMITS: Mapping[str, Mapping[str, tuple[float, float]]] = {
    "option": {"timestep": (MIN_TIMESTEP_S, MAX_TIMESTEP_S), "sdf_initpoints": (0, MAX_ITERATIONS), **_ITERATIONS},
    "size": {
        "njmax": (-1, 1_000_000),
        "nconmax": (-1, 1_000_000),
        "nkey": (-1, 10_000),
        "nuserdata": (-1, 1_000_000),
        **{
            f"nuser_{kind}": (-1, 1_000)
            for kind in ("body", "jnt", "geom", "site", "cam", "tendon", "actuator", "sensor")
        },
    },
    "global": {"offwidth": (1, MAX_SIDE), "offheight": (1, MAX_SIDE)},
    "quality": {
        "shadowsize": (0, 16_384),
        "offsamples": (0, 32),
        "numslices": (1, 256),
        "numstacks": (1, 256),
        "numquads": (1, 256),
    },
    "camera": {"resolution": (1, MAX_SIDE)},
    "texture": {"width": (0, 16_384), "height": (0, 16_384), "nchannel": (1, 4)},
    "hfield": {"nrow": (0, MAX_SIDE), "ncol": (0, MAX_SIDE)},
    "user": {"dim": (1, 100_000), **_HISTORY},
    "numeric": {"size": (1, 1_000_000)},
}
# These attributes belong to elements of <sensor> and <actuator>, which have many names.
_ANYWHERE = _HISTORY
_NOT_FINITE = re.compile(r"[-+]?(nan(\(\w*\))?|inf(inity)?)", re.IGNORECASE)
# Attributes with a name or text, which may be "nan".
_TEXTS = frozenset(
    """
    name class childclass prefix model body body1 body2 bodyname joint joint1 joint2 jointinparent geom geom1 geom2 site
    site1 site2 sidesite cranksite slidersite refsite refname objname mesh material texture hfield target tendon tendon1
    tendon2 actuator camera key data source flex skin file filename gridlayout
    """.split()  # noqa: SIM905
)


def beyond_limits(tag: str, attributes: Mapping[str, str]) -> Iterator[str]:
    """Check the numbers of one element; yields one message per attribute."""
    limits = _LIMITS.get(tag, _ANYWHERE)
    if tag in ("extension", "plugin"):
        yield f"<{tag}>: plugins are not supported; remove it"
    for key, value in attributes.items():
        if key in _TEXTS:
            if len(value) > MAX_NAME and key != "data":
                yield f"<{tag} {key}> has {len(value)} characters; the limit is {MAX_NAME}"
            continue
        bound = limits.get(key)
        if bound is not None:
            yield from _outside(tag, key, value, bound)
        elif any(_NOT_FINITE.fullmatch(word) for word in value.split()):
            yield f"<{tag} {key}={_shown(value)}>: must be finite"


def _outside(tag: str, key: str, value: str, bound: tuple[float, float]) -> Iterator[str]:
    low, high = bound
    for word in value.split():
        number = _number(word)
        if number is not None and not low <= number <= high:
            yield f"<{tag} {key}={_shown(value)}>: must be {low:g} to {high:g}"
            return


def _number(word: str) -> float | None:
    """Parse a number like MuJoCo, including hexadecimal; None for text that MuJoCo rejects itself."""
    try:
        return float(word)
    except ValueError:
        pass
    if _NOT_FINITE.fullmatch(word):
        return math.nan
    try:
        return float.fromhex(word) if "x" in word.lower() else None
    except (ValueError, OverflowError):
        return None


def _shown(value: str) -> str:
    return repr(value if len(value) <= 40 else value[:40] + "...")
