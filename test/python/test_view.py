# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Surfaces in notebooks: the page has what it was given, draws it, and turns it."""

import base64
import html
import json
import pathlib
import re
import shutil
import sys

import numpy as np
import pytest

import conformal_geometry as cg
from meshes import icosphere

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "tools"))
from devtools import browser  # pylint: disable=wrong-import-position
from headless_page import read_png  # pylint: disable=wrong-import-position

EMPTY = (238, 241, 245)
V, F = icosphere(2)


def data_of(view):
    data = json.loads(re.search(r"= (\{\"shapes.*\});", view.page)[1])
    def decode(text): return np.frombuffer(base64.b64decode(text), "<f4").reshape(-1, 3)
    return [decode(text) for text in data["shapes"]], decode(data["colours"])


def test_a_page_has_the_corners_of_the_faces_by_one_scale():
    other = V * [3, 1, 1] + 100
    shapes, _ = data_of(cg.view([V, other], F))
    for shape, wanted in zip(shapes, (V / 3, V * [1, 1 / 3, 1 / 3])):
        assert np.abs(shape - wanted[np.ravel(F)]).max() < 1e-6


def test_colours_tell_the_sign_at_vertices_and_faces():
    for values in (V[:, 0], V[F].mean(axis=1)[:, 0]):
        at = values[np.ravel(F)] if len(values) == len(V) else np.repeat(values, 3)
        red, _, blue = data_of(cg.view(V, F, values))[1].T
        assert np.array_equal(np.sign(np.round(red - blue - .02, 6)[np.abs(at) > .1]), np.sign(at[np.abs(at) > .1]))
    plain = data_of(cg.view(V, F))[1]
    assert np.ptp(plain, axis=0).max() == 0


def test_what_does_not_fit_is_refused():
    with pytest.raises(cg.Precondition_error, match="values for"):
        cg.view(V, F, np.zeros(7))
    with pytest.raises(cg.Precondition_error, match="not in"):
        cg.view(V, [[0, 1, len(V)]])


def test_notebooks_show_the_page(tmp_path):
    view = cg.view(V, F, height=300)
    view.save(tmp_path / "a.html")
    assert (tmp_path / "a.html").read_text(encoding="utf-8") == view.page
    assert html.unescape(re.search(r'srcdoc="([^"]*)" width="100%" height="300"', view._repr_html_())[1]) == view.page


@pytest.mark.skipif(not shutil.which("chromium"), reason="no Chromium")
def test_a_browser_draws_it_and_turns_it_by_the_mouse(tmp_path):
    cg.view([V * [2, 1, 1], V], F, V[:, 0]).save(tmp_path / "a.html")
    pictures = []
    with browser("chromium") as page:
        page.open((tmp_path / "a.html").as_uri(), 600, 300)
        page.wait("document.readyState === 'complete'")
        for end in ((150, 150), (270, 150)):
            page.drag([(150, 150), end])
            page.save(tmp_path / "a.png")
            pictures.append(read_png((tmp_path / "a.png").read_bytes()))
        assert page.complaints == [] and all(url.startswith("file:") for url in page.requests)
    for k, rows in enumerate(pictures):
        left, right = ([pixel for row in rows for pixel in row[begin:begin + 300]] for begin in (0, 300))
        assert sum(pixel != EMPTY for pixel in left) > 5000 and sum(pixel != EMPTY for pixel in right) > 5000
        assert any(r > b + 30 for r, g, b in left) and (k == 1 or any(b > r + 30 for r, g, b in left))
    widths = [sum(pixel != EMPTY for pixel in rows[150][:300]) for rows in pictures]
    assert widths[1] < .8 * widths[0]  # the long axis turns away from the eye
