# Made by python/scripts/make_functions.py from the declarations of the command line. Do not edit.
from __future__ import annotations

from typing import Literal, Sequence

from .._call import command_function, run_on_documents
from .._results import Result
from .._types import File, Numbers, Path, Quantity, Range

_Fit = Literal["ei", "torsion", "rho-a", "young", "shear", "density", "added-mass"]


@command_function("models.beam", "model beam")
def beam(
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
    modes: int | None = None,
    gyration: Quantity | None = None,
    shear_stiffness: float | None = None,
    fit: _Fit | Sequence[_Fit] | None = None,
    measured: Numbers | None = None,
    measured_std: Numbers | None = None,
    measured_modes: int | Sequence[int] | None = None,
    static: Range | None = None,
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
    """Predict natural frequencies, nodes and shapes of a beam.

    Models a beam that is free, or held at x = 0; the default support is a torsion spring, as for a
    clamped bat. The beam is uniform, or has the sections of a table (`profile`). Reports
    frequencies in Hz, the places x of the nodes, and shapes. `fit` finds the stiffness, the spring
    or the mass from measured frequencies, with standard deviations.

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
    modes : int, optional
        List this many modes, including rigid-body modes (0 Hz). Default: 10.
    gyration : float in m, optional
        Add rotary inertia (Timoshenko) with this radius of gyration √(I/A).
    shear_stiffness : float in N, optional
        Add shear (Timoshenko) with this shear stiffness κGA.
    fit : {'ei', 'torsion', 'rho-a', 'young', 'shear', 'density', 'added-mass'} or a list of them, optional
        Fit these parameters to `measured`; their values are the start.
    measured : float or list of float in Hz, optional
        Set the measured frequencies, lowest first.
    measured_std : float or list of float in Hz, optional
        Set the standard deviations of the measured frequencies; one each, or one for all.
    measured_modes : int or list of int, optional
        Set the mode numbers of the measured frequencies, as in the table (default: the lowest
        elastic modes).
    static : (load, lever, deflection) or a list of them, optional
        Compute the spring's stiffness from a transverse load in N, its distance from the spring in
        m, and the deflection there in m.
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
        The keys of the document: `frequency_hz` (modes,), `lambda`, `node_m` …

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
    The keywords are the options of `percuss model beam`; docs/theory/theory.md has the equations.
    """
    return Result(run_on_documents("models.beam", "model beam", (), {
        "support": support, "ei": ei, "rho_a": rho_a, "torsion": torsion, "length": length, "layer": layer,
        "profile": profile, "profile_unit": profile_unit, "profile_kind": profile_kind, "density": density,
        "young": young, "shear": shear, "total_mass": total_mass, "add_mass": add_mass, "modes": modes,
        "gyration": gyration, "shear_stiffness": shear_stiffness, "fit": fit, "measured": measured,
        "measured_std": measured_std, "measured_modes": measured_modes, "static": static, "budget": budget,
        "title": title, "customer": customer, "operator": operator, "specimen": specimen, "date": date,
        "note": note, "logo": logo, "paper": paper,
    }))
