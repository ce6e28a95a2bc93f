# Made by python/scripts/make_functions.py from the declarations of the command line. Do not edit.
from __future__ import annotations

from typing import Literal, Sequence

from .._call import command_function, run_on_documents
from .._results import Result
from .._types import Assignments, File, Numbers, Path, Quantity, Range


@command_function("models.trampoline", "model trampoline")
def trampoline(
    *,
    ball: Literal["baseball", "softball"] | None = None,
    speed: Quantity | None = None,
    hoop: Range | None = None,
    extra_mass: Quantity | None = None,
    free_hoop: float | None = None,
    loaded_hoop: float | None = None,
    fit_ccor: Range | None = None,
    hold: Assignments | None = None,
    bats: File | Sequence[File] | None = None,
    m1: Quantity | None = None,
    k1: float | None = None,
    c1: float | None = None,
    a: float | None = None,
    b: float | None = None,
    m2: Quantity | None = None,
    c2: float | None = None,
    budget: Numbers | None = None,
    title: str | None = None,
    customer: str | None = None,
    operator: str | None = None,
    specimen: str | None = None,
    date: str | None = None,
    note: str | None = None,
    logo: Path | None = None,
    paper: Literal["a4", "letter"] | None = None,
    keep_formulas: bool = False,
) -> Result:
    """Predict the COR of a ball on a hollow barrel as a function of its hoop frequency.

    Models the ball and the wall of a hollow barrel as two masses with springs and dampers. Reports
    the COR as a function of the hoop frequency of the barrel, and the frequency of the largest COR.

    Parameters
    ----------
    ball : {'baseball', 'softball'}, optional
        Use the constants of this ball. Default: baseball.
    speed : float in m/s, optional
        Set the speed of the ball towards the barrel. Default: 60.8.
    hoop : (lo, step, hi), optional
        Set the hoop frequencies in Hz. Default: 100:25:10000.
    extra_mass : float in kg, optional
        Set an extra mass that moves with the barrel without stiffening it. Default: 0.
    free_hoop : float in Hz, optional
        Set the hoop frequency without the extra mass; needs `loaded_hoop`.
    loaded_hoop : float in Hz, optional
        Set the hoop frequency with the extra mass; gives the modal mass from the shift against
        `free_hoop`.
    fit_ccor : (speed, cor, std) or a list of them, optional
        Fit a and b to measured CCOR first: speed in m/s, COR and its standard deviation; or a file
        of such lines.
    hold : dict or str, optional
        Hold an exponent in the fit, such as a=0.6495; with `fit_ccor`, the options `a` and `b` also
        hold their exponents.
    bats : path, array, dict or Result, or a list of them, optional
        Compare with the BBCOR of bats at their first hoop frequency: tables and documents as for
        percuss study.
    m1 : float in kg, optional
        Set the mass of the ball.
    k1 : float, optional
        Set the stiffness of the ball, N/m^(1+a).
    c1 : float, optional
        Set the damping of the ball, N s/m^(1+b).
    a : float, optional
        Set the exponent of the ball's stiffness.
    b : float, optional
        Set the exponent of the ball's damping, below 1 + a.
    m2 : float in kg, optional
        Set the effective mass of the barrel.
    c2 : float in N·s/m, optional
        Set the damping of the barrel; for a baseball, Sutton (2010) has 90.5 in a script and 100 in
        a table.
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
    keep_formulas : bool, optional
        Write texts such as =1+1 to CSV without the apostrophe that keeps a spreadsheet from
        computing them.

    Returns
    -------
    Result
        The keys of the document: `wall_cor`, `peak`, `curve`.

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
    The keywords are the options of `percuss model trampoline`; docs/theory/theory.md has the
    equations.
    """
    return Result(run_on_documents("models.trampoline", "model trampoline", (), {
        "ball": ball, "speed": speed, "hoop": hoop, "extra_mass": extra_mass, "free_hoop": free_hoop,
        "loaded_hoop": loaded_hoop, "fit_ccor": fit_ccor, "hold": hold, "bats": bats, "m1": m1, "k1": k1,
        "c1": c1, "a": a, "b": b, "m2": m2, "c2": c2, "budget": budget, "title": title, "customer": customer,
        "operator": operator, "specimen": specimen, "date": date, "note": note, "logo": logo, "paper": paper,
        "keep_formulas": keep_formulas,
    }))
