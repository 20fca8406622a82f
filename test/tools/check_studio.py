#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""The page that `conformal studio` writes does in headless Chromium what it offers: painting by mouse,
finger and key, formulas, pulled points, undo, the flow, refusals, saving, dropped files; what it finds is what
the program finds for the files that it saves; it asks for nothing, complains about nothing, and its memory is bounded.

usage: check_studio.py CONFORMAL CHROMIUM [FOLDER]   (keeps the pages and pictures in FOLDER)
"""

import json
import math
import pathlib
import subprocess
import sys
import tempfile

from check_example import write_off
from check_html_report import bumpy_sphere, is_marked, require
from devtools import browser
from headless_page import read_png
from studio_files import check_files
from studio_page import Studio, check_same, program
from studio_view import check_first_look, check_phone, check_pointer

CONTROL, MANY_STROKES, ROUNDING = 2, 200, 1e-6


def points(path):
    return [tuple(map(float, line.split()[1:4])) for line in path.read_text().splitlines() if line.startswith("v ")]


def check_painting(studio, conformal):
    for side in (0, 1):
        studio.stroke(side)
    require(studio.report().get("verified") is True, f"not verified: {studio.words('#reason')}")
    picture = read_png(studio.picture("painted.png").read_bytes())
    orange = sum(r > 1.5 * b and r > 90 for row in picture for r, g, b in row)
    require(orange > 1500, f"only {orange} pixels show paint")
    studio.saved("#save-rho", "bumpy_rho.txt")
    command = studio.words("#command").split()
    require(command[0] == "conformal" and "--max-scale" in command, f"the command is {command}")
    check_same(studio.report(), program(conformal, command[1:], studio.folder), "a painted surface")
    wanted = program(conformal, [*command[1:-1], "native.obj"], studio.folder)
    found, native = (points(path) for path in (studio.saved("#save-obj", "bumpy_edited.obj"),
                                               studio.folder / "native.obj"))
    require(all(math.dist(a, b) < ROUNDING for a, b in zip(found, native, strict=True)),
            "the OBJ file is not what the program writes")
    info = program(conformal, ["info", studio.saved("#save-ply", "bumpy_edited.ply").name], studio.folder)
    require(info["input"]["vertices"] == wanted["input"]["vertices"], "the PLY file is another surface")


def check_brush(studio):
    """Each tool does to rho what its name says."""
    def stroke_of(tool):
        studio.click(f"[data-tool={tool}]")
        studio.stroke(0)
        return [float(x) for x in studio.saved("#save-rho", "bumpy_rho.txt").read_text().split()]

    studio.click("#clear")
    dented = stroke_of("dent")
    require(min(dented) < -1 and max(dented) <= 0, f"dents are from {min(dented)} to {max(dented)}")
    erased = stroke_of("erase")
    require(all(a <= b <= 0 for a, b in zip(dented, erased)) and sum(erased) > sum(dented) / 2,
            "little is erased")
    studio.click("#clear")
    studio.click("#symmetric")
    mirrored = stroke_of("dent")
    studio.click("#symmetric")
    require(sum(x < 0 for x in mirrored) > 1.3 * sum(x < 0 for x in dented), "nothing is mirrored")
    studio.click("#clear")
    studio.click("[data-tool=bulge]")


def check_history(studio):
    painted = studio.report()
    studio.page.key("z", CONTROL)
    studio.settle()
    before = studio.report()
    require(before != painted, "undo does nothing")
    studio.page.key("y", CONTROL)
    studio.settle()
    require(studio.report() == painted, "redo does not lead back")
    studio.click("#clear")
    require(studio.report() == {}, "something is left after all is cleared")


def check_formula(studio, conformal):
    studio.page.value("document.querySelector('#formula').value = '-1.5*sin(4*y)^2 + bump(z, .5)*nx'")
    studio.click("#formula-form button")
    wanted = program(conformal, ["spin", "bumpy.off", "--rho-expression", "-1.5*sin(4*y)^2 + bump(z, .5)*nx",
                                 "-o", "formula.ply"], studio.folder)
    check_same(studio.report(), wanted, "a formula")
    studio.page.value("document.querySelector('#formula').value = 'sin(q)'")
    studio.click("#formula-form button")
    require("'q' is not known" in studio.words("#formula-help"), "a wrong formula is not told")


def check_amount_and_flow(studio, conformal):
    studio.set("#amount", .5, "change")
    require("--amplitude=0.5" in studio.words("#command"), "the amount is not in the command")
    studio.click("#undo")
    studio.click("#clear")
    studio.click("#flow")
    wanted = program(conformal, ["flow", "bumpy.off", "--steps", "1", "-o", "flow.ply"], studio.folder)
    found = studio.report()["result"]["energy"]["final"]
    require(math.isclose(found, wanted["result"]["energy"]["final"], rel_tol=1e-9),
            f"the energy after a step is {found}")
    studio.click("#flow")
    require("--steps 2" in studio.words("#command"), "the second step is not in the command")
    second = studio.report()
    studio.click("[data-tool=erase]")
    studio.stroke(0)
    studio.set("#bound", "4", "change")
    require(studio.report() == second, "what does not concern a flow has taken its certificate away")
    studio.click("#undo")
    studio.click("[data-tool=bulge]")
    studio.click("#undo")
    require(math.isclose(studio.report()["result"]["energy"]["final"], found), "undo of a step")
    studio.click("#undo")
    check_time(studio, second)


def check_time(studio, second):
    """The slider of time leads to what as many single steps lead to, and back."""
    studio.page.value("document.querySelector('#time').value = 2")
    studio.page.value("document.querySelector('#time').dispatchEvent(new Event('input', {bubbles: true}))")
    studio.page.wait("document.body.dataset.state === 'preview'")
    require(studio.words("#time-value") == "2 steps", f"two steps are called {studio.words('#time-value')}")
    studio.set("#time", 2, "change")
    check_same(studio.report(), second, "the slider of time")
    require("--steps 2" in studio.words("#command"), "the time is not in the command")
    studio.set("#time", 0, "change")
    require(studio.report() == {}, "at time 0 something is left of the flow")
    studio.click("#undo")
    require(studio.page.value("document.querySelector('#time').value") == "2", "undo does not set the slider")
    studio.click("#undo")


def check_pulls(studio, conformal):
    """A pulled point arrives, where the program takes it for the saved targets, and can be undone; what is
    still computed while somebody turns the shapes is shown."""
    studio.click("[data-tool=pull]")
    x, y = studio.place(.75, .5)
    studio.page.drag([(x, y), (x + 32, y - 24)])  # at once: previews move the camera, and what is pulled with it
    studio.page.drag([studio.place(.95, .95)])
    studio.settle()
    pulled, command = studio.report(), studio.words("#command").split()
    require(pulled.get("verified") is True, f"a pulled point is refused: {studio.words('#reason')}")
    require(command[:2] == ["conformal", "deform"], f"the command is {command}")
    require(studio.page.value("document.querySelectorAll('#pins i').length") == 8, "not all pins are shown")
    require(studio.words("#save-rho") == "Pins", "the button that saves pins is called otherwise")
    path = studio.saved("#save-rho", "bumpy_targets.json")
    # A search that ends where targets are met to 1e-9, after as many steps as rounding decides.
    check_same(pulled, program(conformal, command[1:], studio.folder), "a pulled point", 1e-5)
    found = points(studio.saved("#save-obj", "bumpy_edited.obj"))
    before = points(studio.saved("#save-before", "bumpy.obj"))
    targets = json.loads(path.read_text())["targets"]
    require(max(math.dist(found[t["vertex"]], t["to"]) for t in targets) < 1e-6, "a target is missed")
    moved = sorted(math.dist(before[t["vertex"]], t["to"]) for t in targets)
    require(moved[-1] > .1 and moved[-2] == 0, f"the targets are moved by {moved}")
    same = program(conformal, ["compare", "bumpy_edited.obj", studio.saved("#save-glb", "bumpy_edited.glb").name],
                   studio.folder)
    require(same["result"]["quasi_conformal"]["max"] < 1.001, "the GLB file is another surface")
    studio.picture("pulled.png")
    studio.page.key("z", CONTROL)
    studio.settle()
    require(studio.report() == {}, "undo leaves a pulled point")
    require(studio.page.value("document.querySelectorAll('#pins i').length") == 0, "undo leaves pins")
    studio.click("[data-tool=bulge]")


def check_shapes(studio, conformal):
    """The demo: what is still computed for one shape is not shown on another, and each has the numbers of
    the program."""
    studio.stroke(0, settles=False)
    studio.choose_shape(2)
    require(studio.report() == {}, "the paint of one shape is on another")
    studio.choose_shape(0)
    require(studio.report().get("verified") is True, "a shape has lost its paint")
    for shape, name, down in ((2, "torus", .62), (3, "disk", .5)):
        studio.choose_shape(shape)
        studio.stroke(0, down)
        studio.saved("#save-before", f"{name}.obj")
        studio.saved("#save-rho", f"{name}_rho.txt")
        command = studio.words("#command").split()
        check_same(studio.report(), program(conformal, command[1:], studio.folder), f"a painted {name}")
        studio.picture(f"{name}.png")


def check_slider(studio):
    """A slider that comes back to where it was changes nothing."""
    painted = studio.report()
    x, y, width = studio.page.value("(() => { const r = document.querySelector('#amount').getBoundingClientRect();"
                                    "return [r.x, r.y + r.height / 2, r.width] })()")
    x += 8 + .75 * (width - 16)
    studio.page.drag([(x + right, y) for right in (0, -20, -40, -20, 0)])
    studio.settle()
    require(studio.report() == painted, "a slider that came back has changed the surface")


def marked(picture):
    """How many pixels show what has collapsed."""
    return sum(is_marked(*pixel) for row in read_png(picture.read_bytes()) for pixel in row)


def check_refusal(studio):
    studio.set("#bound", "none", "change")
    studio.page.value("document.querySelector('#formula').value = '60*sin(9*x)'")
    studio.click("#formula-form button")
    require(studio.report().get("verified") is False, "a torn surface verifies")
    require("poor" in studio.page.value("document.querySelector('#verdict').className"), "not refused")
    require(len(studio.words("#reason")) > 30, "no reason is told")
    require(studio.page.value("document.querySelector('#save-ply').disabled"), "it can be saved")
    require("below a tenth" in studio.words("#legend"), "nobody is told what has collapsed")
    studio.click("[data-mode='2']")
    require(marked(studio.picture("collapsed.png")) > 150, "what has collapsed is not marked")
    studio.click("[data-mode='0']")
    studio.click("#clear")
    studio.set("#bound", "2", "change")


def check_memory(studio):
    """Of the kernels, and of the page after its garbage is collected."""
    used = []
    studio.set("#strength", .25, "input")
    studio.page.value("document.querySelector('canvas').focus()")
    for i in range(MANY_STROKES):
        studio.page.key("bd"[i % 2])  # so that what is painted does not pile up
        studio.page.key("Enter")
        studio.settle()
        if i % 4 == 3:
            studio.page.key("z", CONTROL)
            studio.settle()
        if i in (MANY_STROKES // 2, MANY_STROKES - 1):
            studio.page.call("HeapProfiler.collectGarbage")
            heap = studio.page.call("Runtime.getHeapUsage")["usedSize"]
            used.append((int(studio.page.value("document.body.dataset.memory")), heap))
    (kernels, heap), (kernels_later, heap_later) = used
    require(kernels_later == kernels, f"the kernels grow from {kernels} to {kernels_later} bytes")
    require(heap_later < heap + 30e6, f"the page grows from {heap} to {heap_later} bytes")


def check_touch(studio, path):
    studio.open(path, 400, 900, touch=True)
    x, y = studio.place(.5, .75)
    studio.page.touch([[(x + 5 * i, y)] for i in range(5)])
    studio.settle()
    require(studio.report().get("verified") is True, "a finger does not paint")
    painted = studio.report()
    studio.page.touch([[(x - 20 - i, y), (x + 20 + i, y)] for i in range(5)])
    studio.settle()
    require(studio.report() == painted, "two fingers paint")
    studio.picture("touch.png")


def main():
    conformal, chromium = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(sys.argv[3] if len(sys.argv) > 3 else temporary).resolve()
        write_off(folder / "bumpy.off", *bumpy_sphere())
        subprocess.run([conformal, "studio", "bumpy.off", "-o", "page.html", "-q"], cwd=folder, check=True)
        subprocess.run([conformal, "studio", "-o", "demo.html", "-q"], cwd=folder, check=True)
        with browser(chromium) as page:
            studio = Studio(page, folder)
            studio.open(folder / "page.html")
            check_painting(studio, conformal)
            check_slider(studio)
            check_history(studio)
            check_brush(studio)
            check_formula(studio, conformal)
            check_amount_and_flow(studio, conformal)
            check_pulls(studio, conformal)
            check_refusal(studio)
            check_memory(studio)
            check_touch(studio, folder / "page.html")
            studio.open(folder / "demo.html")
            check_shapes(studio, conformal)
            check_files(studio, conformal, folder / "demo.html")
            check_first_look(studio, folder / "demo.html")
            check_pointer(studio, folder / "demo.html")
            check_phone(studio, folder / "demo.html")
            require(not page.complaints, f"the browser complains: {page.complaints}"[:2000])
            elsewhere = [url for url in page.requests if not url.startswith(("file:", "blob:", "data:"))]
            require(not elsewhere, f"the page loads {elsewhere}")


if __name__ == "__main__":
    main()
