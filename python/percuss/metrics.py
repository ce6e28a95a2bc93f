"""Performance of bats, their certification, and comparison of mode shapes.

performance() computes every metric that the readings allow. certify(), abi() and study() follow the test protocols.
mac() compares mode shapes.

>>> import percuss
>>> bat = percuss.metrics.performance(length_in=34, weight_oz=31)
>>> round(bat.drop, 9)
-3.0
"""

from __future__ import annotations

from typing import Any

import numpy as np

from . import _percuss
from ._arrays import frozen
from ._commands import _positional, make as _make
from ._errors import InputError
from ._results import Result as _Result

__all__ = ["performance", "certify", "abi", "study", "mac"]

performance = _make(
    "metrics.performance",
    "metrics",
    _Result,
    "Returns a Result: drop, moi_oz_in2, besr, bbs_mph, bbcor ... A metric that the readings do not allow is None.\n"
    "With the path of a table of readings, Result.bats has such a result per row.",
    "",
    [_positional("table", True)],
)
certify = _make(
    "metrics.certify",
    "certify",
    _Result,
    "session is a path or a dictionary; percuss.example('certify') shows its keys. Returns a Result: verdict, sweet spot, shots, next.\n"
    "exit_code is 5 if the bat exceeds its limit or is damaged.",
    "",
    [_positional("session", False)],
)
abi = _make(
    "metrics.abi",
    "abi",
    _Result,
    "log is a path or a dictionary; percuss.example('abi') shows its keys. Returns a Result. exit_code is 5 if the bat fails.",
    "",
    [_positional("log", False)],
)
study = _make(
    "metrics.study",
    "study",
    _Result,
    "tables are paths of tables, or of documents that name their bat (analyses and metrics with bat_id=, certify, abi). Returns a Result: every hypothesis with its statistics.",
    "",
    [_positional("tables", True)],
)


def mac(a: Any, b: Any = None) -> np.ndarray:
    """Modal assurance criterion |aᴴb|² / (aᴴa · bᴴb): 1 for the same shape, 0 for orthogonal ones.

    a, b  (modes, places), real or complex; both of the same places in the same order. Without b, compares a with itself.

    Returns an array (modes of a, modes of b), independent of the scale of each shape; 0 if a shape is zero everywhere.
    Raises InputError for arrays of other dimensions, empty arrays, NaN and infinity; TypeError for values that are not
    numbers. Source: theory (5.4).

    >>> from percuss import metrics
    >>> metrics.mac([[1, 2, 3]], [[2, 4, 6], [3, 0, -1]]).round(3).tolist()
    [[1.0, 0.0]]
    """
    first = _shapes(a, "a")
    return frozen(_percuss.mac(first, first if b is None else _shapes(b, "b")))


def _shapes(values: Any, name: str) -> np.ndarray:
    """(modes, places), each shape divided by its largest real or imaginary part: squares cannot overflow, and MAC does not change."""
    try:
        array = np.atleast_2d(np.asarray(values))
    except ValueError:
        raise InputError("rows of different lengths", name, "give an array (modes, places)") from None
    if array.dtype.kind not in "biufc":
        raise TypeError(f"{name} holds no numbers: give an array (modes, places), real or complex")
    if array.ndim != 2 or array.size == 0:
        dimensions = " × ".join(str(one) for one in array.shape)
        raise InputError(f"shapes of {dimensions}", name, "give an array (modes, places) with at least one mode and one place")
    bad = np.argwhere(~np.isfinite(array))
    if len(bad):
        raise InputError("not a finite number", f"{name}, mode {bad[0][0]}, place {bad[0][1]}", "remove the place from every shape")
    parts = np.ascontiguousarray(array, dtype=complex).view(float)
    largest = abs(parts).max(axis=1, keepdims=True)
    return (parts / np.where(largest > 0, largest, 1)).view(complex)
