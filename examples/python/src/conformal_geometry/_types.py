# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Arrays with their shapes: n vertices, m faces. Functions take whatever ``numpy.asarray`` does; what they
return is float64, and int32 for vertices."""

from __future__ import annotations

from typing import Annotated, Literal, Tuple

import numpy as np
import numpy.typing as npt

Points = Annotated[npt.ArrayLike, "n x 3"]
Faces = Annotated[npt.ArrayLike, "m x 3 integers"]
Vertex_values = Annotated[npt.ArrayLike, "n"]
Values = Annotated[npt.ArrayLike, "n or m"]
Changes = Annotated[npt.ArrayLike, "n or m, or n x k or m x k"]
Quaternions = Annotated[npt.ArrayLike, "n x 4"]
Vector = Annotated[npt.ArrayLike, "3"]

Point_array = np.ndarray[Tuple[int, Literal[3]], np.dtype[np.float64]]  # n x 3
Quaternion_array = np.ndarray[Tuple[int, Literal[4]], np.dtype[np.float64]]  # n x 4
Plane_array = np.ndarray[Tuple[int, Literal[2]], np.dtype[np.float64]]  # n x 2
Value_array = np.ndarray[Tuple[int], np.dtype[np.float64]]  # n, m or k
Face_array = np.ndarray[Tuple[int, Literal[3]], np.dtype[np.int32]]  # m x 3
Number_array = np.ndarray[Tuple[int], np.dtype[np.int64]]  # of vertices or faces
Edge_array = np.ndarray[Tuple[int, Literal[2]], np.dtype[np.int32]]  # |E| x 2
Form_array = np.ndarray[Tuple[int, int], np.dtype[np.float64]]  # |E| x k
Field_array = np.ndarray[Tuple[int, int, Literal[3]], np.dtype[np.float64]]  # k x m x 3
Spinor_array = np.ndarray[Tuple[int, int, Literal[4]], np.dtype[np.float64]]  # k x n x 4
