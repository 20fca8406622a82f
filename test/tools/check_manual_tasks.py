#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Every page for a task, of the list in the user manual, ends in a picture and its certificate: what
the program printed that made the picture, kept beside it by the program that draws it.
"""

import re

import sources

MANUAL = sources.ROOT / "doc" / "manual"
FIGURES = sources.ROOT / "doc" / "figures"
LIST = re.compile(r"\*\*Learn\*\*.*?\n((?:- \\subpage \w+\n)+)")
FIGURE = re.compile(r"\\cgalFigureBegin\{\w+,(\w+)\.\w+\}")


def tasks():
    """The pages of the list, by the name of each."""
    pages = {re.search(r"\\page (\w+)", path.read_text(encoding="utf-8"))[1]: path
             for path in MANUAL.glob("*.txt") if path.stem != "user_manual"}
    listed = LIST.search((MANUAL / "user_manual.txt").read_text(encoding="utf-8"))[1]
    return {name: pages.get(name) for name in re.findall(r"subpage (\w+)", listed)}


def complaints(pages):
    for name, path in pages.items():
        text = path.read_text(encoding="utf-8") if path else ""
        end = re.split(r"\\section|\\page", text)[-1]
        pictures = FIGURE.findall(end)
        certificates = [p for p in pictures if f"\\verbinclude {p}.txt" in end]
        if not certificates:
            yield f"{name} does not end in a picture and its certificate, but in {pictures}"
        for picture in certificates:
            certificate = FIGURES / f"{picture}.txt"
            if not certificate.exists() or not certificate.stat().st_size:
                yield f"doc/figures/{certificate.name} is missing"


if __name__ == "__main__":
    found = tasks()
    sources.finish(list(complaints(found)), f"{len(found)} pages for a task")
