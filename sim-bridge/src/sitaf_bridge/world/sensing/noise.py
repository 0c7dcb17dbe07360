"""Random numbers as a function of (seed, device, step), independent of the number and order of reads.

The counter is hashed by SplitMix64's finalizer (Steele, Lea, Flood: Fast splittable pseudorandom number generators,
2014) and made Gaussian by the method of Box and Muller (1958).
"""

import hashlib
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

GOLDEN = 0x9E3779B97F4A7C15
MASK = (1 << 64) - 1


@lru_cache(maxsize=4096)
def stream(seed: int, name: str) -> int:
    """The key of one source of randomness."""
    text = seed.to_bytes(8, "big") + name.encode()
    return int.from_bytes(hashlib.blake2b(text, digest_size=8).digest(), "big")


def uniform(key: int, step: int, count: int) -> NDArray[np.float64]:
    """Numbers in (0, 1], shape (count,)."""
    first = (_mixed(key ^ _mixed(step)) * GOLDEN) & MASK
    with np.errstate(over="ignore"):
        x = np.uint64(first) + np.arange(1, count + 1, dtype=np.uint64) * np.uint64(GOLDEN)
        x = (x ^ (x >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
        x = (x ^ (x >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
        x = x ^ (x >> np.uint64(31))
    return ((x >> np.uint64(11)).astype(np.float64) + 1.0) * 2.0**-53


def gaussian(key: int, step: int, count: int) -> NDArray[np.float64]:
    """Standard normal numbers, shape (count,)."""
    u = uniform(key, step, 2 * count)
    return np.sqrt(-2.0 * np.log(u[:count])) * np.cos(2.0 * np.pi * u[count:])


def _mixed(x: int) -> int:
    x = (x + GOLDEN) & MASK
    x = ((x ^ (x >> 30)) * 0xBF58476D1CE4E5B9) & MASK
    x = ((x ^ (x >> 27)) * 0x94D049BB133111EB) & MASK
    return x ^ (x >> 31)
