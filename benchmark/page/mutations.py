# Copyright (c) 2026 The Conformal Geometry Processing authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Formulas broken on purpose: one sign, factor or conjugation of a header at a time."""

import re
from dataclasses import dataclass

# What is replaced, by what, and what it is called. The sources are formatted, so that binary
# operators stand between blanks and signs before what they belong to.
RULES = [
    (re.compile(r"(?<=[\w)\]}]) \+ (?=[\w(*-])"), " - ", "plus to minus"),
    (re.compile(r"(?<=[\w)\]}]) - (?=[\w(*])"), " + ", "minus to plus"),
    (re.compile(r" \+= "), " -= ", "add to subtract"),
    (re.compile(r" -= "), " += ", "subtract to add"),
    (re.compile(r"(?<=[=(,{?:] )-(?=[a-zA-Z(])"), "", "sign dropped"),
    (re.compile(r"(?<=return )-(?=[a-zA-Z(])"), "", "sign dropped"),
    (re.compile(r"(?<=[({])-(?=[a-zA-Z(])"), "", "sign dropped"),
    (re.compile(r" [*/] (?:\d+\.?\d*|\.\d+)(?=[ ;,)])"), "", "factor dropped"),
    (re.compile(r"(?<=[ (])(?:[2-9]|\d*\.\d+) \* "), "", "factor dropped"),
    (re.compile(r"\bconjugate\("), "(", "conjugation dropped"),
    (re.compile(r"\bstd::sqrt\("), "(", "root dropped"),
    (re.compile(r"(?<=[\w)\]]) / (?=[a-zA-Z(])"), " * ", "division to product"),
]

# Lines without a formula: declarations, messages, loops and places in arrays.
NO_FORMULA = re.compile(
    r"^\s*(#|//|template|using|class|struct|static_assert|for \(|while \(|namespace|throw|case)"
    r'|"|\bat\(|operator|index|size_t|offset|ptrdiff_t|seconds|% 3|3 \* f\b|iterations|loop\.size')
SUBSCRIPT = re.compile(r"\[[^\]]*\]")


@dataclass(frozen=True)
class Mutant:
    header: str  # below include/Conformal_geometry_processing
    line: int    # counted from 1
    what: str
    before: str
    after: str

    @property
    def name(self):
        return f"{self.header}:{self.line}: {self.after.strip()}"


def mutants_of(header, text):
    """All mutants of a header, in the order of its lines."""
    found = []
    for number, line in enumerate(text.splitlines(), start=1):
        code = line.split("//")[0]
        if NO_FORMULA.search(code) or not code.strip():
            continue
        subscripts = [match.span() for match in SUBSCRIPT.finditer(code)]
        for pattern, replacement, what in RULES:
            for match in pattern.finditer(code):
                if any(a <= match.start() < b for a, b in subscripts):
                    continue
                after = line[:match.start()] + replacement + line[match.end():]
                found.append(Mutant(header, number, what, line, after))
    return found


def text_with(mutant, text):
    lines = text.splitlines(keepends=True)
    lines[mutant.line - 1] = mutant.after + "\n"
    return "".join(lines)
