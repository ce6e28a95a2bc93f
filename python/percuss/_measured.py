"""FRFs that another program measured."""

from __future__ import annotations

from typing import Any

import numpy as np

from ._arrays import Responses
from ._errors import note_in_python


class MeasuredFrf:
    """FRFs that were read from a file; analyze() accepts them in place of a record.

    frequency_hz    (lines,) Hz
    frf             (points, channels, lines) complex, converted to (m/s²)/N
    std             (points, channels, lines) standard deviation in (m/s²)/N; None if the file has none
    coherence       (points, channels, lines), 0 … 1; None if the file has none

    frf_at() returns one response without a copy.
    """

    def __init__(self, handle: Any) -> None:
        self._handle = handle
        self._description = handle.describe()
        self._responses = Responses(handle.responses())

    @property
    def frequency_hz(self) -> np.ndarray:
        """(lines,) frequencies of the FRFs in Hz."""
        return self._description["frequency_hz"]

    @property
    def format(self) -> str:
        """Format of the file: "FRF HDF5" ..."""
        return self._description["format"]

    @property
    def source(self) -> str:
        """Path of the file."""
        return self._description["source"]

    @property
    def kind(self) -> str:
        """Kind of FRF that the file stores: accelerance, mobility or receptance."""
        return self._description["kind"]

    @property
    def estimator(self) -> str:
        """FRF estimator, "H1" ..."""
        return self._description["estimator"]

    @property
    def notes(self) -> list[str]:
        """Assumptions of the reader, one line each."""
        return [note_in_python(note) for note in self._description["notes"]]

    @property
    def signals(self) -> list[dict[str, Any]]:
        """The accelerations: name, unit, to_si, angle_rad, position_m."""
        return self._description["accel"]

    @property
    def points(self) -> np.ndarray:
        """(points,) indices of the points."""
        return self._responses.points

    @property
    def frf(self) -> np.ndarray:
        """(points, channels, lines) complex, (m/s²)/N."""
        return self._responses.frf

    @property
    def std(self) -> np.ndarray | None:
        """(points, channels, lines) standard deviation of the FRFs in (m/s²)/N; None if the file has none."""
        return self._responses.std

    @property
    def coherence(self) -> np.ndarray | None:
        """(points, channels, lines) ordinary coherence, 0 … 1; None if the file has none."""
        return self._responses.coherence

    def __reduce__(self) -> Any:
        raise TypeError(f"FRFs read from {self.source} are not copied to other processes; pass the path")

    def __copy__(self) -> MeasuredFrf:
        return self

    def __deepcopy__(self, memo: Any) -> MeasuredFrf:
        return self

    def frf_at(self, point: int = 0, channel: int = 0) -> np.ndarray:
        """(lines,) complex, (m/s²)/N: a read-only view of one response, without a copy. `point` is the index of the point.
        Raises KeyError if the point or channel has no FRF."""
        return self._responses.at(point, channel)

    def __repr__(self) -> str:
        return f"<percuss.MeasuredFrf {self.source}: {len(self.points)} points, {len(self.frequency_hz)} lines>"
