# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Meshes that are dropped on the page of `conformal studio`, or chosen, for check_studio.py."""

import math
import subprocess

from check_html_report import require
from studio_page import check_same, program

COLUMNS, ROWS = 36, 20


def torus():
    """The points of a torus without symmetries, in rows, and its quadrangles."""
    def point(i, k):
        u, v = 2 * math.pi * i / COLUMNS, 2 * math.pi * k / ROWS
        r, z = 1 + .4 * math.cos(v), .4 * math.sin(v)
        return 1.2 * r * math.cos(u), r * math.sin(u) + .2 * z, z + .1 * math.cos(2 * u)

    def vertex(i, k):
        return i % COLUMNS * ROWS + k % ROWS

    cells = [(i, k) for i in range(COLUMNS) for k in range(ROWS)]
    return ([point(*cell) for cell in cells],
            [(vertex(i, k), vertex(i + 1, k), vertex(i + 1, k + 1), vertex(i, k + 1)) for i, k in cells])


def to_obj(points, faces):
    return "".join(["v %.17g %.17g %.17g\n" % point for point in points] +
                   ["f " + " ".join(str(v + 1) for v in face) + "\n" for face in faces])


def to_stl(points, faces):
    corners = [(face[0], face[i], face[i + 1]) for face in faces for i in range(1, len(face) - 1)]
    facets = ["facet normal 0 0 0\nouter loop\n" +
              "".join("vertex %.9g %.9g %.9g\n" % points[v] for v in corner) + "endloop\nendfacet\n"
              for corner in corners]
    return "solid torus\n" + "".join(facets) + "endsolid\n"


def drop(studio, path):
    """As from a window of files, onto the view."""
    x, y = studio.place(.5, .5)
    data = {"items": [], "files": [str(path)], "dragOperationsMask": 1}
    for kind in ("dragEnter", "dragOver", "drop"):
        studio.page.call("Input.dispatchDragEvent", type=kind, x=x, y=y, data=data)
        if kind == "dragOver":
            studio.page.wait("document.body.classList.contains('dropping')")
            studio.picture("dropping.png")
    told(studio)


def choose(studio, path):
    """As by the button, in the dialogue of the browser."""
    root = studio.page.call("DOM.getDocument")["root"]["nodeId"]
    node = studio.page.call("DOM.querySelector", nodeId=root, selector="#file")["nodeId"]
    studio.page.call("DOM.setFileInputFiles", nodeId=node, files=[str(path)])
    told(studio)


def told(studio):
    studio.page.wait("!document.querySelector('#file-words').hidden && "
                     "!document.querySelector('#file-words').textContent.startsWith('Reading')")
    studio.settle()


def shown(studio):
    """The name of the shape that is shown, and the number of its triangles."""
    return studio.page.value("[document.querySelector('#shape').selectedOptions[0].text, "
                             "Number(/\\d+(?= triangles)/.exec(document.querySelector('#file-words').textContent))]")


def check_opened(studio, conformal, name):
    """A stroke on it has the numbers of the program for the same file."""
    studio.click("#clear")
    studio.stroke(0, .62)
    require(studio.report().get("verified") is True, f"not verified: {studio.words('#reason')}")
    studio.saved("#save-rho", f"{name}_rho.txt")
    command = studio.words("#command").split()
    check_same(studio.report(), program(conformal, command[1:], studio.folder), "a file that was opened")


def check_refused(studio, conformal, name, content, word):
    """The page says what the program says, and goes on with what it has."""
    before, report = shown(studio)[0], studio.report()
    path = studio.folder / name
    path.write_text(content)
    drop(studio, path)
    run = subprocess.run([conformal, "studio", name, "-o", "none.html"], cwd=studio.folder, capture_output=True,
                         text=True, check=False)
    words = studio.words("#file-words")
    require(run.returncode in (3, 4) and words in run.stderr and word in words,
            f"{name}: {words!r}, not {run.stderr!r}")
    require(studio.page.value("document.querySelector('#repair').hidden") == (word != "non-manifold"),
            f"{name}: repairing it is offered, or not")
    require(shown(studio)[0] == before and studio.report() == report, f"{name} is shown although it is refused")


def check_files(studio, conformal, page):
    studio.open(page)
    points, faces = torus()
    for name, content, open_it in (("ring.obj", to_obj(points, faces), drop),
                                   ("ring.stl", to_stl(points, faces), choose)):
        path = studio.folder / name
        path.write_text(content)
        open_it(studio, path)
        require(shown(studio) == [name, 2 * len(faces)], f"{name}: {shown(studio)} is shown")
        check_opened(studio, conformal, path.stem)
        studio.picture(f"opened_{name}.png")
    check_refused(studio, conformal, "short.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1\n3 0 1 2\n", "short.off:")
    check_refused(studio, conformal, "words.txt", "Dear diary\n", "known format")
    twice = to_obj(points, [*faces, faces[0]])
    check_refused(studio, conformal, "twice.obj", twice, "non-manifold")
    studio.picture("refused_file.png")
    studio.click("#repair")
    told(studio)
    require(shown(studio) == ["twice.obj", 2 * len(faces)], f"repaired: {shown(studio)} is shown")
    check_opened(studio, conformal, "twice")
