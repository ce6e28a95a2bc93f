"""Checks of the arrays of FRFs that users give."""

from __future__ import annotations

import math
import numbers
from typing import Any

import numpy as np

from ._arrays import array_of, one_line, texts_of
from ._errors import InputError

_ROUNDING = 1e-6  # programs store coherences in single precision, and 1 becomes a little more


def frequencies_given(values: Any) -> np.ndarray:
    """Finite frequencies in Hz that rise from 0 or above, (lines,). The library checks their spacing."""
    array, name = _unmasked(values, "frequency_hz"), "frequency_hz"
    if array.dtype.kind not in "iuf" or array.ndim != 1:
        raise InputError(f"an array of {array.ndim} dimensions of {array.dtype}", name, "give real numbers, (lines,)")
    freq_hz = np.ascontiguousarray(array, dtype=float)
    bad = np.flatnonzero(~np.isfinite(freq_hz) | (freq_hz < 0))
    if len(bad):
        raise InputError(f"{freq_hz[bad[0]]:g} is no frequency", f"{name}, line {bad[0]}", "give finite frequencies from 0 Hz up")
    down = np.flatnonzero(np.diff(freq_hz) <= 0)
    if len(down):
        pair = f"{freq_hz[down[0]]:g} Hz before {freq_hz[down[0] + 1]:g} Hz"
        raise InputError(f"frequencies that do not rise: {pair}", f"{name}, line {down[0]}", "sort the lines; give each frequency once")
    return freq_hz


def _unmasked(values: Any, name: str) -> np.ndarray:
    if isinstance(values, np.ma.MaskedArray) and np.ma.is_masked(values):
        raise InputError("masked numbers", name, "repair them or leave out their lines for all responses")
    return array_of(values, name)


def responses_given(values: Any, name: str, kind: Any, lines: int) -> np.ndarray:
    """A copy of the values, (points, channels, lines)."""
    array = _unmasked(values, name)
    if array.dtype.kind == "c" and kind is not complex:
        raise InputError("complex numbers", name, "give real numbers in the shape of H")
    if array.dtype.kind not in "iufc":
        raise TypeError(f"{name} holds no numbers: give an array (points, channels, lines)")
    if not 1 <= array.ndim <= 3 or array.size == 0 or array.shape[-1] != lines:
        shape = " × ".join(str(one) for one in array.shape) or "one number"
        raise InputError(f"{shape} values for {lines} frequencies", name, "give (points, channels, lines), (channels, lines) or (lines,)")
    if kind is complex and array.dtype.kind != "c":
        raise InputError("real numbers without a phase", name, "give complex responses: magnitude * np.exp(1j * phase)")
    made = np.array(array.reshape((1,) * (3 - array.ndim) + array.shape), dtype=kind)
    bad = np.argwhere(~np.isfinite(made))
    if len(bad):
        place = "point {}, channel {}, line {}".format(*bad[0])
        raise InputError("not a finite number", f"{name}, {place}", "repair it or leave out the line for all responses")
    return made


def averages_given(value: Any) -> int:
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, numbers.Real) or not float(value).is_integer() or value < 0:
        raise InputError(f"{one_line(value)} is no number of hits", "averages", "give a whole number; 0 if it is not known")
    return int(value)


def window_decay_given(exponential: Any, freq_hz: np.ndarray) -> float:
    """The decay in 1/s of a window that falls to this fraction within a record; 0 without one."""
    if exponential is None:
        return 0.0
    if isinstance(exponential, (bool, np.bool_)) or not isinstance(exponential, numbers.Real) or not 0 < float(exponential) < 1:
        raise InputError(f"{one_line(exponential)} is no fraction", "exponential", "give a number between 0 and 1, such as 0.01")
    spacing_hz = float(freq_hz[-1] - freq_hz[0]) / max(1, len(freq_hz) - 1)
    return -math.log(float(exponential)) * spacing_hz


def channel_names_given(names: Any, channels: int) -> list[str]:
    given = texts_of(names) or [f"channel {i + 1}" for i in range(channels)]
    if len(given) != channels:
        raise InputError(f"{len(given)} names for {channels} channels", "names", "give one for each channel")
    return given


def _within(made: np.ndarray, name: str, lowest: float, highest: float, remedy: str) -> None:
    bad = np.argwhere((made < lowest) | (made > highest))
    if len(bad):
        place = "point {}, channel {}, line {}".format(*bad[0])
        raise InputError(f"{made[tuple(bad[0])]:g} is impossible", f"{name}, {place}", remedy)


def std_given(values: Any, shape: tuple[int, ...]) -> np.ndarray | None:
    if values is None:
        return None
    made = of_shape(values, "std", shape)
    _within(made, "std", 0, np.inf, "give standard deviations from 0 up, in the unit of H")
    return made


def coherence_given(values: Any, shape: tuple[int, ...]) -> np.ndarray | None:
    if values is None:
        return None
    made = of_shape(values, "coherence", shape)
    _within(made, "coherence", 0, 1 + _ROUNDING, "give the ordinary coherence, 0 to 1")
    return np.minimum(made, 1)


def of_shape(values: Any, name: str, shape: tuple[int, ...]) -> np.ndarray:
    """The values, which must have the shape of H."""
    made = responses_given(values, name, float, shape[-1])
    if made.shape != shape:
        raise InputError(f"{' × '.join(map(str, made.shape))} values for H of {' × '.join(map(str, shape))}", name, "give the shape of H")
    return made
