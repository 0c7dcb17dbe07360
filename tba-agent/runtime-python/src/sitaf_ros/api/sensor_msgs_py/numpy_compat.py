"""Conversion of structured numpy arrays."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.lib import recfunctions


def structured_to_unstructured(arr: Any, dtype: Any = None, copy: bool = False, casting: Any = "unsafe") -> Any:
    return recfunctions.structured_to_unstructured(np.asarray(arr), dtype=dtype, copy=copy, casting=casting)
