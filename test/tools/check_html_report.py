#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""The page that `conformal flow --html` writes stands alone, tells the numbers of the JSON report,
holds shapes that have them, and draws both in headless Chromium.

usage: check_html_report.py CONFORMAL CHROMIUM [FOLDER]   (keeps the page and pictures in FOLDER)
"""

import array
import base64
import collections
import html.parser
import json
import math
import pathlib
import subprocess
import sys
import tempfile

from check_example import sphere, write_off
from headless_page import Browser
from report_view import check_head

EMPTY = (238, 241, 245)  # of the view, where no surface is


class Page(html.parser.HTMLParser):
    """The contents of elements by their `id`, of cells by their `data-place`, and what it loads."""

    def __init__(self, text):
        super().__init__()
        self.ids, self.places, self.loaded, self.policy = {}, {}, [], ""
        self.open, self.tags = (self.ids, None), collections.Counter()
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        self.tags[tag] += 1
        attributes = dict(attrs)
        if attributes.get("http-equiv") == "Content-Security-Policy":
            self.policy = attributes["content"]
        for name, table in (("id", self.ids), ("data-place", self.places)):
            if name in attributes:
                self.open = (table, attributes[name])
                table[attributes[name]] = ""
        for name in ("src", "href", "data", "srcset"):
            if not attributes.get(name, "data:").startswith(("data:", "#")):
                self.loaded.append(attributes[name])

    def handle_endtag(self, tag):
        self.open = (self.ids, None)

    def handle_data(self, data):
        table, name = self.open
        if name is not None:
            table[name] += data

    def numbers(self, name, kind):
        values = array.array(kind, base64.b64decode(self.ids[name]))
        return values if sys.byteorder == "little" else values.byteswap()


def bumpy_sphere():
    points, faces = sphere(4)
    factors = [1 + 0.2 * math.sin(4 * x) * math.cos(3 * y + z) for x, y, z in points]
    return [tuple(s * x for x in p) for s, p in zip(factors, points)], faces


def vector(points, a, b):
    return [points[3 * b + k] - points[3 * a + k] for k in range(3)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def triangle(points, corners):
    """The first fundamental form (E, F, G) of a face, and its determinant's root."""
    u, v = vector(points, corners[0], corners[1]), vector(points, corners[0], corners[2])
    form = dot(u, u), dot(u, v), dot(v, v)
    return form, math.sqrt(form[0] * form[2] - form[1] ** 2)


def quality(before, after, corners):
    """Q of a face's map and its area before: the eigenvalues of one form by the other."""
    (e, f, g), size = triangle(before, corners)
    (p, q, r), other = triangle(after, corners)
    half = (g * p - 2 * f * q + e * r) / (2 * size * other)
    return half + math.sqrt(max(0, half * half - 1)), size / 2


def leaves(value, place):
    if isinstance(value, dict):
        for key, part in value.items():
            yield from leaves(part, f"{place}/{key}")
    elif isinstance(value, (int, float)) and not isinstance(value, bool):
        yield place, value


def require(is_true, message):
    if not is_true:
        sys.exit(message)


def check_numbers(page, report):
    """Every number of the result is in the certificate, to the six digits it has there."""
    places = list(leaves(report["result"], "result"))
    require(len(places) > 10, f"only {len(places)} numbers in the report")
    for place, value in [*places, *leaves(report["seconds"], "seconds")]:
        digits = 1e-5 if place.startswith("result") else 1e-2
        require(place in page.places, f"{place} is not on the page")
        shown = float(page.places[place].split()[0])
        require(math.isclose(shown, value, rel_tol=digits), f"{place} is {value}, not {shown}")


def check_shapes(page, report):
    """The shapes on the page have the quasi-conformal error of the report."""
    before, after = page.numbers("before", "f"), page.numbers("after", "f")
    faces, stored = page.numbers("faces", "I"), page.numbers("quality", "f")
    require(len(faces) == 3 * report["input"]["faces"] == 3 * len(stored), "faces are missing")
    require(len(page.numbers("squares", "f")) == 2 * len(faces), "squares are missing")
    found = [quality(before, after, faces[i:i + 3]) for i in range(0, len(faces), 3)]
    worst = max(abs(q - s) / s for (q, _), s in zip(found, stored))
    require(worst < 1e-3, f"Q of a face is off by {worst}")
    mean = sum(q * area for q, area in found) / sum(area for _, area in found)
    wanted = report["result"]["quasi_conformal"]["mean"]
    for name, value in (("here", mean), ("on the page", float(
            page.places["recomputed/quasi_conformal/mean"]))):
        require(math.isclose(value, wanted, rel_tol=1e-5), f"mean Q {name} {value}, not {wanted}")


def halves(picture):
    """The two views: what is left and right in the box of the empty view's colour."""
    rows = [y for y, row in enumerate(picture) if row.count(EMPTY) > 100]
    require(rows, "no view is drawn")
    line = picture[rows[0]]
    left, right = line.index(EMPTY), len(line) - line[::-1].index(EMPTY)
    box = [row[left:right] for row in picture[rows[0]:rows[-1] + 1]]
    middle = (right - left) // 2
    return [row[:middle - 2] for row in box], [row[middle + 2:] for row in box]


def check_drawing(name, picture, is_wanted):
    """Both views show a surface with colours of the kind wanted on it."""
    views = halves(picture)
    for side, view in zip(("before", "after"), views):
        pixels = collections.Counter(pixel for row in view for pixel in row)
        area = sum(map(len, view))
        covered = 1 - pixels[EMPTY] / area
        require(covered > 0.15, f"{name}, {side}: only {covered:.3f} of the view is covered")
        require(len(pixels) > 200, f"{name}, {side}: only {len(pixels)} colours")
        share = sum(n for pixel, n in pixels.items() if pixel != EMPTY and is_wanted(*pixel)) / area
        require(share > 0.02, f"{name}, {side}: only {share:.3f} has the colours wanted")
    require(views[0] != views[1], f"{name}: before and after look the same")


def is_marked(r, g, b):
    """Whether a colour is that of what has collapsed."""
    return r > 2 * g + 40 and b > 2 * g + 40


def check_collapse(browser, conformal, source):
    """What has collapsed is marked on the surface before, where it can be seen, and told."""
    page = source.with_name("collapse.html")
    subprocess.run([conformal, "spin", "--force", "-q", source, "--rho-expression", "60*sin(9*x)", "--max-scale",
                    "none", "-o", source.with_name("c.ply"), "--html", page], check=False)
    before, _ = halves(browser.screenshot(page, "#scale"))
    count = sum(is_marked(*pixel) for row in before for pixel in row)
    require(count > 150, f"only {count} pixels show what has collapsed")
    require("</b>below a tenth" in browser.document(page)[0], "nothing is said of what has collapsed")


def main():
    conformal, chromium = sys.argv[1:3]
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(sys.argv[3] if len(sys.argv) > 3 else temporary).resolve()
        source, target, page, report = (folder / name for name in
                                        ("a.off", "b.ply", "report.html", "report.json"))
        write_off(source, *bumpy_sphere())
        subprocess.run([conformal, "flow", "--steps", "3", "-q", source, "-o", target, "--html", page,
                        "--json", report], check=True)
        browser = Browser(chromium, folder)
        text, messages = browser.document(page)
        require(not messages, f"the browser complains: {messages}")
        found, wanted = Page(text), json.loads(report.read_text())
        require(not found.loaded, f"the page loads {found.loaded}")
        require("default-src 'none'" in found.policy, "the page may load what it wants")
        require(json.loads(found.ids["report"]) == wanted, "the page has another report")
        require("Permission is hereby granted" in found.ids["three-license"], "no licence of three.js")
        require(found.tags["rect"] == 80, "the two histograms are not drawn")
        require(found.tags["circle"] == 8, "the flow is not drawn")
        check_numbers(found, wanted)
        check_shapes(found, wanted)
        check_drawing("squares", browser.screenshot(page, "#squares"), lambda r, g, b: b > 1.3 * r)
        check_drawing("quality", browser.screenshot(page, "#quality"), lambda r, g, b: r > 1.3 * b)
        check_collapse(browser, conformal, source)
        check_head(conformal, chromium, source, require)


if __name__ == "__main__":
    main()
