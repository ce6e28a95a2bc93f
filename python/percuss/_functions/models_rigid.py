# Made by python/scripts/make_functions.py from the declarations of the command line. Do not edit.
from __future__ import annotations

from typing import Literal

from .._call import command_function, run_on_documents
from .._results import Result
from .._types import Path, Quantity, Range


@command_function("models.rigid", "model rigid")
def rigid(
    *,
    ball_mass: Quantity | None = None,
    bat_mass: Quantity | None = None,
    inertia: Quantity | None = None,
    length: Quantity | None = None,
    at: Range | None = None,
    ball_speed: Quantity | None = None,
    swing_rate: float | None = None,
    bat_speed: Quantity | None = None,
    pivot: Quantity | None = None,
    cor: float | None = None,
    title: str | None = None,
    customer: str | None = None,
    operator: str | None = None,
    specimen: str | None = None,
    date: str | None = None,
    note: str | None = None,
    logo: Path | None = None,
    paper: Literal["a4", "letter"] | None = None,
) -> Result:
    """Predict the exit speed of a ball from a rigid bat at each impact position.

    Computes the impact of a ball on a rigid bat from conservation of momentum. Positions are in m
    from the centre of mass, positive towards the barrel.

    Parameters
    ----------
    ball_mass : float in kg, optional
        Set the mass of the ball. Default: 0.145.
    bat_mass : float in kg, optional
        Set the mass of the bat. Default: 0.83.
    inertia : float in kg·m², optional
        Set the moment of inertia of the bat about its centre of mass. Default: 0.039.
    length : float in m, optional
        Set the length of the bat; without `at`, positions reach from the centre of mass to half
        this length. Default: 0.84.
    at : (lo, step, hi), optional
        Set the impact positions in m from the centre of mass, positive towards the barrel.
    ball_speed : float in m/s, optional
        Set the speed of the ball towards the bat. Default: 67.
    swing_rate : float in rad/s, optional
        Set the rotation rate of the bat. Default: 60.
    bat_speed : float in m/s, optional
        Set the speed of the bat's centre of mass towards the ball. Default: 0.
    pivot : float in m, optional
        Set the distance of the pivot from the centre of mass, towards the knob; adds rate times
        distance to the speed of the centre of mass.
    cor : float, optional
        Set the coefficient of restitution. Default: 0.55.
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
        The keys of the document: `best`, `curve`.

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
    The keywords are the options of `percuss model rigid`; docs/theory/theory.md has the equations.
    """
    return Result(run_on_documents("models.rigid", "model rigid", (), {
        "ball_mass": ball_mass, "bat_mass": bat_mass, "inertia": inertia, "length": length, "at": at,
        "ball_speed": ball_speed, "swing_rate": swing_rate, "bat_speed": bat_speed, "pivot": pivot, "cor": cor,
        "title": title, "customer": customer, "operator": operator, "specimen": specimen, "date": date,
        "note": note, "logo": logo, "paper": paper,
    }))
