#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/performance.md is computed rightly: fits, ratios, verdicts and drawings, from made-up
measurements whose answers are known."""

import sys
import xml.etree.ElementTree

import sources

sys.dont_write_bytecode = True
sys.path.insert(0, str(sources.ROOT / "benchmark"))
from page import performance_page, plot, targets  # noqa: E402
from page.measurements import Measurements, exponent, title  # noqa: E402


def transform(mesh, faces, model, seconds, **more):
    return {"table": "transform", "model": model, "mesh": mesh, "faces": faces,
            "vertices": faces // 2 + 2, "seconds": seconds, "poisson": 0.5, "bytes": 1000 * faces,
            "difference": 1e-7, "iterations": 3, "assembly_share": 0.01, "setup_share": 0.99,
            **more}


def factor(mesh, faces, model, again, **more):
    return {"table": "factor", "model": model, "mesh": mesh, "faces": faces, "simd": "AVX2",
            "vertices": faces // 2 + 2, "ordering": 0.1, "symbolic": 0.1, "numeric": 2 * again,
            "again": again, "solve": 0.1, "bytes": 100 * faces, "residual": 1e-14,
            "poisson": 0.5, "poisson_again": 0.25, "poisson_solve": 0.05, **more}


def roofline(mesh, faces, bytes_per_vertex, share):
    vertices = faces // 2 + 2
    return {"table": "roofline", "model": "product", "mesh": mesh, "faces": faces, "vertices": vertices,
            "bytes": bytes_per_vertex * vertices, "seconds": 2.0,
            "bandwidth": bytes_per_vertex * vertices / 2 / share}


ROWS = [
    roofline("20", 8000, 25, 0.25),
    roofline("41", 33620, 75, 0.75),
    transform("20", 8000, "native, double", 1.5),
    transform("41", 33620, "native, double", 0.75),
    transform("20", 8000, "native, float", 1.0),
    transform("20", 8000, "thesis recipe", 6.0),
    transform("bull.off", 12396, "native, double", 0.5),
    transform("bull.off", 12396, "thesis recipe", 0.6, difference=0.1),
    factor("20", 8000, "native, quaternion n", 0.5),
    factor("20", 8000, "native, quaternion n", 0.3),
    factor("20", 8000, "CHOLMOD, real 4n", 3.0),
    {"table": "factor", "model": "Eigen, real 4n", "mesh": "20", "faces": 8000, "vertices": 4002,
     "left_out": "too long"},
    {"table": "threads", "model": "whole", "mesh": "20", "faces": 8000, "vertices": 4002,
     "wall_1": 3.0, "wall_2": 2.0},
]

VERDICTS = {  # beginning of the statement: (met, part of what is shown)
    "first transformation of spheres, double": (False, "3.00 (20), best 1.50"),
    "first transformation of spheres, float": (False, "2.00 (20)"),
    "first transformation of any mesh": (True, "3.00 (20)"),
    "float factor: difference": (True, "1.0e-07"),
    "quaternionic numeric factorization": (True, "1.20 (20)"),
    "CHOLMOD, real 4n": (True, "10.00 (20)"),
    "Eigen": (None, "not measured"),
    "thesis recipe": (False, "4.00 (20)"),
    "implementation of 2011 / first transformation, time": (False, "0.20 (20), best 2.19"),
    "two threads, first": (False, "1.50 (20)"),
    "assembly": (True, "1.0"),
}


def check_numbers(m):
    if abs(exponent([1, 10, 100], [3, 3e2, 3e4]) - 2) > 1e-12:
        yield "the exponent of 3 x^2 is not 2"
    if exponent([5], [1]) is not None or exponent([5, 5], [1, 2]) is not None:
        yield "one size has an exponent"
    if [mesh for mesh, _, _ in m.meshes()] != ["20", "41", "bull.off"]:
        yield "meshes are not in order: spheres by size, then the others"
    if title("bear.off:2") != "bear, split in 16":
        yield "a split mesh has the wrong title"


def check_verdicts(m):
    for beginning, (met, shown) in VERDICTS.items():
        target = next(t for t in targets.TARGETS if t.statement.startswith(beginning))
        found, cells = target.verdict(m)
        if found is not met or shown not in cells[2]:
            yield f"{target.statement}: {found} with \"{cells[2]}\", not {met} with \"{shown}\""


def check_roofline(m):
    if performance_page.roofline(m) != {title("20"): {"product": 25}, title("41"): {"product": 75}}:
        yield f"the roofline is wrong: {performance_page.roofline(m)}"


def check_drawing():
    lines = {"a <b>": [(1, 1), (1000, 50)], "c": [(1000, 51), (10, 2)]}
    svg = xml.etree.ElementTree.fromstring(plot.curves(lines, "x", "y", "title"))
    space = "{http://www.w3.org/2000/svg}"
    corners = [tuple(map(float, corner.split(",")))
               for line in svg.iter(space + "polyline") for corner in line.get("points").split()]
    if len(corners) != 4 or corners != [c for c in corners if plot.LEFT < c[0] < plot.WIDTH
                                        - plot.RIGHT and plot.TOP < c[1] < plot.HEIGHT]:
        yield "the plot does not hold all points"
    if not (corners[0][0] < corners[1][0] and corners[0][1] > corners[1][1]):
        yield "larger values are not to the right and above"
    heights = plot.spread([100, 100, 400, 409, 409])
    gaps = [b - a for a, b in zip(sorted(heights), sorted(heights)[1:])]
    if min(gaps) < plot.LINE_HEIGHT or max(heights) > plot.HEIGHT - plot.BOTTOM:
        yield f"names overlap or leave the plot: {heights}"


def elements(svg, name):
    return [element for element in xml.etree.ElementTree.fromstring(svg).iter("{http://www.w3.org/2000/svg}" + name)]


def check_rows():
    """Bars are as wide as they are many, dots lie in the order of their values, ticks are round."""
    widths = [float(bar.get("width")) for bar in elements(plot.bars({"row": {"a": 1, "b": 3}}, "title"), "rect")][1:]
    if abs(widths[1] - 3 * widths[0]) > 0.2:
        yield f"bars of 1 and 3 are {widths} wide"
    dots = [float(dot.get("cx")) for dot in elements(plot.dots({"row": {"a": 1, "b": 10, "c": 100}}, "x", "title"),
                                                     "circle")][3:]
    if not dots[0] < dots[1] < dots[2] or abs(dots[2] - 2 * dots[1] + dots[0]) > 0.2:
        yield f"dots of 1, 10 and 100 are at {dots}"
    if plot.round_numbers(0.9, 6.1) != [1, 2, 3, 4, 5, 6] or list(plot.steps([2, 1]))[-1] != (2, 100):
        yield "round numbers or shares are wrong"


def check_page():
    blocks = performance_page.blocks(ROWS)
    if "| **not met** |" not in blocks["targets"] or "7 of 13 targets" not in blocks["met"]:
        yield f"the page does not count targets: {blocks['met']}"
    if len(performance_page.figures(ROWS)) != 6:
        yield "figures are missing"


if __name__ == "__main__":
    measured = Measurements(ROWS)
    sources.finish([*check_numbers(measured), *check_verdicts(measured), *check_roofline(measured), *check_drawing(),
                    *check_rows(), *check_page()], "the page of measurements")
