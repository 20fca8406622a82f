# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Arrays as the compiled kernels take them: float64 and int64, row by row."""

from __future__ import annotations

from typing import Any, Optional

import numpy as np

from ._errors import Precondition_error


def real(values: Any, function: str, what: str) -> np.ndarray:
    """Numbers of any real type, as float64 in C order."""
    array = np.asarray(values)
    if array.dtype.kind not in "fiub":
        raise Precondition_error(function, f"{what} are {array.dtype}; real numbers are needed")
    return np.ascontiguousarray(array, dtype=np.float64)


def real_or_none(values: Any, function: str, what: str) -> Optional[np.ndarray]:
    return None if values is None else real(values, function, what)


def points(V: Any, function: str) -> np.ndarray:
    array = real(V, function, "points")
    return array if array.size else array.reshape(-1, 3)


def faces(F: Any, function: str) -> np.ndarray:
    """Indices of any integer type, as int64 in C order; they are checked by the kernels."""
    array = np.asarray(F)
    if array.size == 0:
        array = array.astype(np.int64).reshape(-1, 3)
    if array.dtype.kind not in "iu":
        raise Precondition_error(function, f"faces are {array.dtype}; integers are needed")
    return np.ascontiguousarray(array, dtype=np.int64)
