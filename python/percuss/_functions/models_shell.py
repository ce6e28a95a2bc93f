# Made by python/scripts/make_functions.py from the declarations of the command line. Do not edit.
from __future__ import annotations

from typing import Literal

from .._call import command_function, run_on_documents
from .._results import Result
from .._types import Path, Quantity, Range


@command_function("models.shell", "model shell")
def shell(
    *,
    outer_diameter: Quantity | None = None,
    wall: Quantity | None = None,
    length: Quantity | None = None,
    young: float | None = None,
    density: float | None = None,
    poisson: float | None = None,
    n: int | None = None,
    modes: int | None = None,
    measured: Range | None = None,
    fit: Literal["young", "wall", "both"] | None = None,
    title: str | None = None,
    customer: str | None = None,
    operator: str | None = None,
    specimen: str | None = None,
    date: str | None = None,
    note: str | None = None,
    logo: Path | None = None,
    paper: Literal["a4", "letter"] | None = None,
) -> Result:
    """Predict hoop frequencies of a barrel as a tube: ring, Rayleigh, Love, Flügge.

    Models the barrel as a tube. Reports hoop frequencies in Hz for n waves around the tube by four
    theories: the shapes of ring and Rayleigh are constant along the tube, the shape of Love grows
    linearly from its middle, and the shape of Flügge has m half-waves along it. `measured` fits
    Young's modulus, the wall or both to measured frequencies.

    Parameters
    ----------
    outer_diameter : float in m, optional
        Set the outer diameter of the tube. Default: 0.066675.
    wall : float in m, optional
        Set the thickness of the wall. Default: 0.00254.
    length : float in m, optional
        Set the length of the tube. Default: 0.3302.
    young : float in Pa, optional
        Set Young's modulus of the wall. Default: 7e+10.
    density : float in kg/m³, optional
        Set the density of the wall. Default: 2700.
    poisson : float, optional
        Set Poisson's ratio. Default: 0.33.
    n : int, optional
        Set the number n of waves around the tube. Default: 2.
    modes : int, optional
        List modes with m from 1 to this many half-waves along the tube. Default: 3.
    measured : (n, m, hz, std) or a list of them, optional
        Fit to measured hoop frequencies: waves around, half-waves along, frequency and its standard
        deviation.
    fit : {'young', 'wall', 'both'}, optional
        Choose the parameters to fit to `measured`. Default: young.
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
        The keys of the document: `ring_hz`, `rayleigh_hz`, `love_hz`, `flugge_hz` (modes,).

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
    The keywords are the options of `percuss model shell`; docs/theory/theory.md has the equations.
    """
    return Result(run_on_documents("models.shell", "model shell", (), {
        "outer_diameter": outer_diameter, "wall": wall, "length": length, "young": young, "density": density,
        "poisson": poisson, "n": n, "modes": modes, "measured": measured, "fit": fit, "title": title,
        "customer": customer, "operator": operator, "specimen": specimen, "date": date, "note": note,
        "logo": logo, "paper": paper,
    }))
