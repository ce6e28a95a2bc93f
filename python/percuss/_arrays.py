"""Checks of the arrays that users give, and the arrays that results return."""

from __future__ import annotations

import numbers
from collections.abc import Iterator
from typing import Any

import numpy as np

from ._errors import InputError

_MAX_ROWS = 1_000_000
_MAX_ROWS_PER_SAMPLE = 8  # an array with more rows per sample counts as transposed and is rejected


def frozen(array: np.ndarray) -> np.ndarray:
    """Makes the array read-only: all users of a result share its arrays."""
    array.flags.writeable = False
    return array


class Responses:
    """FRFs by point and channel, stacked on first use. Each of `responses` is (point, channel, averages, value, std,
    coherence); std and coherence may be None."""

    def __init__(self, responses: list[tuple[Any, ...]]) -> None:
        self._all = {(one[0], one[1]): one for one in responses}
        self._stacked: dict[int, np.ndarray | None] = {}

    @property
    def points(self) -> np.ndarray:
        return frozen(np.array(sorted({point for point, _ in self._all})))

    def _stack(self, part: int) -> np.ndarray | None:
        if part not in self._stacked:
            parts = [[self._all[point, channel][part] for channel in self.channels] for point in self.points.tolist()]
            whole = all(one is not None for row in parts for one in row)
            self._stacked[part] = frozen(np.stack([np.stack(row) for row in parts])) if whole else None
        return self._stacked[part]

    @property
    def channels(self) -> list[int]:
        return sorted({channel for _, channel in self._all})

    value = property(lambda self: self._stack(3))
    std = property(lambda self: self._stack(4))
    coherence = property(lambda self: self._stack(5))

    @property
    def min_averages(self) -> int:
        return min((int(one[2]) for one in self._all.values()), default=0)

    def at(self, point: int, channel: int) -> np.ndarray:
        if (point, channel) not in self._all:
            raise KeyError(f"no FRF of point {point}, channel {channel}")
        return self._all[point, channel][3]


def array_of(values: Any, name: str) -> np.ndarray:
    """The values as an array. Raises InputError for nested lists of different lengths."""
    try:
        return np.asarray(values)
    except ValueError:
        raise InputError("lists of different lengths", name, "give an array of numbers") from None


def _signals(values: Any, name: str) -> np.ndarray:
    if isinstance(values, np.ma.MaskedArray) and np.ma.is_masked(values):
        raise InputError("masked samples", name, "repair or omit the hits that have masked samples")
    if isinstance(values, Iterator):
        raise TypeError(f"{name} cannot be a {type(values).__name__}: give an array or a list")
    array = array_of(values, name)
    return array if array.dtype.isnative else array.astype(array.dtype.newbyteorder("="))


def _is_list_of_arrays(values: Any) -> bool:
    return isinstance(values, (list, tuple)) and bool(values) and all(isinstance(one, (list, tuple)) or np.ndim(one) > 0 for one in values)


def rows_of(force: Any, accel: Any) -> list[tuple[Any, list[np.ndarray]]]:
    """Views of the arrays, a pair (force or None, [accelerations]) per hit."""
    several = is_list = _is_list_of_arrays(force)
    forces: Any = [_signals(one, "force") for one in force] if several else None if force is None else _signals(force, "force")
    if forces is None:
        each: Any = _signals(accel, "accel")
        return _checked([(None, _channels(one)) for one in (list(each) if each.ndim == 3 else [each])])
    several = several or forces.ndim == 2
    if not several:
        return _checked([(forces, _channels(_signals(accel, "accel")))])
    if not is_list and _is_transposed(forces.shape):
        raise InputError(f"{forces.shape[0]} hits of {forces.shape[1]} samples", "force", "is it (hits, samples)? Give force.T")
    hits: Any = list(accel) if _is_list_of_arrays(accel) else _signals(accel, "accel")
    if len(forces) > _MAX_ROWS:
        raise InputError(f"{len(forces)} hits", "force", "give at most a million at a time")
    if len(hits) != len(forces):
        raise InputError(f"{len(hits)} hits of acceleration for {len(forces)} of force", "accel", "give the same number of hits")
    if isinstance(forces, np.ndarray) and forces.size > 0 and len(forces) > 1 and forces.strides[0] == 0:
        raise InputError("one row stands for all hits (a broadcast array)", "force", "give each hit its own samples")
    return _checked([(one, _channels(_signals(hit, "accel"))) for one, hit in zip(forces, hits)])


def _channels(hit: np.ndarray) -> list[np.ndarray]:
    if hit.ndim == 1:
        return [hit]
    if hit.ndim != 2:
        raise InputError(f"{hit.ndim} dimensions", "accel", "give (samples,), (channels, samples) or (hits, channels, samples)")
    if len(hit) > _MAX_ROWS:
        raise InputError(f"{len(hit)} channels", "accel", "is it (channels, samples)?")
    if hit.size == 0:
        raise InputError("no samples", "accel", "record at least one hit with one acceleration")
    if _is_transposed(hit.shape):
        raise InputError(f"{hit.shape[0]} channels of {hit.shape[1]} samples", "accel", "is it (channels, samples)? Give np.swapaxes(accel, -2, -1)")
    return list(hit)


def _is_transposed(shape: tuple[int, ...]) -> bool:
    """Whether an array (rows, samples) has far more rows than samples."""
    return shape[1] > 0 and shape[0] > _MAX_ROWS_PER_SAMPLE * shape[1]


def _checked(rows: list[tuple[Any, list[np.ndarray]]]) -> list[tuple[Any, list[np.ndarray]]]:
    if not rows or not rows[0][1]:
        raise InputError("no samples", "arrays", "record at least one hit with one acceleration")
    for force, accel in rows:
        for name, one in [("force", force)] * (force is not None) + [("accel", part) for part in accel]:
            if one.ndim != 1:
                raise InputError(f"{one.ndim} dimensions", name, "give (samples,) or (hits, samples)")
            if one.size == 0:
                raise InputError("no samples", name, "record at least one hit with one acceleration")
    return rows


def rate_of(fs: Any) -> float:
    """A sampling rate in Hz, from a number or from an array of one number, as HDF5 and MAT files store it."""
    one = fs.item() if isinstance(fs, np.ndarray) and fs.size == 1 else fs
    if isinstance(one, (bool, np.bool_)) or not isinstance(one, numbers.Real):
        raise TypeError(f"fs is a number in Hz, not {fs!r}")
    return float(one)


def points_of(points: Any, count: int, of: str = "hits") -> list[int]:
    if points is None:
        return []
    array = np.asarray(points)
    whole = array.ndim == 1 and array.dtype.kind in "iuf" and bool(np.all(array == np.floor(array)))
    if whole and len(array) == count and count and not 0 <= array.min() <= array.max() < _MAX_ROWS:
        wrong = array.min() if array.min() < 0 else array.max()
        raise InputError(f"{wrong:g} is no number of a point", "points", f"number points from 0 up, below {_MAX_ROWS}")
    if not whole or len(array) != count:
        given = f"{array.size} points" if whole else "points that are not a list of whole numbers"
        raise InputError(f"{given} for {count} {of}", "points", "give a number from 0 up for each")
    return [int(one) for one in array]


def texts_of(names: Any) -> list[str]:
    """The names as a list. Raises InputError for a single text, and for names that are no texts."""
    given = [] if isinstance(names, (str, bytes)) else list(names)
    if isinstance(names, (str, bytes)) or not all(isinstance(one, str) for one in given):
        raise InputError(f"{one_line(names)} is not a list of names", "names", "give a list of texts")
    return given


def names_of(names: Any, signals: int, has_force: bool) -> list[str]:
    given = texts_of(names)
    if given and len(given) != signals:
        wanted = "one for the force and one for each acceleration" if has_force else "one for each acceleration"
        raise InputError(f"{len(given)} names for {signals} signals", "names", f"give {wanted}")
    return given


def one_line(value: Any) -> str:
    text = repr(value)
    return text if len(text) <= 60 else text[:57] + "..."


def geometry_of(geometry: Any, points: list[int], channels: int) -> list[list[float]]:
    """Coordinates of each point. If all hits are at one point, the rows may belong to the accelerometers instead."""
    if geometry is None:
        return []
    try:
        array = np.asarray(geometry, dtype=float)
    except (TypeError, ValueError):
        raise InputError("rows of different lengths, or no numbers", "geometry", "give an array (points, 3) in m") from None
    if array.ndim != 2 or array.shape[1] not in (2, 3):
        shape = " × ".join(str(one) for one in array.shape) or "one number"
        raise InputError(f"an array of {shape}", "geometry", "give (points, 3) in m, or (points, 2): m along a tube and degrees")
    if not np.isfinite(array).all():
        where = np.flatnonzero(~np.isfinite(array).all(axis=1))[0]
        raise InputError(f"row {where} is not finite", "geometry", "give coordinates for every point, numbered from 0")
    struck = max(points, default=0) + 1
    if len(array) not in ({struck} if struck > 1 else {1, channels}):
        problem = f"{len(array)} places for {struck} point{'s' if struck > 1 else ''} struck"
        remedy = "give a row for each point from 0 up" if points else "say which point each hit struck: points="
        if struck > 1 and min(points) == 1 and len(array) == struck - 1:
            problem = f"{len(array)} places for points 1 to {struck - 1}, but point 0 has the first row"
            remedy = "number the points from 0: points - 1"
        raise InputError(problem, "geometry", remedy)
    return array.tolist()
