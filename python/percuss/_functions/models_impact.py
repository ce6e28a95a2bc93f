# Made by python/scripts/make_functions.py from the declarations of the command line. Do not edit.
from __future__ import annotations

from typing import Literal

from .._call import command_function, run_on_documents
from .._results import Result
from .._types import Assignments, File, Numbers, Path, Quantity, Range


@command_function("models.impact", "model impact")
def impact(
    *,
    support: Literal["torsion", "pinned", "clamped", "free"] | None = None,
    ei: float | None = None,
    rho_a: float | None = None,
    torsion: float | None = None,
    length: Quantity | None = None,
    layer: Range | None = None,
    profile: File | None = None,
    profile_unit: Range | None = None,
    profile_kind: Literal["slices", "points"] | None = None,
    density: float | None = None,
    young: float | None = None,
    shear: float | None = None,
    total_mass: Quantity | None = None,
    add_mass: Range | None = None,
    at: Quantity | None = None,
    ball_mass: Quantity | None = None,
    speed: Quantity | None = None,
    hertz: float | None = None,
    contact_cor: float | None = None,
    modes: int | None = None,
    method: Literal["modal", "small-increment"] | None = None,
    step: float | None = None,
    sweep: Assignments | None = None,
    curves: bool = False,
    threads: int | None = None,
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
    """Predict the impact of a ball on a beam: restitution, force and deflection.

    Simulates the impact of a ball on the beam of percuss model beam: coefficient of restitution
    (COR) after the first contact and after the last, contact time, largest force, and deflection of
    the beam until 80 ms after the first contact. `sweep` varies constants of the beam, the impact
    position or the speed.

    Parameters
    ----------
    support : {'torsion', 'pinned', 'clamped', 'free'}, optional
        Choose the support at x = 0; the other end is free. Default: torsion.
    ei : float in N·m², optional
        Set the bending stiffness EI (default: 4000).
    rho_a : float in kg/m, optional
        Set the mass per length (default: 2.24).
    torsion : float in N·m/rad, optional
        Set the stiffness of the torsion spring at x = 0 (default: 1200).
    length : float in m, optional
        Set the length of the beam (default: 0.57).
    layer : (young, width, height[, density]) or a list of them, optional
        Add a layer of the section, from the underside up, in Pa, m, m and kg/m³; layers replace
        `ei`, and layers with a density also `rho_a`.
    profile : path, array or dict, optional
        Read the sections from this file: a position and a diameter, or width and thickness, in each
        line; with a line of names also wall, young, shear, density, and wall_2, young_2 … of
        further layers.
    profile_unit : (position, size), optional
        Set the units of the profile's positions and of its dimensions. Default: m:m.
    profile_kind : {'slices', 'points'}, optional
        Choose what a line means. slices: its section extends back to the position before; points:
        dimensions change linearly between positions. Default: points.
    density : float in kg/m³, optional
        Set the density of the profile's material, where the profile has none.
    young : float in Pa, optional
        Set Young's modulus of the profile's material, where the profile has none.
    shear : float in Pa, optional
        Add shear and rotary inertia (Timoshenko) to a profile, with this shear modulus times the
        shape factor.
    total_mass : float in kg, optional
        Compute the density from this measured mass, which includes added masses.
    add_mass : (kg, at) or a list of them, optional
        Add a point mass (a cap), or a mass spread evenly from one position to another (a grip or an
        insert), in kg and m.
    at : float in m, optional
        Set the impact position, from x = 0. Default: 0.51.
    ball_mass : float in kg, optional
        Set the mass of the ball. Default: 0.16.
    speed : float in m/s, optional
        Set the speed of the ball. Default: 5.
    hertz : float in N/m^1.5, optional
        Set the Hertz constant: force over approach^(3/2). Default: 3.2e+06.
    contact_cor : float, optional
        Set the COR of the ball on a rigid wall at `speed`; below 1 the contact loses energy
        (hysteresis). Default: 1.
    modes : int, optional
        Use this many modes of the beam, including rigid-body modes. Default: 10.
    method : {'modal', 'small-increment'}, optional
        Choose the integration. modal: exact between force steps; small-increment: first order,
        constant force in each step. Default: modal.
    step : float in s, optional
        Set the time step (default: for modal, adaptive steps with restitution and energy accurate
        to 1e-9; for small-increment, 1e-5).
    sweep : dict or str, optional
        Vary ei, torsion, rho-a, at or speed, in the unit of the option, with the others constant.
    curves : bool, optional
        Write and draw the motion over time of each impact of the sweep, in place of one row each.
    threads : int, optional
        Use this many threads (default: all; the result is the same).
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
        The keys of the document: `cor`, `contact_s`, `peak_force_n`, `sweep` …

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
    The keywords are the options of `percuss model impact`; docs/theory/theory.md has the equations.
    """
    return Result(run_on_documents("models.impact", "model impact", (), {
        "support": support, "ei": ei, "rho_a": rho_a, "torsion": torsion, "length": length, "layer": layer,
        "profile": profile, "profile_unit": profile_unit, "profile_kind": profile_kind, "density": density,
        "young": young, "shear": shear, "total_mass": total_mass, "add_mass": add_mass, "at": at,
        "ball_mass": ball_mass, "speed": speed, "hertz": hertz, "contact_cor": contact_cor, "modes": modes,
        "method": method, "step": step, "sweep": sweep, "curves": curves, "threads": threads, "budget": budget,
        "title": title, "customer": customer, "operator": operator, "specimen": specimen, "date": date,
        "note": note, "logo": logo, "paper": paper,
    }))
