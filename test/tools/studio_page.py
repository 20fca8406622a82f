# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""What a person does with the page of `conformal studio`, and what the program finds for the same files, for
check_studio.py."""

import json
import math
import subprocess
import sys
import time

from check_html_report import leaves, require

ROUNDING, GUIDED = 1e-6, 1e-5  # of spins; of gaps, which single precision guides


def check_same(found, wanted, what, tolerance=ROUNDING):
    """The numbers of both reports, but those that measure rounding."""
    numbers = dict(leaves(wanted["result"], ""))
    for place, value in leaves(found["result"], ""):
        near = max(tolerance, GUIDED if place.endswith("gap") else 0)
        if not place.endswith(("residual", "iterations", "factorizations", "solves")):
            require(math.isclose(value, numbers[place], rel_tol=near, abs_tol=near),
                    f"{what}: {place} is {value}, not {numbers[place]}")
    require(found["verified"] is wanted["verified"], f"{what}: verified differs")


def program(conformal, arguments, folder):
    """The report of a run, and its result."""
    subprocess.run([conformal, *arguments, "-q", "--json", "report.json"], cwd=folder, check=True)
    return json.loads((folder / "report.json").read_text())


class Studio:
    """The page, and what a person does with it."""

    def __init__(self, page, folder):
        self.page, self.folder = page, folder
        page.call("Page.setDownloadBehavior", behavior="allow", downloadPath=str(folder))

    def open(self, path, width=1300, height=850, touch=False):
        self.page.open(path.as_uri(), width, height, touch)
        self.settle()

    def settle(self):
        self.page.wait("['exact', 'failed'].includes(document.body?.dataset.state)")

    def click(self, name):
        """On an element, by its id or selector; waits for what comes of it."""
        place = self.page.value("(() => { const r = document.querySelector(%s).getBoundingClientRect();"
                                "return [r.x + r.width / 2, r.y + r.height / 2] })()" % json.dumps(name))
        self.page.drag([place])
        self.settle()

    def set(self, name, value, event):
        self.page.value(f"(() => {{ const input = document.querySelector('{name}'); input.value = '{value}';"
                        f" input.dispatchEvent(new Event('{event}', {{bubbles: true, cancelable: true}})) }})()")
        self.settle()

    def place(self, right, down):
        """A place of the canvas in shares of its width and height."""
        return self.page.value("(() => { const r = document.querySelector('canvas').getBoundingClientRect();"
                               f"return [r.x + {right} * r.width, r.y + {down} * r.height] }})()")

    def stroke(self, side, down=.5, settles=True):
        x, y = self.place(.25 + .5 * side, down)
        self.page.drag([(x - 40 + 10 * i, y + 3 * i) for i in range(9)])
        if settles:
            self.settle()

    def choose_shape(self, number):
        self.set("#shape", number, "change")

    def words(self, name):
        return self.page.value(f"document.querySelector('{name}').textContent")

    def report(self):
        return json.loads(self.words("#json") or "{}")

    def saved(self, button, name):
        path = self.folder / name
        path.unlink(missing_ok=True)
        self.click(button)
        for _ in range(200):
            if path.exists() and path.stat().st_size > 0:
                return path
            time.sleep(.05)
        sys.exit(f"{name} is not saved")

    def picture(self, name):
        path = self.folder / name
        self.page.save(path)
        return path
