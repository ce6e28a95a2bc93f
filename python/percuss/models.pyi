# Made by python/scripts/make_stubs.py from the declarations of the command line.
from os import PathLike
from typing import Any, Literal, Sequence

import numpy as np

from ._results import Result

_Path = str | PathLike[str]
_File = _Path | dict[str, Any] | Sequence[Any] | np.ndarray | Result
_Text = str | float | tuple[float | str, ...] | Sequence[Any] | dict[str, Any]
_Numbers = float | Sequence[float] | np.ndarray

def beam(
    *,
    support: Literal['torsion', 'pinned', 'clamped', 'free'] | None = ...,
    ei: float | None = ...,
    rho_a: float | None = ...,
    torsion: float | None = ...,
    length: float | None = ...,
    layer: _Text | None = ...,
    profile: _File | None = ...,
    profile_unit: _Text | None = ...,
    profile_kind: Literal['slices', 'points'] | None = ...,
    density: float | None = ...,
    young: float | None = ...,
    shear: float | None = ...,
    total_mass: float | None = ...,
    add_mass: _Text | None = ...,
    modes: int | None = ...,
    gyration: float | None = ...,
    shear_stiffness: float | None = ...,
    fit: Literal['ei', 'torsion', 'rho-a', 'young', 'shear', 'density', 'added-mass'] | Sequence[Literal['ei', 'torsion', 'rho-a', 'young', 'shear', 'density', 'added-mass']] | None = ...,
    measured: _Numbers | None = ...,
    measured_std: _Numbers | None = ...,
    measured_modes: int | Sequence[int] | None = ...,
    static: _Text | None = ...,
    budget: _Numbers | None = ...,
) -> Result: ...

def impact(
    *,
    support: Literal['torsion', 'pinned', 'clamped', 'free'] | None = ...,
    ei: float | None = ...,
    rho_a: float | None = ...,
    torsion: float | None = ...,
    length: float | None = ...,
    layer: _Text | None = ...,
    profile: _File | None = ...,
    profile_unit: _Text | None = ...,
    profile_kind: Literal['slices', 'points'] | None = ...,
    density: float | None = ...,
    young: float | None = ...,
    shear: float | None = ...,
    total_mass: float | None = ...,
    add_mass: _Text | None = ...,
    at: float | None = ...,
    ball_mass: float | None = ...,
    speed: float | None = ...,
    hertz: float | None = ...,
    contact_cor: float | None = ...,
    modes: int | None = ...,
    method: Literal['modal', 'small-increment'] | None = ...,
    step: float | None = ...,
    sweep: _Text | None = ...,
    curves: bool = ...,
    threads: int | None = ...,
    budget: _Numbers | None = ...,
) -> Result: ...

def rigid(
    *,
    ball_mass: float | None = ...,
    bat_mass: float | None = ...,
    inertia: float | None = ...,
    length: float | None = ...,
    at: _Text | None = ...,
    ball_speed: float | None = ...,
    swing_rate: float | None = ...,
    bat_speed: float | None = ...,
    pivot: float | None = ...,
    cor: float | None = ...,
) -> Result: ...

def trampoline(
    *,
    ball: Literal['baseball', 'softball'] | None = ...,
    speed: float | None = ...,
    hoop: _Text | None = ...,
    extra_mass: float | None = ...,
    free_hoop: float | None = ...,
    loaded_hoop: float | None = ...,
    fit_ccor: _Text | None = ...,
    hold: _Text | None = ...,
    bats: _File | list[_File] | None = ...,
    m1: float | None = ...,
    k1: float | None = ...,
    c1: float | None = ...,
    a: float | None = ...,
    b: float | None = ...,
    m2: float | None = ...,
    c2: float | None = ...,
    budget: _Numbers | None = ...,
    keep_formulas: bool = ...,
) -> Result: ...

def bat(
    *,
    profile: _File,
    profile_unit: _Text | None = ...,
    profile_kind: Literal['slices', 'points'] | None = ...,
    density: float | None = ...,
    young: float | None = ...,
    shear: float | None = ...,
    total_mass: float | None = ...,
    add_mass: _Text | None = ...,
    support: Literal['free', 'torsion', 'pinned', 'clamped'] | None = ...,
    support_at: float | None = ...,
    torsion: float | None = ...,
    ball_mass: float | None = ...,
    ball_speed: float | None = ...,
    bat_speed: float | None = ...,
    swing_rate: float | None = ...,
    cor: float | None = ...,
    ball_stiffness: float | None = ...,
    ball_exponent: float | None = ...,
    modes: int | None = ...,
    at: _Text | None = ...,
    wave: float | None = ...,
    wave_times: _Text | None = ...,
    fit: Literal['young', 'shear', 'density', 'torsion', 'added-mass'] | Sequence[Literal['young', 'shear', 'density', 'torsion', 'added-mass']] | None = ...,
    measured: _Numbers | None = ...,
    measured_std: _Numbers | None = ...,
    measured_modes: int | Sequence[int] | None = ...,
    budget: _Numbers | None = ...,
) -> Result: ...

def shell(
    *,
    outer_diameter: float | None = ...,
    wall: float | None = ...,
    length: float | None = ...,
    young: float | None = ...,
    density: float | None = ...,
    poisson: float | None = ...,
    n: int | None = ...,
    modes: int | None = ...,
    measured: _Text | None = ...,
    fit: Literal['young', 'wall', 'both'] | None = ...,
) -> Result: ...
