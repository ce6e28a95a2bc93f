# Made by python/scripts/make_stubs.py from the declarations of the command line.
from os import PathLike
from typing import Any, Literal, Sequence

import numpy as np

from ._results import Result

_Path = str | PathLike[str]
_File = _Path | dict[str, Any] | Sequence[Any] | np.ndarray | Result
_Text = str | float | tuple[float | str, ...] | Sequence[Any] | dict[str, Any]
_Numbers = float | Sequence[float] | np.ndarray

def performance(
    *table: Any,
    bat_id: _Text | None = ...,
    bat: _Text | None = ...,
    length_in: float | None = ...,
    weight_oz: float | None = ...,
    cg_in: float | None = ...,
    period_s: _Numbers | None = ...,
    gate_times_s: _Numbers | None = ...,
    crossings_per_period: int | None = ...,
    moi_oz_in2: float | None = ...,
    ball_g: float | None = ...,
    z_in: float | None = ...,
    v_in_mph: float | None = ...,
    v_out_mph: float | None = ...,
    besr: float | None = ...,
    bbcor: float | None = ...,
    v_swing_mph: float | None = ...,
    diameter_in: _Numbers | None = ...,
    handle_diameter_in: float | None = ...,
    length_resolution_in: float | None = ...,
    weight_resolution_oz: float | None = ...,
    cg_resolution_in: float | None = ...,
    ball_resolution_g: float | None = ...,
    diameter_resolution_in: float | None = ...,
    period_resolution_s: float | None = ...,
    moi_resolution_oz_in2: float | None = ...,
    z_resolution_in: float | None = ...,
    speed_resolution_mph: float | None = ...,
    round: bool = ...,
    v_pitch_mph: float | None = ...,
    nominal_mph: float | None = ...,
    v0_mph: float | None = ...,
    swing_length_in: float | None = ...,
    swing_moi_oz_in2: float | None = ...,
    swing_exponent: float | None = ...,
    lot_correction: float | None = ...,
    gravity_in_s2: float | None = ...,
    keep_formulas: bool = ...,
) -> Result: ...

def certify(
    session: _File,
    /,
    *,
    metric: Literal['besr', 'ncaa_besr', 'bbcor'] | None = ...,
    limit: float | None = ...,
    accept_plateau: bool = ...,
) -> Result: ...

def abi(
    log: _File,
    /,
    *,
    limit: float | None = ...,
) -> Result: ...

def study(
    *tables: Any,
    figures: _File | None = ...,
    program: _Text | None = ...,
    hoop_curve: _File | None = ...,
    blind: _File | None = ...,
    table: _File | None = ...,
    keep_formulas: bool = ...,
) -> Result: ...

def mac(a: Any, b: Any = ...) -> np.ndarray: ...
