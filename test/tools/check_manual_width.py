#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""No page of the built manual is wider than a window of 1200 or of 400 pixels: what is wider scrolls
by itself. Headless Chromium shows every page for readers in a frame of that width.

usage: check_manual_width.py FOLDER CHROMIUM   (of the HTML pages, the program)
"""

import html
import json
import pathlib
import re
import subprocess
import sys
import tempfile

import sources
from headless_page import FLAGS

WIDTHS = (1200, 400)
PAGES = re.compile(r"(index|annotated|bgl_|triangle_|md_doc_|manual_|group__|class[A-Z][A-Za-z0-9_]*\.)")
# What is beyond the right border of the page, the innermost elements of it, unless an element around
# them scrolls.
SCRIPT = """
const pages = %s, widths = %s, found = [];
const frame = document.body.appendChild(document.createElement("iframe"));
frame.height = 900;
function measure(page, width) {
  const view = frame.contentWindow, root = frame.contentDocument.querySelector("#doc-content");
  const border = Math.min(width, root.getBoundingClientRect().right) + 1;
  const sticks_out = e => e.getClientRects().length && e.getBoundingClientRect().right > border;
  function scrolls(e) {
    for (; e !== root; e = e.parentElement)
      if (/auto|scroll|hidden/.test(view.getComputedStyle(e).overflowX)) return true;
    return false;
  }
  for (const e of root.querySelectorAll("*"))
    if (sticks_out(e) && ![...e.children].some(sticks_out) && !scrolls(e.parentElement))
      found.push([page, width, e.tagName, e.textContent.trim().slice(0, 60)]);
}
function show(i) {
  if (i == pages.length * widths.length) {
    const result = document.body.appendChild(document.createElement("pre"));
    result.textContent = JSON.stringify(found);
    return;
  }
  const page = pages[i %% pages.length], width = widths[Math.floor(i / pages.length)];
  frame.width = width;
  frame.onload = () => setTimeout(() => { measure(page, width); show(i + 1); }, 100);
  frame.src = page;
}
show(0);
"""


def complaints(folder, browser):
    pages = sorted(path.name for path in folder.glob("*.html")
                   if PAGES.match(path.name) and "-members" not in path.name)
    driver = folder / "width_of_pages.html"
    driver.write_text(f"<body><script>{SCRIPT % (json.dumps(pages), json.dumps(WIDTHS))}</script>",
                      encoding="utf-8")
    try:
        with tempfile.TemporaryDirectory() as profile:
            shown = subprocess.run(
                [browser, *FLAGS, f"--user-data-dir={profile}", "--allow-file-access-from-files",
                 "--virtual-time-budget=600000", "--window-size=1300,1000", "--dump-dom",
                 driver.resolve().as_uri()], capture_output=True, text=True, check=True).stdout
    finally:
        driver.unlink()
    result = re.search(r"<pre>(.*?)</pre>", shown, re.DOTALL)
    if not result:
        yield f"{browser} has not shown all {len(pages)} pages"
        return
    for page, width, element, text in json.loads(html.unescape(result[1])):
        yield f"{page}: at {width} pixels, {element.lower()} is cut off: {text!r}"


if __name__ == "__main__":
    sources.finish(list(complaints(pathlib.Path(sys.argv[1]), sys.argv[2])),
                   "the width of the manual's pages")
