# Made by python/scripts/make_functions.py from the declarations of the command line. Do not edit.
from __future__ import annotations

from typing import Literal, Sequence

from .._call import command_function, run_on_documents
from .._results import Result
from .._types import File, Numbers, Path, Quantity, Range

_Fit = Literal["young", "shear", "density", "torsion", "added-mass"]


@command_function("models.bat", "model bat")
def bat(
    *,
    profile: File,
    profile_unit: Range | None = None,
    profile_kind: Literal["slices", "points"] | None = None,
    density: float | None = None,
    young: float | None = None,
    shear: float | None = None,
    total_mass: Quantity | None = None,
    add_mass: Range | None = None,
    support: Literal["free", "torsion", "pinned", "clamped"] | None = None,
    support_at: Quantity | None = None,
    torsion: float | None = None,
    ball_mass: Quantity | None = None,
    ball_speed: Quantity | None = None,
    bat_speed: Quantity | None = None,
    swing_rate: float | None = None,
    cor: float | None = None,
    ball_stiffness: float | None = None,
    ball_exponent: float | None = None,
    modes: int | None = None,
    at: Range | None = None,
    wave: Quantity | None = None,
    wave_times: Range | None = None,
    fit: _Fit | Sequence[_Fit] | None = None,
    measured: Numbers | None = None,
    measured_std: Numbers | None = None,
    measured_modes: int | Sequence[int] | None = None,
    budget: Numbers | None = None,
    title: str | None = None,
    customer: str | None = None,
    operator: str | None = None,
    specimen: str | None = None,
    date: str | None = None,
    note: str | None = None,
    logo: Path | None = None,
    paper: Literal["a4", "letter"] | None = None,
) -> Result:
    """Predict the modes of a bat from its profile, and exit speeds along it.

    Models a bat as a beam of sections with bending, shear and rotary inertia: solid or hollow, of
    one or several materials, round or rectangular, free or held, with added masses. Reports modes,
    mass, balance point and moment of inertia. For each impact position, reports the exit speed of a
    ball beside the exit speed for a rigid bat, and how the energy divides among ball and modes.
    `fit` finds a constant of the bat from measured frequencies.

    Parameters
    ----------
    profile : path, array or dict
        Read the sections from this file: a position and a diameter, or width and thickness, in each
        line; with a line of names also wall, young, shear, density, and wall_2, young_2 … of
        further layers.
    profile_unit : (position, size), optional
        Set the units of the profile's positions and of its dimensions. Default: m:m.
    profile_kind : {'slices', 'points'}, optional
        Choose what a line means. slices: its section extends back to the position before; points:
        dimensions change linearly between positions. Default: slices.
    density : float in kg/m³, optional
        Set the density, where the profile has none (default: 649).
    young : float in Pa, optional
        Set Young's modulus along the bat, where the profile has none (default: 1.814e10).
    shear : float in Pa, optional
        Set the shear modulus times the shape factor, where the profile has none (default: 1.05e9).
    total_mass : float in kg, optional
        Compute the density from this measured mass, which includes added masses.
    add_mass : (kg, at) or a list of them, optional
        Add a point mass (a cap), or a mass spread evenly from one position to another (a grip or an
        insert), in kg and m.
    support : {'free', 'torsion', 'pinned', 'clamped'}, optional
        Choose how the bat is held: free, or at one position by a pin with a torsion spring, a pin
        or a clamp. Default: free.
    support_at : float in m, optional
        Set the position of the support from the knob (default: 0.1524, 6 in).
    torsion : float in N·m/rad, optional
        Set the stiffness of the torsion spring (default: 1200).
    ball_mass : float in kg, optional
        Set the mass of the ball. Default: 0.145.
    ball_speed : float in m/s, optional
        Set the speed of the ball towards the bat. Default: 67.
    bat_speed : float in m/s, optional
        Set the speed of a free bat's centre of mass towards the ball (default: 0).
    swing_rate : float in rad/s, optional
        Set the rotation rate of a free bat about its centre of mass, or of a pinned bat about its
        pin (default: 60; a clamped bat, or one on a torsion spring, is at rest).
    cor : float, optional
        Set the coefficient of restitution of the ball itself. Default: 0.5.
    ball_stiffness : float, optional
        Set k of the ball's spring F = k u^alpha, in N/m^alpha. Default: 6.53e+07.
    ball_exponent : float, optional
        Set alpha of the ball's spring F = k u^alpha. Default: 1.84.
    modes : int, optional
        Use this many bending modes. Default: 40.
    at : (lo, step, hi), optional
        Set the impact positions from the knob in m (default: 61 positions over the length).
    wave : float in m, optional
        Add the deflection along the bat after an impact this far from the knob.
    wave_times : (lo, step, hi), optional
        Show the deflection of `wave` at these times in s, from first contact. Default:
        0:0.0002:0.002.
    fit : {'young', 'shear', 'density', 'torsion', 'added-mass'} or a list of them, optional
        Fit these parameters to `measured`; their values are the start.
    measured : float or list of float in Hz, optional
        Set the measured frequencies, lowest first.
    measured_std : float or list of float in Hz, optional
        Set the standard deviations of the measured frequencies; one each, or one for all.
    measured_modes : int or list of int, optional
        Set the numbers of the measured modes, 1 for the first bending mode (default: the lowest).
    budget : float or list of float, optional
        Stop a model that takes more than this time in seconds or memory in GB (default: 120 s; 2.1
        GB).
    title : str, optional
        Set the title of the page (default: the name of the file).
    customer : str, optional
        State the customer on the page.
    operator : str, optional
        State on the page who did the test.
    specimen : str, optional
        State on the page what was tested.
    date : str, optional
        State on the page when the test was done (default: as the file states it).
    note : str, optional
        Put this text, or the text of a file, at the top of the page.
    logo : path, optional
        Put this picture at the top of the page (PNG, JPEG or SVG, at most 200 kB).
    paper : {'a4', 'letter'}, optional
        Set the paper on which the page is printed. Default: a4.

    Returns
    -------
    Result
        The keys of the document: `frequency_hz` (modes,), `node_m`, `mass_kg`, `curve` …

    Raises
    ------
    InputError
        Data that percuss cannot use.
    UsageError
        Invalid values, and keywords that exclude each other.
    TypeError
        Unknown keywords, and values of another type.

    Notes
    -----
    `profile` may be an array (slices, 2): the position of each slice's far end, from the knob, and
    the diameter, in the units of `profile_unit`. A file with a line of names may hold walls and
    layers.

    The keywords are the options of `percuss model bat`; docs/theory/theory.md has the equations.
    """
    return Result(run_on_documents("models.bat", "model bat", (), {
        "profile": profile, "profile_unit": profile_unit, "profile_kind": profile_kind, "density": density,
        "young": young, "shear": shear, "total_mass": total_mass, "add_mass": add_mass, "support": support,
        "support_at": support_at, "torsion": torsion, "ball_mass": ball_mass, "ball_speed": ball_speed,
        "bat_speed": bat_speed, "swing_rate": swing_rate, "cor": cor, "ball_stiffness": ball_stiffness,
        "ball_exponent": ball_exponent, "modes": modes, "at": at, "wave": wave, "wave_times": wave_times,
        "fit": fit, "measured": measured, "measured_std": measured_std, "measured_modes": measured_modes,
        "budget": budget, "title": title, "customer": customer, "operator": operator, "specimen": specimen,
        "date": date, "note": note, "logo": logo, "paper": paper,
    }))
