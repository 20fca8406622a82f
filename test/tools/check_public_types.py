#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""At most 70 types are public: classes and enumerations directly in the library's namespace. Each of
them, and each alias there, is named in the README, the overview, the manual or on the page of a concept. All
others are in its namespace `internal`, or members of a class.
"""

import re

import sources

MOST = 70
PAGES = ("README.md", "doc/overview.md", "doc/named_parameters.txt", "doc/manual/*.txt", "doc/Concepts/*.h")
COMMENT_OR_STRING = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:[^"\\\n]|\\.)*"', re.DOTALL)
DIRECTIVE = re.compile(r"^[ \t]*#(?:[^\n\\]|\\.|\\\n)*", re.MULTILINE)
# an opening or closing brace, or the head of a type that is defined
TOKEN = re.compile(r"namespace(?P<space>\s+[\w:]+)?\s*\{|[{}]"
                   r"|\b(?:class|struct|union|enum)\s+(?:\[\[\w+\]\]\s*)?(?P<type>[A-Z]\w*)"
                   r"\s*(?P<arguments><[^;{}()]*>)?\s*(?:final\s*)?(?=\{|:[^:])"
                   r"|\busing\s+(?P<alias>[A-Z]\w*)\s*=")


def code(header):
    text = (sources.INCLUDE / header).read_text(encoding="utf-8")
    return DIRECTIVE.sub("", COMMENT_OR_STRING.sub("", text))


def public_types():
    """The header of each type or alias, by its name, and the names of the aliases; specializations
    do not count."""
    found, aliases = {}, set()
    for header in sources.headers():
        scopes = []
        for token in TOKEN.finditer(code(header)):
            name = token["type"] or token["alias"]
            if name:
                if scopes == [sources.LIBRARY] and not token["arguments"]:
                    found.setdefault(name, header)
                    if token["alias"]:
                        aliases.add(name)
            elif token[0] == "}":
                scopes.pop()
            else:
                scopes.append((token["space"] or token[0]).strip())
    return found, aliases


def complaints(types, aliases):
    if len(types) - len(aliases) > MOST:
        yield f"{len(types) - len(aliases)} public types, more than {MOST}; move some into namespace internal"
    pages = (page for pattern in PAGES for page in sources.ROOT.glob(pattern))
    words = {word for page in pages
             for word in re.findall(r"\w+", page.read_text(encoding="utf-8"))}
    for name, header in sorted(types.items(), key=lambda pair: (pair[1], pair[0])):
        if name not in words:
            yield f"{header}: {name} is public, but on no page of the manual"


if __name__ == "__main__":
    public, also = public_types()
    sources.finish(list(complaints(public, also)),
                   f"{len(public) - len(also)} public types and {len(also)} aliases")
