"""Records of force and acceleration, and measured FRFs, as Python sees them."""

from __future__ import annotations

import numbers
import os
from typing import Any, Sequence

import numpy as np

from . import _percuss

_MOST_ROWS = 1_000_000


class Record:
    """A hammer test: one force and any number of accelerations, hit by hit.

    Record(force, accel, fs=25600.0) takes arrays as they are, without a copy:

    force   (samples,) one hit, or a long record in which hits are searched; (hits, samples) one hit per row;
            or a list of hits of different lengths; None where only accelerations were recorded. In N.
    accel   (samples,) or (channels, samples) beside one force; (hits, samples) or (hits, channels, samples) beside
            several; or a list like force's. In m/s². Other units: unit= and force_unit= of analyze and the others.
    fs      Hz.
    points  (hits,) which point was struck, from 0; all at point 0 unless given.
    names   of the force and of each acceleration; "force", "accel 1" ... unless given.
    geometry  (points, 3) in m, or (points, 2): position along a tube in m and angle around it in degrees.
    continuous  every row may hold several hits.

    Numbers may be float64, float32 or integers, in any strides. The arrays are read when a result is computed, perhaps
    in other threads, so leave them alone until then: what is computed from numbers that change is anybody's guess.
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
        if isinstance(fs, bool) or not isinstance(fs, numbers.Real):
            raise TypeError(f"fs is a number in Hz, not {fs!r}")
        rows = _rows_of(force, accel)
        struck = [] if points is None else [int(one) for one in points]
        if struck and (len(struck) != len(rows) or min(struck) < 0):
            raise _percuss.InputError(f"{len(struck)} points for {len(rows)} hits (points); give one from 0 up for each hit")
        places = [] if geometry is None else np.asarray(geometry, dtype=float).tolist()
        self._handle = _percuss.RecordHandle(rows, struck, float(fs), continuous, list(names), places)
        self._told = self._handle.describe()

    @classmethod
    def _of(cls, handle: Any) -> Record:
        made = cls.__new__(cls)
        made._handle = handle
        made._told = handle.describe()
        return made

    @property
    def fs_hz(self) -> float:
        """Sampling rate in Hz."""
        return self._told["fs_hz"]

    @property
    def format(self) -> str:
        """What it was read from: "HDF5", "CSV" ...; "arrays"."""
        return self._told["format"]

    @property
    def source(self) -> str:
        """The file it was read from; the format where there is none."""
        return self._told["source"]

    @property
    def rows(self) -> int:
        """How many rows: hits, or long records in which hits are searched."""
        return len(self._told["rows"])

    @property
    def channels(self) -> int:
        """How many accelerations."""
        return len(self._told["accel"])

    @property
    def samples(self) -> np.ndarray:
        """(rows,) how many samples each row has."""
        return np.array([row[0] for row in self._told["rows"]])

    @property
    def points(self) -> np.ndarray:
        """(rows,) which point was struck."""
        return np.array([row[1] for row in self._told["rows"]])

    @property
    def signals(self) -> list[dict[str, Any]]:
        """The force, unless there is none, and each acceleration: name, unit, to_si, angle_rad, position_m."""
        force = self._told["force"]
        return ([] if force is None else [force]) + self._told["accel"]

    @property
    def geometry(self) -> np.ndarray | None:
        """(points, 3) or (points, 2), as the file has it."""
        places = self._told["geometry"]
        return np.array(places) if places else None

    @property
    def notes(self) -> list[str]:
        """What was assumed, or could not be read."""
        return self._told["notes"]

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


class MeasuredFrf:
    """FRFs that were measured elsewhere and read from a file; `analyze` takes them in place of a record.

    frequency_hz (lines,) in Hz; frf (points, channels, lines), complex, in (m/s²)/N whatever the file has; std and
    coherence (points, channels, lines), or None where the file has none. frf_at() shows one without a copy.
    """

    def __init__(self, handle: Any) -> None:
        self._handle = handle
        self._told = handle.describe()
        self._responses = Responses(handle.responses())

    @property
    def frequency_hz(self) -> np.ndarray:
        """(lines,) Hz."""
        return self._told["frequency_hz"]

    @property
    def format(self) -> str:
        """What was read: "FRF HDF5" ..."""
        return self._told["format"]

    @property
    def source(self) -> str:
        """The file."""
        return self._told["source"]

    @property
    def kind(self) -> str:
        """As the file has it: accelerance, mobility or receptance."""
        return self._told["kind"]

    @property
    def estimator(self) -> str:
        """"H1" ..."""
        return self._told["estimator"]

    @property
    def notes(self) -> list[str]:
        """What was assumed, one line each."""
        return self._told["notes"]

    @property
    def signals(self) -> list[dict[str, Any]]:
        """The accelerations: name, unit, to_si, angle_rad, position_m."""
        return self._told["accel"]

    @property
    def points(self) -> np.ndarray:
        """(points,) numbers of the points."""
        return self._responses.points

    @property
    def frf(self) -> np.ndarray:
        """(points, channels, lines) complex, (m/s²)/N."""
        return self._responses.frf

    @property
    def std(self) -> np.ndarray | None:
        """(points, channels, lines) (m/s²)/N, or None."""
        return self._responses.std

    @property
    def coherence(self) -> np.ndarray | None:
        """(points, channels, lines) 0 … 1, or None."""
        return self._responses.coherence


    def frf_at(self, point: int = 0, channel: int = 0) -> np.ndarray:
        """(lines,) complex, (m/s²)/N: one response where it lies, without a copy; `point` is its number."""
        return self._responses.at(point, channel)

    def __repr__(self) -> str:
        return f"<percuss.MeasuredFrf {self.source}: {len(self.points)} points, {len(self.frequency_hz)} lines>"


class Responses:
    """FRFs by point and channel; stacked only when asked for."""

    def __init__(self, responses: list[tuple[Any, ...]]) -> None:
        self._all = {(one[0], one[1]): one for one in responses}
        self._stacked: dict[int, np.ndarray | None] = {}

    @property
    def points(self) -> np.ndarray:
        return np.array(sorted({point for point, _ in self._all}))

    def _stack(self, part: int) -> np.ndarray | None:
        if part not in self._stacked:
            channels = sorted({channel for _, channel in self._all})
            parts = [[self._all[point, channel][part] for channel in channels] for point in self.points.tolist()]
            whole = all(one is not None for row in parts for one in row)
            self._stacked[part] = np.stack([np.stack(row) for row in parts]) if whole else None
        return self._stacked[part]

    frf = property(lambda self: self._stack(3))
    std = property(lambda self: self._stack(4))
    coherence = property(lambda self: self._stack(5))
    averages = property(lambda self: np.array([one[2] for one in self._all.values()]))

    def at(self, point: int, channel: int) -> np.ndarray:
        if (point, channel) not in self._all:
            raise KeyError(f"no FRF of point {point}, channel {channel}")
        return self._all[point, channel][3]


def _index(value: int, count: int, name: str) -> int:
    at = value + count if value < 0 else value
    if not 0 <= at < count:
        raise IndexError(f"{name} {value} of {count}")
    return at


def _signals(values: Any, name: str) -> np.ndarray:
    if isinstance(values, np.ma.MaskedArray) and np.ma.is_masked(values):
        raise _percuss.InputError(f"masked samples ({name}); repair or leave out the hits that have them")
    return np.asarray(values)


def _is_ragged(values: Any) -> bool:
    return isinstance(values, (list, tuple)) and bool(values) and all(np.ndim(one) > 0 for one in values)


def _rows_of(force: Any, accel: Any) -> list[tuple[Any, list[np.ndarray]]]:
    """[(force or None, [accelerations])] of views, hit by hit."""
    several = _is_ragged(force)
    forces = [_signals(one, "force") for one in force] if several else None if force is None else _signals(force, "force")
    if forces is None:
        each = _signals(accel, "accel")
        return _checked([(None, _channels(one)) for one in (each if each.ndim == 3 else [each])])
    several = several or forces.ndim == 2
    if not several:
        return _checked([(forces, _channels(_signals(accel, "accel")))])
    hits = list(accel) if _is_ragged(accel) else _signals(accel, "accel")
    if len(forces) > _MOST_ROWS:
        raise _percuss.InputError(f"{len(forces)} hits (force); give at most a million at a time")
    if len(hits) != len(forces):
        raise _percuss.InputError(f"accelerations of {len(hits)} hits for forces of {len(forces)} (accel); give as many of each")
    if isinstance(forces, np.ndarray) and len(forces) > 1 and forces.strides[0] == 0:
        raise _percuss.InputError("one hit stands for all (force: a broadcast array); give each hit its own samples")
    return _checked([(one, _channels(_signals(hit, "accel"))) for one, hit in zip(forces, hits)])


def _channels(hit: np.ndarray) -> list[np.ndarray]:
    if hit.ndim == 1:
        return [hit]
    if hit.ndim != 2:
        raise _percuss.InputError(f"{hit.ndim} dimensions (accel); give (samples,), (channels, samples) or (hits, channels, samples)")
    if len(hit) > _MOST_ROWS:
        raise _percuss.InputError(f"{len(hit)} channels (accel); is it (channels, samples)?")
    return list(hit)


def _checked(rows: list[tuple[Any, list[np.ndarray]]]) -> list[tuple[Any, list[np.ndarray]]]:
    if not rows or not rows[0][1]:
        raise _percuss.InputError("no samples (arrays); record at least one hit with one acceleration")
    for force, accel in rows:
        for name, one in [("force", force)] * (force is not None) + [("accel", part) for part in accel]:
            if one.ndim != 1:
                raise _percuss.InputError(f"{one.ndim} dimensions ({name}); give (samples,) or (hits, samples)")
    return rows


def handles_of(data: tuple[Any, ...], fs: Any) -> tuple[list[str], list[Any]]:
    """What a command is given: paths, or handles of what is in memory."""
    flat = list(data[0]) if len(data) == 1 and _is_several(data[0]) else list(data)
    if all(isinstance(one, (str, bytes, os.PathLike)) for one in flat):
        return [os.fsdecode(one) for one in flat], []
    if all(isinstance(one, (Record, MeasuredFrf)) for one in flat):
        return [], [one._handle for one in flat]
    if any(isinstance(one, (str, bytes, os.PathLike, Record, MeasuredFrf)) for one in flat):
        raise TypeError("give files, records or arrays, not some of each")
    if len(data) != 2:
        raise TypeError("give two arrays, force and accel, with fs=; or paths; or records")
    if fs is None:
        raise TypeError("arrays need their sampling rate: fs= in Hz")
    return [], [Record(data[0], data[1], fs)._handle]


def _is_several(value: Any) -> bool:
    return isinstance(value, (list, tuple)) and all(isinstance(one, (str, bytes, os.PathLike, Record, MeasuredFrf)) for one in value)
