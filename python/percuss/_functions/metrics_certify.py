# Made by python/scripts/make_functions.py from the declarations of the command line. Do not edit.
from __future__ import annotations

from typing import Literal

from .._call import command_function, run_on_documents
from .._results import Result
from .._types import File, Path


@command_function("metrics.certify", "certify")
def certify(
    session: File,
    /,
    *,
    metric: Literal["besr", "ncaa_besr", "bbcor"] | None = None,
    limit: float | None = None,
    accept_plateau: bool = False,
    title: str | None = None,
    customer: str | None = None,
    operator: str | None = None,
    specimen: str | None = None,
    date: str | None = None,
    note: str | None = None,
    logo: Path | None = None,
    paper: Literal["a4", "letter"] | None = None,
) -> Result:
    """Check a bat's test session: valid shots, next impact position, verdict.

    Checks a test session against its protocol: validates each shot, names the next impact position,
    finds the sweet spot and compares BESR or BBCOR with the limit. The exit code is 5 if the bat
    fails.

    Parameters
    ----------
    session : path or dict
        The session; `percuss.example("certify")` shows its keys.
    metric : {'besr', 'ncaa_besr', 'bbcor'}, optional
        Judge by this metric in place of the session's.
    limit : float, optional
        Use this limit in place of the session's.
    accept_plateau : bool, optional
        Accept the best location within the margin as the sweet spot if no location stands out.
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
        Verdict, sweet spot, shots, `next`. `exit_code` is 5 if the bat exceeds its limit or is
        damaged.

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
    The keywords are the options of `percuss certify`; docs/theory/performance.md has the equations.
    """
    return Result(run_on_documents("metrics.certify", "certify", (session,), {
        "metric": metric, "limit": limit, "accept_plateau": accept_plateau, "title": title,
        "customer": customer, "operator": operator, "specimen": specimen, "date": date, "note": note,
        "logo": logo, "paper": paper,
    }))
