# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""A surface to begin with, and still pictures by matplotlib: what the examples and the notebook show."""

from __future__ import annotations

from typing import Any, Sequence, Tuple

import numpy as np

from ._types import Point_array, Value_array


def ring(around: int, across: int, radius: float = 3.) -> Tuple[Point_array, np.ndarray, Value_array]:
    """A torus as arrays: V, n x 3, F, m x 3, and the angle of each vertex around the axis."""
    i, j = np.meshgrid(np.arange(around), np.arange(across), indexing="ij")
    a, b = 2 * np.pi * i / around, 2 * np.pi * j / across
    r = radius + np.cos(b)
    V = np.stack([r * np.cos(a), r * np.sin(a), np.sin(b)], axis=-1).reshape(-1, 3)

    def at(k: np.ndarray, l: np.ndarray) -> np.ndarray:
        return k % around * across + l % across

    F = np.concatenate([np.stack([at(i, j), at(i + 1, j), at(i + 1, j + 1)], axis=-1),
                        np.stack([at(i, j), at(i + 1, j + 1), at(i, j + 1)], axis=-1)])
    return V, F.reshape(-1, 3), a.ravel()


def picture(surfaces: Sequence[Point_array], F: np.ndarray, values: np.ndarray, zoom: float = 1.4) -> Any:
    """A figure with the surfaces side by side, coloured by values per vertex: red where positive."""
    from matplotlib import cm, colors, pyplot

    figure = pyplot.figure(figsize=(5 * len(surfaces), 4))
    bound = np.abs(values).max()
    tones = cm.coolwarm(colors.Normalize(-bound, bound)(values[F].mean(axis=1)))
    for k, V in enumerate(surfaces):
        axes = figure.add_subplot(1, len(surfaces), k + 1, projection="3d", proj_type="ortho")
        normals = np.cross(V[F[:, 1]] - V[F[:, 0]], V[F[:, 2]] - V[F[:, 0]])
        normals /= np.linalg.norm(normals, axis=1, keepdims=True)
        light = .35 + .65 * np.clip(normals @ np.array([.3, -.5, .81]), 0, 1)
        mesh = axes.plot_trisurf(*V.T, triangles=F, linewidth=0, antialiased=False)
        mesh.set_facecolors(tones * np.column_stack([light, light, light, np.ones(len(F))]))
        axes.set_box_aspect(np.maximum(np.ptp(V, axis=0), 1e-3), zoom=zoom)
        axes.view_init(45, -60)
        axes.set_axis_off()
    figure.subplots_adjust(0, 0, 1, 1, 0, 0)
    return figure
