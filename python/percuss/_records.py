"""Records of force and acceleration."""

from __future__ import annotations

import copy
from typing import Any, Sequence

import numpy as np

from . import _percuss
from ._arrays import geometry_of, names_of, points_of, rate_of, rows_of
from ._errors import InputError, note_in_python


class Record:
    """A hammer test: the force and any number of accelerations of each hit.

    Record(force, accel, fs=25600.0) uses arrays without a copy:

    force       N. (samples,): one hit, or a long record that is searched for hits; (hits, samples): one hit per row; a
                list of hits of different lengths; None if only accelerations were recorded.
    accel       m/s². (samples,) or (channels, samples) for one force; (hits, samples) or (hits, channels, samples) for
                several; a list if the force is a list. For other units, pass unit= and force_unit= to analyze().
    fs          Hz; also an array of one number.
    points      (hits,): index of the struck point, from 0; 0 for all hits unless given.
    names       names of the force and of each acceleration; "force", "accel 1" ... unless given.
    geometry    (points, 3) in m, or (points, 2): position along a tube in m and angle around it in degrees. One row per
                point from 0 up; if all hits are at point 0, one row, or one per acceleration.
    continuous  whether each row may hold several hits.

    The numbers may be float64, float32 or integers, with any strides. A result reads the arrays when it is computed,
    possibly in other threads: do not change them before that. Records of arrays are pickled with their samples. A
    record that was read from a file is pickled as its path and options, and read again. Raises InputError for arrays
    that do not form a test, and for NaN and infinity when the samples are read.

    >>> import numpy as np, percuss
    >>> record = percuss.Record(np.zeros(256), np.zeros((2, 256)), fs=4096.0)
    >>> record.rows, record.channels, record.fs_hz
    (1, 2, 4096.0)
    """

    def __init__(
        self,
        force: Any,
        accel: Any,
        fs: float,
        *,
        points: Sequence[int] | None = None,
        names: Sequence[str] = (),
        geometry: Any = None,
        continuous: bool = False,
    ) -> None:
        rate = rate_of(fs)
        rows = rows_of(force, accel)
        has_force, channels = rows[0][0] is not None, len(rows[0][1])
        struck = points_of(points, len(rows))
        texts = names_of(names, channels + has_force, has_force)
        places = geometry_of(geometry, struck, channels)
        self._given: tuple[Any, ...] | None = (rows, struck, rate, bool(continuous), texts, places)
        self._again: tuple[Any, tuple[Any, ...]] | None = None
        self._handle = _percuss.RecordHandle(*self._given)
        self._description = self._handle.describe()

    @classmethod
    def _from_handle(cls, handle: Any, again: tuple[Any, tuple[Any, ...]] | None) -> Record:
        """`again` is the function, with its arguments, from which pickle makes the record again; None for a record of arrays."""
        made = cls.__new__(cls)
        made._given = None
        made._again = again
        made._handle = handle
        made._description = handle.describe()
        return made

    @classmethod
    def _from_arrays(cls, *given: Any) -> Record:
        made = cls._from_handle(_percuss.RecordHandle(*given), None)
        made._given = given
        return made

    def __reduce__(self) -> Any:
        return (type(self)._from_arrays, self._given) if self._again is None else self._again

    def __copy__(self) -> Record:
        return self  # immutable

    def __deepcopy__(self, memo: Any) -> Record:
        return self if self._given is None else type(self)._from_arrays(*copy.deepcopy(self._given, memo))

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        near = {"fs": "fs_hz"}.get(name) or _percuss.nearest(name, [one for one in dir(type(self)) if not one.startswith("_")])
        raise AttributeError(f"Record has no attribute {name!r}" + (f"; did you mean {near!r}?" if near else ""))

    @property
    def fs_hz(self) -> float:
        """Sampling rate in Hz."""
        return self._description["fs_hz"]

    @property
    def format(self) -> str:
        """Format of the file, "HDF5", "CSV" ..., or "arrays"."""
        return self._description["format"]

    @property
    def source(self) -> str:
        """Path of the file; the format if there is no file."""
        return self._description["source"]

    @property
    def rows(self) -> int:
        """Number of rows: hits, or long records that are searched for hits."""
        return len(self._description["rows"])

    @property
    def channels(self) -> int:
        """Number of accelerations."""
        return len(self._description["accel"])

    @property
    def samples(self) -> np.ndarray:
        """(rows,) number of samples of each row."""
        return np.array([row[0] for row in self._description["rows"]])

    @property
    def points(self) -> np.ndarray:
        """(rows,) index of the struck point."""
        return np.array([row[1] for row in self._description["rows"]])

    @property
    def signals(self) -> list[dict[str, Any]]:
        """The force, if recorded, and each acceleration: name, unit, to_si, angle_rad, position_m."""
        force = self._description["force"]
        return ([] if force is None else [force]) + self._description["accel"]

    @property
    def geometry(self) -> np.ndarray | None:
        """(points, 3) or (points, 2), as stored in the file, or None."""
        places = self._description["geometry"]
        return np.array(places) if places else None

    @property
    def notes(self) -> list[str]:
        """Assumptions of the reader, and parts of the file that it could not read."""
        return [note_in_python(note) for note in self._description["notes"]]

    def force(self, row: int = 0) -> np.ndarray:
        """(samples,) force of a row in N: a view of samples in memory, or a new array read from the file. Raises IndexError for a
        row that does not exist, and InputError for samples that cannot be read."""
        return self._handle.force(_index(row, self.rows, "row"))

    def accel(self, row: int = 0, channel: int = 0) -> np.ndarray:
        """(samples,) acceleration of a row and channel in m/s²: a view or a new array, and errors, as for force()."""
        return self._handle.accel(_index(row, self.rows, "row"), _index(channel, self.channels, "channel"))

    @property
    def force_n(self) -> np.ndarray:
        """(rows, samples) force of all rows in N, as a new array. Raises InputError if rows differ in length."""
        return np.stack([self.force(row) for row in range(self._same_length())])

    @property
    def accel_mps2(self) -> np.ndarray:
        """(rows, channels, samples) all accelerations in m/s², as a new array. Raises InputError as force_n."""
        return np.stack([[self.accel(row, c) for c in range(self.channels)] for row in range(self._same_length())])

    def _same_length(self) -> int:
        if len(set(self.samples.tolist())) != 1:
            raise InputError("rows of different lengths", self.source, "read them one by one: force(row)")
        return self.rows

    def __repr__(self) -> str:
        lengths = sorted(set(self.samples.tolist()))
        long = f"{lengths[0]}" if len(lengths) == 1 else f"{lengths[0]} to {lengths[-1]}"
        return f"<percuss.Record {self.source}: {self.rows} × {long} samples at {self.fs_hz:g} Hz, {self.channels} channels>"


def _index(value: int, count: int, name: str) -> int:
    at = value + count if value < 0 else value
    if not 0 <= at < count:
        raise IndexError(f"there is no {name} {value}: the record has {count}, from 0")
    return at
