#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Every link between pages of the built manual leads to a file, a picture or a heading there is.

usage: check_manual_links.py FOLDER   (of the HTML pages)
"""

import pathlib
import re
import sys
import urllib.parse

import sources

LINK = re.compile(r'(?:href|src)="([^"]+)"')
NAME = re.compile(r'(?:id|name)="([^"]+)"')
# The target `doc` copies MathJax; a test that runs doxygen alone does not.
ELSEWHERE = re.compile(r"[a-z]+:|mathjax/")


def complaints(folder):
    pages = {path.name: path.read_text(encoding="utf-8") for path in folder.glob("*.html")}
    if "index.html" not in pages:
        yield f"{folder} has no index.html"
    names = {page: set(NAME.findall(text)) for page, text in pages.items()}
    for page, text in sorted(pages.items()):
        for link in sorted(set(LINK.findall(text))):
            if link.startswith("file:"):
                yield f"{page}: {link} is of this machine only"
            if ELSEWHERE.match(link):
                continue
            target, _, heading = urllib.parse.unquote(link).partition("#")
            if target and not (folder / target).exists():
                yield f"{page}: there is no {target}"
            elif heading and heading not in names.get(target or page, {heading}):
                yield f"{page}: {target} has no heading {heading}"


if __name__ == "__main__":
    sources.finish(list(complaints(pathlib.Path(sys.argv[1]))), "links of the manual")
