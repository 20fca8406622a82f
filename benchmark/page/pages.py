# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""The measured pages doc/NAME.md. A module NAME_page.py makes, of the rows in doc/data/NAME.jsonl.gz,
the blocks of the page between the lines <!-- BLOCK --> and <!-- end -->, and its plots."""

import importlib
import pathlib
import re

from page import machine, record

DOC = machine.ROOT / "doc"
BLOCK = re.compile(r"<!-- (\w+) -->\n(.*?)<!-- end -->", re.DOTALL)


def names():
    return sorted(path.stem.removesuffix("_page") for path in pathlib.Path(__file__).parent.glob("*_page.py"))


def filled(text, blocks):
    """The page with its blocks anew."""
    return BLOCK.sub(lambda found: f"<!-- {found[1]} -->\n{blocks[found[1]]}\n<!-- end -->", text)


def files(name):
    """path -> content, of the page and its plots."""
    module, rows = importlib.import_module(f"page.{name}_page"), record.load(name)
    page = DOC / f"{name}.md"
    plots = {DOC / "figures" / file: svg for file, svg in module.figures(rows).items()}
    return {page: filled(page.read_text(encoding="utf-8"), module.blocks(rows)), **plots}


def write(name):
    for path, content in files(name).items():
        path.write_text(content, encoding="utf-8")


def stale():
    """The files that are not what the data give."""
    for name in names():
        for path, content in files(name).items():
            if not path.exists() or path.read_text(encoding="utf-8") != content:
                yield f"{path.relative_to(machine.ROOT)} is not what the data give: run benchmark/pages {name}"
