#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""The npm package, packed and installed as a user does without a network: its laws hold under Node
(test/npm/package.test.mjs), and its example draws in headless Chromium.

usage: check_npm_package.py PACKAGE NODE NPM [THREE.js CHROMIUM [PICTURE.png]]
"""

import functools
import http.server
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import threading

from devtools import browser
from headless_page import read_png

HERE = pathlib.Path(__file__).resolve().parent
LARGEST = 3e6  # bytes of the archive
EMPTY = (238, 241, 245)


def require(is_true, message):
    if not is_true:
        sys.exit(message)


def install(package, npm, folder):
    """npm pack, and npm install of the archive, in the folder."""
    def run(*arguments):
        return subprocess.run([npm, *arguments], cwd=folder, check=True, capture_output=True, text=True).stdout

    packed = json.loads(run("pack", "--json", str(package)))[0]
    names = {file["path"] for file in packed["files"]}
    wanted = {"package.json", "index.js", "index.d.ts", "kernels.js", "surface.js", "README.md", "LICENSE",
              "example/index.html", "example/main.js"}
    require(names == wanted, f"in the archive: {sorted(names)}")
    require(packed["size"] < LARGEST, f"the archive has {packed['size']} bytes")
    run("install", "--offline", "--no-audit", "--no-fund", packed["filename"])


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


def check_example(folder, three, chromium, picture):
    """The page of the example, from a server of files, draws another shape when its slider is moved."""
    shutil.copytree(folder / "node_modules/conformal-geometry/example", folder, dirs_exist_ok=True)
    (folder / "node_modules/three/build").mkdir(parents=True)
    shutil.copy(three, folder / "node_modules/three/build/three.module.min.js")
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=folder))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    drawn = []
    try:
        with browser(chromium) as page:
            page.open(f"http://127.0.0.1:{server.server_port}/", 500, 500)
            page.wait("document.querySelector('#report')?.textContent.includes('mean Q')")
            for amplitude in (1.5, 0):
                page.value(f"(() => {{ const slider = document.querySelector('#amplitude'); slider.value = {amplitude};"
                           "slider.dispatchEvent(new Event('input')) })()")
                page.value("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
                page.save(picture)
                drawn.append(sum(pixel != EMPTY for row in read_png(picture.read_bytes())[:400] for pixel in row))
            require(not page.complaints, f"the browser complains: {page.complaints}"[:2000])
    finally:
        server.shutdown()
    require(min(drawn) > 20000 and drawn[0] != drawn[1], f"pixels drawn: {drawn}")


def main():
    package, node, npm = pathlib.Path(sys.argv[1]).resolve(), *sys.argv[2:4]
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        install(package, npm, folder)
        shutil.copy(HERE.parent / "npm/package.test.mjs", folder)
        subprocess.run([node, "--test", "package.test.mjs"], cwd=folder, check=True)
        if len(sys.argv) > 5:
            picture = pathlib.Path(sys.argv[6]).resolve() if len(sys.argv) > 6 else folder / "example.png"
            check_example(folder, *sys.argv[4:6], picture)


if __name__ == "__main__":
    main()
