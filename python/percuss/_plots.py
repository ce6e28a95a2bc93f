"""Pictures of results with matplotlib."""

from __future__ import annotations

from typing import Any

import numpy as np

from ._errors import UsageError
from ._optional import optional_module
from ._synthesis import synthesised

_MAX_CURVES = 12  # more are drawn thin and without a legend
_MARKS = {"stable": ("o", "tab:green"), "frequency": ("v", "tab:orange"), "new": (".", "0.7")}


def _axes(count: int, ax: Any, heights: list[int] | None = None) -> Any:
    """The given axes, or new ones below each other."""
    if ax is not None:
        given = list(np.ravel(np.array(ax, dtype=object)))
        if len(given) != count:
            raise UsageError(f"{len(given)} axes for {count} drawings", f"give {count} axes")
        return given
    pyplot = optional_module("matplotlib.pyplot", "plot()")
    ratios = {"height_ratios": heights} if heights else {}
    _, made = pyplot.subplots(count, 1, sharex=True, squeeze=False, layout="constrained", gridspec_kw=ratios)
    return list(made[:, 0])


def _places(points: list[int], channels: int, point: int | None, channel: int | None) -> list[tuple[int, int, int]]:
    """(row, point, channel) of the responses that are drawn."""
    chosen = [(row, number, c) for row, number in enumerate(points) for c in range(channels)
              if point in (None, number) and channel in (None, c)]  # fmt: skip
    if not chosen:
        asked = [f"{name} {value}" for name, value in (("point", point), ("channel", channel)) if value is not None]
        raise KeyError(f"no FRF of {', '.join(asked)}" if asked else "no FRF")
    return chosen


def plot_frf(frf: Any, point: int | None, channel: int | None, ax: Any, fit: Any = None, modes_hz: Any = ()) -> Any:
    """Magnitude and phase over frequency. `fit` (points, channels, lines) is drawn dashed over each response."""
    magnitude, phase = axes = _axes(2, ax, [3, 1])
    drawn = _places(frf.points.tolist(), frf.H.shape[1], point, channel)
    few = len(drawn) <= _MAX_CURVES
    tiny = np.finfo(float).tiny
    for row, number, c in drawn:
        curve = frf.H[row, c]
        [line] = magnitude.plot(frf.frequency_hz, 20 * np.log10(np.maximum(np.abs(curve), tiny)), lw=1.2 if few else 0.5,
                                label=f"point {number}, {frf.names[c]}" if few else None)  # fmt: skip
        phase.plot(frf.frequency_hz, np.degrees(np.angle(curve)), lw=0.8 if few else 0.3, color=line.get_color())
        if fit is not None:
            magnitude.plot(frf.frequency_hz, 20 * np.log10(np.maximum(np.abs(fit[row, c]), tiny)), "--", color="k", lw=0.9,
                           label="fit" if (row, number, c) == drawn[-1] else None)  # fmt: skip
    for freq_hz in modes_hz:
        magnitude.axvline(freq_hz, color="0.8", lw=0.8, zorder=0)
    magnitude.set_ylabel(f"{frf.kind}, dB re 1 {frf.unit}")
    phase.set_ylabel("phase, °")
    phase.set_yticks([-180, 0, 180])
    phase.set_xlabel("frequency, Hz")
    if few or fit is not None:
        magnitude.legend(fontsize="small")
    return axes


def plot_stabilisation(diagram: dict[str, Any], modes_hz: Any, ax: Any) -> Any:
    """Poles by frequency and model order; stable poles of a mode lie below each other."""
    [axes] = _axes(1, ax)
    stability = np.array(diagram["stability"])
    for name in sorted(set(diagram["stability"])):
        mark, colour = _MARKS.get(name, ("x", "tab:blue"))
        chosen = stability == name
        axes.plot(diagram["frequency_hz"][chosen], diagram["order"][chosen], mark, color=colour, ms=4, label=name)
    for freq_hz in modes_hz:
        axes.axvline(freq_hz, color="0.8", lw=0.8, zorder=0)
    axes.set_xlabel("frequency, Hz")
    axes.set_ylabel("order of the model")
    if len(stability):
        axes.legend(fontsize="small")
    return axes


def plot_shapes(places: list[str], shapes: np.ndarray, titles: list[str], ax: Any) -> Any:
    """Real and imaginary part of each shape over its places, largest value 1, a drawing per mode."""
    axes = _axes(len(titles), ax)
    at = np.arange(len(places))
    for one, shape, title in zip(axes, shapes, titles):
        largest = shape[np.argmax(np.abs(shape))] if shape.size else 1
        scaled = shape / largest if largest else shape
        one.axhline(0, color="0.8", lw=0.8)
        one.plot(at, scaled.real, "o-", ms=3, label="in phase")
        one.plot(at, scaled.imag, ".", color="tab:orange", ms=3, label="quadrature")
        one.set_title(title, fontsize="small", loc="left")
    step = max(1, len(places) // 12)
    axes[-1].set_xticks(at[::step], places[::step], fontsize="small")
    axes[-1].set_xlabel("point (from 0):channel (from 1)")
    axes[0].legend(fontsize="small")
    return axes


def plot_curves(curves: list[dict[str, Any]], fs_hz: float, ax: Any) -> Any:
    """Deflection over time under each impact."""
    [axes] = _axes(1, ax)
    for curve in curves:
        t_s = curve["first_s"] + np.arange(len(curve["deflection_m"])) / fs_hz
        label = f"hit {curve['hit'] + 1}, channel {curve['channel'] + 1}" if len(curves) <= _MAX_CURVES else None
        axes.plot(1e3 * t_s, 1e3 * curve["deflection_m"], lw=0.9, label=label)
    axes.set_xlabel("time, ms")
    axes.set_ylabel("deflection, mm")
    if len(curves) <= _MAX_CURVES:
        axes.legend(fontsize="small")
    return axes


def plot_analysis(analysis: Any, what: str, point: int | None, channel: int | None, ax: Any) -> Any:
    """The drawing of an Analysis by name."""
    if what == "frf":
        frf = analysis.frf()
        s = analysis._computed("window_decay_per_s") + 2j * np.pi * frf.frequency_hz
        return plot_frf(frf, point, channel, ax, synthesised(analysis, s, frf.kind, True), analysis.frequency_hz)
    if what == "stabilisation":
        return plot_stabilisation(analysis.stabilisation(), analysis.frequency_hz, ax)
    if what == "shapes":
        if not len(analysis.frequency_hz):
            raise UsageError("needs a mode, and none was found", "draw frf, or widen the band", ["what"])
        titles = [f"mode {i}: {freq:.5g} Hz" for i, freq in enumerate(analysis.frequency_hz, 1)]
        return plot_shapes([f"{p}:{c + 1}" for p, c in analysis._shape_places], analysis._shape_values, titles, ax)
    raise UsageError(f"cannot be {what!r}", "give frf, stabilisation or shapes", ["what"])
