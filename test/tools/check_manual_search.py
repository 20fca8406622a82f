#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""The field that searches the built manual finds what users type: the first hit of each query is the right one, its
link leads to what there is, and a phone shows the field. In headless Chromium, without a server.

usage: check_manual_search.py FOLDER CHROMIUM [PICTURE]   (of the HTML pages, the program)
"""

import json
import pathlib
import re
import sys

import sources
from devtools import browser

# What users type, and the title and address of the right page.
WANTED = {
    "scale_bound": r"scale_bound, a parameter of spin_transform\(\)",
    "sparse_solver": r"sparse_solver, a parameter of ",
    "install": r"Installation index\.html#manual_installation",
    "cmake": r"Installation index",
    "FetchContent": r"Installation index",
    "spin_transform": r"spin_transform\(\) group__PkgEntryPoints",
    "CGP::spin_transform()": r"spin_transform\(\) group__PkgEntryPoints",
    "conformal_parameterization": r"conformal_parameterization\(\) group__PkgEntryPoints",
    "willmore flow": r"conformal_willmore_flow\(\) group__PkgEntryPoints",
    "rho": r"rho, a parameter of spin_transform\(\)",
    "units of rho": r"How large rho should be",
    "quasi-conformal error": r"Conformal maps, and the quasi-conformal error",
    "python": r"Python md_doc_python",
    "blender": r"Blender md_doc_python",
    "studio": r"The studio md_doc_studio\.html",
    "npm": r"The kernels as an npm package",
    "license": r"Licence, and how to cite md_doc_overview",
    "cite": r"Licence, and how to cite",
    "BibTeX": r"Licence, and how to cite",
    "memory": r"Time and memory",
    "threads": r"Threads",
    "boundary": r"Boundary conditions",
    "handles": r"Handles manual_smooth",
    "flattening": r"Flatten manual_flatten",
    "smooth": r"Smooth manual_smooth",
    "control points": r"Control points md_doc_control_points",
    "minimal surface": r"[Mm]inimal.surface",
    "spectrum": r"dirac_spectrum\(\)",
    "cones": r"Cones md_doc_cones",
    "cone": r"Cones md_doc_cones",
    "gltf": r"File formats manual_program",
    "GLB": r"File formats manual_program",
    "obj": r"File formats manual_program",
    "bound": r"scale_bound, a parameter of spin_transform\(\)",
    "texture": r"Flatten manual_flatten",
    "UV": r"Flatten manual_flatten",
    "flatten": r"Flatten manual_flatten",
    "unwrap": r"Flatten manual_flatten",
    "volume": r"With a volume manual_smooth",
    "hole": r"A region, or a hole that was filled manual_smooth",
    "genus": r"Handles manual_smooth",
    "curvature": r"Deform by curvature manual_deform",
    "Q": r"Conformal maps, and the quasi-conformal error",
    "error": r"Errors and certificates manual_certificates",
    "exceptions": r"Exceptions manual_certificates",
    "repair": r"Repair of meshes manual_program",
    "watertight": r"Repair of meshes manual_program",
    "solver": r"Choose or write a linear solver manual_own_solver",
    "MPI": r"Surfaces larger than a machine md_doc_parts",
    "tutorial": r"A first program index",
    "getting started": r"A first program index",
    "command line": r"The program conformal manual_program",
    "API": r"Entry points",
    "brush": r"The studio md_doc_studio\.html",
    "wasm": r"The kernels as an npm package",
    "notebook": r"A notebook md_doc_notebook",
    "pip": r"Install the module md_doc_python",
    "conda": r"Packages md_doc_versions",
    "vesicle": r"Vesicles md_doc_vesicles",
    "energy": r"Willmore energy manual_definitions",
    "mean curvature": r"What rho is",
    "möbius": r"Inversions in spheres manual_forms",
}
RESULTS = "document.querySelector('#manual-search-results')"
HITS = f"[...{RESULTS}.querySelectorAll('a')].map(a => [a.querySelector('b').textContent, a.getAttribute('href')])"


def search(page, query):
    """The hits of a query as (title, address)."""
    page.value("(() => { const field = document.querySelector('#manual-search-field'); field.focus();"
               f"field.value = {json.dumps(query)}; field.dispatchEvent(new Event('input')) }})()")
    page.wait(f"{RESULTS}.dataset.query === {json.dumps(query)}", 30)
    return page.value(HITS)


def complaints(folder, page):
    page.open((folder / "index.html").as_uri(), 1200, 800)
    page.wait("document.querySelector('#manual-search-field') !== null", 30)
    for query, wanted in WANTED.items():
        hits = search(page, query)
        first = " ".join(hits[0]) if hits else "nothing"
        if not re.match(wanted, first):
            yield f"{query}: first {first}, then {[title for title, _ in hits[1:4]]}, not {wanted}"
        for _, address in hits:
            name, _, anchor = address.partition("#")
            if anchor and f'"{anchor}"' not in (folder / name).read_text(encoding="utf-8"):
                yield f"{query}: {name} has no {anchor}"
    if search(page, "xyzzy"):
        yield "xyzzy is found"
    if page.value(f"{RESULTS}.textContent") != "Nothing found":
        yield "nobody is told that nothing is found"


def on_a_phone(folder, page, picture):
    page.open((folder / "index.html").as_uri(), 390, 800, touch=True)
    page.wait("document.querySelector('#manual-search-field')?.getClientRects().length", 30)
    search(page, "scale_bound")
    left, right = page.value(f"(r => [r.left, r.right])({RESULTS}.getBoundingClientRect())")
    if left < 0 or right > 390:
        yield f"results are from {left} to {right} on a phone of 390 pixels"
    if not page.value(f"(a => {{ const r = a.getBoundingClientRect(); return a.contains(document.elementFromPoint("
                      f"r.x + 20, r.y + 12)) }})({RESULTS}.querySelector('a'))"):
        yield "the first hit is below something else"
    if picture:
        page.save(picture)


def main():
    folder = pathlib.Path(sys.argv[1]).resolve()
    picture = pathlib.Path(sys.argv[3]) if len(sys.argv) > 3 else None
    with browser(sys.argv[2]) as page:
        found = [*complaints(folder, page), *on_a_phone(folder, page, picture)]
        # Formulas are set by a MathJax that only the target `doc` copies, or by one in the network.
        found += [f"the browser complains: {complaint}" for complaint in page.complaints
                  if "MathJax.js" not in str(complaint)]
    sources.finish(found, f"{len(WANTED)} searches")


if __name__ == "__main__":
    main()
