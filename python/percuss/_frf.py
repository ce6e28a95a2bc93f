"""Averaged frequency responses, the base of an analysis."""

from __future__ import annotations

import os
from typing import Any

import numpy as np

from ._arrays import Responses
from ._errors import NoHitError, UsageError
from ._results import Result


class Frf(Result):
    """Averaged frequency responses.

    frequency_hz    (lines,) Hz
    frf             (points, channels, lines) complex: accelerance in (m/s²)/N; with kind=, mobility in (m/s)/N or
                    receptance in m/N
    std             (points, channels, lines) standard deviation in the unit of frf; None if a point has a single hit
    coherence       (points, channels, lines), 0 … 1; None if a point has a single hit

    frf_at() returns one response without a copy. save() writes the chosen kind as .csv, .h5 (.hdf5), .mat or .uff. Reading an
    array raises NoHitError if no hit can be used.
    """

    def __init__(self, outcome: Any, test: int | None = None, kind: str = "accelerance") -> None:
        super().__init__(outcome)
        self._chosen = test
        self._kind = kind
        self._cache: dict[str, Any] = {}

    @property
    def _test(self) -> int:
        if self._chosen is None and self._outcome.tests > 1:
            raise UsageError(f"the result holds {self._outcome.tests} tests", "choose one, such as runs[0]")
        return self._chosen or 0

    def _computed(self, name: str) -> Any:
        if name not in self._cache:
            self._cache[name] = getattr(self._outcome, name)(self._test)
        return self._cache[name]

    def _calls(self) -> list[tuple[Any, ...]]:
        tests = range(self._outcome.tests) if self._chosen is None else [self._chosen]
        possible = [test for test in tests if self._outcome.possible(test)]
        mine = [call for test in possible for call in self._of_test(test)]
        return [*super()._calls(), *(("possible", test) for test in tests), *mine]

    def _of_test(self, test: int) -> list[tuple[Any, ...]]:
        return [("frequency_hz", test), ("frfs", test, self._kind)]

    def __getstate__(self) -> dict[str, Any]:
        return {**super().__getstate__(), "_cache": {}}

    @property
    def possible(self) -> bool:
        """False if no hit can be used. Reading FRFs or modes then raises NoHitError."""
        return self._outcome.possible(self._test)

    def _require_hits(self) -> None:
        if not self.possible:
            raise NoHitError("no hit can be used, so there are no FRFs", "hits", "see the findings of the hits")

    @property
    def _responses(self) -> Responses:
        self._require_hits()
        if "responses" not in self._cache:
            self._cache["responses"] = Responses(self._outcome.frfs(self._test, self._kind))
        return self._cache["responses"]

    @property
    def frequency_hz(self) -> np.ndarray:
        """(lines,) frequencies of the FRFs in Hz."""
        self._require_hits()
        return self._computed("frequency_hz")

    @property
    def points(self) -> np.ndarray:
        """(points,) indices of the points that have FRFs."""
        return self._responses.points

    @property
    def frf(self) -> np.ndarray:
        """(points, channels, lines) complex accelerance in (m/s²)/N; with kind=, mobility in (m/s)/N or receptance in m/N."""
        return self._responses.frf

    @property
    def std(self) -> np.ndarray | None:
        """(points, channels, lines) standard deviation in the unit of frf; None if a point has a single hit."""
        return self._responses.std

    @property
    def coherence(self) -> np.ndarray | None:
        """(points, channels, lines) ordinary coherence, 0 … 1; None if a point has a single hit."""
        return self._responses.coherence

    def frf_at(self, point: int = 0, channel: int = 0) -> np.ndarray:
        """(lines,) complex, in the unit of frf: a read-only view of one response, without a copy. `point` is the index of the
        point. Raises KeyError if the point or channel has no FRF."""
        return self._responses.at(point, channel)

    def save(self, path: str | os.PathLike[str], force: bool = False) -> None:
        shows_hits = os.path.splitext(os.fspath(path))[1].lower() in (".json", ".html", ".svg")
        if not shows_hits:
            self._require_hits()
        super().save(path, force)

    save.__doc__ = Result.save.__doc__
