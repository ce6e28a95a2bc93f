"""Checks of the arrays of FRFs that users give."""

from __future__ import annotations

from typing import Any

import numpy as np

from ._errors import InputError


def real_lines(values: Any, name: str, dimensions: int) -> np.ndarray:
    array = np.asarray(values)
    if array.dtype.kind not in "biuf" or array.ndim != dimensions:
        raise InputError(f"an array of {array.ndim} dimensions of {array.dtype}", name, "give real numbers, (lines,)")
    return array


def responses_given(values: Any, name: str, kind: Any, lines: int) -> np.ndarray:
    """A copy of the values, (points, channels, lines)."""
    array = np.asarray(values)
    if array.dtype.kind not in ("biufc" if kind is complex else "biuf"):
        raise TypeError(f"{name} holds no numbers: give an array (points, channels, lines)")
    if not 1 <= array.ndim <= 3 or array.size == 0 or array.shape[-1] != lines:
        shape = " × ".join(str(one) for one in array.shape) or "one number"
        raise InputError(f"{shape} values for {lines} frequencies", name, "give (points, channels, lines), (channels, lines) or (lines,)")
    made = np.array(array.reshape((1,) * (3 - array.ndim) + array.shape), dtype=kind)
    bad = np.argwhere(~np.isfinite(made))
    if len(bad):
        place = "point {}, channel {}, line {}".format(*bad[0])
        raise InputError("not a finite number", f"{name}, {place}", "repair it or leave out the line for all responses")
    return made


def alike(values: Any, name: str, shape: tuple[int, ...]) -> np.ndarray:
    made = responses_given(values, name, float, shape[-1])
    if made.shape != shape:
        raise InputError(f"{' × '.join(map(str, made.shape))} values for H of {' × '.join(map(str, shape))}", name, "give the shape of H")
    return made
