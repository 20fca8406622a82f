# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Formulas broken on purpose: one sign, factor, root, conjugation or division of a header at a time.

A mutant is a change of one line. Instead of compiling each, `switchable` writes all of a header into
one text, where benchmark/support/mutation.h chooses among them at run time."""

import re
from dataclasses import dataclass

# What is replaced, by what, what stands there if it is to be chosen at run time ({} is the switch,
# \g<0> the original), and what it is called. The sources are formatted, so that binary operators
# stand between blanks and signs before what they belong to.
RULES = [
    (r"(?<=[\w)\]}]) \+ (?=[\w(*-])", " - ", " + {} * ", "plus to minus"),
    (r"(?<=[\w)\]}]) - (?=[\w(*])", " + ", " - {} * ", "minus to plus"),
    (r" \+= ", " -= ", " += {} %= ", "add to subtract"),
    (r" -= ", " += ", " -= {} %= ", "subtract to add"),
    (r"(?:(?<=[=(,{?:] )|(?<=return )|(?<=[({]))-(?=[a-zA-Z(])", "", "-{} * ", "sign dropped"),
    (r"(?<= [*/] )(?:\d+\.?\d*|\.\d+)(?=[ ;,)])", "1", r"{}.factor(\g<0>)", "factor dropped"),
    (r"(?<=[ (])(?<![*/] )(?:[2-9]|\d*\.\d+)(?= \* )", "1", r"{}.factor(\g<0>)", "factor dropped"),
    (r"\bconjugate\(", "(", "{}.conjugate_of(", "conjugation dropped"),
    (r"\bstd::sqrt\(", "(", "{}.root(", "root dropped"),
    (r"(?<=[\w)\]]) / (?=[a-zA-Z(])", " * ", " / {} ->* ", "division to product"),
]
RULES = [(re.compile(rule[0]), *rule[1:]) for rule in RULES]

# Lines without a formula: declarations, messages, loops and places in arrays.
NO_FORMULA = re.compile(
    r"^\s*(#|//|template|using|class|struct|static_assert|for \(|while \(|namespace|throw|case)"
    r'|"|\bat\(|operator|index|size_t|offset|ptrdiff_t|seconds|% 3|3 \* f\b|iterations|loop\.size')
SUBSCRIPT = re.compile(r"\[[^\]]*\]")


@dataclass(frozen=True)
class Mutant:
    header: str   # below include/Conformal_geometry_processing
    line: int     # counted from 1
    what: str
    before: str
    after: str
    column: int   # where the change begins
    length: int   # of what is replaced
    switch: str   # what replaces it in the text with all mutants

    @property
    def name(self):
        return f"{self.header}: {self.after.strip()}"


def mutants_of_line(header, number, line):
    code = line.split("//")[0]
    if NO_FORMULA.search(code) or not code.strip():
        return
    subscripts = [match.span() for match in SUBSCRIPT.finditer(code)]
    for pattern, replacement, switch, what in RULES:
        for match in pattern.finditer(code):
            start, end = match.span()
            if not any(a <= start < b for a, b in subscripts):
                yield Mutant(header, number, what, line, line[:start] + replacement + line[end:],
                             start, end - start, match.expand(switch))


def mutants_of(header, text):
    """All mutants of a header, in the order of its lines."""
    return [mutant for number, line in enumerate(text.splitlines(), start=1)
            for mutant in mutants_of_line(header, number, line)]


def switchable(ids, text):
    """The text of a header with a switch for each of its mutants, given as {mutant: number}."""
    lines = text.splitlines(keepends=True)
    for mutant, number in sorted(ids.items(), key=lambda pair: pair[0].column, reverse=True):
        start, end = mutant.column, mutant.column + mutant.length
        line = lines[mutant.line - 1]
        switch = mutant.switch.replace("{}", f"mutation::Mutant{{{number}}}")
        lines[mutant.line - 1] = line[:start] + switch + line[end:]
    first = next(i for i, line in enumerate(lines) if line.startswith("#include"))
    lines[first] = f"#include <Conformal_geometry_processing/mutation.h>\n#line {first + 1}\n" + lines[first]
    return "".join(lines)
