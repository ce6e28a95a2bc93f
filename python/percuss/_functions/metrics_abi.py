# Made by python/scripts/make_functions.py from the declarations of the command line. Do not edit.
from __future__ import annotations

from typing import Literal

from .._call import command_function, run_on_documents
from .._results import Result
from .._types import File, Path


@command_function("metrics.abi", "abi")
def abi(
    log: File,
    /,
    *,
    limit: float | None = None,
    title: str | None = None,
    customer: str | None = None,
    operator: str | None = None,
    specimen: str | None = None,
    date: str | None = None,
    note: str | None = None,
    logo: Path | None = None,
    paper: Literal["a4", "letter"] | None = None,
) -> Result:
    """Follow the break-in of a composite bat from its log: next step and verdict.

    Evaluates the accelerated break-in of a composite bat by rolling. The log lists compressions,
    rollings and tests in order; the report names the next step. The bat passes when the result of a
    test falls clearly below the best one. It fails when a result exceeds the limit, or when the
    first test damages the bat (exit code 5).

    Parameters
    ----------
    log : path or dict
        The log; `percuss.example("abi")` shows its keys.
    limit : float, optional
        Use this limit in place of the log's.
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
        The next step and the verdict. `exit_code` is 5 if the bat fails.

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
    The keywords are the options of `percuss abi`; docs/theory/performance.md has the equations.
    """
    return Result(run_on_documents("metrics.abi", "abi", (log,), {
        "limit": limit, "title": title, "customer": customer, "operator": operator, "specimen": specimen,
        "date": date, "note": note, "logo": logo, "paper": paper,
    }))
