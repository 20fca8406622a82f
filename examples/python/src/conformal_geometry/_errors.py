# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""The exceptions of the library, with the element they are about."""

from __future__ import annotations

import re
from typing import Optional, Tuple, Union

_NAMED = re.compile(r"\b(vertex|face|edge) (\d+)(?:-(\d+))?")


class Error(Exception):
    """Base class of all errors of the library.

    Attributes
    ----------
    function : str
        the function that failed
    message : str
        what, where (the first one), how many, and what is needed
    """

    def __init__(self, function: str, message: str) -> None:
        super().__init__(function, message)
        self.function = function
        self.message = message

    def __str__(self) -> str:
        return f"{self.function}: {self.message}"

    @property
    def element(self) -> Optional[Tuple[str, Union[int, Tuple[int, int]]]]:
        """The first offending element, with its index from 0: ``("vertex", 3)``, ``("face", 7)``,
        an edge by its two vertices, ``("edge", (3, 5))``; None if the error is about none."""
        found = _NAMED.search(self.message)
        if not found:
            return None
        kind, first, second = found.groups()
        return kind, (int(first), int(second)) if second else int(first)


class Precondition_error(Error, ValueError):
    """The data violate a documented precondition; nothing was computed."""


class Solver_error(Error, RuntimeError):
    """A factorization failed, or did not fit into memory, although the preconditions hold."""
