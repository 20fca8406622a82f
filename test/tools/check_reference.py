#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""The reference fits the headers: there are no more named parameters than one can read, as what is
seldom set is a member of the options of its family; each function documents the named parameters that it accepts, all
of them with a default, doc/parameters.md is the table of these, the page of a concept names the
header of every type of the library that its functions take or return, and nothing that is internal
has a group, as the manual leaves it out.

usage: check_reference.py [--fix]   (writes the page and the lists of headers)
"""

import re
import sys

import check_public_types
import sources

PAGE = sources.ROOT / "doc" / "parameters.md"
MOST_PARAMETERS = 36
CONCEPTS = sources.ROOT / "doc" / "Concepts"
INTRODUCTION = """# Named parameters by function

What each function accepts, and what holds without it; what a name means is in
`named_parameters.txt`, its type on the page of the function. The functions for several components
(`..._components()`) take those of the function for one. This page is written from the headers by
`test/tools/check_reference.py --fix`; a test compares both.
"""
# a comment, and the head of the function below it
DOCUMENTED = re.compile(r"((?:^///.*\n)+)(?:template <[^{;]*?>\n)?([^{;]*?)\b(\w+)\(",
                        re.MULTILINE)
PARAMETER = re.compile(r"\\cgalParamNBegin\{([\w, ]+)\}(.*?)\\cgalParamNEnd")
DEFAULT = re.compile(r"\\cgalParamDefault\{(.*?)\} *(?=\\|$)|"
                     r"\\cgalParamDescription\{see `(\w+)\(\)`\}")
ACCEPTED = re.compile(r"only_known_parameters<(.*?)>,?\s*\"", re.DOTALL)
HEADERS = "Headers of these types:"


def lists():
    return (sources.INCLUDE / sources.LIBRARY / "core/named_parameters.h").read_text(encoding="utf-8")


def names_of_tags():
    """What users write for a tag of CGAL's, as `vertex_point_map` for `vertex_point`."""
    return dict(re.findall(r"\bX\((\w+), (\w+)\)", lists()))


def names():
    """All named parameters."""
    return re.findall(r"^  X\((?:\w+, )?(\w+)\)", lists(), re.MULTILINE)


def documented(header):
    """{function: {named parameter: default}} of a header."""
    functions = {}
    for comment, _, function in DOCUMENTED.findall(header):
        text = re.sub(r"\s*\n///\s*", " ", comment)
        found = {name: DEFAULT.search(body.strip()) for names, body in PARAMETER.findall(text)
                 for name in names.split(", ")}
        if found:
            functions[function] = {name: default and (default[1] or f"as in `{default[2]}()`")
                                   for name, default in found.items()}
    return functions


def parameters():
    """(header, functions as above, the names that its functions accept) of each entry point."""
    names = names_of_tags()
    for path in sorted((sources.INCLUDE / sources.LIBRARY).glob("*.h")):
        text = path.read_text(encoding="utf-8")
        tags = re.findall(r"(?:CGAL::)?internal_np::(\w+)_t\b", "".join(ACCEPTED.findall(text)))
        functions = documented(text)
        if functions or tags:
            yield path.name, functions, {names.get(tag, tag) for tag in tags}


def table(functions):
    for function, defaults in functions.items():
        yield f"\n## {function}()\n\n| parameter | default |\n|---|---|\n"
        for name, default in sorted(defaults.items()):
            yield f"| `{name}` | {default} |\n"


def page():
    return INTRODUCTION + "".join(row for _, functions, _ in parameters()
                                  for row in table(functions))


def differences():
    for header, functions, accepted in parameters():
        for function, defaults in functions.items():
            for name in sorted(accepted ^ set(defaults)):
                verb = "accepts, but does not document" if name in accepted else "does not accept"
                yield f"{header}: {function}() {verb} {name}"
            for name, default in defaults.items():
                if not default:
                    yield f"{header}: {function}() has no default of {name}"


def headers_of(concept, types):
    """The comment that names the header of each type of the library that a concept speaks of."""
    text = re.sub(r"(?s)cgalHasModelsBegin.*?cgalHasModelsEnd", "", concept)
    used = sorted(set(re.findall(r"\b[A-Z]\w+", text)) & set(types))
    lines = [f"/// - `{sources.LIBRARY}::{name}`,\n///   `{types[name]}`\n" for name in used]
    return f"///\n/// {HEADERS}\n" + "".join(lines) if used else ""


def with_headers(concept, types):
    plain = re.sub(rf"///\n/// {re.escape(HEADERS)}\n(/// - .*\n///   .*\n)*", "", concept)
    block = headers_of(plain, types)
    return re.sub(r"(?m)^///\n(?=/// \\cgalHasModelsBegin)", lambda _: block + "///\n", plain, count=1)


def grouped_internals():
    for header in sources.headers():
        depth, text = 0, (sources.INCLUDE / header).read_text(encoding="utf-8")
        for number, line in enumerate(text.splitlines(), 1):
            depth += bool(re.match(r"namespace (\w+::)?internal \{", line))
            depth -= bool(re.match(r"\}  // namespace (\w+::)?internal$", line))
            if depth and "\\ingroup" in line:
                yield f"{header}:{number}: what is internal has no group"


def files():
    """(path, what it should contain) of the page and the concepts."""
    yield PAGE, page()
    types, _ = check_public_types.public_types()
    for path in sorted(CONCEPTS.glob("*.h")):
        yield path, with_headers(path.read_text(encoding="utf-8"), types)


def complaints(fix):
    if len(names()) > MOST_PARAMETERS:
        yield (f"core/named_parameters.h: {len(names())} named parameters, more than {MOST_PARAMETERS}: "
               "what is seldom set is a member of the options of its family")
    yield from differences()
    yield from grouped_internals()
    for path, content in files():
        if fix:
            path.write_text(content, encoding="utf-8")
        elif not path.exists() or path.read_text(encoding="utf-8") != content:
            yield f"{path.relative_to(sources.ROOT)} does not fit the headers: run check_reference.py --fix"


if __name__ == "__main__":
    sources.finish(list(complaints("--fix" in sys.argv[1:])), "the reference")
