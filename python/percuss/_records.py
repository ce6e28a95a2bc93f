"""Records of force and acceleration, as Python sees them."""

from __future__ import annotations

import copy
from typing import Any, Sequence

import numpy as np

from . import _percuss
from ._arrays import geometry_of, names_of, points_of, rate_of, rows_of
from ._words import in_python_terms


class Record:
    """A hammer test: one force and any number of accelerations, hit by hit.

    Record(force, accel, fs=25600.0) takes arrays as they are, without a copy:

    force   (samples,) one hit, or a long record in which hits are searched; (hits, samples) one hit per row;
            or a list of hits of different lengths; None where only accelerations were recorded. In N.
    accel   (samples,) or (channels, samples) beside one force; (hits, samples) or (hits, channels, samples) beside
            several; or a list like force's. In m/s². Other units: unit= and force_unit= of analyze and the others.
    fs      Hz; also an array of one number.
    points  (hits,) which point was struck, from 0; all at point 0 unless given.
    names   of the force and of each acceleration; "force", "accel 1" ... unless given.
    geometry  (points, 3) in m, or (points, 2): position along a tube in m and angle around it in degrees; a row for
            each point from 0 up, or, where one point was struck, for each acceleration.
    continuous  every row may hold several hits.

    Numbers may be float64, float32 or integers, in any strides. The arrays are read when a result is computed, perhaps
    in other threads, so leave them alone until then: what is computed from numbers that change is anybody's guess.
    Records of arrays are pickled with their samples; of those that were read, give the path to other processes.
    Raises InputError for arrays that fit no test; for NaN and infinity when they are read.

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
        try:
            self._handle = _percuss.RecordHandle(*self._given)
        except _percuss.InputError as error:
            raise in_python_terms(error) from None
        self._description = self._handle.describe()

    @classmethod
    def _of(cls, handle: Any) -> Record:
        made = cls.__new__(cls)
        made._given = None
        made._handle = handle
        made._description = handle.describe()
        return made

    @classmethod
    def _again(cls, *given: Any) -> Record:
        made = cls._of(_percuss.RecordHandle(*given))
        made._given = given
        return made

    def __reduce__(self) -> Any:
        if self._given is None:
            raise TypeError(f"a record read from {self.source} is not copied to other processes; give them its path, or arrays")
        return type(self)._again, self._given

    def __copy__(self) -> Record:
        return self  # nothing of it changes

    def __deepcopy__(self, memo: Any) -> Record:
        return self if self._given is None else type(self)._again(*copy.deepcopy(self._given, memo))

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
        """What it was read from: "HDF5", "CSV" ...; "arrays"."""
        return self._description["format"]

    @property
    def source(self) -> str:
        """The file it was read from; the format where there is none."""
        return self._description["source"]

    @property
    def rows(self) -> int:
        """How many rows: hits, or long records in which hits are searched."""
        return len(self._description["rows"])

    @property
    def channels(self) -> int:
        """How many accelerations."""
        return len(self._description["accel"])

    @property
    def samples(self) -> np.ndarray:
        """(rows,) how many samples each row has."""
        return np.array([row[0] for row in self._description["rows"]])

    @property
    def points(self) -> np.ndarray:
        """(rows,) which point was struck."""
        return np.array([row[1] for row in self._description["rows"]])

    @property
    def signals(self) -> list[dict[str, Any]]:
        """The force, unless there is none, and each acceleration: name, unit, to_si, angle_rad, position_m."""
        force = self._description["force"]
        return ([] if force is None else [force]) + self._description["accel"]

    @property
    def geometry(self) -> np.ndarray | None:
        """(points, 3) or (points, 2), as the file has it."""
        places = self._description["geometry"]
        return np.array(places) if places else None

    @property
    def notes(self) -> list[str]:
        """What was assumed, or could not be read."""
        return self._description["notes"]

    def force(self, row: int = 0) -> np.ndarray:
        """(samples,) the force of a row in N: where it lies, if it lies in memory, else read from the file now."""
        return self._handle.force(_index(row, self.rows, "row"))

    def accel(self, row: int = 0, channel: int = 0) -> np.ndarray:
        """(samples,) an acceleration of a row in m/s², as force()."""
        return self._handle.accel(_index(row, self.rows, "row"), _index(channel, self.channels, "channel"))

    @property
    def force_n(self) -> np.ndarray:
        """(rows, samples) the whole force in N, as a new array. InputError where rows differ in length."""
        return np.stack([self.force(row) for row in range(self._same_length())])

    @property
    def accel_mps2(self) -> np.ndarray:
        """(rows, channels, samples) all accelerations in m/s², as a new array. InputError as force_n."""
        return np.stack([[self.accel(row, c) for c in range(self.channels)] for row in range(self._same_length())])

    def _same_length(self) -> int:
        if len(set(self.samples.tolist())) != 1:
            raise _percuss.InputError(f"rows of different lengths ({self.source}); take them one by one: force(row)")
        return self.rows

    def __repr__(self) -> str:
        lengths = sorted(set(self.samples.tolist()))
        long = f"{lengths[0]}" if len(lengths) == 1 else f"{lengths[0]} to {lengths[-1]}"
        return f"<percuss.Record {self.source}: {self.rows} × {long} samples at {self.fs_hz:g} Hz, {self.channels} channels>"


def _index(value: int, count: int, name: str) -> int:
    at = value + count if value < 0 else value
    if not 0 <= at < count:
        raise IndexError(f"{name} {value} of {count}")
    return at
