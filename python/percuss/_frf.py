"""Averaged frequency responses, which an analysis is made of."""

from __future__ import annotations

import os
from typing import Any

import numpy as np

from . import _percuss
from ._arrays import Responses
from ._results import Result


class Frf(Result):
    """Averaged frequency responses.

    frequency_hz (lines,) in Hz; frf (points, channels, lines), complex: accelerance in (m/s²)/N unless kind says
    mobility, (m/s)/N, or receptance, m/N; std and coherence likewise, None where a point has one hit
    only; frf_at() shows one response without a copy. save() writes .csv, .h5, .mat, .uff, of the kind that was asked for.
    """

    def __init__(self, outcome: Any, test: int | None = None, kind: str = "accelerance") -> None:
        super().__init__(outcome)
        self._asked = test
        self._kind = kind
        self._kept: dict[str, Any] = {}

    @property
    def _test(self) -> int:
        if self._asked is None and self._outcome.tests > 1:
            raise _percuss.UsageError(f"this is {self._outcome.tests} tests; take one of them, as runs[0]")
        return self._asked or 0

    def _computed(self, name: str) -> Any:
        if name not in self._kept:
            self._kept[name] = getattr(self._outcome, name)(self._test)
        return self._kept[name]

    def _calls(self) -> list[tuple[Any, ...]]:
        tests = range(self._outcome.tests) if self._asked is None else [self._asked]
        possible = [test for test in tests if self._outcome.possible(test)]
        mine = [call for test in possible for call in self._of_test(test)]
        return [*super()._calls(), *(("possible", test) for test in tests), *mine]

    def _of_test(self, test: int) -> list[tuple[Any, ...]]:
        return [("frequency_hz", test), ("frfs", test, self._kind)]

    def __getstate__(self) -> dict[str, Any]:
        return {**super().__getstate__(), "_kept": {}}

    @property
    def possible(self) -> bool:
        """False where no hit can be used: there are no FRFs and no modes then, and reading them raises NoHitError."""
        return self._outcome.possible(self._test)

    def _require_hits(self) -> None:
        if not self.possible:
            raise _percuss.NoHitError("no hit can be used, so there are no FRFs (hits); see the hits' findings")

    @property
    def _responses(self) -> Responses:
        self._require_hits()
        if "responses" not in self._kept:
            self._kept["responses"] = Responses(self._outcome.frfs(self._test, self._kind))
        return self._kept["responses"]

    @property
    def frequency_hz(self) -> np.ndarray:
        """(lines,) frequencies of the FRFs, Hz."""
        self._require_hits()
        return self._computed("frequency_hz")

    @property
    def points(self) -> np.ndarray:
        """(points,) numbers of the points that have FRFs."""
        return self._responses.points

    @property
    def frf(self) -> np.ndarray:
        """(points, channels, lines) complex; accelerance in (m/s²)/N unless another kind was asked for."""
        return self._responses.frf

    @property
    def std(self) -> np.ndarray | None:
        """(points, channels, lines) standard deviation of the FRFs, (m/s²)/N; None where a point has one hit."""
        return self._responses.std

    @property
    def coherence(self) -> np.ndarray | None:
        """(points, channels, lines) ordinary coherence, 0 … 1; None where a point has one hit."""
        return self._responses.coherence

    def frf_at(self, point: int = 0, channel: int = 0) -> np.ndarray:
        """(lines,) complex, (m/s²)/N: one response where it lies, without a copy; `point` is its number."""
        return self._responses.at(point, channel)

    def save(self, path: str | os.PathLike[str], force: bool = False) -> None:
        shows_hits = os.path.splitext(os.fspath(path))[1].lower() in (".json", ".html", ".svg")
        if not shows_hits:
            self._require_hits()
        super().save(path, force)

    save.__doc__ = Result.save.__doc__
