"""Results that hold the FRFs of a test."""

from __future__ import annotations

import os
from typing import Any

import numpy as np

from ._arrays import Responses
from ._errors import NoHitError, UsageError
from ._frf import Frf, channel_of
from ._results import Result
from ._synthesis import require_kind


class TestResult(Result):
    """A result that holds the FRFs of a test."""

    __test__ = False  # not a test of pytest

    def __init__(self, outcome: Any, kind: str | None = None) -> None:
        super().__init__(outcome)
        self._kind = kind or "accelerance"
        self._cache: dict[Any, Any] = {}

    def _require_one_test(self) -> None:
        if self._outcome.tests > 1:
            raise UsageError(f"the result holds {self._outcome.tests} tests", "choose one, such as runs[0]")

    def _computed(self, name: str, *arguments: Any) -> Any:
        key = (name, *arguments)
        if key not in self._cache:
            self._require_one_test()
            self._cache[key] = getattr(self._outcome, name)(0, *arguments)
        return self._cache[key]

    def _calls(self) -> list[tuple[Any, ...]]:
        if self._outcome.tests > 1:
            return super()._calls()
        has_frfs = self._own().get("input") != "response" and self._outcome.possible(0)
        return [*super()._calls(), ("possible", 0), *(self._of_test(0) if has_frfs else [])]

    def _of_test(self, test: int) -> list[tuple[Any, ...]]:
        return [("frequency_hz", test), ("window_decay_per_s", test), ("signals", test), ("frfs", test, self._kind)]

    def __getstate__(self) -> dict[str, Any]:
        return {**super().__getstate__(), "_cache": {}}

    @property
    def possible(self) -> bool:
        """False if no hit can be used. Reading FRFs or modes then raises NoHitError."""
        self._require_one_test()
        return self._outcome.possible(0)

    def _require_hits(self) -> None:
        if not self.possible:
            raise NoHitError("no hit can be used, so there are no FRFs", "hits", "see the findings of the hits")

    def _own(self) -> dict[str, Any]:
        self._require_one_test()
        return self._parsed()

    def frf(self, kind: str | None = None) -> Frf:
        """The averaged FRFs over the band.

        Parameters
        ----------
        kind : {'accelerance', 'mobility', 'receptance'}, optional
            Default: accelerance, or the kind of the result of `percuss.frf`.

        Returns
        -------
        Frf
            Views of the result's arrays. `std` and `coherence` are None if a point has a single hit.

        Raises
        ------
        NoHitError
            No hit can be used.
        InputError
            A test without a force.
        UsageError
            An unknown kind.
        """
        self._require_hits()
        kind = kind or self._kind
        require_kind(kind)
        if ("frf", kind) not in self._cache:
            responses = Responses(self._computed("frfs", kind))
            signals = self._computed("signals")
            channels = [channel_of(signals[channel]) for channel in responses.channels]
            frequency_hz, decay = self._computed("frequency_hz"), self._computed("window_decay_per_s")
            self._cache["frf", kind] = Frf._of_responses(frequency_hz, responses, kind, channels, decay, self._source)
        return self._cache["frf", kind]

    @property
    def _source(self) -> str:
        inputs = self._own().get("inputs") or self._parsed().get("inputs") or [{}]
        return inputs[0].get("path", "arrays")

    @property
    def points(self) -> np.ndarray:
        """(points,) numbers of the points that have FRFs."""
        return self.frf().points

    @property
    def coherence(self) -> np.ndarray | None:
        """(points, channels, lines) ordinary coherence, 0 … 1; None if a point has a single hit."""
        return self.frf().coherence

    def _write(self, path: str | os.PathLike[str], force: bool, page: list[tuple[str, bytes]]) -> None:
        shows_hits = os.path.splitext(os.fspath(path))[1].lower() in (".json", ".html", ".svg")
        if not shows_hits:
            self._require_hits()
        super()._write(path, force, page)


class AveragedFrf(TestResult):
    """Averaged frequency responses of a test.

    Attributes
    ----------
    frequency_hz : array (lines,)
        Hz.
    H : array (points, channels, lines)
        Complex accelerance in (m/s²)/N; with kind, mobility in (m/s)/N or receptance in m/N.
    std : array (points, channels, lines) or None
        Standard deviation in the unit of H; None if a point has a single hit.
    coherence : array (points, channels, lines) or None
        0 … 1.

    Notes
    -----
    `frf()` returns the arrays as a Frf. `save` writes the chosen kind as .csv, .h5 (.hdf5), .mat or .uff. Reading an array
    raises NoHitError if no hit can be used.
    """

    @property
    def frequency_hz(self) -> np.ndarray:
        """(lines,) frequencies of the FRFs in Hz."""
        return self.frf().frequency_hz

    @property
    def H(self) -> np.ndarray:
        """(points, channels, lines) complex accelerance in (m/s²)/N; with kind, mobility in (m/s)/N or receptance in m/N."""
        return self.frf().H

    @property
    def std(self) -> np.ndarray | None:
        """(points, channels, lines) standard deviation in the unit of H; None if a point has a single hit."""
        return self.frf().std

    def at(self, point: int = 0, channel: int = 0) -> np.ndarray:
        """(lines,) complex: a read-only view of one response, without a copy. Raises KeyError if there is none."""
        return self.frf().at(point, channel)

    def plot(self, point: int | None = None, channel: int | None = None, ax: Any = None) -> Any:
        """Draw magnitude and phase, of all responses or of one point and channel. Needs matplotlib. Returns the two axes."""
        return self.frf().plot(point, channel, ax)

    def to_dataframe(self) -> Any:
        """A pandas.DataFrame: a row per line, a complex column per point and channel. Needs pandas."""
        return self.frf().to_dataframe()
