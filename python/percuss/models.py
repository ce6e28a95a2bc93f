"""Models of beams, bats and barrels, and of a ball that strikes them.

Each function takes the options of `percuss model NAME` as keywords, in SI units unless the name of a keyword states
another unit. It returns a Result with the keys of the document. The attribute table holds the columns of the command's
.csv.

>>> import percuss
>>> beam = percuss.models.beam(support="free", length=0.84, modes=4)
>>> beam.frequency_hz.shape
(4,)
"""

from __future__ import annotations

from ._commands import make as _make
from ._results import Result as _Result

__all__ = ["beam", "impact", "rigid", "trampoline", "bat", "shell"]

_RETURNS = "Returns a Result with the keys of the document, such as {keys}."

beam = _make("models.beam", "model beam", _Result, _RETURNS.format(keys="frequency_hz (modes,), lambda, node_m"), "", [])
impact = _make("models.impact", "model impact", _Result, _RETURNS.format(keys="cor, contact_s, peak_force_n, sweep"), "", [])
rigid = _make("models.rigid", "model rigid", _Result, _RETURNS.format(keys="best, curve"), "", [])
trampoline = _make("models.trampoline", "model trampoline", _Result, _RETURNS.format(keys="wall_cor, peak, curve"), "", [])
bat = _make(
    "models.bat",
    "model bat",
    _Result,
    _RETURNS.format(keys="frequency_hz (modes,), node_m, mass_kg, curve")
    + " profile may be an array (slices, 2): the position of each slice's far end, from the knob, and the diameter, in the units of profile_unit. A file with a line of names may hold walls and layers.",
    "",
    [],
)
shell = _make("models.shell", "model shell", _Result, _RETURNS.format(keys="ring_hz, rayleigh_hz, love_hz, flugge_hz (modes,)"), "", [])
