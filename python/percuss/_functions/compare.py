# Made by python/scripts/make_functions.py from the declarations of the command line. Do not edit.
from __future__ import annotations

from typing import Literal

from .._call import command_function, run_on_documents
from .._results import Result
from .._types import File, Path


@command_function("compare", "compare")
def compare(
    *documents: File,
    furthest: float | None = None,
    least_mac: float | None = None,
    title: str | None = None,
    customer: str | None = None,
    operator: str | None = None,
    specimen: str | None = None,
    date: str | None = None,
    note: str | None = None,
    logo: Path | None = None,
    paper: Literal["a4", "letter"] | None = None,
) -> Result:
    """Compare modes or deflections of tests and models side by side.

    Pairs the modes of the first document with the modes of each other document, and shows the
    differences. Modes with three common places are paired by shape. The MAC compares the shapes at
    the common points, or the channels if there are fewer than three points. Points are matched by
    their coordinates, else by their numbers. Other modes are paired by family and order if both
    documents state them with 90 % confidence and the frequencies do not contradict. The remaining
    modes are paired by frequency, so that modes that crossed are exchanged. The output says which
    rule applied. Letters name the peaks of one order, as bending 3a and bending 3b, the lowest
    first; they pair from below. Compares the deflections of two documents likewise. analyze,
    survey, deflect and model write such documents.

    Parameters
    ----------
    *documents : Result, dict or path
        Two or more results of `analyze`, `survey`, `deflect`, `models.beam`, `models.bat`,
        `models.impact` or `models.shell`, or their documents.
    furthest : float in %, optional
        Pair modes only if their frequencies differ by at most this much (default: 25, or 50 for
        modes of equal order).
    least_mac : float, optional
        Pair modes only if their MAC is at least this. Default: 0.6.
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
        `pairs`, `unpaired_a` and `unpaired_b`.

    Raises
    ------
    InputError
        Data that percuss cannot use.
    UsageError
        Invalid values, and keywords that exclude each other.
    TypeError
        Unknown keywords, and values of another type.

    See Also
    --------
    mac : the modal assurance criterion of two sets of shapes

    Notes
    -----
    The keywords are the options of `percuss compare`; docs/theory/theory.md has the equations.

    Examples
    --------
    >>> import percuss
    >>> a = percuss.models.beam(support="free", length=0.84, modes=4)
    >>> b = percuss.models.beam(support="free", length=0.85, modes=4)
    >>> len(percuss.compare(a, b)["pairs"]) > 0
    True
    """
    return Result(run_on_documents("compare", "compare", documents, {
        "furthest": furthest, "least_mac": least_mac, "title": title, "customer": customer,
        "operator": operator, "specimen": specimen, "date": date, "note": note, "logo": logo, "paper": paper,
    }))
