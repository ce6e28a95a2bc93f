"""Frequency responses as arrays."""

from __future__ import annotations

from typing import Any, Optional, Sequence, Tuple

import numpy as np

from . import _percuss
from ._arrays import Responses, frozen, points_of
from ._errors import InputError, note_in_python
from ._frf_arrays import averages_given, channel_names_given, coherence_given, frequencies_given, responses_given, std_given, window_decay_given
from ._optional import frf_frame, frf_html
from ._plots import plot_frf
from ._synthesis import KINDS, require_kind

_UNITS = dict(zip(KINDS, ("(m/s²)/N", "(m/s)/N", "m/N")))


Channel = Tuple[str, Optional[float], Optional[float]]  # name, angle in rad and position in m, or None


def channel_of(signal: dict[str, Any]) -> Channel:
    return signal["name"], signal["angle_rad"], signal["position_m"]


class Frf:
    """Frequency responses. `analyze`, `survey` and `write` take them in place of a record.

    Parameters
    ----------
    frequency_hz : array (lines,)
        Evenly spaced frequencies in Hz, multiples of their spacing.
    H : array (lines,), (channels, lines) or (points, channels, lines)
        Complex responses over force, in SI units.
    kind : {'accelerance', 'mobility', 'receptance'}, optional
        Response: acceleration, velocity or displacement.
    std, coherence : array, optional
        Standard deviation of the complex number in the unit of H, and ordinary coherence, in the shape of H. Without std, the
        standard deviation follows from coherence and averages: |H| √((1 − γ²)/(γ² (n − 1))). The ± of modes include it
        where it exceeds the residual of the fit; the weights of the fit come from the residual. What the averaged hits
        share (gain, place, direction) is part of the ± of residues alone. Frequencies that differ between the hits are part
        of the ± of frequencies, where the standard deviations show it.
    points : sequence of int, optional
        Number of each struck point. Default: from 0 up. The points are sorted by their numbers.
    names : sequence of str, optional
        Name of each channel.
    averages : int, optional
        Hits behind each response; 0 if not known.
    exponential : float, optional
        Fraction that an exponential window over force and response had fallen to at the end of each record, as in
        `analyze`. The record is taken to last 1/(spacing of the frequencies). Damping is corrected for it.

    Raises
    ------
    InputError
        Shapes that do not agree; responses that are real, without a phase; frequencies that do not rise, are uneven or
        negative; coherences outside 0 … 1, negative standard deviations, values that are masked or not finite; a point
        given twice.
    UsageError
        An unknown kind.
    TypeError
        Values that are not numbers.

    Notes
    -----
    FRFs without `exponential` are taken to come from records that hold the whole decay. If the record had an
    exponential window that is not stated, its damping is part of the damping ratios. With `exponential`, H lies at
    s = jω + σ, and mobility and receptance are accelerance/s and accelerance/s².

    Examples
    --------
    >>> import numpy as np, percuss
    >>> f = np.arange(1, 401.0)
    >>> s = 2j * np.pi * f
    >>> H = s**2 / (s**2 + 2 * 0.01 * 2 * np.pi * 150 * s + (2 * np.pi * 150) ** 2)
    >>> frf = percuss.Frf(f, H)
    >>> frf
    <percuss.Frf arrays: 1 × 1 accelerance of 400 lines, 1 to 400 Hz>
    >>> found = percuss.analyze(frf, band=(60, 300))
    >>> found.frequency_hz.round(6).tolist(), found.damping_ratio.round(6).tolist()
    ([150.0], [0.01])
    """

    def __init__(
        self,
        frequency_hz: Any,
        H: Any,
        *,
        kind: str = "accelerance",
        std: Any = None,
        coherence: Any = None,
        points: Sequence[int] | None = None,
        names: Sequence[str] = (),
        averages: int = 0,
        exponential: float | None = None,
    ) -> None:
        freq_hz = frequencies_given(frequency_hz)
        require_kind(kind)
        value = responses_given(H, "H", complex, len(freq_hz))
        numbers = points_of(points, len(value), "points of H") or list(range(len(value)))
        if len(set(numbers)) != len(numbers):
            raise InputError("a point number is given twice", "points", "give each point once")
        self._set(
            freq_hz, kind, numbers, [(name, None, None) for name in channel_names_given(names, value.shape[1])],
            averages_given(averages), window_decay_given(exponential, freq_hz), "arrays",
            value, std_given(std, value.shape), coherence_given(coherence, value.shape),
        )  # fmt: skip
        self._handle  # checks the frequencies

    def _set(
        self, freq_hz: np.ndarray, kind: str, points: list[int], channels: list[Channel], averages: int, decay_per_s: float,
        source: str, value: np.ndarray, std: np.ndarray | None, coherence: np.ndarray | None,
    ) -> None:  # fmt: skip
        rows: list[tuple[Any, ...]] = [
            (point, channel, averages, *(None if one is None else one[p, channel] for one in (value, std, coherence)))
            for p, point in enumerate(points)
            for channel in range(value.shape[1])
        ]
        self._made: Any = None
        self._responses = Responses([(*row[:3], *(None if one is None else frozen(one) for one in row[3:])) for row in rows])
        self._frequency_hz = frozen(freq_hz)
        self._kind, self._channels, self._decay_per_s, self._source = kind, channels, decay_per_s, source
        self._described: dict[str, Any] = {}

    @classmethod
    def _from_handle(cls, handle: Any) -> Frf:
        described = handle.describe()
        made = cls._of_responses(
            described["frequency_hz"], Responses(handle.responses()), "accelerance",
            [channel_of(one) for one in described["accel"]], described["decay_per_s"], described["source"],
        )  # fmt: skip
        made._made, made._described = handle, described
        return made

    @classmethod
    def _of_responses(
        cls, freq_hz: np.ndarray, responses: Responses, kind: str, channels: list[Channel], decay_per_s: float, source: str
    ) -> Frf:
        made = cls.__new__(cls)
        made._made, made._described, made._responses, made._frequency_hz = None, {}, responses, freq_hz
        made._kind, made._channels, made._decay_per_s, made._source = kind, channels, decay_per_s, source
        return made

    @property
    def _handle(self) -> Any:
        if self._made is None:
            value, std, coherence = (None if one is None else np.ascontiguousarray(one) for one in (self.H, self.std, self.coherence))
            assert value is not None
            averages = self._responses.min_averages
            self._made = _percuss.FrfHandle(
                np.ascontiguousarray(self._frequency_hz), value, std, coherence, self._kind, self.points.tolist(), self._channels,
                averages, self._decay_per_s,
            )  # fmt: skip
        return self._made

    @property
    def frequency_hz(self) -> np.ndarray:
        """(lines,) frequencies in Hz."""
        return self._frequency_hz

    @property
    def H(self) -> np.ndarray:
        """(points, channels, lines) complex, in `unit`."""
        return self._responses.value

    @property
    def std(self) -> np.ndarray | None:
        """(points, channels, lines) standard deviation in `unit`; None if it is not known."""
        return self._responses.std

    @property
    def coherence(self) -> np.ndarray | None:
        """(points, channels, lines) ordinary coherence, 0 … 1; None if it is not known."""
        return self._responses.coherence

    @property
    def points(self) -> np.ndarray:
        """(points,) number of each point."""
        return self._responses.points

    @property
    def names(self) -> list[str]:
        """Name of each channel."""
        return [name for name, _, _ in self._channels]

    @property
    def kind(self) -> str:
        """'accelerance', 'mobility' or 'receptance'. FRFs of a file are converted to accelerances."""
        return self._kind

    @property
    def unit(self) -> str:
        """Unit of H."""
        return _UNITS[self._kind]

    @property
    def source(self) -> str:
        """Path of the file, or "arrays"."""
        return self._source

    @property
    def format(self) -> str:
        """Format of the file: "FRF HDF5" …, or "arrays"."""
        return self._described.get("format", "arrays")

    @property
    def stored_kind(self) -> str:
        """Kind of the FRFs as the file stores them."""
        return self._described.get("kind", self._kind)

    @property
    def estimator(self) -> str:
        """FRF estimator as the file states it, "H1" …; "" for arrays."""
        return self._described.get("estimator", "")

    @property
    def signals(self) -> list[dict[str, Any]]:
        """The accelerations: name, unit, to_si, angle_rad, position_m."""
        return self._handle.describe()["accel"]

    @property
    def notes(self) -> list[str]:
        """Assumptions of the reader, one line each."""
        return [note_in_python(note) for note in self._described.get("notes", [])]

    def at(self, point: int = 0, channel: int = 0) -> np.ndarray:
        """(lines,) complex: a read-only view of one response, without a copy. Raises KeyError if there is none."""
        return self._responses.at(point, channel)

    def plot(self, point: int | None = None, channel: int | None = None, ax: Any = None) -> Any:
        """Draw magnitude and phase, of all responses or of one point and channel. Needs matplotlib. Returns the two axes."""
        return plot_frf(self, point, channel, ax)

    def to_dataframe(self) -> Any:
        """A pandas.DataFrame: a row per line (frequency_hz), a complex column per point and channel. Needs pandas."""
        return frf_frame(self)

    def __array__(self, dtype: Any = None, copy: Any = None) -> np.ndarray:
        return np.array(self.H, dtype=dtype) if copy or dtype is not None else self.H

    def __reduce__(self) -> Any:
        averages = self._responses.min_averages
        given = (
            np.array(self.frequency_hz), self._kind, self.points.tolist(), self._channels, averages, self._decay_per_s, self._source,
            np.array(self.H), *(None if one is None else np.array(one) for one in (self.std, self.coherence)),
        )  # fmt: skip
        return _restored, given

    def __copy__(self) -> Frf:
        return self  # immutable

    def __deepcopy__(self, memo: Any) -> Frf:
        return self

    def __repr__(self) -> str:
        points, channels, lines = self.H.shape
        low, high = self._frequency_hz[0], self._frequency_hz[-1]
        return f"<percuss.Frf {self._source}: {points} × {channels} {self._kind} of {lines} lines, {low:g} to {high:g} Hz>"

    def _repr_html_(self) -> str:
        return frf_html(self)


def _restored(*given: Any) -> Frf:
    made = Frf.__new__(Frf)
    made._set(*given)
    return made
