# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""What all reports have in common: made from what the kernels return, printed, shown in notebooks."""

from __future__ import annotations

import dataclasses
import html
from typing import Any, Dict, Iterator, Optional, Tuple, Type, TypeVar, get_args, get_type_hints

T = TypeVar("T")


def build(cls: Type[T], fields: Dict[str, Any]) -> T:
    """A data class from the fields of a kernel's report, those of inner reports likewise."""
    hints = get_type_hints(cls)
    made = {}
    for name, value in fields.items():
        hint = hints.get(name)
        for inner in (hint, *get_args(hint)):  # itself, or what may be there
            if dataclasses.is_dataclass(inner) and isinstance(value, dict):
                value = build(inner, value)
        made[name] = value
    return cls(**made)


def _text(value: Any) -> str:
    return f"{value:.6g}" if isinstance(value, float) else str(value)


class Report:
    """The numbers that verify a result. True if the result is what was asked for; otherwise
    ``fault`` says why not, in words."""

    fault: Optional[str]

    def __bool__(self) -> bool:
        return self.fault is None

    def rows(self) -> Iterator[Tuple[str, str]]:
        """(name, value as text) of each number; those of inner reports have names with points."""
        def walk(report: Any, prefix: str) -> Iterator[Tuple[str, str]]:
            for field in dataclasses.fields(report):
                value = getattr(report, field.name)
                if dataclasses.is_dataclass(value):
                    yield from walk(value, f"{prefix}{field.name}.")
                elif isinstance(value, tuple):
                    yield prefix + field.name, f"{len(value)} of them"
                else:
                    yield prefix + field.name, _text(value)
        return walk(self, "")

    def __str__(self) -> str:
        return "\n".join(f"{name:36} {value}" for name, value in self.rows())

    def _repr_html_(self) -> str:
        verdict = "verified" if self else self.fault
        colour = "#1a7f37" if self else "#b42318"
        body = "".join(f"<tr><td>{html.escape(name)}</td><td>{html.escape(value)}</td></tr>"
                       for name, value in self.rows() if name != "fault")
        return (f"<details><summary>{type(self).__name__}: "
                f"<b style='color:{colour}'>{html.escape(str(verdict))}</b></summary>"
                f"<table>{body}</table></details>")


class Result:
    """Arrays with the report that verifies them. True if the result is what was asked for."""

    report: Report

    def __bool__(self) -> bool:
        return bool(self.report)

    def _repr_html_(self) -> str:
        return self.report._repr_html_()
