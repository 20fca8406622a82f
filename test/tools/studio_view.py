# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""What the view of the studio shows of a drag before it begins, and how it fits a phone, for check_studio.py."""

from check_html_report import EMPTY, require
from headless_page import read_png

PHONES = ((360, 740), (390, 800), (430, 930))
LOOKS = ((400, 860), (1200, 800))
NAMES = 30  # pixels of the names above views that are one above the other


def look(studio, x, y):
    """Holds the mouse there: what a drag does, and the circle of the brush as (left, top, width), if any."""
    studio.page.mouse("mouseMoved", (x, y))
    drag, is_hidden, *circle = studio.page.value(
        "(() => { const c = document.querySelector('#ring'), r = c.getBoundingClientRect();"
        "return [document.querySelector('#canvas').dataset.drag, c.hidden, r.x, r.y, r.width, r.height] })()")
    return drag, None if is_hidden else circle


def silhouette(studio, x, y):
    """The last place to the left from which a drag paints."""
    while look(studio, x, y)[0] == "paint":
        x -= 4
    return x + 4


def check_circle(studio):
    """It is round and as large at a silhouette as in the middle, up to what is nearer to the camera."""
    x, y = studio.place(.25, .5)
    _, middle = look(studio, x, y)
    edge = silhouette(studio, x, y)
    drag, circle = look(studio, edge, y)
    require(drag == "paint" and circle, "no circle at the silhouette")
    left, top, width, height = circle
    require(abs(width - height) < 1 and .7 < width / middle[2] < 1.4, f"circles {middle} and {circle}")
    require(abs(left + width / 2 - edge) < 2 and abs(top + height / 2 - y) < 2, f"the circle is at {circle}")
    require(edge - left > .3 * width, "the circle ends at the silhouette")
    drag, circle = look(studio, edge - 12, y)
    require(drag == "turn" and circle is None, f"beside the shape a drag seems to {drag}")


def check_size(studio):
    """What one dab paints is within the circle, and fills most of it."""
    x, y = studio.place(.25, .5)
    _, (left, _, width, _) = look(studio, x, y)
    studio.page.drag([(x, y)])
    studio.settle()
    studio.page.mouse("mouseMoved", (5, 5))
    row = read_png(studio.picture("dab.png").read_bytes())[round(y)]
    painted = [i for i in range(round(left - width), round(left + 2 * width)) if row[i][0] > 1.15 * row[i][2]]
    require(painted, "a dab paints nothing")
    require(left - 2 < painted[0] and painted[-1] < left + width + 2, f"paint from {painted[0]} to {painted[-1]}, "
            f"a circle from {left} to {left + width}")
    require(painted[-1] - painted[0] > .6 * width, f"paint over {painted[-1] - painted[0]} of {width} pixels")
    studio.click("#clear")


def check_selection(studio):
    """A stroke and a turn that leave the canvas select nothing of the page; not every browser would select."""
    begins = studio.page.value(
        "[getComputedStyle(document.querySelector('#view')).userSelect, document.querySelector('canvas')"
        ".dispatchEvent(new MouseEvent('mousedown', {bubbles: true, cancelable: true}))]")
    require(begins == ["none", False], f"a selection can begin in the view: {begins}")
    for down in (.5, .95):
        x, y = studio.place(.25, down)
        studio.page.drag([(x, y), (x, y + 80), (x + 300, 1000), (x + 900, 20)])
        studio.settle()
        words = studio.page.value("getSelection().toString()")
        require(words == "", f"a drag has selected {words[:60]!r}")
    require(studio.page.value("document.activeElement.id") == "canvas", "keys do not reach the view")


def check_pointer(studio, path):
    """The pointer shows what a drag does; turning is told in words."""
    studio.open(path)
    check_circle(studio)
    check_size(studio)
    studio.click("[data-tool=pull]")
    require(look(studio, *studio.place(.75, .5))[0] == "pull", "a pull is not shown")
    require(look(studio, *studio.place(.25, .5))[0] == "turn", "the first shape seems to be pulled")
    studio.click("[data-tool=bulge]")
    x, y = studio.place(.02, .95)
    studio.page.mouse("mousePressed", (x, y), button="left", buttons=1, clickCount=1)
    shown = "getComputedStyle(document.querySelector('#gesture')).display"
    require(studio.page.value(shown) == "block" and "Turning" in studio.words("#gesture"), "turning is not told")
    studio.page.mouse("mouseReleased", (x, y), button="left", clickCount=1)
    require(studio.page.value(shown) == "none", "it is told for ever")
    check_selection(studio)


def check_room(studio, name):
    """Both shapes are in their halves, whole and beside the names; the corners of the view are round."""
    rows = read_png(studio.picture(name).read_bytes())
    left, top, width, height = studio.page.value(
        "(() => { const r = document.querySelector('canvas').getBoundingClientRect();"
        "return [r.x, r.y, r.width, r.height].map(Math.round) })()")
    for side in (0, 1):
        begin, end = top + side * height // 2 + NAMES + 1, top + (side + 1) * height // 2 - 2
        seen = [y for y in range(begin, end) if set(rows[y][left + 12:left + width - 12]) != {EMPTY}]
        require(seen and seen[0] > begin + 3 and seen[-1] < end - 4,
                f"{name}: side {side} is seen from row {seen[0] - begin} to {seen[-1] - end} before the end")
        require(seen[-1] - seen[0] > .4 * (end - begin), f"{name}: side {side} is small")


def check_finger(studio):
    """A finger that meets the shape by its side paints; one further away turns."""
    x, y = studio.place(.5, .28)
    edge = silhouette(studio, x, y)
    for away, wanted in ((10, "paint"), (40, "turn")):
        studio.page.touch([[(edge - away, y)]])
        studio.settle()
        drag = studio.page.value("document.querySelector('#canvas').dataset.drag")
        require(drag == wanted, f"a finger {away} pixels beside the shape: {drag}")


def check_told(studio):
    """A phone shows the verdict below the view, in place of the words that it answers."""
    words, bottom, hint = studio.page.value(
        "(() => { const told = document.querySelector('#told'), hint = document.querySelector('.hint');"
        "return [told.textContent, told.getBoundingClientRect().bottom, hint.getClientRects().length] })()")
    height = studio.page.value("innerHeight")
    require("Verified" in words and bottom < height and hint == 0,
            f"{words!r} ends at {bottom} of {height}, hint {hint}")


def check_first_look(studio, path):
    """Before anything is done: an invitation that moves, sliders and undo without scrolling; pictures to look at."""
    for width, height in LOOKS:
        studio.open(path, width, height, touch=width < 600)
        studio.picture(f"first_{width}.png")
        seen = studio.page.value(
            "['#invitation', '.finger', '#undo', '#size', '#strength', '#amount'].map(e => document.querySelector(e))"
            ".map(e => [e.getClientRects().length > 0, e.getBoundingClientRect().top < innerHeight])")
        wanted = [[True, True]] * (6 if width > 600 else 5)  # a phone has the third slider further down
        require(seen[:len(wanted)] == wanted, f"at {width} pixels: {seen}")
        require(studio.page.value("document.querySelector('.finger').getAnimations().length") > 0, "nothing moves")
        wide = studio.page.value("document.documentElement.scrollWidth")
        require(wide <= width, f"the page is {wide} pixels wide at {width}")


def check_phone(studio, path):
    for width, height in PHONES:
        studio.open(path, width, height, touch=True)
        wide = studio.page.value("document.documentElement.scrollWidth")
        require(wide <= width, f"the page is {wide} pixels wide on a phone of {width}")
        low = studio.page.value("document.querySelector('#undo').getBoundingClientRect().bottom")
        require(low <= height, f"undo is {low - height} pixels below a phone of {width} x {height}")
        check_room(studio, f"phone_{width}.png")
        x, y = studio.place(.5, .3)
        studio.page.touch([[(x + 5 * i, y)] for i in range(6)])
        studio.settle()
        require(studio.report().get("verified") is True, "a finger does not paint")
        check_told(studio)
        check_room(studio, f"phone_{width}_painted.png")
    check_finger(studio)
