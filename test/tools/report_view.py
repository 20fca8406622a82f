# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""The head of an HTML report and its layout on phones, for check_html_report.py: what was asked, tiles that are green
where their limit holds, all else folded, and both shapes whole, above each other."""

import json
import subprocess

from devtools import browser
from headless_page import read_png

PHONES = ((360, 800), (400, 860), (430, 930))
EMPTY, NAMES = (238, 241, 245), 30  # the colour of the view where no surface is; pixels above each shape
TILES = ("[...document.querySelectorAll('#tiles li')].map(tile => [tile.querySelector('span').textContent,"
         "tile.className, tile.querySelector('b').textContent, tile.querySelector('small')?.textContent ?? ''])")


def open_report(page, path, width, height):
    page.open(path.as_uri(), width, height, touch=width < 600)
    page.wait("document.querySelector('#canvas')?.dataset.drawn === 'yes'")


def wanted_kinds(report):
    """{part of a tile's name: its colour}, by the numbers and limits of the report alone."""
    result, options = report["result"], {k: float(v) for k, v in report["options"].items()
                                         if k in ("quasi_conformal", "flipped_share", "closure", "collapsed_share")}
    holds = {"shear": result["quasi_conformal"]["mean"] <= options["quasi_conformal"],
             "flipped": result["flipped_faces"] / report["input"]["faces"] <= options["flipped_share"],
             "gap": result["closure_residual"] <= options["closure"]}
    if "realised_curvature" in result:
        realised = result["realised_curvature"]
        holds["realised"] = realised["agreement"] >= realised["least_agreement"]
    if result["scale"]["collapsed_share"] > 0:
        holds["below a tenth"] = result["scale"]["collapsed_share"] <= options["collapsed_share"]
    kinds = {name: "good" if is_so else "poor" for name, is_so in holds.items()}
    if "scale_control" in result:
        scales = result["scale_control"]
        is_within = max(scales["high"], 1 / scales["low"]) <= scales["bound"] * (1 + 1e-6)
        return kinds | {"lengths, on 98 %": "good" if is_within else "poor"}
    return kinds | {"lengths": ""}  # nothing judges them


def check_tiles(page, report, require):
    """Each tile has the colour that its limit gives it, and says the limit."""
    tiles = page.value(TILES)
    verdict, colour = [tile for tile in tiles if "erified" in tile[2]], "good" if report["verified"] else "poor"
    require(len(verdict) == 1 and verdict[0][1] == colour, f"the verdict: {verdict}")
    for name, kind in wanted_kinds(report).items():
        found = [tile for tile in tiles if name in tile[0] and tile not in verdict]
        require(len(found) == 1 and found[0][1] == kind, f"{name} should be {kind or 'without a colour'}: {tiles}")
        require(bool(found[0][3]) == bool(kind), f"{name}: its limit is {found[0][3]!r}")
    require(all(tile[1] == "" or tile[3] or tile in verdict for tile in tiles), f"a colour without a limit: {tiles}")
    error = report.get("error", "")
    require(error in page.value("document.querySelector('#remarks').textContent"), "no reason is told")


def check_first_screen(page, name, require):
    """The verdict and both surfaces are seen without scrolling."""
    height = page.value("innerHeight")
    ends = page.value("['#tiles li', '.view'].map(e => document.querySelector(e).getBoundingClientRect().bottom)")
    require(max(ends) <= height, f"{name}: the verdict and the view end at {ends} of {height}")


def check_rows(page, require):
    """Tiles are as wide as each other, also those that a row is too short for, and their words in lines."""
    boxes = page.value("[...document.querySelectorAll('#tiles li')].map(tile => (r => [r.width, r.top])"
                       "(tile.getBoundingClientRect()))")
    widths, tops = [width for width, _ in boxes], [top for _, top in boxes]
    require(max(widths) - min(widths) < 2, f"tiles are {widths} pixels wide")
    rows = [tops.count(top) for top in sorted(set(tops))]
    require(max(rows) - min(rows[:-1] or rows) == 0, f"rows of {rows} tiles")


def check_flat(page, conformal, source, require):
    """A map to the plane says what it was, and what would overlap."""
    path, report = source.with_name("flat.html"), source.with_name("flat.json")
    subprocess.run([conformal, "flatten", "-q", source, "--method", "cones", "--cut=24", "-o",
                    source.with_name("c.ply"), "--html", path, "--json", report], check=True)
    result = json.loads(report.read_text())["result"]
    open_report(page, path, 1200, 800)
    words = page.value("document.querySelector('#asked').textContent")
    require("a map to the plane" in words and "24 cones" in words, f"flatten: what was asked is {words!r}")
    told = [tile for tile in page.value(TILES) if "overlap" in tile[0]]
    require(len(told) == ("charts" in result) and all(f"{result['charts']} charts" in tile[0] for tile in told),
            f"flatten: {result['overlap']} is told by {told}")
    check_rows(page, require)
    page.save(source.with_name("flat_1200.png"))


def check_folded(page, require):
    """Tables and charts are in the page, folded."""
    for name in ("histogram", "scales", "certificate", "options", "seconds", "json"):
        shown = page.value(f"(() => {{ const e = document.getElementById('{name}'), d = e.closest('details');"
                           "return [d.open, e.getClientRects().length > 0, e.textContent.length > 0] })()")
        require(shown[0] is False and shown[2], f"{name}: open, shown, filled: {shown}")


def check_room(page, picture, require):
    """Both shapes are whole in their half of the view, below their names."""
    page.value("document.querySelector('.view').scrollIntoView({block: 'end'})")
    page.value("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
    page.save(picture)
    rows = read_png(picture.read_bytes())
    left, top, width, height = page.value("(() => { const r = document.querySelector('canvas').getBoundingClientRect();"
                                          "return [r.x, r.y, r.width, r.height].map(Math.round) })()")
    for side in (0, 1):
        begin, end = top + side * height // 2 + NAMES + 1, top + (side + 1) * height // 2 - 2
        seen = [y for y in range(begin, end) if set(rows[y][left + 12:left + width - 12]) != {EMPTY}]
        require(seen and seen[0] > begin + 2 and seen[-1] < end - 3, f"{picture.name}: side {side} is not whole")
        require(seen[-1] - seen[0] > .35 * (end - begin), f"{picture.name}: side {side} is small")


def check_head(conformal, chromium, source, require):
    """Of a bounded change of curvature, of a torn surface, and of a flow."""
    runs = {"bent": ["spin", "--rho-expression", "5*sin(6*y)"],
            "torn": ["spin", "--force", "--rho-expression", "60*sin(9*x)", "--max-scale", "none", "--limit",
                     "quasi_conformal=1.05"],
            "smooth": ["flow", "--steps", "3"]}
    asked = {"bent": "5*sin(6*y)", "torn": "60*sin(9*x)", "smooth": "at most 3 steps"}
    with browser(chromium) as page:
        for name, (command, *options) in runs.items():
            path, report = source.with_name(f"{name}.html"), source.with_name(f"{name}.json")
            subprocess.run([conformal, command, "-q", source, *options, "-o", source.with_name("c.ply"), "--html", path,
                            "--json", report], check=False)
            open_report(page, path, 1200, 800)
            page.save(source.with_name(f"{name}_1200.png"))
            check_first_screen(page, name, require)
            check_rows(page, require)
            check_tiles(page, json.loads(report.read_text()), require)
            words = page.value("document.querySelector('#asked').textContent")
            require(asked[name] in words, f"{name}: what was asked is {words!r}")
            check_folded(page, require)
            for width, height in PHONES:
                open_report(page, path, width, height)
                wide = page.value("document.documentElement.scrollWidth")
                require(wide <= width, f"{name} is {wide} pixels wide on a phone of {width}")
                if name == "bent":
                    page.save(source.with_name(f"first_{width}.png"))
                    check_first_screen(page, f"{name} at {width}", require)
                check_room(page, source.with_name(f"{name}_{width}.png"), require)
                page.value("document.querySelectorAll('details').forEach(e => e.open = true)")
                wide = page.value("document.documentElement.scrollWidth")
                require(wide <= width, f"{name}, unfolded, is {wide} pixels wide on a phone of {width}")
        check_flat(page, conformal, source, require)
        require(not page.complaints, f"the browser complains: {page.complaints}"[:2000])
