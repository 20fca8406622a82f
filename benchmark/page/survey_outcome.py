# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""What became of one run of the survey, in one word, and why."""

import re

from page import ply_points, sandbox

VERIFIED, UNSUITABLE, UNREADABLE = "verified", "unsuitable", "cannot read"
NOT_VERIFIED, NO_MEMORY = "not verified", "out of memory"
CRASHED, TIMED_OUT = "crashed", "timed out"
UNVERIFIED, LEFT, UNSTATED = "unverified success", "file left", "no reason"
REFUSALS = {1: NOT_VERIFIED, 3: UNREADABLE, 4: UNSUITABLE, 6: NO_MEMORY}
GOOD = [VERIFIED, UNSUITABLE, UNREADABLE, NOT_VERIFIED]
BAD = [NO_MEMORY, CRASHED, TIMED_OUT, UNVERIFIED, LEFT, UNSTATED]
COLORS = {VERIFIED: "#009e73", UNSUITABLE: "#7f7f7f", UNREADABLE: "#333333", NOT_VERIFIED: "#c77700",
          **dict.fromkeys(BAD, "#d00000")}
WITHOUT_OUTPUT = ["info", "spectrum"]
SMALL = 1e-6  # of the residuals of harmonic forms, whose report has no certificate


def certified(command, report):
    """Whether the report says that the result was checked: of info that nothing is checked, of
    forms the residuals."""
    result = report.get("result", {})
    if command == "info":
        return "problems" in result
    if command == "harmonic":
        names = ("closed_residual", "coclosed_residual", "orthonormal_residual")
        return all(result.get(name) is not None and result[name] < SMALL for name in names)
    return report.get("verified") is True


def success(command, run):
    wanted = [] if command in WITHOUT_OUTPUT else [sandbox.OUTPUT]
    if run.files != wanted:
        return UNVERIFIED, f"wrote {run.files}"
    if not certified(command, run.report):
        return UNVERIFIED, "the report does not say verified"
    fault = ply_points.fault(run.output, run.report["input"]["vertices"]) if wanted else ""
    return (UNVERIFIED, "the output is " + fault) if fault else (VERIFIED, "")


def keeps_last_steps(command, run):
    """Whether it is a flow that stopped early, and said that it wrote the last good surface."""
    return (command == "flow" and run.code == 1 and run.files == [sandbox.OUTPUT]
            and "is written" in run.message
            and not ply_points.fault(run.output, run.report["input"]["vertices"]))


def outcome(command, run):
    """(outcome, reason)"""
    if run.late:
        return TIMED_OUT, f"after {run.seconds:.0f} seconds of the processor"
    if run.code == 0:
        return success(command, run)
    if run.code not in REFUSALS:
        return CRASHED, f"code {run.code}: {run.message}"
    if run.files and not keeps_last_steps(command, run):
        return LEFT, f"{', '.join(run.files)} after exit {run.code}: {run.message}"
    if not run.message:
        return UNSTATED, f"exit {run.code}"
    return REFUSALS[run.code], run.message


def kind(reason):
    """The reason without its file and numbers, to be counted."""
    text = re.sub(r"^FILE(:\d+)?: ", "", reason).split("; try: ")[0]
    while "(" in text and (shorter := re.sub(r"\s*\([^()]*\)", "", text)) != text:
        text = shorter
    return re.sub(r"\d+(,\d{3})*(\.\d+)?(e[-+]?\d+)?", "N", text).strip()
