"""FRFs from modes."""

from __future__ import annotations

from typing import Any

import numpy as np

from ._errors import InputError, UsageError

KINDS = ("accelerance", "mobility", "receptance")  # each is the one before it divided by s


def require_kind(kind: Any) -> None:
    """Raises UsageError for an unknown kind of FRF."""
    if kind not in KINDS:
        raise UsageError(f"cannot be {kind!r}", "give accelerance, mobility or receptance", ["kind"])


def laplace_of(freq_hz: Any) -> np.ndarray:
    """s = jω of frequencies that a user gives."""
    freq = np.atleast_1d(np.asarray(freq_hz, dtype=float))
    if freq.ndim != 1 or not np.isfinite(freq).all():
        raise InputError("not a list of finite frequencies", "freq_hz", "give frequencies in Hz, (lines,)")
    return 2j * np.pi * freq


def synthesised(analysis: Any, s: np.ndarray, kind: str, residual_terms: bool) -> np.ndarray:
    """FRFs (points, channels, lines) of the modes of an Analysis at s."""
    require_kind(kind)
    omega = 2 * np.pi * analysis.frequency_hz[:, None]
    # The powers of s are cancelled here, so the terms of mobility and receptance are finite at 0 Hz, except `lower`.
    power = 2 - KINDS.index(kind)
    modal = s**power / (s**2 + 2 * analysis.damping_ratio[:, None] * omega * s + omega**2)
    out = np.einsum("mpc,ml->pcl", analysis.residues, modal)
    if residual_terms:
        with np.errstate(divide="ignore", invalid="ignore"):
            lower = analysis.lower[..., None] / s ** (2 - power) if power < 2 else analysis.lower[..., None]
        out = out + lower
        for k, term in enumerate((analysis.upper, analysis.upper_4, analysis.upper_6)):
            out = out + term[..., None] * s ** (power + 2 * k)
    return out
