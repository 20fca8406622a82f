#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Gives every page of the built manual a field that searches it without a server: writes an index of titles,
headings, symbols, parameters and text to search_index.js, copies search.js, and names both in the pages.

usage: make_index.py FOLDER   (of the HTML pages)
"""

import collections
import html.parser
import json
import pathlib
import re
import shutil
import sys
import unicodedata

HERE = pathlib.Path(__file__).resolve().parent
SCRIPT = '<script src="search.js" defer="defer"></script>\n'
# Lists of what is elsewhere, and listings.
LEFT_OUT = re.compile(r"(_source|-members|_8(h|md|txt|cpp))\.html$|^(dir_|files|globals|functions|namespace|annotated|"
                      r"hierarchy|classes|modules|pages|examples|citelist|inherit)")
PAGE, SECTION, SYMBOL, PARAMETER = range(4)
WORD = re.compile(r"[a-z0-9_]+(?:[-.:/+][a-z0-9_]+)*")
MOST = 9  # repetitions that count


def tokens(text):
    """Words without accents, and the parts of those that have parts: scale_bound has scale and bound."""
    plain = unicodedata.normalize("NFD", text).translate(dict.fromkeys(range(0x300, 0x370)))
    for word in WORD.findall(plain.lower()):
        yield word
        parts = [part for part in re.split(r"[^a-z0-9]+", word) if len(part) > 1]
        yield from parts if len(parts) > 1 else ()


class Page(html.parser.HTMLParser):
    """The entries of a page: [kind, title, anchor, words]."""

    def __init__(self, text):
        super().__init__()
        self.title, self.entries = "", [[PAGE, "", "", []]]
        self.inside, self.skipped, self.heading, self.anchor = False, 0, None, ""
        self.feed(text)
        self.entries[0][1] = self.title

    def handle_starttag(self, tag, attrs):
        attributes = dict(attrs)
        kind = attributes.get("class") or ""
        self.inside |= tag == "div" and kind == "contents"
        if self.skipped or (tag == "table" and "memberdecls" in kind):
            self.skipped += tag == "table"
        elif tag == "div" and kind == "title":
            self.heading = ("title", [])
        elif self.inside and tag in ("h1", "h2", "h3") and kind != "groupheader":
            self.heading = ("symbol" if kind == "memtitle" else "section", [])
            self.anchor = attributes.get("id", "")
        elif self.inside and kind == "paramname" and tag == "td":
            self.heading = ("parameter", [])
        elif self.heading and tag == "a":
            self.anchor = attributes.get("id") or attributes.get("href", "").partition("#")[2] or self.anchor

    def handle_endtag(self, tag):
        if self.skipped:
            self.skipped -= tag == "table"
        elif self.heading and tag in ("div", "h1", "h2", "h3", "td"):
            kind, words = self.heading
            self.heading = None
            self.end_heading(kind, " ".join("".join(words).replace("◆", "").split()))

    def end_heading(self, kind, title):
        if kind == "title":  # of a class: its name alone
            self.title = re.sub(r"^(.*::)?(\S+?)(< .* >)? (Struct|Class)( Template)? Reference.*", r"\2", title)
        elif kind == "parameter":
            owner = next((entry for entry in reversed(self.entries) if entry[0] == SYMBOL), None)
            if owner and re.fullmatch(r"\w+", title):
                self.entries.append([PARAMETER, f"{title}, a parameter of {owner[1]}", owner[2], []])
        elif title:
            self.entries.append([SYMBOL if kind == "symbol" else SECTION, title, self.anchor, []])

    def handle_data(self, data):
        if self.heading:
            self.heading[1].append(data)
        elif self.inside and not self.skipped:
            self.entries[-1][3].append(data)


def name_words(kind, title):
    """What the title of an entry is found by: a parameter by its own name."""
    return title.partition(",")[0] if kind == PARAMETER else title


def index_of(folder):
    entries, titles, texts = [], collections.defaultdict(set), collections.defaultdict(dict)
    for path in sorted(folder.glob("*.html")):
        if LEFT_OUT.search(path.name):
            continue
        page = Page(path.read_text(encoding="utf-8"))
        for kind, title, anchor, words in page.entries:
            number, text = len(entries), " ".join(" ".join(words).split())
            entries.append([kind, title, path.name + (f"#{anchor}" if anchor else ""), page.title, text[:140],
                            len(text.split())])
            for token in tokens(name_words(kind, title)):
                titles[token].add(number)
            for token, count in collections.Counter(tokens(text)).items():
                texts[token][number] = min(count, MOST)
    return {"entries": entries, "titles": {token: sorted(found) for token, found in titles.items()},
            "texts": {token: [x for pair in found.items() for x in pair] for token, found in texts.items()}}


def main():
    folder = pathlib.Path(sys.argv[1])
    content = json.dumps(index_of(folder), ensure_ascii=False, separators=(",", ":"))
    (folder / "search_index.js").write_text(f"window.searchIndex = {content};\n", encoding="utf-8")
    shutil.copy(HERE / "search.js", folder)
    for path in folder.glob("*.html"):
        text = path.read_text(encoding="utf-8")
        if SCRIPT not in text:
            path.write_text(text.replace("</head>", SCRIPT + "</head>", 1), encoding="utf-8")


if __name__ == "__main__":
    main()
