# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Surfaces that one turns, in notebooks and pages."""

from __future__ import annotations

import base64
import html
import json
import pathlib
from typing import Any, List, Optional, Union

import numpy as np

from ._arrays import faces, points, real
from ._errors import Precondition_error
from ._types import Faces, Points, Values

GREY, RED, BLUE = (np.array(colour) for colour in ((.86, .86, .84), (.75, .22, .17), (.18, .43, .71)))


def encoded(numbers: np.ndarray) -> str:
    return base64.b64encode(np.ascontiguousarray(numbers, "<f4").tobytes()).decode()


def colours_of(values: np.ndarray) -> np.ndarray:
    """Red above zero, blue below, grey at zero."""
    largest = np.abs(values).max(initial=0)
    shares = values[:, None] / (largest if largest > 0 else 1)
    return GREY + np.maximum(shares, 0) * (RED - GREY) + np.maximum(-shares, 0) * (BLUE - GREY)


def at_corners(values: Optional[Values], corners: np.ndarray, vertices: int) -> np.ndarray:
    """Of vertices or faces, at the corners of the faces one after the other."""
    numbers = np.zeros(vertices) if values is None else real(values, "view", "values")
    if len(numbers) == vertices:
        return numbers[corners.ravel()]
    if len(numbers) == len(corners):
        return np.repeat(numbers, 3)
    raise Precondition_error("view", f"{len(numbers)} values for {vertices} vertices and {len(corners)} faces")


def in_unit_balls(shapes: List[np.ndarray]) -> List[np.ndarray]:
    """All centred, by one scale."""
    centred = [shape - (shape.min(axis=0) + shape.max(axis=0)) / 2 for shape in shapes]
    radius = max(np.linalg.norm(shape, axis=1).max() for shape in centred)
    return [shape / (radius if radius > 0 else 1) for shape in centred]


class View:
    """A page of its own, which notebooks show as their output."""

    def __init__(self, page: str, height: int):
        self.page, self.height = page, height  #: HTML that needs nothing else; in pixels

    def save(self, path: Union[str, pathlib.Path]) -> None:
        pathlib.Path(path).write_text(self.page, encoding="utf-8")

    def _repr_html_(self) -> str:
        return (f'<iframe srcdoc="{html.escape(self.page)}" width="100%" height="{self.height}" frameborder="0">'
                "</iframe>")


def view(V: Union[Points, List[Points]], F: Faces, values: Optional[Values] = None, *, height: int = 400) -> View:
    """Shows a surface, or several with the same faces side by side, which the mouse turns and the wheel zooms. It
    needs no other package and no network.

    Parameters
    ----------
    V : (n, 3) array, or a list of such arrays
    F : (m, 3) array of integers
    values : (n,) or (m,) array, optional
        of the vertices or the faces: red above zero, blue below
    height : int
        of the output of a notebook, in pixels
    """
    several: Any = V if isinstance(V, (list, tuple)) and np.ndim(V[0]) == 2 else [V]
    shapes, corners = [points(shape, "view") for shape in several], faces(F, "view")
    least = min(len(shape) for shape in shapes)
    if corners.size and not 0 <= corners.min() <= corners.max() < least:
        raise Precondition_error("view", f"a face has a vertex that is not in [0, {least})")
    shown = colours_of(at_corners(values, corners, least))
    data = json.dumps({"shapes": [encoded(shape[corners.ravel()]) for shape in in_unit_balls(shapes)],
                       "colours": encoded(shown)})
    template = pathlib.Path(__file__).with_name("view.html").read_text(encoding="utf-8")
    return View(template.replace("@DATA@", data), height)
